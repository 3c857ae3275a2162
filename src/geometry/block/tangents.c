/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Comparisons of tangent points of rounded corners along a direction, each the sign of a sum of
 * square roots of integers (number/surd.h). */

#include "block/tangents.h"

#include "number/surd.h"
#include "number/word.h"

/* The tangent point as v + (own |e| + other |f|) e, e its edge and f the corner's other one. */
typedef struct tangent {
  fmpz_t ex, ey, own_square, other_square;
  fmpq_t own, other;
} tangent;

static void edge_vector(fmpz_t x, fmpz_t y, const tp_lattice *l, long from, long to) {
  fmpz_sub(x, l->x + to, l->x + from);
  fmpz_sub(y, l->y + to, l->y + from);
}

static void dot(fmpz_t value, const fmpz_t ax, const fmpz_t ay, const fmpz_t bx, const fmpz_t by) {
  fmpz_mul(value, ax, bx);
  fmpz_addmul(value, ay, by);
}

static void tangent_init(tangent *t, const tp_corner *c, bool after, const tp_lattice *l) {
  fmpz_t fx, fy, cross, along;
  fmpz_init(fx);
  fmpz_init(fy);
  fmpz_init(cross);
  fmpz_init(along);
  fmpz_init(t->ex);
  fmpz_init(t->ey);
  fmpz_init(t->own_square);
  fmpz_init(t->other_square);
  fmpq_init(t->own);
  fmpq_init(t->other);
  edge_vector(t->ex, t->ey, l, c->vertex, after ? c->after : c->before);
  edge_vector(fx, fy, l, c->vertex, after ? c->before : c->after);
  dot(t->own_square, t->ex, t->ey, t->ex, t->ey);
  dot(t->other_square, fx, fy, fx, fy);
  dot(along, t->ex, t->ey, fx, fy);
  fmpz_mul(cross, t->ex, fy);
  fmpz_submul(cross, t->ey, fx);
  fmpz_abs(cross, cross);
  fmpq_div_fmpz(t->other, c->radius, cross);
  fmpq_mul_fmpz(t->own, t->other, along);
  fmpq_div_fmpz(t->own, t->own, t->own_square);
  fmpz_clear(fx);
  fmpz_clear(fy);
  fmpz_clear(cross);
  fmpz_clear(along);
}

static void tangent_clear(tangent *t) {
  fmpz_clear(t->ex);
  fmpz_clear(t->ey);
  fmpz_clear(t->own_square);
  fmpz_clear(t->other_square);
  fmpq_clear(t->own);
  fmpq_clear(t->other);
}

/* sum += factor (T - v) . a / (e . a): the share of the edge, times a whole number. */
static void add_share(tp_surd *sum, const tangent *t, const fmpz_t factor) {
  fmpq_t part;
  fmpq_init(part);
  fmpq_mul_fmpz(part, t->own, factor);
  tp_surd_add_root(sum, part, t->own_square);
  fmpq_mul_fmpz(part, t->other, factor);
  tp_surd_add_root(sum, part, t->other_square);
  fmpq_clear(part);
}

bool tp_outline_point_is_same(const tp_lattice *l, tp_outline_point a, tp_outline_point b) {
  if (a.cut != b.cut) return false;
  if (a.cut != NULL) return a.after == b.after;
  return a.point == b.point || (tp_word_equal(l->x + a.point, l->x + b.point) &&
                                tp_word_equal(l->y + a.point, l->y + b.point));
}

/* sum += sign (p . t): of the lattice point or the vertex as a whole number, of a tangent point
 * what lies beyond the vertex. */
static void add_along(tp_surd *sum, fmpz_t whole, tp_outline_point p, int sign, const fmpz_t tx,
                      const fmpz_t ty, const tp_lattice *l) {
  const long point = p.cut != NULL ? p.cut->vertex : p.point;
  fmpz_t value;
  fmpz_init(value);
  dot(value, l->x + point, l->y + point, tx, ty);
  if (sign < 0) fmpz_neg(value, value);
  fmpz_add(whole, whole, value);
  if (p.cut != NULL) {
    tangent t;
    tangent_init(&t, p.cut, p.after, l);
    dot(value, t.ex, t.ey, tx, ty);
    if (sign < 0) fmpz_neg(value, value);
    add_share(sum, &t, value);
    tangent_clear(&t);
  }
  fmpz_clear(value);
}

int tp_outline_point_along(const tp_lattice *l, tp_outline_point p, tp_outline_point q, long t0,
                           long t1) {
  tp_surd sum;
  fmpz_t tx, ty, whole;
  tp_surd_init(&sum);
  fmpz_init(tx);
  fmpz_init(ty);
  fmpz_init(whole);
  edge_vector(tx, ty, l, t0, t1);
  add_along(&sum, whole, q, 1, tx, ty, l);
  add_along(&sum, whole, p, -1, tx, ty, l);
  fmpq_set_fmpz(sum.c, whole);
  const int sign = tp_surd_sign(&sum);
  tp_surd_clear(&sum);
  fmpz_clear(tx);
  fmpz_clear(ty);
  fmpz_clear(whole);
  return sign;
}

int tp_tangent_compare(const tp_corner *c, bool after, const tp_lattice *l, long point) {
  const tp_outline_point tangent_point = {c->vertex, c, after}, own = {point, NULL, false};
  return tp_outline_point_along(l, tangent_point, own, c->vertex, after ? c->after : c->before);
}

int tp_tangents_room(const tp_corner *start, const tp_corner *end, const tp_lattice *l) {
  if (start == NULL && end == NULL) return 1;
  const long from = start != NULL ? start->vertex : end->before;
  const long to = start != NULL ? start->after : end->vertex;
  const tp_outline_point first = {from, start, true}, last = {to, end, false};
  return tp_outline_point_along(l, first, last, from, to);
}
