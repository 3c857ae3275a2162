/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The start of a run: the block set down on its springs, so that no drop shocks it.
 *
 * The weight and all loads grow from nothing at the table's angle at time 0, smoothly over twenty
 * periods of the shear springs, with strong local damping, dashpots of half the critical damping
 * beside the springs, and Coulomb's limit in force; then it waits until the block is quiet
 * (watch.h). That is the elastic settlement: no contact has carried much more than it does in the
 * end. How far the springs give on the way tells nothing: few that bear the block near its limit
 * may give a thousandth of its extent. Where the block accelerates for good instead, it has no
 * equilibrium there: it is released as it is placed, its springs without force, and the dashpots
 * keep it from bouncing through the first five periods of the shear springs; they resist no motion
 * but that of the springs. */

#ifndef TP_CONTACT_SPRINGS_SETTLEMENT_H
#define TP_CONTACT_SPRINGS_SETTLEMENT_H

#include "contact_springs/stepper.h"

typedef enum tp_settlement {
  TP_SETTLEMENT_REACHED,
  TP_SETTLEMENT_NONE,
  TP_SETTLEMENT_NO_MEMORY
} tp_settlement;

/* From the state where the run starts, at rest or not: one that moves is released. `share`: of the
 * stable step. The stepper is ready to be evaluated at time 0. */
TP_MUST_USE tp_settlement tp_stepper_settle(tp_stepper *stepper, const tp_body_state *start,
                                            double share);

/* Have the dashpots of a block that was released had their time? */
bool tp_stepper_is_past_letting_go(const tp_stepper *stepper);

#endif
