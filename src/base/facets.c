/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "base/facets.h"

#include <stdlib.h>

bool tp_facets_append(tp_facets *facets, tp_facet facet) {
  if (facets->count == facets->capacity) {
    const long capacity = facets->capacity == 0 ? 16 : 2 * facets->capacity;
    tp_facet *items = realloc(facets->items, (size_t)capacity * sizeof *items);
    if (items == NULL) return false;
    facets->items = items;
    facets->capacity = capacity;
  }
  facets->items[facets->count++] = facet;
  return true;
}

static int bilinear_sign(const fmpz *a, const fmpz *b, const fmpz *c, const fmpz *d, bool add) {
  fmpz_t result;
  fmpz_init(result);
  fmpz_mul(result, a, b);
  if (add) {
    fmpz_addmul(result, c, d);
  } else {
    fmpz_submul(result, c, d);
  }
  const int sign = fmpz_sgn(result);
  fmpz_clear(result);
  return sign;
}

static int sign_of_product(const tp_lattice *l, long a, long b, long c, long d, bool dot) {
  fmpz r[4]; /* dx and dy of b - a and of d - c */
  for (int k = 0; k < 4; k++) fmpz_init(r + k);
  fmpz_sub(r, l->x + b, l->x + a);
  fmpz_sub(r + 1, l->y + b, l->y + a);
  fmpz_sub(r + 2, l->x + d, l->x + c);
  fmpz_sub(r + 3, l->y + d, l->y + c);
  const int sign = dot ? bilinear_sign(r, r + 2, r + 1, r + 3, true)
                       : bilinear_sign(r, r + 3, r + 1, r + 2, false);
  for (int k = 0; k < 4; k++) fmpz_clear(r + k);
  return sign;
}

int tp_facet_cross(const tp_lattice *lattice, long a, long b, long c, long d) {
  return sign_of_product(lattice, a, b, c, d, false);
}

int tp_facet_dot(const tp_lattice *lattice, long a, long b, long c, long d) {
  return sign_of_product(lattice, a, b, c, d, true);
}

static bool is_on(const tp_lattice *l, long point, long from, long to) {
  return tp_facet_cross(l, from, to, from, point) == 0 &&
         tp_facet_dot(l, from, point, from, to) >= 0 && tp_facet_dot(l, to, point, to, from) >= 0;
}

long tp_facet_touch(const tp_lattice *l, long a0, long a1, long b0, long b1) {
  if (is_on(l, a0, b0, b1)) return a0;
  if (is_on(l, a1, b0, b1)) return a1;
  return is_on(l, b0, a0, a1) ? b0 : b1;
}

bool tp_facet_same_point(const tp_lattice *lattice, long a, long b) {
  return a == b ||
         (fmpz_equal(lattice->x + a, lattice->x + b) && fmpz_equal(lattice->y + a, lattice->y + b));
}

tp_outline_point tp_facet_begin(const tp_facet *facet) {
  return (tp_outline_point){facet->q0, facet->cut0, true};
}

tp_outline_point tp_facet_end(const tp_facet *facet) {
  if (facet->q0 == facet->q1) return tp_facet_begin(facet);
  return (tp_outline_point){facet->q1, facet->cut1, false};
}

bool tp_facet_ends_in(const tp_lattice *lattice, const tp_facet *facet, tp_outline_point point) {
  return tp_outline_point_is_same(lattice, tp_facet_begin(facet), point) ||
         tp_outline_point_is_same(lattice, tp_facet_end(facet), point);
}

int tp_facet_side(const tp_lattice *lattice, const tp_facet *facet, tp_outline_point p,
                  tp_outline_point q) {
  if (p.cut == NULL && q.cut == NULL) {
    return tp_facet_dot(lattice, p.point, q.point, facet->t0, facet->t1);
  }
  return tp_outline_point_along(lattice, p, q, facet->t0, facet->t1);
}
