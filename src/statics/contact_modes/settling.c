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

/* A contact of blocks at rest is at rest, of a pair by its first side; a block that sticks to one
 * at rest by an edge is too. */
static bool settle_contact(bool *changed, tp_modes_node *n, const tp_resting *r, long k) {
  const tp_resting_contact *c = r->contacts + k;
  const long *row = c->along.row, moving = moving_row(n, c);
  if (tp_modes_rests(n, row[0]) && tp_modes_rests(n, row[1])) {
    const bool is_second = tp_modes_is_second_side(r, k);
    n->sets[k] &= is_second ? 0 : tp_modes_at_rest(c->ends);
    return is_second || n->sets[k] != 0;
  }
  if (moving >= 0 && c->ends == 2 && n->sets[k] == tp_modes_at_rest(2)) {
    n->still[moving / 3] = *changed = true;
  }
  return true;
}

bool tp_modes_node_settle(tp_modes_node *n, const tp_resting *r) {
  for (bool changed = true; changed;) {
    changed = false;
    for (long k = 0; k < r->contact_count; k++) {
      if (!settle_contact(&changed, n, r, k)) return false;
    }
    for (long b = 0; b < r->rows / 3 && !changed; b++) {
      if (n->still[b] || !tp_modes_is_held_fast(n, r, b)) continue;
      n->still[b] = changed = true;
    }
  }
  return true;
}

bool tp_modes_node_is_still(const tp_modes_node *n, const tp_resting *r) {
  for (long b = 0; b < r->rows / 3; b++) {
    if (!n->still[b]) return false;
  }
  return true;
}
