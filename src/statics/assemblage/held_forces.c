/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* One pass over the contacts, in doubles with their bounds. */

#include "assemblage/held_forces.h"

#include "plane/contact_rows.h"

/* -(A f + w0 + s w1). */
static void find_lacks(tp_near *lacks, const tp_force_program *p, const double *forces,
                       tp_near load) {
  for (long r = 0; r < p->rows; r++) {
    lacks[r] = tp_near_neg(tp_near_plus(p->dead[r], tp_near_times(load, p->live[r])));
  }
  for (long k = 0; k < p->count; k++) {
    const tp_force_column *c = p->columns + k;
    const tp_near force = {forces[k], 0};
    for (int side = 0; side < 2; side++) {
      if (c->row[side] < 0) continue;
      tp_near *own = lacks + c->row[side];
      for (int e = 0; e < 3; e++) {
        own[e] = tp_near_minus(own[e], tp_near_times(force, c->entry[side][e]));
      }
    }
  }
}

/* A wrench on a block as one on another, about that one's own point: what one contact carries. */
static void hand_over(tp_near *other, const tp_near *own, const tp_assemblage *a,
                      const tp_rigid_block *from, const tp_rigid_block *to) {
  const tp_near x = tp_assemblage_length(a, to->x, from->x);
  const tp_near y = tp_assemblage_length(a, to->y, from->y);
  tp_near moved[3] = {own[0], own[1]};
  tp_sparse_moment(moved, &x, &y);
  moved[2] = tp_near_plus(moved[2], own[2]);
  for (int e = 0; e < 3; e++) other[e] = tp_near_plus(other[e], moved[e]);
}

/* A column bears so much more: what the block on its other side lacks then. */
static void bear(tp_near *lacks, const tp_force_column *column, int side, tp_near more) {
  if (column->row[!side] < 0) return;
  tp_near *own = lacks + column->row[!side];
  for (int e = 0; e < 3; e++) {
    own[e] = tp_near_minus(own[e], tp_near_times(more, column->entry[!side][e]));
  }
}

/* What a block lacks becomes that of those that it rests on. Of one contact as a whole: the factors
 * know it less well, and the more so the higher the pile. */
static void hand_down(tp_near *lacks, const tp_force_program *p, const tp_tree_link *link,
                      const tp_near factors[3]) {
  const tp_force_column *first = p->columns + link->columns[0];
  if (!link->of_one_contact) {
    for (int c = 0; c < 3; c++) {
      bear(lacks, p->columns + link->columns[c], link->sides[c], factors[c]);
    }
  } else if (first->row[!link->sides[0]] >= 0) {
    const long other = first->row[!link->sides[0]] / 3;
    hand_over(lacks + 3 * other, lacks + 3 * link->number, p->assemblage,
              p->assemblage->blocks + p->block[link->number],
              p->assemblage->blocks + p->block[other]);
  }
}

/* Factors above zero, of which the method keeps them, and no greater than they may be. */
static bool are_allowed(const tp_force_program *p, const double *forces) {
  for (long k = 0; k < p->count; k++) {
    const tp_near most = p->columns[k].most;
    if (!(forces[k] >= 0 && forces[k] <= most.value - most.error)) return false;
  }
  return true;
}

bool tp_forces_hold(tp_near *lacks, const tp_force_program *p, const tp_ground_tree *tree,
                    const double *forces, tp_near load) {
  if (tree->count < p->rows / 3 || !are_allowed(p, forces)) return false;
  find_lacks(lacks, p, forces, load);
  for (long k = tree->count - 1; k >= 0; k--) {
    const tp_tree_link *link = tree->links + k;
    tp_near factors[3];
    tp_tree_link_share(factors, link, p, lacks + 3 * link->number);
    for (int c = 0; c < 3; c++) {
      const tp_force_column *column = p->columns + link->columns[c];
      const tp_near sum = tp_near_plus((tp_near){forces[link->columns[c]], 0}, factors[c]);
      if (!(sum.value >= sum.error &&
            sum.value + sum.error <= column->most.value - column->most.error)) {
        return false;
      }
    }
    hand_down(lacks, p, link, factors);
  }
  return true;
}
