/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A mode of motion: twists, and the forces that they allow (motion/strata.h). */

#ifndef TP_MOTION_MODE_H
#define TP_MOTION_MODE_H

#include "motion/twists.h"

typedef struct tp_mode {
  tp_mechanism mechanism; /* TP_LEAVES_BASE in the interior, which has all of K's rays */
  int ray_count;          /* 1 or 2; 0 in the interior */
  long rays[2];
  long normal; /* that both rays lie on */
  long edge_count;
  const tp_cone_edge *edges;
} tp_mode;

/* Is its one ray a slide? */
bool tp_mode_slides(const tp_mode *mode, const tp_twists *twists);

#endif
