/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The ways to an angle: each evaluates a subject at a price (tp_priced). */

#ifndef TP_ACCURACY_WAYS_H
#define TP_ACCURACY_WAYS_H

#include "accuracy/accuracy.h"
#include "evaluation/evaluation.h"

/* One question: a scene made ready, and the pivot that governs in it. */
typedef struct tp_accuracy_subject {
  tp_scene scene; /* a view of the user's, with other corners perhaps; owns nothing */
  tp_problem problem;
  tp_solution *noted; /* where the scene made ready notes what ran */
  tp_direction towards;
  bool has_pivot;
  long point; /* of the contact */
} tp_accuracy_subject;

/* Critical angle about the pivot by sums at the rung's own level, never at a cheaper one; by sums
 * over triangles; with rounded corners. */
tp_status tp_accuracy_by_boundary(arb_t degrees, bool *found, const void *subject, tp_rung rung);
tp_status tp_accuracy_by_triangles(arb_t degrees, bool *found, const void *subject, tp_rung rung);
tp_status tp_accuracy_by_rounding(arb_t degrees, bool *found, const void *subject, tp_rung rung);

/* Static limit: TP_LEVEL_DOUBLE unproven, TP_LEVEL_BALL certified, TP_LEVEL_EXACT by the exact
 * program of all columns. */
tp_status tp_accuracy_by_limit(arb_t degrees, bool *found, const void *subject, tp_rung rung);

/* Onset of motion: by balls of the rung's bits, on sums of its level or cheaper exact ones. */
tp_status tp_accuracy_by_onset(arb_t degrees, bool *found, const void *subject, tp_rung rung);

#endif
