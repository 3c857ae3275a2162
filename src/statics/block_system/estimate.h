/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Where it is not known whether a motion of many blocks can begin: estimates of their factors of
 * safety, of joints that do not dilate, and of more blocks than an exclusion takes a motion that is
 * proven, near the estimate or as the blocks are given. */

#ifndef TP_BLOCK_SYSTEM_ESTIMATE_H
#define TP_BLOCK_SYSTEM_ESTIMATE_H

#include "block_system/driving.h"
#include "block_system/threshold.h"

typedef struct tp_estimate_task {
  const tp_built_system *system;
  const tp_resultant *resultant;
  const tp_driving *driving;
  const tp_threshold *strength; /* up to which divisor forces hold, by its logarithm */
  bool asks_factor;             /* else only whether a motion can begin as they are given */
} tp_estimate_task;

/* Into a case whose verdict and beginnings are found. A motion that is proven as the blocks are
 * given makes its verdict `may move`. */
TP_MUST_USE tp_status tp_estimate_find(tp_system_case *one, const tp_estimate_task *task,
                                       tp_message *message);

/* Of two cases of one direction the lesser estimates. */
void tp_estimate_join(tp_system_case *one, const tp_system_case *other);

#endif
