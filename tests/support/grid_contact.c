/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "grid_contact.h"
#include "exact_vectors.h"

#include <check.h>
#include <flint/ulong_extras.h>
#include <stdlib.h>

long grid_cross(grid_point a, grid_point b, grid_point c, grid_point d) {
  return (b.x - a.x) * (d.y - c.y) - (b.y - a.y) * (d.x - c.x);
}

long grid_dot(grid_point a, grid_point b, grid_point c, grid_point d) {
  return (b.x - a.x) * (d.x - c.x) + (b.y - a.y) * (d.y - c.y);
}

bool grid_same(grid_point a, grid_point b) {
  return a.x == b.x && a.y == b.y;
}

/* On the closed segment. */
static bool is_on(grid_point p, grid_point a, grid_point b) {
  return grid_cross(a, b, a, p) == 0 && grid_dot(a, p, a, b) >= 0 && grid_dot(b, p, b, a) >= 0;
}

static grid_point outline_at(const grid_figure *f, long k) {
  return f->outline[(k + f->outline_count) % f->outline_count];
}

bool grid_contains(const grid_restraints *all, grid_restraint own) {
  for (long k = 0; k < all->count; k++) {
    if (grid_same(all->of[k].at, own.at) && grid_same(all->of[k].along, own.along)) return true;
  }
  return false;
}

void grid_add(grid_restraints *all, grid_point at, grid_point from, grid_point to) {
  const long x = to.x - from.x, y = to.y - from.y;
  const long common = (long)n_gcd((ulong)labs(x), (ulong)labs(y));
  const grid_restraint own = {at, {x / common, y / common}};
  if (grid_contains(all, own)) return;
  ck_assert_int_lt(all->count, GRID_MOST_RESTRAINTS);
  all->of[all->count++] = own;
}

/* Both ends of what two edges of one direction share. */
static void add_shared(grid_restraints *all, grid_point a0, grid_point a1, grid_point b0,
                       grid_point b1) {
  if (grid_cross(a0, a1, b0, b1) != 0 || grid_dot(a0, a1, b0, b1) <= 0) return;
  const grid_point from = is_on(a0, b0, b1) ? a0 : b0, to = is_on(a1, b0, b1) ? a1 : b1;
  if (!is_on(from, a0, a1) || !is_on(from, b0, b1) || !is_on(to, a0, a1) || grid_same(from, to))
    return;
  grid_add(all, from, a0, a1);
  grid_add(all, to, a0, a1);
}

/* A vertex on a corner of the base: both edges of a notch of either, the edge that a straight one
 * lies on, and nothing of a corner on a corner. */
static void add_corner(grid_restraints *all, const grid_figure *f, long vertex, long corner) {
  const grid_point p = f->outline[vertex];
  const grid_point before = outline_at(f, vertex - 1), after = outline_at(f, vertex + 1);
  const grid_point *b = f->base + corner;
  const long up = grid_cross(b[-1], b[0], b[0], b[1]), down = grid_cross(before, p, p, after);
  if (up > 0 || (up == 0 && down > 0)) grid_add(all, p, b[0], b[1]);
  if (up > 0) grid_add(all, p, b[-1], b[0]);
  if (up > 0) return;
  if (down < 0) grid_add(all, p, before, p);
  if (down <= 0) grid_add(all, p, p, after);
}

void grid_compare_edges(grid_restraints *all, grid_restraints *touching, const grid_figure *f) {
  all->count = touching->count = 0;
  for (long i = 0; i < f->outline_count; i++) {
    const grid_point a0 = f->outline[i], a1 = outline_at(f, i + 1);
    for (long j = 0; j + 1 < f->base_count; j++) {
      const grid_point b0 = f->base[j], b1 = f->base[j + 1];
      add_shared(all, a0, a1, b0, b1);
      const bool vertex = is_on(a0, b0, b1), corner = is_on(b0, a0, a1);
      if (vertex && !grid_same(a0, b0) && !grid_same(a0, b1)) grid_add(all, a0, b0, b1);
      if (corner && !grid_same(b0, a0) && !grid_same(b0, a1)) grid_add(all, b0, a0, a1);
      if (grid_same(a0, b0)) add_corner(all, f, i, j);
      if (vertex && !grid_contains(touching, (grid_restraint){a0, {0, 0}})) {
        touching->of[touching->count++] = (grid_restraint){a0, {0, 0}};
      }
      if (corner && !grid_contains(touching, (grid_restraint){b0, {0, 0}})) {
        touching->of[touching->count++] = (grid_restraint){b0, {0, 0}};
      }
    }
  }
}

/* How far the line through a and b lies above the one through c and d at an abscissa, times a
 * number above zero; both run to the right. */
static long above(grid_point a, grid_point b, grid_point c, grid_point d, long x) {
  const long first = a.y * (b.x - a.x) + (b.y - a.y) * (x - a.x);
  const long second = c.y * (d.x - c.x) + (d.y - c.y) * (x - c.x);
  return first * (d.x - c.x) - second * (b.x - a.x);
}

/* Does the block lie partly below the profile? In the column from x to x + 1. */
static bool overlaps_in_column(const grid_figure *f, long x) {
  grid_point low[2] = {{0, 0}, {0, 0}};
  bool found = false;
  for (long i = 0; i < f->outline_count; i++) {
    const grid_point a = f->outline[i], b = outline_at(f, i + 1);
    const grid_point left = a.x < b.x ? a : b, right = a.x < b.x ? b : a;
    if (left.x > x || right.x < x + 1) continue;
    /* they do not cross, so that twice the middle tells which is lower */
    const long higher =
        found ? above(left, right, low[0], low[1], x) + above(left, right, low[0], low[1], x + 1)
              : -1;
    if (higher >= 0) continue;
    low[0] = left;
    low[1] = right;
    found = true;
  }
  for (long j = 1; j + 2 < f->base_count && found; j++) {
    if (f->base[j].x > x || f->base[j + 1].x < x + 1) continue;
    return above(low[0], low[1], f->base[j], f->base[j + 1], x) < 0 ||
           above(low[0], low[1], f->base[j], f->base[j + 1], x + 1) < 0;
  }
  return false;
}

bool grid_overlaps(const grid_figure *f) {
  for (long x = -GRID; x < 2 * GRID; x++) {
    if (overlaps_in_column(f, x)) return true;
  }
  return false;
}

static bool is_simple(const grid_figure *f) {
  const long n = f->outline_count;
  for (long i = 0; i < n; i++) {
    const grid_point a0 = f->outline[i], a1 = outline_at(f, i + 1);
    if (grid_same(a0, a1)) return false;
    for (long j = 0; j < n; j++) {
      if (j == i) continue;
      const grid_point b0 = f->outline[j], b1 = outline_at(f, j + 1);
      const bool next = (i + 1) % n == j, last = (j + 1) % n == i;
      if (!last && is_on(b0, a0, a1) && !(next && grid_same(b0, a1))) return false;
      if (last && is_on(b0, a0, a1)) return false;
      const long one = grid_cross(a0, a1, a0, b0), two = grid_cross(a0, a1, a0, b1);
      const long three = grid_cross(b0, b1, b0, a0), four = grid_cross(b0, b1, b0, a1);
      if (one * two < 0 && three * four < 0) return false;
    }
  }
  return true;
}

void grid_draw_outline(grid_figure *f, random_numbers *state) {
  do {
    f->outline_count = 3 + draw_below(state, GRID_MOST_VERTICES - 2);
    for (long k = 0; k < f->outline_count; k++) {
      f->outline[k] = (grid_point){draw_below(state, GRID), 1 + draw_below(state, GRID)};
    }
  } while (!is_simple(f));
  long area = 0;
  for (long k = 0; k < f->outline_count; k++) {
    const grid_point a = f->outline[k], b = outline_at(f, k + 1);
    area += a.x * b.y - a.y * b.x;
  }
  for (long k = 0; area < 0 && k < f->outline_count / 2; k++) {
    const grid_point own = f->outline[k];
    f->outline[k] = f->outline[f->outline_count - 1 - k];
    f->outline[f->outline_count - 1 - k] = own;
  }
}

void grid_draw_profile(tp_polyline *profile, random_numbers *state) {
  const long count = 2 + draw_below(state, GRID_MOST_POINTS - 1);
  long x = draw_below(state, 4) - 1, y = draw_below(state, 4);
  bool upright = true;
  for (long k = 0; k < count; k++) {
    exact_point p;
    exact_point_init(&p);
    fmpq_set_si(&p.x, x, 1);
    fmpq_set_si(&p.y, y, 1);
    ck_assert(tp_polyline_append(profile, &p.x, &p.y, (tp_mark){0}));
    exact_point_clear(&p);
    upright = !upright && k > 0 && k + 2 < count && draw_below(state, 3) == 0;
    if (!upright) x += 1 + draw_below(state, 4);
    const long last = y;
    do y = draw_below(state, 5);
    while (upright && y == last);
  }
}

void grid_set_ring(tp_polyline *ring, const grid_figure *f) {
  for (long k = 0; k < f->outline_count; k++) {
    exact_point p;
    exact_point_init(&p);
    fmpq_set_si(&p.x, f->outline[k].x, 1);
    fmpq_set_si(&p.y, f->outline[k].y, 1);
    ck_assert(tp_polyline_append(ring, &p.x, &p.y, (tp_mark){0}));
    exact_point_clear(&p);
  }
}

/* The base's ring begins with the profile, and ends with its lower right and its lower left corner.
 */
void grid_take_base(grid_figure *f, const tp_base *base) {
  const long count = base->ring.count;
  ck_assert_int_eq(base->edge_count, count - 3);
  f->base_count = count;
  for (long k = 0; k < count; k++) {
    const long own = (k + count - 1) % count;
    ck_assert(fmpz_is_one(fmpq_denref(base->ring.x + own)));
    ck_assert(fmpz_is_one(fmpq_denref(base->ring.y + own)));
    f->base[k] = (grid_point){fmpz_get_si(fmpq_numref(base->ring.x + own)),
                              fmpz_get_si(fmpq_numref(base->ring.y + own))};
  }
}

grid_point grid_point_of(const grid_figure *f, long point) {
  if (point < f->outline_count) return f->outline[point];
  return f->base[(point - f->outline_count + 1) % f->base_count];
}
