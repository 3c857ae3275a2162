/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What exclusions of motions of the same blocks have found, for those of other loads and of other
 * friction: the proofs, and how the searches divided their nodes. A proof is never taken as it is:
 * its multipliers are evaluated with bounds for the question at hand, or its program is solved
 * again, and what that refutes is known. */

#ifndef TP_CONTACT_MODES_KNOWN_PROOFS_H
#define TP_CONTACT_MODES_KNOWN_PROOFS_H

#include "contact_modes/forces_proof.h"
#include "contact_modes/nogoods.h"
#include "contact_modes/search_tree.h"

/* A proof by forces, or by reactions where it has none of its own. */
typedef struct tp_known_proof {
  bool by_forces;
  tp_modes_node node; /* by forces what it was found for, by reactions what it refutes */
  tp_bearing_reactions reactions;
  double *factors, share;
  bool was_asked; /* for the search at hand; else it was found by that */
  long nogood;    /* and is this one there; -1: none */
} tp_known_proof;

typedef struct tp_known_proofs {
  const tp_resting *resting;
  long count, room;
  tp_known_proof *all;
  tp_search_tree tree;
  /* By number of a free block: the tree of the blocks that it is the first of, as the last search
   * left it, and as the last one that proved it did; -1: none. */
  long *root, *proven_root;
} tp_known_proofs;

TP_MUST_USE tp_status tp_known_proofs_init(tp_known_proofs *known, const tp_resting *resting,
                                           tp_message *message);
void tp_known_proofs_clear(tp_known_proofs *known);

/* All that another one has, into an empty one. Where memory is exhausted it is less. */
void tp_known_proofs_copy(tp_known_proofs *known, const tp_known_proofs *from);

/* `known` may be NULL. Where memory is exhausted nothing is kept. */
void tp_known_proofs_add_forces(tp_known_proofs *known, const tp_forces_proof *proof);
void tp_known_proofs_add_reactions(tp_known_proofs *known, const tp_modes_node *refuted);

/* Keep no more than those that the nogoods of a search that has ended needed, and that it found. */
void tp_known_proofs_keep_used(tp_known_proofs *known, const tp_nogoods *nogoods);

/* How a search of some blocks ended: what it told of its first node, steps in the tree. */
typedef enum tp_search_end { TP_SEARCH_PROVEN, TP_SEARCH_LEFT, TP_SEARCH_SPENT } tp_search_end;
void tp_known_proofs_end(tp_known_proofs *known, long first_block, tp_search_end end, long told);

#endif
