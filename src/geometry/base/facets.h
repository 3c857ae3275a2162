/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Facets of a contact: where edges of the underside and of the base lie on each other, found among
 * the meetings of their edges (CGAL's exact predicates) or, on a mated base, one by one. All of it
 * by signs of whole numbers, so that nothing needs a bound. */

#ifndef TP_BASE_FACETS_H
#define TP_BASE_FACETS_H

#include "base/profile.h"
#include "block/tangents.h"

#include <stdint.h>

/* Where rounded corners have cut a facet off: it begins at the tangent point of the one on the edge
 * after it, or ends at that of the other on the edge before it. */
typedef struct tp_facet_rounding {
  const tp_corner *cut0, *cut1; /* NULL where the end is q0, q1; cut1 of a point is NULL */
  /* Of a point that is all that roundings leave of an edge: the same point as the end of the facet
   * that it is not yet, on the other side (`after`: the left one); its cut is NULL otherwise. */
  tp_outline_point also;
} tp_facet_rounding;

/* Ends and direction by points of the lattice; the block lies on the left of the direction. q0 and
 * q1 are the ends without rounding. A contact may have millions: what few of them have stands
 * apart. */
typedef struct tp_facet {
  int32_t q0, q1;    /* from left to right; equal for a contact in a point */
  int32_t t0, t1;    /* direction from t0 to t1; equal: restrains nothing */
  int32_t base_edge; /* of the profile; -1 and edge_count: the upright end faces of the base */
  tp_facet_rounding *rounding; /* owned by the list; NULL: none has cut it off */
} tp_facet;

tp_facet tp_facet_of(long q0, long q1, long t0, long t1, long base_edge);

/* A growing list of facets. */
typedef struct tp_facets {
  long count, capacity;
  tp_facet *items;
} tp_facets;

TP_MUST_USE bool tp_facets_append(tp_facets *facets, tp_facet facet);
void tp_facets_clear(tp_facets *facets);

/* From facets of the sharp outline to those of the rounded one; false when memory is exhausted. */
TP_MUST_USE bool tp_facets_cut(tp_facets *facets, const tp_corners *corners,
                               const tp_lattice *lattice, long outline_count);

/* Where a facet begins and ends. */
tp_outline_point tp_facet_begin(const tp_facet *facet);
tp_outline_point tp_facet_end(const tp_facet *facet);

/* The points of contact at which a facet presses: both, the left one first, or the one of a contact
 * in a point; none of a corner on a corner, which restrains nothing. Their number. */
int tp_facet_contacts(tp_outline_point points[2], const tp_facet *facet);

/* Facets of a mated base: the shared edges one by one, and the notches at its two ends. */
TP_MUST_USE tp_status tp_facets_of_mated(tp_facets *facets, const tp_section *section,
                                         const tp_base *base, const tp_lattice *lattice,
                                         tp_message *message);

/* Facets of any base, by searching for edges that meet; sorted along the base. */
TP_MUST_USE tp_status tp_facets_of_profile(tp_facets *facets, const tp_section *section,
                                           const tp_base *base, const tp_lattice *lattice,
                                           tp_message *message);

/* Of two edges that touch in one point alone that point, an end of one of them. */
long tp_facet_touch(const tp_lattice *lattice, long a0, long a1, long b0, long b1);

/* Does the facet begin or end in the point? */
bool tp_facet_ends_in(const tp_lattice *lattice, const tp_facet *facet, tp_outline_point point);

/* Sign of (q - p) . t, t the direction of the facet: below zero where turning about p towards the
 * left presses q through it (docs/mechanics.md section 3). */
int tp_facet_side(const tp_lattice *lattice, const tp_facet *facet, tp_outline_point p,
                  tp_outline_point q);

#endif
