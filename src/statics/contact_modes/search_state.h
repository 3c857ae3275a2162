/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The node that a branch and bound is at, and by which changes it came to be: so that they can be
 * taken back, and a refutation be told of the node as it was before them. */

#ifndef TP_CONTACT_MODES_SEARCH_STATE_H
#define TP_CONTACT_MODES_SEARCH_STATE_H

#include "contact_modes/nogoods.h"

/* Why a contact has fewer modes: it was decided so; the blocks that it joins are at rest; else a
 * nogood, by its number. */
enum { TP_REASON_DECIDED = -1, TP_REASON_REST = -2 };

typedef struct tp_search_change {
  long contact, block; /* of the two one is changed, the other is -1 */
  tp_mode_set gone, gone_of_twin;
  long reason;
} tp_search_change;

typedef struct tp_search_state {
  const tp_resting *resting;
  tp_modes_node node;
  long count;
  tp_search_change *changes;
  long told;  /* changes that nogoods were asked about */
  long asked; /* nogoods that were asked about the node itself */
} tp_search_state;

/* All modes of all contacts; blocks of which `still` is true are at rest. False when memory is
 * exhausted. */
TP_MUST_USE bool tp_search_state_init(tp_search_state *state, const tp_resting *resting,
                                      const bool *still);
void tp_search_state_clear(tp_search_state *state);

/* No more than these are left to a contact, of a pair of corners to its first side and its twin.
 * True where that takes any. */
bool tp_search_narrow(tp_search_state *state, long contact, tp_mode_set own, tp_mode_set of_twin,
                      long reason);
void tp_search_rest(tp_search_state *state, long block);

/* Take back all changes but the first `mark`. */
void tp_search_undo(tp_search_state *state, long mark);

/* The same, with a refuted node that the state is part of, which afterwards is one of the state as
 * it was then, whatever followed from it since. */
void tp_search_explain(tp_modes_node *refuted, tp_search_state *state, tp_nogoods *nogoods,
                       long mark);

#endif
