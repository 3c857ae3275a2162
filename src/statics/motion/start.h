/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* How a block begins to move in one mode: acceleration and forces, as motion/accelerations.h finds
 * them. */

#ifndef TP_MOTION_START_H
#define TP_MOTION_START_H

#include "motion/motion.h"
#include "motion/strength.h"

typedef struct tp_start {
  bool moves;        /* the mode has a motion under these loads, with all of its rays at work */
  bool fixed;        /* one alone; else that with the least sum of factors, or the greatest */
  bool greatest;     /* the latter */
  bool forces_fixed; /* so are the factors of the forces, which are given then */
  bool one_point;  /* all forces act at one point: their sum is given, with the cohesion of lines */
  tp_vector sum;   /* through it that stick */
  tp_vector twist; /* sum mu r, about the origin, with its acceleration of the centroid in */
  tp_vector acceleration; /* units of w, lengths those of the question, about the centroid */
  long force_count;
  arb_ptr forces; /* lambda, by the edges of the mode, and behind those by its pulls */
  bool paradox;   /* a contact that slips would press itself harder: n . M^-1 e <= 0 */
} tp_start;

void tp_start_init(tp_start *start, const tp_motion_mode *mode);
void tp_start_clear(tp_start *start);

#endif
