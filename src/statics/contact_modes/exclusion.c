/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Depth first, with probing. Each contact of a block that is not at rest could be divided: whether
 * it sticks at both ends, slips forward, slips back, or opens; then by which ends are closed. Parts
 * that are refuted are left out for good, whatever is divided in the end. Where one part is left,
 * it is so; else the contact of the fewest parts is divided. Each refutation becomes a nogood, of
 * the node as it was divided, so that no branch repeats what another has found. Blocks that do not
 * touch, but by ground, move whatever the others do: each group of those that do is taken by
 * itself, with the others at rest. */

#include "contact_modes/exclusion.h"

#include "contact_modes/contact_parts.h"
#include "contact_modes/corner_modes.h"
#include "contact_modes/refutation.h"
#include "contact_modes/settling.h"

#include <stdlib.h>

typedef struct branching {
  const tp_modes_question *q;
  tp_exclusion *of;
  tp_search_state state;
  tp_nogoods nogoods;
  tp_relaxed_motions relaxed;
  tp_modes_node refuted;  /* of which the state was part when it was refuted last */
  tp_modes_finding found; /* the same, and why programs do not refute it */
} branching;

static bool is_spent(const branching *b) {
  return b->of->work > b->of->most_work;
}

static bool settle(branching *b) {
  return tp_search_settle(&b->refuted, &b->of->work, &b->state, &b->nogoods);
}

/* By linear programs, but where a relaxed motion shows that they would be in vain. It does so in
 * doubles: a node that can be divided no more is asked for in any case. */
static tp_status refute_by_programs(bool *refuted, branching *b, bool in_any_case,
                                    tp_message *message) {
  const tp_modes_node *own = &b->state.node;
  long *work = &b->of->work;
  tp_status status = TP_OK;
  *refuted = false;
  if (in_any_case || !tp_relaxed_motions_have(&b->relaxed, TP_RELAXED_BY_FORCES, work, own)) {
    status = tp_modes_refute_by_forces(refuted, &b->found, work, own, b->q, message);
  }
  if (status != TP_OK || *refuted) return status;
  if (!in_any_case && tp_relaxed_motions_have(&b->relaxed, TP_RELAXED_DRIVEN, work, own)) {
    return TP_OK;
  }
  return tp_modes_refute_by_reactions(refuted, &b->found, work, own, b->q, message);
}

/* By what follows from it at once, else by linear programs. */
static tp_status refute(bool *refuted, branching *b, tp_message *message) {
  *refuted = !settle(b);
  return *refuted ? TP_OK : refute_by_programs(refuted, b, false, message);
}

/* ---- parts -------------------------------------------------------------------------------------
 */

static void take(branching *b, const tp_contact_parts *of, int part) {
  tp_search_narrow(&b->state, of->contact, of->own[part], of->of_twin[part], TP_REASON_DECIDED);
}

/* A part of a contact is refuted, and the state as it was before is at hand. True where all of that
 * is refuted with it, or by what follows. */
static tp_status leave_out(bool *refuted, branching *b, long contact, tp_message *message) {
  const tp_mode_set *sets = b->state.node.sets, *of = b->refuted.sets;
  const long twin = b->q->resting->contacts[contact].twin;
  *refuted = (sets[contact] & ~of[contact]) == 0 && (twin < 0 || (sets[twin] & ~of[twin]) == 0);
  const tp_status status = tp_nogoods_add(&b->nogoods, &b->refuted, message);
  if (status == TP_OK && !*refuted) *refuted = !settle(b);
  return status;
}

/* Is this part still among the modes of its contact? */
static bool is_left(const tp_modes_node *n, const tp_contact_parts *of, int part) {
  return (n->sets[of->contact] & of->own[part]) != 0 ||
         (of->twin >= 0 && (n->sets[of->twin] & of->of_twin[part]) != 0);
}

/* How many parts of a contact are not refuted, and their modes; no more than `most` are counted. */
typedef struct division {
  int count;
  long modes;
} division;

static tp_status divide(division *d, bool *refuted, branching *b, long contact, int most,
                        tp_message *message) {
  const tp_contact_parts of = tp_contact_parts_of(&b->state.node, b->q->resting, contact);
  tp_status status = TP_OK;
  *d = (division){.count = 0};
  *refuted = false;
  for (int k = of.count - 1; k >= 0 && status == TP_OK && !*refuted && d->count <= most; k--) {
    const long mark = b->state.count;
    if (!is_left(&b->state.node, &of, k)) continue;
    bool gone = false;
    take(b, &of, k);
    const long decided = b->state.count;
    status = refute(&gone, b, message);
    if (gone)
      tp_search_explain(&b->refuted, &b->state, &b->nogoods, decided);
    else
      d->modes += tp_modes_node_count(&b->state.node, b->q->resting);
    tp_search_undo(&b->state, mark);
    if (gone && status == TP_OK)
      status = leave_out(refuted, b, contact, message);
    else
      d->count++;
  }
  return status;
}

/* ---- the tree ----------------------------------------------------------------------------------
 */

/* A pair of corners by its first side. */
static bool can_divide(const tp_modes_node *n, const tp_resting *r, long contact) {
  const long *row = r->contacts[contact].along.row;
  return !(tp_modes_rests(n, row[0]) && tp_modes_rests(n, row[1])) &&
         !tp_modes_is_settled(n->sets, r, contact) && !tp_modes_is_second_side(r, contact);
}

/* Of a pair: past which side it opens is not asked until nothing else is left to ask. */
static bool is_asked_last(const tp_modes_node *n, const tp_resting *r, long contact) {
  const long twin = r->contacts[contact].twin;
  return twin >= 0 && can_divide(n, r, contact) &&
         ((n->sets[contact] | n->sets[twin]) & ~(tp_mode_set)TP_MODES_OPEN) == 0;
}

static bool is_asked_first(const tp_modes_node *n, const tp_resting *r, long contact) {
  return can_divide(n, r, contact) && !is_asked_last(n, r, contact);
}

typedef bool candidate(const tp_modes_node *n, const tp_resting *r, long contact);

/* The contact of the fewest parts of all candidates, and of those the one that leaves the fewest
 * modes; -1: there is none. From the first again where one part is left of one. */
static tp_status probe(long *best, bool *refuted, branching *b, candidate *is_asked,
                       tp_message *message) {
  enum { MANY = TP_MOST_PARTS + 1 };
  const tp_resting *r = b->q->resting;
  tp_status status = TP_OK;
  division fewest = {.count = MANY};
  *best = -1;
  for (long k = 0; k < r->contact_count && status == TP_OK && !*refuted && !is_spent(b); k++) {
    if (!is_asked(&b->state.node, r, k)) continue;
    division own;
    status = divide(&own, refuted, b, k, fewest.count, message);
    if (own.count < fewest.count || (own.count == fewest.count && own.modes < fewest.modes)) {
      fewest = own;
      *best = k;
    }
    if (own.count > 1) continue;
    fewest = (division){.count = MANY};
    *best = -1;
    k = -1;
  }
  return status;
}

/* A side of a pair of which nothing is left bears nothing. */
static void leave(tp_exclusion *e, const tp_modes_node *n, const tp_resting *r) {
  for (long k = 0; k < r->contact_count; k++) {
    e->left[k] = n->sets[k] != 0 ? n->sets[k] : TP_MODES_OPEN;
  }
}

/* All have one mode. */
static tp_status exclude_one_mode(bool *refuted, branching *b, tp_message *message) {
  const tp_status status = refute_by_programs(refuted, b, true, message);
  if (status != TP_OK || *refuted) return status;
  b->of->has_left = true;
  leave(b->of, &b->state.node, b->q->resting);
  return TP_OK;
}

static tp_status exclude(bool *refuted, branching *b, tp_message *message);

/* Part by part; each refutation may be of more. */
static tp_status exclude_parts(bool *refuted, branching *b, long contact, tp_message *message) {
  const tp_contact_parts of = tp_contact_parts_of(&b->state.node, b->q->resting, contact);
  tp_status status = TP_OK;
  bool goes_on = true;
  for (int k = 0; k < of.count && status == TP_OK && goes_on && !*refuted; k++) {
    const long mark = b->state.count;
    if (!is_left(&b->state.node, &of, k)) continue;
    const long known = b->nogoods.count;
    take(b, &of, k);
    status = exclude(&goes_on, b, message);
    tp_search_undo(&b->state, mark);
    b->state.asked = known; /* what the others say of the node as it is now */
    if (status == TP_OK && goes_on) status = leave_out(refuted, b, contact, message);
  }
  return status;
}

/* The state as it is. */
static tp_status exclude(bool *refuted, branching *b, tp_message *message) {
  const long mark = b->state.count;
  candidate *const asked[] = {is_asked_first, is_asked_last};
  long contact = -1;
  tp_status status = TP_OK;
  *refuted = !settle(b);
  for (int k = 0; k < 2 && contact < 0 && status == TP_OK && !*refuted; k++) {
    status = probe(&contact, refuted, b, asked[k], message);
  }
  if (status == TP_OK && !*refuted && !is_spent(b)) {
    status = contact >= 0 ? exclude_parts(refuted, b, contact, message)
                          : exclude_one_mode(refuted, b, message);
  }
  if (*refuted) tp_search_explain(&b->refuted, &b->state, &b->nogoods, mark);
  tp_search_undo(&b->state, mark);
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

/* Of one group, with the others at rest. */
static tp_status exclude_group(bool *proven, tp_exclusion *e, const tp_modes_question *q,
                               const bool *others, tp_message *message) {
  branching b = {.q = q, .of = e};
  const bool made = tp_nogoods_init(&b.nogoods, q->resting) &&
                    tp_search_state_init(&b.state, q->resting, others) &&
                    tp_relaxed_motions_init(&b.relaxed, q) &&
                    tp_modes_node_init(&b.refuted, q->resting);
  b.found = (tp_modes_finding){.refuted = &b.refuted, .relaxed = &b.relaxed};
  tp_status status = made ? refute(proven, &b, message) : tp_fail_memory(message, "a proof");
  if (status == TP_OK && !*proven && !is_spent(&b)) status = exclude(proven, &b, message);
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
    status = exclude_group(&proven, e, q, others, message);
  }
  free(group);
  free(others);
  e->is_proven = status == TP_OK && proven;
  return status;
}
