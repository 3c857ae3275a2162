/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The edge that a point lies on is found by exact comparison, and its place on the moved edge by
 * the share along the axis in which the edge runs. */

#include "problem/with_outline.h"

static bool lies_between(const fmpq_t t, const fmpq_t a, const fmpq_t b) {
  return fmpq_cmp(a, b) <= 0 ? fmpq_cmp(t, a) >= 0 && fmpq_cmp(t, b) <= 0
                             : fmpq_cmp(t, b) >= 0 && fmpq_cmp(t, a) <= 0;
}

/* Move along with the edge from vertex k to the next, where the point lies on that. */
static bool move_with_edge(fmpq_t x, fmpq_t y, const tp_moved_outline *o, long k) {
  const tp_polyline *a = o->before, *b = o->now;
  const long n = k + 1 == a->count ? 0 : k + 1;
  if (!lies_between(x, a->x + k, a->x + n) || !lies_between(y, a->y + k, a->y + n) ||
      tp_points_turn(a->x + k, a->y + k, a->x + n, a->y + n, x, y) != 0) {
    return false;
  }
  fmpq_t share, work;
  fmpq_init(share);
  fmpq_init(work);
  const bool upright = fmpq_equal(a->x + k, a->x + n);
  const fmpq *from = upright ? a->y + k : a->x + k, *to = upright ? a->y + n : a->x + n;
  fmpq_sub(share, upright ? y : x, from);
  fmpq_sub(work, to, from);
  fmpq_div(share, share, work);
  fmpq_sub(work, b->x + n, b->x + k);
  fmpq_mul(work, work, share);
  fmpq_add(x, b->x + k, work);
  fmpq_sub(work, b->y + n, b->y + k);
  fmpq_mul(work, work, share);
  fmpq_add(y, b->y + k, work);
  fmpq_clear(share);
  fmpq_clear(work);
  return true;
}

static bool is_moved(const tp_moved_outline *o, long k) {
  return !fmpq_equal(o->before->x + k, o->now->x + k) ||
         !fmpq_equal(o->before->y + k, o->now->y + k);
}

void tp_move_with_outline(fmpq_t x, fmpq_t y, const void *context) {
  const tp_moved_outline *o = context;
  bool last = is_moved(o, 0);
  for (long k = 0; k < o->before->count; k++) {
    const bool first = last;
    last = is_moved(o, k + 1 == o->before->count ? 0 : k + 1);
    if ((first || last) && move_with_edge(x, y, o, k)) return;
  }
}
