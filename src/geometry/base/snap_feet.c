/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Which vertices of either body lie within the distance of the other, and where those of the block
 * go. */

#include "base/snap_search.h"

#include "common/grow.h"

#include <stdlib.h>

/* 1 where the block, or the air above the rock, has less than half a turn there; -1 for more. */
static int sense_of_vertex(const tp_snap_search *s, long k) {
  return tp_polyline_turn(s->outline, tp_snap_before(s, k), k, tp_snap_next(s, k));
}

static int sense_of_point(const tp_snap_search *s, long p) {
  if (p == 0 || p + 1 == s->near->points) return -1;
  return tp_polyline_turn(s->ring, p - 1, p, p + 1);
}

static void square_between(fmpq_t square, const tp_snap_search *s, long vertex, long point) {
  fmpq_t d;
  fmpq_init(d);
  fmpq_sub(d, s->outline->x + vertex, s->ring->x + point);
  fmpq_mul(square, d, d);
  fmpq_sub(d, s->outline->y + vertex, s->ring->y + point);
  fmpq_addmul(square, d, d);
  fmpq_clear(d);
}

static void square_of_edge(fmpq_t square, const tp_polyline *line, long edge) {
  fmpq_t d;
  fmpq_init(d);
  fmpq_sub(d, line->x + edge + 1, line->x + edge);
  fmpq_mul(square, d, d);
  fmpq_sub(d, line->y + edge + 1, line->y + edge);
  fmpq_addmul(square, d, d);
  fmpq_clear(d);
}

static void consider_corner(const tp_snap_search *s, tp_snap_foot *f, long point) {
  const int sense = sense_of_point(s, point);
  fmpq_t square;
  if (sense == 0 || sense != sense_of_vertex(s, f->pair.vertex)) return;
  fmpq_init(square);
  square_between(square, s, f->pair.vertex, point);
  if (fmpq_cmp(square, s->limit) <= 0 &&
      (f->corner < 0 || fmpq_cmp(square, f->corner_square) < 0)) {
    f->corner = point;
    fmpq_swap(f->corner_square, square);
  }
  fmpq_clear(square);
}

static tp_snap_foot *add_foot(tp_snap_search *s, const tp_closeness_pair *pair) {
  tp_snap_foot *room = tp_grow(s->feet, s->count, &s->capacity, sizeof *room);
  if (room == NULL) return NULL;
  s->feet = room;
  tp_snap_foot *f = s->feet + s->count;
  *f = (tp_snap_foot){.pair = *pair, .corner = -1};
  fmpq_init(f->share);
  fmpq_init(f->square);
  fmpq_init(f->corner_square);
  (pair->of_base ? s->of_point : s->of_vertex)[pair->vertex] = s->count++;
  return f;
}

bool tp_snap_take(void *context, const tp_closeness_pair *pair, double distance) {
  tp_snap_search *s = context;
  fmpq_t share, square;
  int side = 0;
  bool done = true;
  (void)distance;
  fmpq_init(share);
  fmpq_init(square);
  tp_closeness_foot(share, square, &side, s->near, pair);
  if (fmpq_cmp(square, s->limit) <= 0) {
    const long known = (pair->of_base ? s->of_point : s->of_vertex)[pair->vertex];
    tp_snap_foot *f = known >= 0 ? s->feet + known : add_foot(s, pair);
    done = f != NULL;
    if (done && (known < 0 || fmpq_cmp(square, f->square) < 0)) {
      f->pair = *pair;
      f->side = side;
      fmpq_swap(f->share, share);
      fmpq_swap(f->square, square);
    }
    if (done && !pair->of_base) {
      consider_corner(s, f, pair->edge);
      consider_corner(s, f, pair->edge + 1);
    }
  }
  fmpq_clear(share);
  fmpq_clear(square);
  return done;
}

/* Does the vertex lie inside the other body? Over an end of its edge it does where that is a notch
 * of the body. */
bool tp_snap_is_inside(const tp_snap_search *s, const tp_snap_foot *f) {
  const bool first = fmpq_is_zero(f->share), last = fmpq_is_one(f->share);
  if (fmpq_is_zero(f->square)) return false;
  if (!first && !last) return f->pair.of_base ? f->side > 0 : f->side < 0;
  if (!f->pair.of_base) return sense_of_point(s, f->pair.edge + (last ? 1 : 0)) > 0;
  return sense_of_vertex(s, last ? tp_snap_next(s, f->pair.edge) : f->pair.edge) < 0;
}

/* A vertex that touches stays; each point of the profile takes the nearest vertex that would have
 * it; the others go where they are nearest. */
bool tp_snap_settle_corners(tp_snap_search *s) {
  long *taker = malloc((size_t)s->near->points * sizeof *taker);
  if (taker == NULL) return false;
  for (long p = 0; p < s->near->points; p++) taker[p] = -1;
  for (long k = 0; k < s->count; k++) {
    tp_snap_foot *f = s->feet + k;
    if (fmpq_is_zero(f->square)) f->corner = -1;
    if (f->corner < 0) continue;
    const long rival = taker[f->corner];
    if (rival < 0 || fmpq_cmp(f->corner_square, s->feet[rival].corner_square) < 0) {
      taker[f->corner] = k;
    }
  }
  for (long k = 0; k < s->count; k++) {
    tp_snap_foot *f = s->feet + k;
    if (f->corner >= 0 && taker[f->corner] != k) f->corner = -1;
    if (f->corner < 0) continue;
    f->pair.edge = f->corner;
    fmpq_zero(f->share);
    fmpq_swap(f->square, f->corner_square);
  }
  free(taker);
  return true;
}

/* Bits of a denominator that feet may have of their own, and of that of all together. */
enum { SHORT_BITS = 64, COMMON_BITS = 256 };

/* A vertex of the block that moves along an edge. */
static bool moves_along(const tp_snap_foot *f) {
  return !f->pair.of_base && !fmpq_is_zero(f->square) && !fmpz_is_one(fmpq_denref(f->share));
}

/* Is the common denominator of all feet short? Each may be, and that of a thousand still grow to
 * ten thousands of digits. */
static bool have_short_denominator(const tp_snap_search *s) {
  fmpz_t common;
  fmpz_init_set_ui(common, 1);
  for (long k = 0; k < s->count && fmpz_bits(common) <= COMMON_BITS; k++) {
    const tp_snap_foot *f = s->feet + k;
    if (moves_along(f) && fmpz_bits(fmpq_denref(f->share)) <= SHORT_BITS) {
      fmpz_lcm(common, common, fmpq_denref(f->share));
    }
  }
  const bool is_short = fmpz_bits(common) <= COMMON_BITS;
  fmpz_clear(common);
  return is_short;
}

/* Takes a foot within an edge to a fraction of it with few digits, a hair along the edge: each
 * exact one of a block that was turned has hundreds of its own, and all points come to one lattice.
 * Within the distance it stays. */
static void shorten(tp_snap_search *s, tp_snap_foot *f) {
  enum { SHARE_BITS = 48 };
  const long e = f->pair.edge;
  fmpq_t share, step, side;
  fmpq_init(share);
  fmpq_init(step);
  fmpq_init(side);
  fmpq_mul_2exp(step, f->share, SHARE_BITS);
  fmpz_fdiv_q(fmpq_numref(share), fmpq_numref(step), fmpq_denref(step));
  fmpq_div_2exp(share, share, SHARE_BITS);
  fmpq_sub(step, share, f->share);
  fmpq_mul(step, step, step);
  square_of_edge(side, s->ring, e);
  fmpq_mul(step, step, side);
  fmpq_add(step, step, f->square);
  if (fmpq_sgn(share) > 0 && fmpq_cmp(step, s->limit) <= 0) {
    fmpq_swap(f->share, share);
    fmpq_swap(f->square, step);
  }
  fmpq_clear(share);
  fmpq_clear(step);
  fmpq_clear(side);
}

/* By the profile's points, which the last edge's end is too. */
void tp_snap_normalise(tp_snap_search *s) {
  const bool is_short = have_short_denominator(s);
  for (long k = 0; k < s->count; k++) {
    tp_snap_foot *f = s->feet + k;
    if (f->pair.of_base) continue;
    const bool keeps = is_short && fmpz_bits(fmpq_denref(f->share)) <= SHORT_BITS;
    if (moves_along(f) && !keeps) shorten(s, f);
    if (fmpq_is_one(f->share)) {
      f->pair.edge++;
      fmpq_zero(f->share);
    }
    if (fmpq_is_zero(f->share)) s->has_vertex[f->pair.edge] = true;
  }
}

static void place(fmpq_t x, fmpq_t y, const tp_snap_search *s, const tp_snap_foot *f) {
  const tp_polyline *ring = s->ring;
  const long e = f->pair.edge;
  fmpq_set(x, ring->x + e);
  fmpq_set(y, ring->y + e);
  if (fmpq_is_zero(f->share)) return;
  fmpq_t along;
  fmpq_init(along);
  fmpq_sub(along, ring->x + e + 1, ring->x + e);
  fmpq_addmul(x, along, f->share);
  fmpq_sub(along, ring->y + e + 1, ring->y + e);
  fmpq_addmul(y, along, f->share);
  fmpq_clear(along);
}

bool tp_snap_move_vertices(tp_snap *snap, const tp_snap_search *s) {
  if (!tp_polyline_copy(&snap->moved, s->outline)) return false;
  for (long k = 0; k < s->outline->count; k++) {
    const tp_snap_foot *f = s->of_vertex[k] < 0 ? NULL : s->feet + s->of_vertex[k];
    if (f == NULL || fmpq_is_zero(f->square)) continue;
    place(snap->moved.x + k, snap->moved.y + k, s, f);
    snap->moved_count++;
    if (fmpq_cmp(f->square, snap->most) > 0) fmpq_set(snap->most, f->square);
  }
  return true;
}

void tp_snap_find_extent(tp_snap *snap, const tp_snap_search *s) {
  for (long k = 0; k < s->count; k++) {
    const long vertex = s->feet[k].pair.vertex;
    const fmpq *x = (s->feet[k].pair.of_base ? s->ring->x : snap->moved.x) + vertex;
    if (k == 0 || fmpq_cmp(x, snap->left) < 0) fmpq_set(snap->left, x);
    if (k == 0 || fmpq_cmp(x, snap->right) > 0) fmpq_set(snap->right, x);
  }
}
