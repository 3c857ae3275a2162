/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Where a block touches its base: facets and single points, found exactly on the lattice.
 *
 * A facet is a piece that an edge of the block shares with an edge of the base; its ends are
 * vertices of one of them, so nothing is rounded. Where a vertex touches only in a point, the edge
 * that it would press into is a facet without length: the other's edge, or both edges of a notch
 * (in the base, or in the block). A corner on a corner presses into neither and restrains
 * nothing to first order. The upright faces at which the rock ends are rock too. A rounded block
 * touches where the sharp one does and its outline still is (base/facets_cut.c). */

#ifndef TP_BASE_CONTACT_H
#define TP_BASE_CONTACT_H

#include "base/facets.h"

/* A vertex of the contact: candidate pivot. */
typedef struct tp_contact_point {
  int32_t point;       /* of the lattice; without rounding, where a corner is cut off */
  int32_t left, right; /* facets of positive length that end, and begin, here; -1 for none */
  tp_pivot_kind kind : 8;
  bool after;
  const tp_corner *cut; /* the corner whose tangent point it is, on the edge after it or before */
  const tp_outline_point *also; /* where roundings leave it alone of an edge: that of its facet */
} tp_contact_point;

typedef struct tp_contact {
  long facet_count;
  tp_facet *facets; /* along the base from left to right */
  long point_count;
  tp_contact_point *points;
  long steepest; /* the facet farthest from level: of those alike, the first */
  bool steep;    /* it is nearer upright than level, or overhangs */
} tp_contact;

/* The contact of a checked section, its corners rounded (NULL: sharp), with its base, whose ring is
 * the chain after the section's rings in the lattice. A base that cuts into the block, and a block
 * that touches it nowhere, are bad input. On failure `contact` is cleared; it borrows the corners.
 */
TP_MUST_USE tp_status tp_contact_init(tp_contact *contact, const tp_section *section,
                                      const tp_corners *corners, const tp_base *base,
                                      const tp_lattice *lattice, tp_message *message);
void tp_contact_clear(tp_contact *contact);

/* Where on the outline it lies. */
tp_outline_point tp_contact_on_outline(const tp_contact_point *point);

/* The same as the left end of a contact, or the right one: where two roundings meet, the tangent
 * point of the corner on that side, and the end that the contact has without them. */
tp_outline_point tp_contact_end_on_outline(const tp_contact_point *point, bool left);

/* Where the contact ends on one side. */
tp_outline_point tp_contact_extreme(const tp_contact *contact, bool left);

/* Does any of it restrain the block? A corner on a corner does not. */
bool tp_contact_restrains(const tp_contact *contact);

/* Can the block slip along all of it at once, so that no facet stands in the way of another? */
bool tp_contact_is_free_to_slip(const tp_contact *contact, const tp_lattice *lattice);

#endif
