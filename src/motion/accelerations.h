/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* How a block begins to move in one mode under given loads: w = sum mu M r + sum lambda (-e), with
 * factors that are not negative. Of more than three generators every solution lies between those by
 * three of them. */

#ifndef TP_ACCELERATIONS_H
#define TP_ACCELERATIONS_H

#include "motion/motion.h"

typedef struct tp_start {
  bool moves;        /* the mode has a motion under these loads, with all of its rays at work */
  bool fixed;        /* one alone; else that with the least sum of factors */
  bool forces_fixed; /* so are the factors of the forces, which are given then */
  tp_vector twist;   /* sum mu r, about the origin, with its acceleration of the centroid in */
  tp_vector acceleration; /* units of w, lengths those of the question, about the centroid */
  long force_count;
  arb_ptr forces; /* lambda, by the edges of the mode */
  bool paradox;   /* a contact that slips would press itself harder: n . M^-1 e <= 0 */
} tp_start;

bool tp_start_init(tp_start *start, const tp_motion_mode *mode);
void tp_start_clear(tp_start *start);

TP_MUST_USE tp_motion_outcome tp_start_find(tp_start *start, const tp_motion_question *question,
                                            const tp_motions *motions, const tp_motion_mode *mode,
                                            const tp_vector *loads);

#endif
