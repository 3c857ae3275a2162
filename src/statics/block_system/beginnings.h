/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The strong side of a scene of many blocks: whether a motion can begin though forces can hold
 * them, and up to which divisor of strength, and which tilt, that is excluded, or proven. */

#ifndef TP_BLOCK_SYSTEM_BEGINNINGS_H
#define TP_BLOCK_SYSTEM_BEGINNINGS_H

#include "block_system/built_system.h"
#include "block_system/driving.h"
#include "block_system/resultant.h"
#include "contact_modes/resting.h"

/* The limits of what forces can hold: where a search for motions begins. Infinities where there are
 * none. */
typedef struct tp_beginnings_task {
  const tp_built_system *system;
  const tp_resultant *resultant;
  const tp_driving *driving;
  double held_factor; /* no forces hold with strength divided by more, as far as is known */
  double held_tilt_deg;
  bool asks_factor;
  bool verdict_alone; /* whether they stand as they lie; no thresholds */
} tp_beginnings_task;

/* Into a case, of which the verdict is that of forces: it becomes `stands` or `may move` where one
 * of both is proven. */
TP_MUST_USE tp_status tp_beginnings_find(tp_system_case *own, const tp_beginnings_task *task,
                                         tp_message *message);

#endif
