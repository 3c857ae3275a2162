/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Is every motion of a solid on few contact points excluded, in three dimensions, as it is let go?
 *
 * Accelerations a of a body at rest have M a = w + sum of contact forces; contacts open, stick or
 * slip (mode_cones.h). The forces of a motion do no work above zero on it, so that a . M a <= w .
 * a: a motion needs w . a > 0. Contacts are given their modes one after the other, and sectors of
 * slips are halved. Of each set of modes the greatest w . a is a linear program; it is no more than
 * zero, and the set is excluded, where some y = C (w + sum of z rows) has z >= 0 for each row n . a
 * >= 0 that the modes ask for, any z for each row that they ask to be zero, y . f <= 0 for each
 * force f, and y . w <= 0:
 *
 *     w . a = y . M a - sum of z row . a <= y . (w + sum of f) <= 0.
 *
 * Two loads w1 and w2 are a stretch: for all loads between them w1 . a and w2 . a are bounded so,
 * each by a y of its own with y . w1 <= 0 and y . w2 <= 0. Strengths are a stretch from mu to mu
 * over a divisor. No motion begins at any load and any strength of these stretches.
 *
 * The program runs in doubles and names the z that are not zero, and the forces that y does no work
 * on. That is proven for the true body and loads (mode_claim.h).
 *
 * That it ends without a proof says nothing: near an onset sectors would have to be narrower than
 * they become, and with more than some eight contacts there are too many sets. */

#ifndef TP_SOLID_CONTACTS_SOLID_EXCLUSION_H
#define TP_SOLID_CONTACTS_SOLID_EXCLUSION_H

#include "solid_contacts/hold_load.h"

typedef struct tp_solid_exclusion {
  const tp_friction_cones *cones;
  const fmpq *inertia; /* as mode_cones.h has it */
  tp_hold_load
      loads[2]; /* at the centroid, from the one to the other; or both the same; borrowed */
  const tp_hold_load *way; /* along which they differ, or NULL */
  double divisor;          /* of mu, from one to this */
  long most;               /* programs; less by those that were solved */
  bool is_excluded;        /* the answer */
} tp_solid_exclusion;

/* False when memory is exhausted. */
TP_MUST_USE bool tp_solid_exclusion_find(tp_solid_exclusion *exclusion);

#endif
