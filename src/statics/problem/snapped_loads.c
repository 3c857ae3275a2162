/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Divides a pressure or surcharge at the new vertices of its edge, with the load interpolated
 * linearly at their feet on the old line. */

#include "problem/snapped_loads.h"

#include "common/grow.h"
#include "number/between.h"
#include "scene/moved.h"

#include <stdlib.h>

/* The loads as they grow. */
typedef struct lines {
  tp_line_load *items;
  long count, capacity;
} lines;

/* A load with numbers of its own, the same as another's. */
static tp_line_load *add_line(lines *l, const tp_line_load *like) {
  tp_line_load *room = tp_grow(l->items, l->count, &l->capacity, sizeof *room);
  if (room == NULL) return NULL;
  l->items = room;
  tp_line_load *own = l->items + l->count++;
  *own = *like;
  tp_quantity *const numbers[] = {&own->x0, &own->y0,        &own->x1,
                                  &own->y1, &own->first_kpa, &own->last_kpa};
  const fmpq *const values[] = {like->x0.value, like->y0.value,        like->x1.value,
                                like->y1.value, like->first_kpa.value, like->last_kpa.value};
  for (size_t k = 0; k < sizeof numbers / sizeof numbers[0]; k++) {
    fmpq_init(numbers[k]->value);
    fmpq_set(numbers[k]->value, values[k]);
  }
  return own;
}

/* Where the foot of a point lies on the load's line: 0 at its first end, 1 at its last. */
static void place_on(fmpq_t place, const tp_line_load *load, const fmpq *x, const fmpq *y) {
  fmpq_t dx, dy, part, whole;
  fmpq_init(dx);
  fmpq_init(dy);
  fmpq_init(part);
  fmpq_init(whole);
  fmpq_sub(dx, load->x1.value, load->x0.value);
  fmpq_sub(dy, load->y1.value, load->y0.value);
  fmpq_mul(whole, dx, dx);
  fmpq_addmul(whole, dy, dy);
  fmpq_sub(part, x, load->x0.value);
  fmpq_mul(place, part, dx);
  fmpq_sub(part, y, load->y0.value);
  fmpq_addmul(place, part, dy);
  fmpq_div(place, place, whole);
  fmpq_clear(dx);
  fmpq_clear(dy);
  fmpq_clear(part);
  fmpq_clear(whole);
}

static bool lies_along(const tp_line_load *load, const tp_polyline *line, long k) {
  return tp_points_turn(load->x0.value, load->y0.value, load->x1.value, load->y1.value, line->x + k,
                        line->y + k) == 0;
}

static void share_between(fmpq_t share, const fmpq_t begin, const fmpq_t end, const fmpq *at) {
  fmpq_t whole;
  fmpq_init(whole);
  fmpq_sub(whole, end, begin);
  fmpq_sub(share, at, begin);
  fmpq_div(share, share, whole);
  fmpq_clear(whole);
}

/* An edge of the new outline, its ends at two places of the load's line: the part of it that lies
 * within the line, the way that this runs. False when memory is exhausted. */
static bool add_part(lines *l, const tp_line_load *load, const tp_polyline *now, long k,
                     const fmpq_t begin, const fmpq_t end) {
  const long next = k + 1 == now->count ? 0 : k + 1;
  const bool forwards = fmpq_cmp(begin, end) < 0;
  fmpq_t low, high, share;
  fmpq_init(low);
  fmpq_init(high);
  fmpq_init(share);
  fmpq_set(low, forwards ? begin : end);
  fmpq_set(high, forwards ? end : begin);
  if (fmpq_sgn(low) < 0) fmpq_zero(low);
  if (fmpq_cmp_si(high, 1) > 0) fmpq_one(high);
  bool done = true;
  if (fmpq_cmp(low, high) < 0) {
    tp_line_load *own = add_line(l, load);
    done = own != NULL;
    const fmpq *const at[2] = {low, high};
    for (int e = 0; e < 2 && done; e++) {
      share_between(share, begin, end, at[e]);
      tp_ratio_between((e == 0 ? &own->x0 : &own->x1)->value, now->x + k, now->x + next, share);
      tp_ratio_between((e == 0 ? &own->y0 : &own->y1)->value, now->y + k, now->y + next, share);
      tp_ratio_between((e == 0 ? &own->first_kpa : &own->last_kpa)->value, load->first_kpa.value,
                       load->last_kpa.value, at[e]);
    }
  }
  fmpq_clear(low);
  fmpq_clear(high);
  fmpq_clear(share);
  return done;
}

/* What an edge between two places has become: the edges of the new outline from vertex `first` to
 * vertex `last`. The feet of those between them divide it. */
static bool add_edges(lines *l, const tp_line_load *load, const tp_polyline *now, long first,
                      long last, const fmpq_t begin, const fmpq_t end) {
  const int way = fmpq_cmp(end, begin);
  fmpq_t from, to;
  fmpq_init(from);
  fmpq_init(to);
  fmpq_set(from, begin);
  bool done = true;
  for (long k = first; k < last && done; k++) {
    const long next = k + 1 == now->count ? 0 : k + 1;
    place_on(to, load, now->x + next, now->y + next);
    if (k + 1 == last || way * fmpq_cmp(to, end) > 0) fmpq_set(to, end);
    if (way * fmpq_cmp(to, from) <= 0) continue; /* it stands upright on the line */
    done = add_part(l, load, now, k, from, to);
    fmpq_set(from, to);
  }
  fmpq_clear(from);
  fmpq_clear(to);
  return done;
}

static bool same_point(const tp_polyline *a, long j, const tp_polyline *b, long k) {
  return fmpq_equal(a->x + j, b->x + k) && fmpq_equal(a->y + j, b->y + k);
}

/* The part of [0, 1] between two places, added. */
static void add_covered(fmpq_t covered, const fmpq_t begin, const fmpq_t end) {
  fmpq_t low, high;
  fmpq_init(low);
  fmpq_init(high);
  const bool forwards = fmpq_cmp(begin, end) < 0;
  fmpq_set(low, forwards ? begin : end);
  fmpq_set(high, forwards ? end : begin);
  if (fmpq_sgn(low) < 0) fmpq_zero(low);
  if (fmpq_cmp_si(high, 1) > 0) fmpq_one(high);
  if (fmpq_cmp(low, high) < 0) {
    fmpq_add(covered, covered, high);
    fmpq_sub(covered, covered, low);
  }
  fmpq_clear(low);
  fmpq_clear(high);
}

/* One load by the edges that it covers. `*whole` where they cover all of it, and one of them is not
 * what it was. */
static bool split(lines *parts, bool *whole, const tp_line_load *load,
                  const tp_snapped_outline *o) {
  const long count = o->before->count;
  bool done = true, changed = false;
  fmpq_t begin, end, covered;
  fmpq_init(begin);
  fmpq_init(end);
  fmpq_init(covered);
  for (long k = 0, at = 0; k < count && done; k++) {
    const long next = k + 1 == count ? 0 : k + 1, first = at;
    do {
      at++;
    } while (at < o->now->count && !(next != 0 && same_point(o->now, at, o->moved, next)));
    if (!lies_along(load, o->before, k) || !lies_along(load, o->before, next)) continue;
    place_on(begin, load, o->before->x + k, o->before->y + k);
    place_on(end, load, o->before->x + next, o->before->y + next);
    done = add_edges(parts, load, o->now, first, at, begin, end);
    changed = changed || at > first + 1 || !same_point(o->before, k, o->moved, k) ||
              !same_point(o->before, next, o->moved, next);
    add_covered(covered, begin, end);
  }
  *whole = changed && fmpq_is_one(covered);
  fmpq_clear(begin);
  fmpq_clear(end);
  fmpq_clear(covered);
  return done;
}

/* Its parts, or itself. */
static bool take_load(lines *l, const tp_line_load *load, const tp_snapped_outline *o) {
  lines parts = {0};
  bool whole = false;
  const bool is_point =
      fmpq_equal(load->x0.value, load->x1.value) && fmpq_equal(load->y0.value, load->y1.value);
  bool done = is_point || split(&parts, &whole, load, o);
  if (done && !whole) done = add_line(l, load) != NULL;
  for (long k = 0; k < parts.count && done && whole; k++) {
    done = add_line(l, parts.items + k) != NULL;
  }
  tp_moved_clear_lines(parts.items, parts.count);
  return done;
}

tp_line_load *tp_snapped_lines(long *count, const tp_line_load *own, long own_count,
                               const tp_snapped_outline *o) {
  lines l = {malloc(sizeof *l.items), 0, 1}; /* room, so that NULL tells */
  bool done = l.items != NULL;
  for (long k = 0; k < own_count && done; k++) done = take_load(&l, own + k, o);
  if (done) {
    *count = l.count;
    return l.items;
  }
  tp_moved_clear_lines(l.items, l.count);
  return NULL;
}
