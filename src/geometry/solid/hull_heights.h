/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The height of the centroid over each facet of the hull, and its arms about the sides of these:
 * once for all that is asked about poses. */

#ifndef TP_SOLID_HULL_HEIGHTS_H
#define TP_SOLID_HULL_HEIGHTS_H

#include "solid/centre.h"
#include "solid/hull_facets.h"

typedef struct tp_hull_heights {
  const tp_centre *centre; /* borrowed, as are the facets */
  const tp_hull_facets *facets;
  tp_near *heights; /* of facets, as the surface's `near` */
  tp_near *arms;    /* about sides, times lengths: above 0 where the foot is within */
  bool is_open;     /* the level does not give a height to nine digits */
} tp_hull_heights;

/* To be cleared, also on failure. */
TP_MUST_USE tp_status tp_hull_heights_init(tp_hull_heights *over, const tp_centre *centre,
                                           const tp_hull_facets *facets, tp_message *message);
void tp_hull_heights_clear(tp_hull_heights *over);

/* The first three corners of a facet, and its plane for a solid that rests on it, to be cleared. */
void tp_hull_heights_corners(int corners[3], const tp_hull_heights *over, long facet);
void tp_hull_heights_plane(tp_rest_plane *plane, const tp_hull_heights *over, long facet);

/* Where the foot of the centroid is seen from a facet, as tp_foot_side returns it. */
int tp_hull_heights_side(const tp_hull_heights *over, long facet);

#endif
