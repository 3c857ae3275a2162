/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The facet that governs sliding (evaluation/sliding.c says which). */

#ifndef TP_EVALUATION_SLIDING_FACET_H
#define TP_EVALUATION_SLIDING_FACET_H

#include "evaluation/direction_ball.h"

/* i = atan2(rise, run), positive where the motion down-dip climbs. */
typedef struct tp_sliding_facet {
  long facet;   /* -1: none */
  bool blocked; /* a facet stands upright in the way */
  bool uneven;  /* one parallel to it has another friction */
  fmpz_t run, rise;
} tp_sliding_facet;

void tp_sliding_facet_init(tp_sliding_facet *best);
void tp_sliding_facet_clear(tp_sliding_facet *best);

/* Take the facet if its i is the largest so far; of two with the same i, one that has a length. */
void tp_sliding_facet_consider(const tp_evaluation *evaluation, long facet, tp_direction towards,
                               tp_sliding_facet *best);

/* The largest i among the facets that reach down-dip of the centroid, or among all; of several the
 * first from the toe that has a length. Where facets have frictions of their own, of all that are
 * parallel to that the one of the least. */
void tp_sliding_facet_find(tp_sliding_facet *best, const tp_evaluation *evaluation,
                           tp_direction towards, bool all, tp_certainty *certainty);

/* phi_b + i with a friction angle of the facet; with that at a tilt. Where tan(phi_b) is rational,
 * at 0 and 45 degrees, the direction is exact. */
void tp_sliding_add_friction(const tp_evaluation *evaluation, const tp_sliding_facet *best,
                             const arb_t friction, tp_direction_ball *sliding);
void tp_sliding_add_friction_at(const tp_evaluation *evaluation, const tp_sliding_facet *best,
                                const arb_t tilt, tp_direction_ball *sliding);

/* Does sliding down-dip along the facet open every other one, or slip along it? */
bool tp_sliding_facet_opens(const tp_evaluation *evaluation, const tp_sliding_facet *best,
                            tp_direction towards);

#endif
