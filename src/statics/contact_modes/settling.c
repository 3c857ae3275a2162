/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Blocks at rest grow from the ground: over contacts that only stick, and where what contacts with
 * blocks at rest do leaves no velocity (contact_modes/held_fast.h). */

#include "contact_modes/settling.h"

#include "contact_modes/corner_modes.h"
#include "contact_modes/held_fast.h"

/* The row of the one block of a contact that is not at rest; -1: there is none, or there are two.
 */
static long moving_row(const tp_modes_node *n, const tp_resting_contact *c) {
  const long *row = c->along.row;
  const bool first = tp_modes_rests(n, row[0]), second = tp_modes_rests(n, row[1]);
  return first == second ? -1 : row[first ? 1 : 0];
}

/* No motion has these modes at a contact of blocks that are at rest. */
static void refute_rest(tp_modes_node *refuted, const tp_resting *r, long k) {
  const tp_resting_contact *c = r->contacts + k;
  tp_modes_node_widen(refuted, r);
  refuted->sets[k] &= ~tp_modes_at_rest(c->ends);
  for (int side = 0; side < 2; side++) {
    if (c->along.row[side] >= 0) refuted->still[c->along.row[side] / 3] = true;
  }
}

/* A contact of blocks at rest is at rest, of a pair by its first side; a block that sticks to one
 * at rest by an edge is too. False: this cannot be. */
static bool settle_contact(bool *changed, tp_search_state *s, long k) {
  const tp_resting_contact *c = s->resting->contacts + k;
  const tp_modes_node *n = &s->node;
  const long *row = c->along.row, moving = moving_row(n, c);
  if (tp_modes_rests(n, row[0]) && tp_modes_rests(n, row[1])) {
    const tp_mode_set rest = tp_modes_at_rest(c->ends);
    if (tp_modes_is_second_side(s->resting, k)) return true;
    if ((n->sets[k] & rest) == 0) return false;
    *changed = tp_search_narrow(s, k, rest, 0, TP_REASON_REST) || *changed;
  } else if (moving >= 0 && c->ends == 2 && n->sets[k] == tp_modes_at_rest(2)) {
    tp_search_rest(s, moving / 3);
    *changed = true;
  }
  return true;
}

static bool settle_blocks(tp_modes_node *refuted, bool *changed, tp_search_state *s) {
  const tp_resting *r = s->resting;
  for (long k = 0; k < r->contact_count; k++) {
    if (settle_contact(changed, s, k)) continue;
    refute_rest(refuted, r, k);
    return false;
  }
  bool moves = false;
  for (long b = 0; b < r->rows / 3; b++) {
    if (!s->node.still[b] && !*changed && tp_modes_is_held_fast(&s->node, r, b)) {
      tp_search_rest(s, b);
      *changed = true;
    }
    moves = moves || !s->node.still[b];
  }
  if (moves) return true;
  tp_modes_node_widen(refuted, r);
  for (long b = 0; b < r->rows / 3; b++) refuted->still[b] = true;
  return false;
}

/* What a nogood says. */
static bool settle_by_nogood(tp_modes_node *refuted, bool *changed, long *work, tp_search_state *s,
                             tp_nogoods *nogoods, long number) {
  tp_nogood_term term;
  const tp_nogood_says says = tp_nogoods_ask(&term, work, nogoods, number, &s->node);
  if (says == TP_NOGOOD_REFUTES) tp_nogoods_take(refuted, nogoods, number);
  if (says == TP_NOGOOD_LIMITS) {
    const bool own = tp_search_narrow(s, term.contact, ~term.own, ~term.of_twin, number);
    *changed = *changed || own;
  }
  return says != TP_NOGOOD_REFUTES;
}

/* Of those that watch what a change is of. That they may watch something else afterwards is why the
 * next is found first. */
static bool settle_change(tp_modes_node *refuted, bool *changed, long *work, tp_search_state *s,
                          tp_nogoods *nogoods, const tp_search_change *c) {
  long at = -1;
  long number = tp_nogoods_watching(&at, nogoods, c->contact, c->block);
  while (number >= 0) {
    const long own = number;
    number = tp_nogoods_watching(&at, nogoods, c->contact, c->block);
    if (!settle_by_nogood(refuted, changed, work, s, nogoods, own)) return false;
  }
  return true;
}

static bool settle_by_nogoods(tp_modes_node *refuted, bool *changed, long *work, tp_search_state *s,
                              tp_nogoods *nogoods) {
  for (; s->asked < nogoods->count; s->asked++) {
    if (!settle_by_nogood(refuted, changed, work, s, nogoods, s->asked)) return false;
  }
  for (; s->told < s->count; s->told++) {
    const tp_search_change own = s->changes[s->told];
    if (!settle_change(refuted, changed, work, s, nogoods, &own)) return false;
  }
  return true;
}

bool tp_search_settle(tp_modes_node *refuted, long *work, tp_search_state *s, tp_nogoods *nogoods) {
  for (bool changed = true; changed;) {
    changed = false;
    if (!settle_blocks(refuted, &changed, s)) return false;
    if (!changed && !settle_by_nogoods(refuted, &changed, work, s, nogoods)) return false;
  }
  return true;
}
