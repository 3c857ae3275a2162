/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Intervals of tilts at which loads do some power, and their unions, in doubles with bounds. */

#ifndef TP_CASE_FILTER_NEAR_INTERVAL_H
#define TP_CASE_FILTER_NEAR_INTERVAL_H

#include "case_filter/filter_loads.h"

/* Of a set of tangents t of the tilt, an interval; or none. One whose ends are not told apart is a
 * single tilt at most, or none: `perhaps`. */
typedef struct tp_near_interval {
  bool empty, perhaps, has_low, has_high;
  tp_near low, high;
} tp_near_interval;

/* Where the loads lie in the mode's cone, and where its motion takes part with all of its rays:
 * both sets are convex. */
typedef struct tp_mode_interval {
  tp_near_interval all, with_rays;
  tp_near_interval pulled; /* with all rays where bonds pull on what slides, by any force */
} tp_mode_interval;

/* Keep the tilts at which the power of what the base bears is not above zero, times `sign`; where
 * some of it `stays` with the block, of those from level to upright. False where that is open. */
TP_MUST_USE bool tp_near_interval_keep(tp_near_interval *own, const tp_tilt_form *power, int sign,
                                       bool stays);

/* Two planes that share a generator meet the loads at one tilt where these lie along it: weight
 * along a facet that slides. */
void tp_near_interval_settle(tp_near_interval *own);

/* From the least lower to the largest upper end of intervals, */
void tp_near_interval_unite(tp_near_interval *sum, const tp_near_interval *own);
/* and of those that may be none, which are no more than an end. */
void tp_near_interval_add_perhaps(tp_near_interval *sum, const tp_near_interval *perhaps);

#endif
