/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Blocks at rest grow from the ground: over contacts that only stick, and where the rows of closed
 * ends and of contacts that stick, against blocks at rest, have a determinant that is not zero. */

#include "contact_modes/node.h"

#include "contact_modes/corner_modes.h"

#include "plane/contact_rows.h"

#include <string.h>

/* Rows of one block's contacts with blocks at rest that give no velocity; of very many the first.
 */
enum { MOST_ROWS = 12 };
typedef struct fixed_rows {
  int count;
  const tp_near *rows[MOST_ROWS];
} fixed_rows;

static void take(fixed_rows *f, const tp_force_column *column, int side) {
  if (f->count < MOST_ROWS) f->rows[f->count++] = column->entry[side];
}

static void take_contact(fixed_rows *f, const tp_resting_contact *c, tp_mode_set set, long row) {
  const int side = c->along.row[0] == row ? 0 : 1;
  for (int e = 0; e < c->ends; e++) {
    if ((set & ~tp_modes_closed(e)) == 0) take(f, c->normal + e, side);
  }
  if ((set & ~(tp_mode_set)TP_MODES_STICK) == 0) take(f, &c->along, side);
}

static bool spans_all(const fixed_rows *f) {
  for (int i = 0; i < f->count; i++) {
    for (int j = i + 1; j < f->count; j++) {
      for (int k = j + 1; k < f->count; k++) {
        if (tp_near_sign(tp_near_determinant(f->rows[i], f->rows[j], f->rows[k])) != 0) return true;
      }
    }
  }
  return false;
}

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

static bool is_held_fast(const tp_modes_node *n, const tp_resting *r, long block) {
  fixed_rows f = {.count = 0};
  for (long k = 0; k < r->contact_count; k++) {
    if (moving_row(n, r->contacts + k) == 3 * block && n->sets[k] != 0 &&
        tp_modes_is_told(n->sets, r, k)) {
      take_contact(&f, r->contacts + k, n->sets[k], 3 * block);
    }
  }
  return spans_all(&f);
}

bool tp_modes_node_settle(tp_modes_node *n, const tp_resting *r) {
  for (bool changed = true; changed;) {
    changed = false;
    for (long k = 0; k < r->contact_count; k++) {
      if (!settle_contact(&changed, n, r, k)) return false;
    }
    for (long b = 0; b < r->rows / 3 && !changed; b++) {
      if (n->still[b] || !is_held_fast(n, r, b)) continue;
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
