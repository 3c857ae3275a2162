/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Two proofs that no motion has modes of the sets of a node.
 *
 * Of a motion, a^T M a = w . a + (work of the forces) <= w . a. Let K be the cone of accelerations
 * that the sets allow, F that of forces, both closed.
 *   Reactions: w + A c = 0 with c . u >= 0 on K gives w . a <= 0, so that a = 0. Of a contact, c is
 * any compression of its ends, any normal force of those that are closed, a shear in the direction
 * of a slip that is certain, and any shear where it sticks.
 *   Forces: with such c, s >= 0 and y = M^-1 (A c + s w), e . y <= 0 for each edge e of F and
 * w . y + C (t . y) < 0 for all shears C of cohesion that the sets allow (that of a joint does no
 * work but against its slip). Newton's law gives s w . a + c . u = y . M a = w . y + f . A^T y + C
 * (t . y) < 0: with c . u >= 0 and w . a >= 0 that cannot be. Bonds are part of w, as the pull of
 * all of them. Where a joint stays closed at both ends it may pull by less, and elsewhere
 * (contact_modes/bond_pull.h): that does no work, so that w . a is the same, and w . y < 0 is asked
 * for each such pull instead of that in w. Blocks at rest, joined to the ground by contacts
 * that only stick or that leave no velocity, take no part. Friction and cohesion may be anything
 * between two numbers, and the loads anything between two: each proof is of all of that. */

#ifndef TP_CONTACT_MODES_REFUTATION_H
#define TP_CONTACT_MODES_REFUTATION_H

#include "contact_modes/known_proofs.h"
#include "contact_modes/relaxed_motions.h"

/* What a proof tells besides: where it refutes a node, the widest that it refutes, and the proof
 * itself; where it does not, why. */
typedef struct tp_modes_finding {
  tp_modes_node *refuted;
  tp_relaxed_motions *relaxed;
  tp_known_proofs *known; /* or NULL */
  bool is_last;           /* the node can be divided no more: it is asked of fewer blocks too */
} tp_modes_finding;

/* `finding` may be NULL; `work` grows by what it took. */
TP_MUST_USE tp_status tp_modes_refute_by_reactions(bool *refuted, const tp_modes_finding *finding,
                                                   long *work, const tp_modes_node *node,
                                                   const tp_modes_question *question,
                                                   tp_message *message);
TP_MUST_USE tp_status tp_modes_refute_by_forces(bool *refuted, const tp_modes_finding *finding,
                                                long *work, const tp_modes_node *node,
                                                const tp_modes_question *question,
                                                tp_message *message);

#endif
