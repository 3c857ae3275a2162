/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a search found is proven.
 *
 * Forces: a little of forces deep within their cones is mixed to those found; what is then missing
 * to equilibrium, in rational numbers, is solved for exactly by six of their components; by doubles
 * with bounds each force still lies in its true cone. So forces exist that hold the load.
 *
 * A motion: a little of one that goes away from all contacts is mixed to the twist found; by
 * doubles with bounds it does no negative work on any force of any true cone. The load, on which it
 * does positive work, moves the solid; and of load + t way with a gain on the way of one, t is at
 * most minus its gain on the load. */

#ifndef TP_SOLID_CONTACTS_HOLD_PROOF_H
#define TP_SOLID_CONTACTS_HOLD_PROOF_H

#include "solid_contacts/hold_load.h"

/* Forces and how far along the way they hold. */
typedef struct tp_held {
  double t;
  double (*forces)[3];
} tp_held;

/* Components that equilibrium is solved for, of the forces of some cones. */
typedef struct tp_hold_basis {
  int count;
  long cones[TP_WRENCH];
  int axes[TP_WRENCH]; /* -1: the normal, of a cone without friction */
} tp_hold_basis;

void tp_hold_basis_choose(tp_hold_basis *basis, const tp_friction_cones *cones);

/* Do forces hold load + t way, for a t near `found`, which is put into it, as are the forces? Where
 * `way` is NULL, the load. `share` is that of every mu. False when memory is exhausted. */
TP_MUST_USE bool tp_hold_prove_forces(bool *proven, tp_held *found, const tp_held *deep,
                                      const tp_friction_cones *cones, const tp_hold_basis *basis,
                                      tp_near share, const tp_hold_load *load,
                                      const tp_hold_load *way);

/* Is there a motion near the twist, which is put into it, that no contact resists? */
bool tp_hold_prove_motion(double twist[TP_WRENCH], const double apart[TP_WRENCH],
                          const tp_friction_cones *cones, tp_near share);

#endif
