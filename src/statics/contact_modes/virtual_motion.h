/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Is every motion of blocks at rest excluded? By a linear virtual motion v = L a: velocities of all
 * blocks that are linear in the accelerations a, such that, for every a with which no contact
 * closes up,
 *
 *  1. every contact force that can act with a does no work above zero on v,
 *  2. neither do the loads,
 *  3. and a . M v > 0, but for a = 0.
 *
 * Newton's law M a = w + forces, times v, leaves a = 0. The velocity of block b is
 *
 *     v_b = T a_b + sum over gaps m near b of H_bm g_m,
 *
 * with one T for all blocks and gaps g = G a >= 0; so the three are linear inequalities in T and H,
 * few for each contact, and their number grows as that of the blocks. They are solved in doubles
 * (linear_program/margins.h), and proven for that T and H with bounds. In the first column of T is
 * a slide of all blocks along the base, on which the loads do no work.
 *
 * Loads are weights alone, which one direction drives; all contacts have two ends, and no cohesion.
 * Where T and H exist is not known: a failure says nothing. */

#ifndef TP_CONTACT_MODES_VIRTUAL_MOTION_H
#define TP_CONTACT_MODES_VIRTUAL_MOTION_H

#include "contact_modes/arranged.h"
#include "contact_modes/node.h"

/* What a proof of the same blocks may leave out, as those before it did: so it takes a third. */
typedef struct tp_virtual_known {
  long count;
  bool *is_out;
} tp_virtual_known;

TP_MUST_USE bool tp_virtual_known_copy(tp_virtual_known *known, const tp_virtual_known *other);
void tp_virtual_known_clear(tp_virtual_known *known);

/* For any friction between the two of the question and any loads between its loads. */
TP_MUST_USE tp_status tp_virtual_motion_find(bool *proven, tp_virtual_known *known,
                                             const tp_arranged *arranged,
                                             const tp_modes_question *question,
                                             tp_message *message);

#endif
