/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The motions of one mode at given loads (motion/accelerations.h): w as a sum of three of its
 * generators, free forces that are not among the three at their bounds, every such sum with factors
 * within their bounds tried. */

#ifndef TP_MOTION_STARTING_H
#define TP_MOTION_STARTING_H

#include "motion/motion.h"
#include "motion/start.h"

/* One mode at work. */
typedef struct tp_starting {
  tp_start *start;
  const tp_motion_question *q;
  const tp_motions *m;
  const tp_motion_mode *mode;
  const tp_strength *strength; /* or NULL */
  tp_vector loads;             /* with what is fixed of the strength */
  tp_vector rest;              /* with free forces at one of their bounds */
  long count;                  /* of the generators: rays, edges, pulls; behind them ... */
  long free_count;             /* ... those whose factor goes from -1 to 1 */
  tp_vector *items;
  long solutions;
  bool greatest; /* is kept, not the least: */
  arb_t best;    /* sum of the factors of rays */
} tp_starting;

/* Counts the solutions, and keeps the best of them in `start`. */
TP_MUST_USE tp_motion_outcome tp_starting_try(tp_starting *starting);

#endif
