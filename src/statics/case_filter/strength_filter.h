/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The share of its friction nearest to 1 at which it changes whether a motion can begin at a tilt
 * (motion/strength_change.h), in doubles with bounds. */

#ifndef TP_CASE_FILTER_STRENGTH_FILTER_H
#define TP_CASE_FILTER_STRENGTH_FILTER_H

#include "case_filter/limit_filter.h"

typedef struct tp_strength_told {
  bool found;   /* false: no share changes it; */
  bool farther; /* or none whose ratio is as near to 1 as was asked for: whether there is one, and
                   all else, is not told */
  tp_near share;
  tp_mechanism mechanism; /* of what begins there, or ends */
} tp_strength_told;

/* `moves`: a motion can begin with all of it. Ratios above `most` do not matter; INFINITY: all do.
 * False where doubles do not tell. */
TP_MUST_USE bool tp_strength_filter_find(tp_strength_told *told, const tp_filter_case *of,
                                         tp_near tangent, bool moves, double most);

/* Can a motion certainly begin with hardly any of its strength? Of a block that stands with all of
 * it, some share then changes that. */
TP_MUST_USE bool tp_strength_filter_needs_some(const tp_filter_case *of, tp_near tangent);

/* Does a little more or less friction move the onset (tp_window.from_by_strength)? By the same
 * search just above it; false where doubles do not tell. */
TP_MUST_USE bool tp_strength_filter_moves_onset(const tp_filter_case *of, tp_near onset);

#endif
