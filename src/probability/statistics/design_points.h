/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The design points of all ways to fail: of those with g = 0 the ones with the least distance from
 * the origin nearby. The first-order method (form.h) from the origin; again with a bulge on every
 * point that is known, which sends it elsewhere (Der Kiureghian and Dakessian, Structural Safety 20
 * (1998) 37-49), and then without; from both ends of each axis and from random directions, at the
 * distance of the nearest point. A search from the origin alone finds one mechanism of several, and
 * by symmetry may end in a saddle, further out than the points at its sides.
 *
 * Nothing proves that all are found: what is not shows in the weights of samples
 * (importance_sampling.h), and each of these searches can begin at a sample, too. */

#ifndef TP_STATISTICS_DESIGN_POINTS_H
#define TP_STATISTICS_DESIGN_POINTS_H

#include "statistics/form.h"

enum { TP_DESIGN_POINTS = 16 };

typedef struct tp_design_points {
  size_t count;
  tp_form points[TP_DESIGN_POINTS]; /* found, the nearest first; those that are less likely by 1e-4
                                       are left out */
  tp_form_state state; /* of the search from the origin; the first one's where a point was found */
  double at_origin;    /* g */
  uint64_t calls;
} tp_design_points;

/* By numbers from the seed. That none is found is TP_OK, and the state says why. */
tp_status tp_design_points_find(tp_design_points *found, const tp_reliability *problem,
                                uint64_t seed, tp_message *message) TP_MUST_USE;

/* Once more from these scores. `*added`: it ended at a point that was not known. */
tp_status tp_design_points_add(tp_design_points *found, bool *added, const tp_reliability *problem,
                               const double *start, tp_message *message) TP_MUST_USE;

void tp_design_points_clear(tp_design_points *found);

#endif
