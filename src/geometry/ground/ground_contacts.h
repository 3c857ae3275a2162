/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Where a rock and its ground, two surfaces on one lattice, are within a band of each other. All of
 * it is decided in whole numbers:
 *
 * - a corner of the rock over, or in, a face of the ground that it faces, of which no edge leads
 *   deeper behind that face's plane than the band: with the face's normal. On a plane these are all
 *   that are no higher over the lowest than the band, as a plane base has it;
 * - a corner of the ground that stands out against a face of the rock, all of the ground about it
 *   behind the plane through it along the face: with the normal of that face;
 * - an edge of the rock across an edge of the ground, both standing out: with the normal across
 *   both.
 *
 * "Over" is along the normal; the distance along it is at most the band. Corners and edges are
 * those of the relief, not of how it is cut into triangles. The contact is the point on the ground.
 * So with a larger band no contact is lost. A corner over an edge or a corner of the ground, off by
 * a gap, faces no one plane and is none: which holds less.
 *
 * Of contacts with one normal in one plane those are kept that are corners of their convex hull;
 * forces of the others are sums of forces at these. */

#ifndef TP_GROUND_GROUND_CONTACTS_H
#define TP_GROUND_GROUND_CONTACTS_H

#include "ground/relief.h"

typedef struct tp_ground_contact {
  fmpq at[3];      /* on the ground, as the surfaces' whole numbers */
  tp_whole normal; /* out of the ground, into the rock: no whole number divides all three */
  double gap;      /* from the ground to the rock along it, as the surfaces' doubles: below zero
                      where the rock is in the ground */
} tp_ground_contact;

typedef struct tp_ground_contacts {
  long count, room;
  tp_ground_contact *items;
  long found; /* before those within hulls of others were left out */
} tp_ground_contacts;

/* Within a band, in whole numbers of the lattice: 0 or more. False when memory is exhausted; to be
 * cleared also then. */
TP_MUST_USE bool tp_ground_contacts_find(tp_ground_contacts *contacts, const tp_relief *rock,
                                         const tp_relief *ground, const fmpq_t band);
void tp_ground_contacts_clear(tp_ground_contacts *contacts);

/* For the search alone: a contact to be filled, or NULL. */
tp_ground_contact *tp_ground_contacts_next(tp_ground_contacts *contacts);
/* Leaves out those within the hulls of others of one plane; in the order of normals, then places.
 */
TP_MUST_USE bool tp_ground_contacts_reduce(tp_ground_contacts *contacts);

#endif
