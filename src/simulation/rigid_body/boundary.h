/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The boundaries of the block and of the rock that it lies on, as straight edges and arcs.
 *
 * Arcs, rounded corners and circles are exact but for the rounding of doubles. An ellipse stands as
 * arcs that meet smoothly (two to each of 64 pieces of a quarter), off by less than 1e-7 of its
 * longer axis where that is at most four times the shorter one; stretched to a circle, by less than
 * 1e-4 of its radius however slender it is. */

#ifndef TP_RIGID_BODY_BOUNDARY_H
#define TP_RIGID_BODY_BOUNDARY_H

#include "rigid_body/local.h"

/* A straight edge, or an arc of less than half a circle, of a boundary with the rock on its left:
 * the outline runs counter-clockwise, the base from right to left. */
typedef struct tp_edge {
  tp_xy from, to;
  bool arc, inwards; /* inwards: the centre lies outside of the rock */
  tp_xy centre;      /* of an arc */
  double radius;     /* of an arc, above 0 on whichever side its centre lies; else 0 */
  long number; /* of the outline: of the vertex it begins in, from 1; of the base: of its facet
                  of the profile from the left, from 1, 0 for what closes the rock (end faces and
                  below) */
} tp_edge;

typedef struct tp_boundary {
  long count; /* closed: the last edge ends where the first begins */
  tp_edge *edges;
} tp_boundary;

/* Of the block, its holes left out; and of the base. False when memory is exhausted. */
TP_MUST_USE bool tp_boundary_of_block(tp_boundary *boundary, const tp_local *local);
TP_MUST_USE bool tp_boundary_of_base(tp_boundary *boundary, const tp_local *local);
void tp_boundary_clear(tp_boundary *boundary);

/* The largest distance of any of it from the origin. */
double tp_boundary_reach(const tp_boundary *boundary);

/* Arcs along an ellipse about `centre`, counter-clockwise from the angle `first` of its parameter
 * to the angle `last`; `edges` has room for tp_ellipse_arc_count. */
long tp_ellipse_arc_count(tp_xy half_axes);
void tp_ellipse_arcs(tp_edge *edges, tp_xy centre, tp_xy half_axes, double first, double last);

#endif
