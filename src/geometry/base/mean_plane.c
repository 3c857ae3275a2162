/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Sums of the least-squares line over the facets, in rationals, with whole numbers treated without
 * common denominators, and the direction that they give. */

#include "base/mean_plane.h"

void tp_mean_plane_init(tp_mean_plane *p) {
  fmpq *const all[] = {p->along[0], p->along[1], p->length, p->a, p->b, p->aa, p->ab};
  for (size_t k = 0; k < sizeof all / sizeof all[0]; k++) fmpq_init(all[k]);
}

void tp_mean_plane_clear(tp_mean_plane *p) {
  fmpq *const all[] = {p->along[0], p->along[1], p->length, p->a, p->b, p->aa, p->ab};
  for (size_t k = 0; k < sizeof all / sizeof all[0]; k++) fmpq_clear(all[k]);
}

void tp_mean_plane_ends(tp_mean_plane *p, const fmpq_t dx, const fmpq_t dy) {
  fmpq_set(p->along[0], dx);
  fmpq_set(p->along[1], dy);
}

static bool is_whole(const fmpq_t number) {
  return fmpz_is_one(fmpq_denref(number));
}

/* sum += a b, and sum -= a b: mostly of whole numbers, which take no common denominators. */
static void add_multiple(fmpq_t sum, const fmpq_t a, const fmpq_t b) {
  if (is_whole(sum) && is_whole(a) && is_whole(b)) {
    fmpz_addmul(fmpq_numref(sum), fmpq_numref(a), fmpq_numref(b));
  } else {
    fmpq_addmul(sum, a, b);
  }
}

static void subtract_multiple(fmpq_t sum, const fmpq_t a, const fmpq_t b) {
  if (is_whole(sum) && is_whole(a) && is_whole(b)) {
    fmpz_submul(fmpq_numref(sum), fmpq_numref(a), fmpq_numref(b));
  } else {
    fmpq_submul(sum, a, b);
  }
}

/* Along the line between the ends and normal to it, both times its length. */
static void turn(fmpq_t a, fmpq_t b, const tp_mean_plane *p, const fmpq_t x, const fmpq_t y) {
  fmpq_mul(a, p->along[0], x);
  add_multiple(a, p->along[1], y);
  fmpq_mul(b, p->along[0], y);
  subtract_multiple(b, p->along[1], x);
}

/* sum += weight * (f0 * 2 g0 + f0 g1 + f1 g0 + f1 * 2 g1) */
static void add_product(fmpq_t sum, const fmpq_t weight, const fmpq_t f0, const fmpq_t f1,
                        const fmpq_t g0, const fmpq_t g1) {
  fmpq_t own, both, inner;
  fmpq_init(own);
  fmpq_init(both);
  fmpq_init(inner);
  fmpq_add(both, g0, g1);
  fmpq_add(inner, both, g0);
  fmpq_mul(own, f0, inner);
  fmpq_add(inner, both, g1);
  add_multiple(own, f1, inner);
  add_multiple(sum, weight, own);
  fmpq_clear(own);
  fmpq_clear(both);
  fmpq_clear(inner);
}

void tp_mean_plane_add(tp_mean_plane *p, const fmpq_t x0, const fmpq_t y0, const fmpq_t x1,
                       const fmpq_t y1) {
  fmpq_t a0, b0, a1, b1, weight, both;
  fmpq *const all[] = {a0, b0, a1, b1, weight, both};
  for (size_t k = 0; k < sizeof all / sizeof all[0]; k++) fmpq_init(all[k]);
  turn(a0, b0, p, x0, y0);
  turn(a1, b1, p, x1, y1);
  fmpq_sub(weight, a1, a0);
  fmpq_abs(weight, weight);
  fmpq_add(p->length, p->length, weight);
  fmpq_add(both, a0, a1);
  add_multiple(p->a, weight, both);
  fmpq_add(both, b0, b1);
  add_multiple(p->b, weight, both);
  add_product(p->aa, weight, a0, a1, a0, a1);
  add_product(p->ab, weight, a0, a1, b0, b1);
  for (size_t k = 0; k < sizeof all / sizeof all[0]; k++) fmpq_clear(all[k]);
}

bool tp_mean_plane_direction(fmpq_t u, fmpq_t v, const tp_mean_plane *p) {
  if (fmpq_is_zero(p->along[0]) && fmpq_is_zero(p->along[1])) return false;
  fmpq_set(u, p->along[0]);
  fmpq_set(v, p->along[1]);
  fmpq_t slope, variance, square; /* both sums times 12 L */
  fmpq_init(slope);
  fmpq_init(variance);
  fmpq_init(square);
  fmpq_mul(variance, p->aa, p->length);
  fmpq_add(variance, variance, variance);
  fmpq_mul(square, p->a, p->a);
  fmpq_mul_ui(square, square, 3);
  fmpq_sub(variance, variance, square);
  if (!fmpq_is_zero(variance)) { /* else no facet lies along the line at all */
    fmpq_mul(slope, p->ab, p->length);
    fmpq_add(slope, slope, slope);
    fmpq_mul(square, p->a, p->b);
    fmpq_mul_ui(square, square, 3);
    fmpq_sub(slope, slope, square);
    fmpq_div(slope, slope, variance);
    fmpq_submul(u, slope, p->along[1]);
    fmpq_addmul(v, slope, p->along[0]);
  }
  fmpq_clear(slope);
  fmpq_clear(variance);
  fmpq_clear(square);
  return true;
}

bool tp_mean_plane_of_outline(fmpq_t u, fmpq_t v, const tp_polyline *line, long first, long last) {
  tp_mean_plane plane;
  fmpq_t x0, y0, x1, y1;
  tp_mean_plane_init(&plane);
  fmpq_init(x0);
  fmpq_init(y0);
  fmpq_init(x1);
  fmpq_init(y1);
  fmpq_sub(x1, line->x + last, line->x + first);
  fmpq_sub(y1, line->y + last, line->y + first);
  tp_mean_plane_ends(&plane, x1, y1);
  for (long k = first; k != last;) {
    k = k + 1 == line->count ? 0 : k + 1;
    fmpq_sub(x1, line->x + k, line->x + first);
    fmpq_sub(y1, line->y + k, line->y + first);
    tp_mean_plane_add(&plane, x0, y0, x1, y1);
    fmpq_swap(x0, x1);
    fmpq_swap(y0, y1);
  }
  const bool found = tp_mean_plane_direction(u, v, &plane);
  tp_mean_plane_clear(&plane);
  fmpq_clear(x0);
  fmpq_clear(y0);
  fmpq_clear(x1);
  fmpq_clear(y1);
  return found;
}

static void set_relative(fmpq_t x, fmpq_t y, const tp_lattice *l, long point, long from) {
  fmpz_sub(fmpq_numref(x), l->x + point, l->x + from);
  fmpz_sub(fmpq_numref(y), l->y + point, l->y + from);
  fmpz_one(fmpq_denref(x));
  fmpz_one(fmpq_denref(y));
}

bool tp_mean_plane_of_contact(fmpq_t u, fmpq_t v, const tp_contact *contact, const tp_lattice *l) {
  const long first = contact->points[0].point;
  const long last = contact->points[contact->point_count - 1].point;
  tp_mean_plane plane;
  fmpq_t x0, y0, x1, y1;
  tp_mean_plane_init(&plane);
  fmpq_init(x0);
  fmpq_init(y0);
  fmpq_init(x1);
  fmpq_init(y1);
  set_relative(x1, y1, l, last, first);
  tp_mean_plane_ends(&plane, x1, y1);
  for (long k = 0; k < contact->facet_count; k++) {
    const tp_facet *f = contact->facets + k;
    if (f->q0 == f->q1) continue;
    set_relative(x0, y0, l, f->q0, first);
    set_relative(x1, y1, l, f->q1, first);
    tp_mean_plane_add(&plane, x0, y0, x1, y1);
  }
  const bool found = tp_mean_plane_direction(u, v, &plane);
  tp_mean_plane_clear(&plane);
  fmpq_clear(x0);
  fmpq_clear(y0);
  fmpq_clear(x1);
  fmpq_clear(y1);
  return found;
}
