/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The facets of the convex hull of a solid: triangles of the hull that lie in one plane, exactly,
 * are one facet, and corners on a straight edge are none. A facet begins with its least corner, and
 * facets stand in the order of their corners, so that they do not depend on how the hull was
 * found. */

#ifndef TP_SOLID_HULL_FACETS_H
#define TP_SOLID_HULL_FACETS_H

#include "solid/surface.h"

/* A side of a facet, counter-clockwise seen from outside. */
typedef struct tp_hull_side {
  int from, to;  /* vertices of the surface */
  int neighbour; /* the facet beyond it */
} tp_hull_side;

typedef struct tp_hull_facets {
  long count;
  long *starts; /* facet f has the sides starts[f] … starts[f + 1] - 1, one behind the other */
  tp_hull_side *sides;
} tp_hull_facets;

/* To be cleared, also on failure. */
TP_MUST_USE tp_status tp_hull_facets_init(tp_hull_facets *facets, const tp_surface *surface,
                                          tp_message *message);
void tp_hull_facets_clear(tp_hull_facets *facets);

#endif
