/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Have two simple rings whose edges do not cross an inside in common?
 *
 * Where one enters the other without crossing an edge it does so at a point in which they touch,
 * and there the sectors that are their insides overlap. Rings that touch nowhere overlap where one
 * lies in the other. So each meeting is judged by itself, O(n) in all. */

#ifndef TP_BASE_OVERLAP_H
#define TP_BASE_OVERLAP_H

#include "base/facets.h"
#include "geom/geom.h"

/* Points from `first` on, counter-clockwise or not. */
typedef struct tp_overlap_ring {
  long first, count;
  bool clockwise;
} tp_overlap_ring;

typedef struct tp_overlap {
  const tp_lattice *lattice;
  tp_overlap_ring a, b;
  bool touch; /* somewhere */
  bool found; /* by a meeting */
} tp_overlap;

/* One meeting of edges of a and b, other than a crossing: named by their first points. */
void tp_overlap_meet(tp_overlap *overlap, tp_geom_meeting_kind kind, long edge_a, long edge_b);

/* After all meetings. */
bool tp_overlap_is(const tp_overlap *overlap);

#endif
