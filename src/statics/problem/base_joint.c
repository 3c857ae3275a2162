/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Ends of the base joint, heel and toe of water: the outermost contacts, or the part of the sole
 * that has base below it, cut at the ends of the base. */

#include "problem/base_joint.h"

void tp_base_joint_init(tp_base_joint *joint) {
  for (int side = 0; side < 2; side++) {
    fmpq_init(joint->x + side);
    fmpq_init(joint->y + side);
    fmpq_init(joint->contact_x + side);
    fmpq_init(joint->contact_y + side);
    joint->vertex[side] = joint->contact_vertex[side] = -1;
  }
}

void tp_base_joint_clear(tp_base_joint *joint) {
  for (int side = 0; side < 2; side++) {
    fmpq_clear(joint->x + side);
    fmpq_clear(joint->y + side);
    fmpq_clear(joint->contact_x + side);
    fmpq_clear(joint->contact_y + side);
  }
}

bool tp_base_joint_gapes(const tp_base_joint *joint, int side) {
  return !fmpq_equal(joint->x + side, joint->contact_x + side) ||
         !fmpq_equal(joint->y + side, joint->contact_y + side);
}

/* Is the point a farther out than b? */
static bool is_beyond(const tp_lattice *l, long a, long b, int side) {
  const int out = fmpz_cmp(l->x + a, l->x + b);
  return side == 0 ? out < 0 : out > 0;
}

static void end_in_point(tp_base_joint *joint, const tp_lattice *l, long point, int side) {
  tp_lattice_metres_x(joint->x + side, l, l->x + point);
  tp_lattice_metres_y(joint->y + side, l, l->y + point);
  joint->vertex[side] = point < l->start[1] ? point : -1;
}

/* Above the base's end, on the edge between two vertices of the outline, of which the first lies
 * beyond that. */
static void end_on_edge(tp_base_joint *joint, const tp_lattice *l, long from, long to, long base,
                        int side) {
  fmpq_t y0;
  fmpz_t part, whole;
  fmpq_init(y0);
  fmpz_init(part);
  fmpz_init(whole);
  fmpq *y = joint->y + side;
  tp_lattice_metres_x(joint->x + side, l, l->x + base);
  tp_lattice_metres_y(y0, l, l->y + from);
  tp_lattice_metres_y(y, l, l->y + to);
  fmpq_sub(y, y, y0);
  fmpz_sub(part, l->x + base, l->x + from);
  fmpz_sub(whole, l->x + to, l->x + from);
  fmpq_mul_fmpz(y, y, part);
  fmpq_div_fmpz(y, y, whole);
  fmpq_add(y, y, y0);
  joint->vertex[side] = -1;
  fmpq_clear(y0);
  fmpz_clear(part);
  fmpz_clear(whole);
}

/* From the end of the underside on one side inwards, to where it has base below it. */
static void end_of_sole(tp_base_joint *joint, const tp_lattice *l, const tp_sole *sole, long base,
                        int side) {
  const long count = l->start[1], last = sole->first + sole->count;
  for (long k = 0; k <= sole->count; k++) {
    const long own = (side == 0 ? sole->first + k : last - k) % count;
    if (is_beyond(l, own, base, side)) continue;
    if (k == 0 || fmpz_equal(l->x + own, l->x + base)) {
      end_in_point(joint, l, own, side);
    } else {
      const long before = (side == 0 ? sole->first + k - 1 : last - k + 1) % count;
      end_on_edge(joint, l, before, own, base, side);
    }
    return;
  }
}

void tp_base_joint_find(tp_base_joint *joint, const tp_contact *contact, const tp_sole *sole,
                        const tp_lattice *l, const long base_ends[2]) {
  for (int side = 0; side < 2; side++) {
    const long touching = tp_contact_extreme(contact, side == 0).point;
    end_in_point(joint, l, touching, side);
    fmpq_set(joint->contact_x + side, joint->x + side);
    fmpq_set(joint->contact_y + side, joint->y + side);
    joint->contact_vertex[side] = joint->vertex[side];
    if (sole->count == 0) continue;
    const long sole_end = (side == 0 ? sole->first : sole->first + sole->count) % l->start[1];
    /* a contact on a flank beyond the underside is an end of it, too */
    if (!is_beyond(l, sole_end, touching, side)) continue;
    end_of_sole(joint, l, sole, base_ends[side], side);
  }
}
