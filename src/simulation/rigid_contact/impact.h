/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* An impact: of all contacts that touch each gets an impulse within its cone of friction, so that
 * those that closed leave with `restitution` times the speed at which they did (Newton), the others
 * do not close, and friction impulses go against the slip that is left, or leave none (the law of
 * rigid_contact/law.h, for speeds).
 *
 * With restitution 0 the kinetic energy cannot grow: it changes by p . v+ - p M^-1 p / 2, where
 * p . v+ <= 0. With friction and restitution it could (Stronge, Impact Mechanics, 2000, chapter 3);
 * then the restitution of this impact is the largest at which it does not, found by halving. Of
 * several solutions the one that keeps most energy is taken: the worst for the block. */

#ifndef TP_RIGID_CONTACT_IMPACT_H
#define TP_RIGID_CONTACT_IMPACT_H

#include "rigid_contact/touching.h"

typedef struct tp_impact {
  double speed[3];    /* after it */
  double energy_lost; /* over weight and extent; not below zero but for rounding */
  double restitution; /* that was used */
} tp_impact;

/* False where the law has no solution within rounding: the speeds stay then. */
bool tp_impact_find(tp_impact *impact, tp_touching *touching, const tp_contact_system *system,
                    const tp_motion_state *state, double restitution);

/* Without any approach: where no forces go with a slip (Painleve), impulses stop it. Of several
 * solutions, one of which is that nothing happens, the one that keeps least energy. */
bool tp_impact_jam(tp_impact *impact, tp_touching *touching, const tp_contact_system *system,
                   const tp_motion_state *state);

#endif
