/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Depth first, with probing. Each contact of a block that is not at rest could be divided: whether
 * it sticks at both ends, slips forward, slips back, or opens; then by which ends are closed. Parts
 * that are refuted are left out for good, whatever is divided in the end. Where one part is left,
 * it is so; else the contact of the fewest parts is divided. Blocks that do not touch, but by
 * ground, move whatever the others do: each group of those that do is taken by itself, with the
 * others at rest. */

#include "contact_modes/exclusion.h"

#include "common/grow.h"
#include "contact_modes/contact_parts.h"
#include "contact_modes/corner_modes.h"
#include "contact_modes/settling.h"

#include <stdlib.h>
#include <string.h>

typedef struct branching {
  const tp_modes_question *q;
  tp_exclusion *of;
  tp_modes_node *waiting;
  long count, room;
  bool is_open; /* a part was left that is not excluded */
} branching;

static void clear_node(tp_modes_node *n) {
  free(n->sets);
  free(n->still);
}

static bool copy_node(tp_modes_node *own, const tp_modes_node *from, const tp_resting *r) {
  const size_t contacts = (size_t)r->contact_count, blocks = (size_t)r->rows / 3;
  own->sets = malloc((contacts + 1) * sizeof *own->sets);
  own->still = malloc((blocks + 1) * sizeof *own->still);
  if (own->sets == NULL || own->still == NULL) {
    clear_node(own);
    return false;
  }
  memcpy(own->sets, from->sets, contacts * sizeof *own->sets);
  memcpy(own->still, from->still, blocks * sizeof *own->still);
  return true;
}

static tp_status wait(branching *b, tp_modes_node *own, tp_message *message) {
  tp_modes_node *more = tp_grow(b->waiting, b->count, &b->room, sizeof *more);
  if (more == NULL) return tp_fail_memory(message, "a proof");
  b->waiting = more;
  more[b->count++] = *own;
  *own = (tp_modes_node){.sets = NULL};
  return TP_OK;
}

static tp_status refute(bool *refuted, branching *b, tp_modes_node *n, tp_message *message) {
  const tp_resting *r = b->q->resting;
  *refuted = !tp_modes_node_settle(n, r) || tp_modes_node_is_still(n, r);
  if (*refuted) return TP_OK;
  const tp_status status = tp_modes_refute_by_forces(refuted, &b->of->work, n, b->q, message);
  if (status != TP_OK || *refuted) return status;
  return tp_modes_refute_by_reactions(refuted, &b->of->work, n, b->q, message);
}

/* ---- parts -------------------------------------------------------------------------------------
 */

/* A division: parts of a node that are not refuted. */
typedef struct division {
  int count;
  tp_modes_node parts[TP_MOST_PARTS];
} division;

static void clear_division(division *d) {
  for (int k = 0; k < d->count; k++) clear_node(d->parts + k);
  d->count = 0;
}

/* No more than `most` of them. Parts that are refuted are left out of the node. */
static tp_status divide(division *d, branching *b, tp_modes_node *n, long contact, int most,
                        tp_message *message) {
  const tp_contact_parts of = tp_contact_parts_of(n, b->q->resting, contact);
  tp_status status = TP_OK;
  d->count = 0;
  for (int k = of.count - 1; k >= 0 && status == TP_OK && d->count <= most; k--) {
    tp_modes_node *own = d->parts + d->count;
    bool refuted = false;
    if (!copy_node(own, n, b->q->resting)) return tp_fail_memory(message, "a proof");
    tp_contact_parts_take(own, &of, k);
    d->count++;
    status = refute(&refuted, b, own, message);
    if (refuted) {
      tp_contact_parts_leave_out(n, &of, k);
      clear_node(own);
      d->count--;
    }
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

/* In all parts. */
static long count_modes(const division *d, const tp_resting *r) {
  long count = 0;
  for (int k = 0; k < d->count; k++) {
    for (long c = 0; c < r->contact_count; c++) {
      for (tp_mode_set set = d->parts[k].sets[c]; set != 0; set &= set - 1) count++;
    }
  }
  return count;
}

/* The division of the fewest parts of all candidates, and of those the one that leaves the fewest
 * modes; -1 parts: there is none. */
static tp_status probe(division *best, branching *b, tp_modes_node *n, candidate *is_asked,
                       tp_message *message) {
  enum { MANY = TP_MOST_PARTS + 1 };
  const tp_resting *r = b->q->resting;
  tp_status status = TP_OK;
  int fewest = MANY;
  long fewest_modes = 0;
  for (long k = 0; k < r->contact_count && status == TP_OK && fewest > 1; k++) {
    if (!is_asked(n, r, k)) continue;
    if (b->of->work > b->of->most_work) break;
    division own;
    status = divide(&own, b, n, k, fewest, message);
    const long modes = count_modes(&own, r);
    if (status == TP_OK && (own.count < fewest || (own.count == fewest && modes < fewest_modes))) {
      fewest_modes = modes;
      clear_division(best);
      fewest = own.count;
      *best = own;
    } else {
      clear_division(&own);
    }
  }
  if (fewest == MANY) best->count = -1;
  return status;
}

/* A side of a pair of which nothing is left bears nothing. */
static void leave(tp_exclusion *e, const tp_modes_node *n, const tp_resting *r) {
  for (long k = 0; k < r->contact_count; k++) {
    e->left[k] = n->sets[k] != 0 ? n->sets[k] : TP_MODES_OPEN;
  }
}

/* By what was left out of the node that it is a part of. */
static void narrow(tp_modes_node *part, const tp_modes_node *of, const tp_resting *r) {
  for (long k = 0; k < r->contact_count; k++) part->sets[k] &= of->sets[k];
}

static tp_status take_one(bool *goes_on, branching *b, tp_message *message) {
  tp_modes_node own = b->waiting[--b->count];
  division d = {.count = 0};
  candidate *const asked[] = {is_asked_first, is_asked_last};
  d.count = -1;
  tp_status status = TP_OK;
  for (int k = 0; k < 2 && d.count < 0 && status == TP_OK; k++) {
    d.count = 0;
    status = probe(&d, b, &own, asked[k], message);
  }
  if (status == TP_OK && d.count < 0) {
    b->is_open = true;
    *goes_on = false;
    b->of->has_left = b->of->work <= b->of->most_work; /* all have one mode */
    if (b->of->has_left) leave(b->of, &own, b->q->resting);
  }
  for (int k = 0; k < d.count && status == TP_OK; k++) {
    narrow(d.parts + k, &own, b->q->resting);
    status = wait(b, d.parts + k, message);
  }
  clear_division(&d);
  clear_node(&own);
  *goes_on = *goes_on && b->of->work <= b->of->most_work;
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

static tp_status make_root(tp_modes_node *root, const tp_resting *r, tp_message *message) {
  root->sets = calloc((size_t)r->contact_count + 1, sizeof *root->sets);
  root->still = calloc((size_t)r->rows / 3 + 1, sizeof *root->still);
  if (root->sets == NULL || root->still == NULL) {
    clear_node(root);
    return tp_fail_memory(message, "a proof");
  }
  for (long k = 0; k < r->contact_count; k++) root->sets[k] = tp_modes_of_contact(r, k);
  return TP_OK;
}

tp_status tp_exclusion_frictionless(bool *proven, long *work, const tp_modes_question *q,
                                    tp_message *message) {
  tp_modes_node root;
  tp_status status = make_root(&root, q->resting, message);
  if (status != TP_OK) return status;
  status = tp_modes_refute_by_reactions(proven, work, &root, q, message);
  clear_node(&root);
  return status;
}

/* Of one group, with the others at rest. */
static tp_status exclude_group(bool *proven, tp_exclusion *e, const tp_modes_question *q,
                               const long *group, long own, tp_message *message) {
  branching b = {.q = q, .of = e};
  tp_modes_node root;
  bool goes_on = true, refuted = false;
  tp_status status = make_root(&root, q->resting, message);
  if (status != TP_OK) return status;
  for (long k = 0; k < q->resting->rows / 3; k++) root.still[k] = group[k] != own;
  status = refute(&refuted, &b, &root, message);
  if (status == TP_OK && !refuted) status = wait(&b, &root, message);
  clear_node(&root);
  while (status == TP_OK && goes_on && b.count > 0) status = take_one(&goes_on, &b, message);
  *proven = status == TP_OK && b.count == 0 && !b.is_open;
  for (long k = 0; k < b.count; k++) clear_node(b.waiting + k);
  free(b.waiting);
  return status;
}

tp_status tp_exclusion_find(tp_exclusion *e, const tp_modes_question *q, tp_message *message) {
  const long count = q->resting->rows / 3;
  long *group = calloc((size_t)count + 1, sizeof *group);
  if (group == NULL) return tp_fail_memory(message, "a proof");
  find_groups(group, q->resting);
  tp_status status = TP_OK;
  bool proven = true;
  e->is_proven = e->has_left = false;
  for (long k = 0; k < count && proven && status == TP_OK; k++) {
    if (group[k] == k) status = exclude_group(&proven, e, q, group, k, message);
  }
  free(group);
  e->is_proven = status == TP_OK && proven;
  return status;
}
