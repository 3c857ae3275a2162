/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A branch and bound over what contacts do, as it stands at one of its nodes, and what is tried
 * there: whether the node is refuted, and whether a part of a contact is, which is then left out of
 * it for good. */

#ifndef TP_CONTACT_MODES_BRANCHING_H
#define TP_CONTACT_MODES_BRANCHING_H

#include "contact_modes/refutation.h"
#include "contact_modes/search_state.h"

typedef struct tp_branching {
  const tp_modes_question *q;
  long *work; /* so far, and the most of it */
  long most_work;
  tp_search_state state;
  tp_nogoods nogoods;
  tp_relaxed_motions relaxed;
  tp_modes_node refuted;  /* of which the state was part when it was refuted last */
  tp_modes_finding found; /* the same, and why programs do not refute it */
  tp_tree_node *told;     /* the node, as it is told to the next search */
  bool has_left;          /* one combination of modes is left: */
  tp_mode_set *left;      /* by contact */
} tp_branching;

/* Some modes of a contact, of a pair of corners of its first side and its twin. */
typedef struct tp_contact_part {
  long contact;
  tp_mode_set own, of_twin;
} tp_contact_part;

static inline bool tp_branching_is_spent(const tp_branching *b) {
  return *b->work > b->most_work;
}

/* What follows at once; false: nothing is left. */
bool tp_branching_settle(tp_branching *b);

/* By what follows from it at once, else by linear programs; of a node that can be divided no more,
 * by these in any case. */
TP_MUST_USE tp_status tp_branching_refute(bool *refuted, tp_branching *b, tp_message *message);
TP_MUST_USE tp_status tp_branching_refute_mode(bool *refuted, tp_branching *b, tp_message *message);

/* Is any of a part still among the modes of its contact? */
bool tp_branching_has(const tp_branching *b, const tp_contact_part *part);
/* Nothing else is. */
void tp_branching_take(tp_branching *b, const tp_contact_part *part);

/* A part of a contact is refuted, and the state as it was before is at hand. `refuted`: all of that
 * is refuted with it, or by what follows. */
TP_MUST_USE tp_status tp_branching_leave_out(bool *refuted, tp_branching *b, long contact,
                                             tp_message *message);

/* Is a part refuted? Then it is left out, and told; else how many `modes` are left of all. */
TP_MUST_USE tp_status tp_branching_try(bool *gone, bool *refuted, long *modes, tp_branching *b,
                                       const tp_contact_part *part, tp_message *message);

/* Told of the node: what was left out, or a part with its own node. */
void tp_branching_tell(tp_branching *b, const tp_contact_part *part, bool is_part, long child);

#endif
