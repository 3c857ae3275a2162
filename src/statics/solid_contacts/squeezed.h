/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Pairs of contacts that opposite forces on the line between them squeeze, exactly.
 *
 * Problem: in a groove whose half-angle eta has tan(eta) = tan(phi), two opposite contacts can
 * press against each other along an edge of both cones of friction, with forces of any size. The
 * loads that are held are then no closed set, and proofs by doubles with bounds leave the limit
 * open.
 *
 * Method: a pair of forces f at r_i and -f at r_j, f along r_j - r_i and each in its cone, has no
 * resultant; where both points are one, for any f. A motion that no contact resists does no work
 * below zero on either, and none on both together: so none on each. Where f is within the cone, the
 * point does not move; where it is on the edge, the point moves along m = |f|^2 n - (n . f) f
 * alone, away from the contact; without friction it moves across n. The motions that satisfy these
 * equations are a polyhedral cone. No load that gains nothing on any of its rays leaves the closure
 * of what is held. A load that forces within all cones hold is inside; so load + t way is held for
 * every t below the least at which a ray gains, and beyond it that ray moves the solid. All in
 * rational numbers, and within the errors of the loads: a gain whose sign these leave open leaves
 * the limit open.
 *
 * tan(phi) of a rational angle in degrees is rational at 0 and 45 degrees alone (Niven), where the
 * cone's friction has no error. */

#ifndef TP_SOLID_CONTACTS_SQUEEZED_H
#define TP_SOLID_CONTACTS_SQUEEZED_H

#include "solid_contacts/hold_load.h"

typedef struct tp_squeezed_limit {
  bool is_known;
  bool is_endless; /* if known */
  tp_near t;       /* if known and not endless */
  double twist[TP_WRENCH];
} tp_squeezed_limit;

/* Up to which t load + t way is held, where forces strictly within all cones hold the load. Not
 * known: a friction is no rational number, no pair is squeezed, or the cone of motions has more
 * than three dimensions. */
void tp_squeezed_find(tp_squeezed_limit *limit, const tp_friction_cones *cones,
                      const tp_hold_load *load, const tp_hold_load *way);

#endif
