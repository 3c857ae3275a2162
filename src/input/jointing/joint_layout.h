/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A joint set as it is laid out about the toe: its angle, its normal, its random numbers. */

#ifndef TP_JOINTING_JOINT_LAYOUT_H
#define TP_JOINTING_JOINT_LAYOUT_H

#include "jointing/cuts.h"

#include <stdint.h>

typedef enum tp_joint_random {
  TP_RANDOM_SPACING,
  TP_RANDOM_DIP,
  TP_RANDOM_BRIDGES,
  TP_JOINT_RANDOMS
} tp_joint_random;

typedef struct tp_joint_layout {
  tp_cuts *cuts;
  const tp_joint_set *set;
  long number;
  uint64_t random[TP_JOINT_RANDOMS]; /* streams */
  fmpq_t angle_deg;
  tp_cut_point along, normal;
  bool left; /* of `along` is the normal */
} tp_joint_layout;

void tp_joint_layout_init(tp_joint_layout *layout, tp_cuts *cuts, long number, uint64_t seed);
void tp_joint_layout_clear(tp_joint_layout *layout);

#endif
