/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Depth first: each node is divided by a contact (contact_modes/probing.h), or as the search of a
 * question like this one divided it, whose proofs are renewed first: then programs are solved only
 * where these no longer are proofs. Blocks that do not touch, but by ground, move whatever the
 * others do: each group of those that do is taken by itself, with the others at rest. */

#include "contact_modes/exclusion.h"

#include "contact_modes/contact_parts.h"
#include "contact_modes/probing.h"
#include "contact_modes/renewing.h"

#include <stdlib.h>

/* A side of a pair of which nothing is left bears nothing. */
static void leave(tp_branching *b) {
  const tp_mode_set *sets = b->state.node.sets;
  b->has_left = true;
  for (long k = 0; k < b->q->resting->contact_count; k++) {
    b->left[k] = sets[k] != 0 ? sets[k] : TP_MODES_OPEN;
  }
}

/* All have one mode. */
static tp_status exclude_one_mode(bool *refuted, tp_branching *b, tp_message *message) {
  const tp_status status = tp_branching_refute_mode(refuted, b, message);
  if (status != TP_OK || *refuted) return status;
  leave(b);
  return TP_OK;
}

/* ---- as it was divided before ------------------------------------------------------------------
 */

/* Where to go on: the contact that is divided; from which step on it was before, -1: it was not. */
typedef struct guide {
  long contact, parts;
} guide;

/* Of what is not reached the next search is told what is known. */
static void tell_rest(tp_branching *b, long step) {
  const tp_search_tree *tree = &b->found.known->tree;
  for (long k = step; k >= 0; k = tree->steps[k].next) {
    const tp_tree_step own = tree->steps[k];
    const tp_contact_part part = {own.contact, own.own, own.of_twin};
    tp_branching_tell(b, &part, own.is_part, own.child);
  }
}

/* What was left out is tried again. */
static tp_status follow(guide *g, bool *refuted, tp_branching *b, long step, tp_message *message) {
  tp_status status = TP_OK;
  long at = step;
  while (at >= 0 && status == TP_OK && !*refuted && !tp_branching_is_spent(b)) {
    const tp_tree_step own = b->found.known->tree.steps[at];
    const tp_contact_part part = {own.contact, own.own, own.of_twin};
    if (own.is_part) break;
    bool gone = false;
    long modes = 0;
    at = own.next;
    if (!tp_probing_can_divide(&b->state.node, b->q->resting, own.contact)) continue;
    if (!tp_branching_has(b, &part)) continue;
    status = tp_branching_try(&gone, refuted, &modes, b, &part, message);
  }
  if (at < 0 || *refuted || status != TP_OK) return status;
  if (tp_branching_is_spent(b)) {
    tell_rest(b, at);
    return status;
  }
  const long contact = b->found.known->tree.steps[at].contact;
  if (tp_probing_can_divide(&b->state.node, b->q->resting, contact)) *g = (guide){contact, at};
  return status;
}

/* ---- the tree ----------------------------------------------------------------------------------
 */

static tp_status exclude(bool *refuted, tp_tree_node *told, tp_branching *b, long step,
                         tp_message *message);

/* The step of a part as it was divided before; -1: it was not. */
static long step_of(const tp_branching *b, const guide *g, const tp_contact_part *p) {
  return g->parts < 0 ? -1
                      : tp_search_tree_part(&b->found.known->tree, g->parts, p->own, p->of_twin);
}

/* A part that was refuted as it was is tried so first. */
static tp_status exclude_part(bool *goes_on, bool *refuted, tp_branching *b, const guide *g,
                              const tp_contact_part *p, tp_message *message) {
  const long known = b->nogoods.count, mark = b->state.count, before = step_of(b, g, p);
  const long child = before < 0 ? -1 : b->found.known->tree.steps[before].child;
  tp_tree_node told = {-1, -1};
  tp_status status = TP_OK;
  if (before >= 0 && child < 0) {
    long modes = 0;
    bool gone = false;
    status = tp_branching_try(&gone, refuted, &modes, b, p, message);
    if (status != TP_OK || gone) return status;
  }
  tp_branching_take(b, p);
  status = exclude(goes_on, &told, b, child, message);
  tp_search_undo(&b->state, mark);
  b->state.asked = known; /* what the others say of the node as it is now */
  tp_branching_tell(b, p, true, told.first);
  if (status != TP_OK || !*goes_on) return status;
  return tp_branching_leave_out(refuted, b, p->contact, message);
}

/* Part by part; each refutation may be of more. */
static tp_status exclude_parts(bool *refuted, tp_branching *b, const guide *g,
                               tp_message *message) {
  const tp_contact_parts of = tp_contact_parts_of(&b->state.node, b->q->resting, g->contact);
  tp_status status = TP_OK;
  bool goes_on = true;
  for (int k = 0; k < of.count && status == TP_OK && !*refuted; k++) {
    const tp_contact_part part = {g->contact, of.own[k], of.of_twin[k]};
    if (!tp_branching_has(b, &part)) continue;
    if (goes_on) {
      status = exclude_part(&goes_on, refuted, b, g, &part, message);
      continue;
    }
    const long before = step_of(b, g, &part);
    if (before >= 0) tp_branching_tell(b, &part, true, b->found.known->tree.steps[before].child);
  }
  return status;
}

/* The state as it is; `step` is the first of the node as it was divided before, or -1. */
static tp_status exclude(bool *refuted, tp_tree_node *told, tp_branching *b, long step,
                         tp_message *message) {
  const long mark = b->state.count;
  tp_tree_node *const above = b->told;
  guide g = {-1, -1};
  b->told = told;
  *refuted = !tp_branching_settle(b);
  tp_status status = *refuted ? TP_OK : follow(&g, refuted, b, step, message);
  if (status == TP_OK && !*refuted && g.contact < 0 && !tp_branching_is_spent(b)) {
    status = tp_probing_find(&g.contact, refuted, b, message);
  }
  if (status == TP_OK && !*refuted && !tp_branching_is_spent(b)) {
    status = g.contact >= 0 ? exclude_parts(refuted, b, &g, message)
                            : exclude_one_mode(refuted, b, message);
  }
  if (*refuted) tp_search_explain(&b->refuted, &b->state, &b->nogoods, mark);
  tp_search_undo(&b->state, mark);
  b->told = above;
  return status;
}

/* By number of a free block: the least of those that it touches, and that these touch. */
static void find_groups(long *group, const tp_resting *r) {
  for (long b = 0; b < r->rows / 3; b++) group[b] = b;
  for (bool changed = true; changed;) {
    changed = false;
    for (long k = 0; k < r->contact_count; k++) {
      const long *row = r->contacts[k].along.row;
      if (row[0] < 0 || row[1] < 0 || group[row[0] / 3] == group[row[1] / 3]) continue;
      const long one = group[row[0] / 3], other = group[row[1] / 3];
      group[row[0] / 3] = group[row[1] / 3] = one < other ? one : other;
      changed = true;
    }
  }
}

tp_status tp_exclusion_frictionless(bool *proven, long *work, const tp_modes_question *q,
                                    tp_message *message) {
  tp_modes_node root;
  if (!tp_modes_node_init(&root, q->resting)) return tp_fail_memory(message, "a proof");
  const tp_status status = tp_modes_refute_by_reactions(proven, NULL, work, &root, q, message);
  tp_modes_node_clear(&root);
  return status;
}

/* By what is known, else from nothing. So too where a mode is left of nodes as they were divided
 * before: a proof may be of a node at once, and of none of such parts by itself. */
static tp_status search(bool *proven, tp_branching *b, long first_block, const bool *others,
                        tp_message *message) {
  tp_known_proofs *known = b->found.known;
  const long before = known != NULL ? known->root[first_block] : -1;
  tp_tree_node told = {-1, -1};
  tp_status status = TP_OK;
  if (known != NULL) {
    status = tp_known_proofs_renew(known, &b->nogoods, &b->refuted, b->work, b->most_work, b->q,
                                   others, message);
  }
  if (status == TP_OK && before < 0) status = tp_branching_refute(proven, b, message);
  if (status == TP_OK && !*proven && !tp_branching_is_spent(b)) {
    status = exclude(proven, &told, b, before, message);
  }
  if (status == TP_OK && b->has_left && before >= 0 && !tp_branching_is_spent(b)) {
    b->has_left = false;
    told = (tp_tree_node){-1, -1};
    status = exclude(proven, &told, b, -1, message);
  }
  if (known == NULL || status != TP_OK) return status;
  if (*proven) tp_known_proofs_keep_used(known, &b->nogoods);
  const tp_search_end end = *proven       ? TP_SEARCH_PROVEN
                            : b->has_left ? TP_SEARCH_LEFT
                                          : TP_SEARCH_SPENT;
  if (*proven || told.first >= 0) tp_known_proofs_end(known, first_block, end, told.first);
  return status;
}

/* Of one group, with the others at rest. */
static tp_status exclude_group(bool *proven, tp_exclusion *e, const tp_modes_question *q,
                               long first_block, const bool *others, tp_message *message) {
  tp_branching b = {.q = q, .work = &e->work, .most_work = e->most_work, .left = e->left};
  const bool made = tp_nogoods_init(&b.nogoods, q->resting) &&
                    tp_search_state_init(&b.state, q->resting, others) &&
                    tp_relaxed_motions_init(&b.relaxed, q) &&
                    tp_modes_node_init(&b.refuted, q->resting);
  b.found = (tp_modes_finding){.refuted = &b.refuted, .relaxed = &b.relaxed, .known = e->known};
  *proven = false;
  const tp_status status =
      made ? search(proven, &b, first_block, others, message) : tp_fail_memory(message, "a proof");
  e->has_left = b.has_left;
  tp_search_state_clear(&b.state);
  tp_modes_node_clear(&b.refuted);
  tp_nogoods_clear(&b.nogoods);
  tp_relaxed_motions_clear(&b.relaxed);
  return status;
}

tp_status tp_exclusion_find(tp_exclusion *e, const tp_modes_question *q, tp_message *message) {
  const long count = q->resting->rows / 3;
  long *group = calloc((size_t)count + 1, sizeof *group);
  bool *others = calloc((size_t)count + 1, sizeof *others);
  tp_status status = group != NULL && others != NULL ? TP_OK : tp_fail_memory(message, "a proof");
  bool proven = true;
  e->is_proven = e->has_left = false;
  if (status == TP_OK) find_groups(group, q->resting);
  for (long k = 0; k < count && proven && status == TP_OK; k++) {
    if (group[k] != k) continue;
    for (long b = 0; b < count; b++) others[b] = group[b] != k;
    status = exclude_group(&proven, e, q, k, others, message);
  }
  free(group);
  free(others);
  e->is_proven = status == TP_OK && proven;
  return status;
}
