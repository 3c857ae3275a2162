/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The outline of a region drawn to where the picture changes, to parts of a pixel, and how
 * uncertain it is there. */

#ifndef TP_TRACE_REFINE_H
#define TP_TRACE_REFINE_H

#include "trace/region.h"

typedef struct tp_refined {
  tp_trace_ring ring;
  double edge_px;  /* standard deviation of a place within the change from inside to outside: the
                      median over the outline */
  double shift_px; /* root mean square by which the outline was moved off the region's contour */
  double weak;     /* share of the outline along which the colours hardly change */
} tp_refined;

TP_MUST_USE tp_status tp_refine(tp_refined *refined, const tp_picture_region *region,
                                const tp_trace_picture *picture, tp_message *message);

/* Fewer points: none that is left out lies farther than `tolerance` from the chord in its place
 * (Douglas and Peucker 1973). In place. */
TP_MUST_USE bool tp_trace_simplify(tp_trace_ring *ring, double tolerance);

/* By how much each vertex moves where the ring as a whole is moved outwards by one: along the
 * bisector of its edges, by at most 1.5. `moves` has an entry for each point. */
void tp_trace_moves(tp_trace_point *moves, const tp_trace_ring *ring);

#endif
