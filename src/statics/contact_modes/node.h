/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A set of modes for each contact; what it says of accelerations and of forces; and two proofs that
 * no motion has modes of these sets.
 *
 * Of a motion, a^T M a = w . a + (work of the forces) <= w . a. Let K be the cone of accelerations
 * that the sets allow, F that of forces, both closed.
 *   Reactions: w + A c = 0 with c . u >= 0 on K gives w . a <= 0, so that a = 0. Of a contact, c is
 * any compression of its ends, any normal force of those that are closed, a shear in the direction
 * of a slip that is certain, and any shear where it sticks.
 *   Forces: with such c, s >= 0 and y = M^-1 (A c + s w), e . y <= 0 for each edge e of F and
 * w . y + C (t . y) < 0 for all shears C of cohesion that the sets allow (that of a joint does no
 * work but against its slip). Newton's law gives s w . a + c . u = y . M a = w . y + f . A^T y + C
 * (t . y) < 0: with c . u >= 0 and w . a >= 0 that cannot be. Tensile strength is part of w, as a
 * pull that the ends of a joint press against. Blocks at rest, joined to the ground by contacts
 * that only stick or that leave no velocity, take no part. Friction and cohesion may be anything
 * between two numbers, and the loads anything between two: each proof is of all of that. */

#ifndef TP_CONTACT_MODES_NODE_H
#define TP_CONTACT_MODES_NODE_H

#include "contact_modes/mode_set.h"
#include "contact_modes/resting.h"

typedef struct tp_modes_question {
  const tp_resting *resting;
  const tp_near *friction[2]; /* tan(phi) by contact: the least, the greatest */
  const tp_near *cohesion[2]; /* its force by contact: the least, the greatest */
  const tp_near *loads[2];    /* w by row */
  int load_count;             /* 1 or 2 */
} tp_modes_question;

typedef struct tp_modes_node {
  tp_mode_set *sets; /* by contact */
  bool *still;       /* by number of a free block: its acceleration is 0 */
} tp_modes_node;

/* Is a block, by its row, at rest or fixed? */
static inline bool tp_modes_rests(const tp_modes_node *node, long row) {
  return row < 0 || node->still[row / 3];
}

/* The two proofs; `work` grows by what they took. */
TP_MUST_USE tp_status tp_modes_refute_by_reactions(bool *refuted, long *work,
                                                   const tp_modes_node *node,
                                                   const tp_modes_question *question,
                                                   tp_message *message);
TP_MUST_USE tp_status tp_modes_refute_by_forces(bool *refuted, long *work,
                                                const tp_modes_node *node,
                                                const tp_modes_question *question,
                                                tp_message *message);

#endif
