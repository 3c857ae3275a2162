/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What two salient corners that meet can do as a motion begins.
 *
 * With n and n' the normals of the two sides of the pair (assemblage/corner_pairs.h), as they open,
 * the corners do not enter each other where u_n >= 0 or u_n' >= 0: one of both is enough, so that
 * what they allow is no convex cone. It is five parts, of which each is one:
 *
 *     the first side opens            u_n >= 0                no force
 *     the second side opens           u_n' >= 0               no force
 *     they stick                      u = 0                   any of both cones, and of all between
 *     they slip along the first edge  u_n = 0, u_t >= 0       N (n - t tan(phi))
 *     along the second edge           u_n' = 0, u_t' <= 0     N (n' + t' tan(phi'))
 *
 * A corner that slips along the line of an edge the other way parts from it. A rounding of the
 * corners, however small, has one normal between n and n' at each of its points: so while they
 * stick a force can have any direction from n turned outwards by phi to n' turned outwards by phi'.
 * Where these are more than 180 degrees apart that is any force at all, the sum of four.
 *
 * The set of the first side has the first part (open), sticking and the first slip (forward); that
 * of the second side its own opening and slip (back). So the pair does what one of them says where
 * the other is empty; where neither is, nothing is known of its velocities. */

#ifndef TP_CONTACT_MODES_CORNER_MODES_H
#define TP_CONTACT_MODES_CORNER_MODES_H

#include "contact_modes/mode_set.h"
#include "contact_modes/resting.h"

enum { TP_MODES_OF_FIRST_SIDE = 1 + 2 + 4, TP_MODES_OF_SECOND_SIDE = 1 + 8 };

/* Of all contacts: those that it begins with. */
static inline tp_mode_set tp_modes_of_contact(const tp_resting *r, long contact) {
  const tp_resting_contact *c = r->contacts + contact;
  if (c->twin < 0) return tp_modes_all(c->ends);
  return c->twin > contact ? TP_MODES_OF_FIRST_SIDE : TP_MODES_OF_SECOND_SIDE;
}

/* Is it the second side of a pair? */
static inline bool tp_modes_is_second_side(const tp_resting *r, long contact) {
  return r->contacts[contact].twin >= 0 && r->contacts[contact].twin < contact;
}

/* Do the blocks do what the set of this contact says? */
static inline bool tp_modes_is_told(const tp_mode_set *sets, const tp_resting *r, long contact) {
  return r->contacts[contact].twin < 0 || sets[r->contacts[contact].twin] == 0;
}

/* Modes by which it can bear something: a second side also where the pair sticks. */
static inline tp_mode_set tp_modes_bearing(const tp_mode_set *sets, const tp_resting *r,
                                           long contact) {
  if (!tp_modes_is_second_side(r, contact)) return sets[contact];
  return sets[contact] | (sets[r->contacts[contact].twin] & TP_MODES_STICK);
}

/* Is there no more than one mode left, of both sides? */
static inline bool tp_modes_is_settled(const tp_mode_set *sets, const tp_resting *r, long contact) {
  const long twin = r->contacts[contact].twin;
  if (twin < 0) return tp_modes_is_one(sets[contact]);
  return sets[contact] == 0 ? tp_modes_is_one(sets[twin])
                            : sets[twin] == 0 && tp_modes_is_one(sets[contact]);
}

#endif
