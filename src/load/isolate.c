/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Zeros are told apart by Arb's own isolation (arb_calc): boxes are halved until the function has
 * no zero over one, or changes its sign over it with a slope that has none. Each zero is then
 * narrowed by Newton's steps in intervals. Those of arb_calc do not serve: they want a start that
 * is known to so many bits of its size, which a zero at level ground never is, and a second
 * derivative. */

#include "load/isolate.h"

#include "number/ball.h"

#include <arb_calc.h>
#include <arb_poly.h>

/* A function of the tilt times the power of cos a, 1 or 2, with which it stays bounded up to the
 * right angles: there it is its leading term alone, so that a zero close to them is one of f. */
typedef struct bounded {
  const tp_trig *f;
  bool squared;
  long bits;
} bounded;

static bounded bound(const tp_trig *f, long bits) {
  return (bounded){f, !arb_is_zero(f->of + TP_SEC2), bits};
}

/* The value, and of `order` 2 the slope after it: with p = A cos + B sin + C p cos + D, or
 * (p cos + D) cos + E, in power series about the angle. */
static void series_at(arb_ptr out, const bounded *b, const arb_t angle, slong order) {
  enum { ORDER = 2 };
  const arb_struct *of = b->f->of;
  const int last = b->squared ? TP_SEC2 : TP_SEC;
  arb_ptr room = _arb_vec_init(4 * ORDER);
  arb_ptr sine = room, cosine = room + ORDER, product = room + 2 * ORDER, at = room + 3 * ORDER;
  arb_set(at, angle);
  arb_one(at + 1);
  _arb_poly_sin_cos_series(sine, cosine, at, ORDER, order, b->bits);
  _arb_vec_scalar_mul(out, cosine, order, of + TP_COS, b->bits);
  _arb_vec_scalar_addmul(out, sine, order, of + TP_SIN, b->bits);
  arb_add(out, out, of + TP_ONE, b->bits);
  for (int k = TP_SEC; k <= last; k++) {
    _arb_poly_mullow(product, out, order, cosine, order, order, b->bits);
    arb_add(out, product, of + k, b->bits);
    if (order > 1) arb_swap(out + 1, product + 1);
  }
  _arb_vec_clear(room, 4 * ORDER);
}

static int sign_at(const bounded *g, const arf_t at) {
  arb_t x, value;
  arb_init(x);
  arb_init(value);
  arb_set_arf(x, at);
  series_at(value, g, x, 1);
  const int sign = tp_ball_sign(value);
  arb_clear(x);
  arb_clear(value);
  return sign;
}

/* Newton's step in intervals, m - g(m) / g'(box), keeps the zero: is what is left of the box less
 * than half as wide? */
static bool contract(arf_interval_t box, const bounded *g, const arf_t middle) {
  arb_ptr over = _arb_vec_init(2), slope = over + 1; /* the box */
  arb_t x, value;
  arf_t low, high, width, left;
  arb_init(x);
  arb_init(value);
  arf_init(low);
  arf_init(high);
  arf_init(width);
  arf_init(left);
  arf_interval_get_arb(x, box, g->bits);
  series_at(over, g, x, 2);
  arb_set_arf(x, middle);
  series_at(value, g, x, 1);
  arb_div(value, value, slope, g->bits);
  arb_sub(x, x, value, g->bits);
  bool narrower = false;
  if (arb_is_finite(x)) {
    arb_get_interval_arf(low, high, x, g->bits);
    arf_max(low, low, &box->a);
    arf_min(high, high, &box->b);
    arf_sub(width, &box->b, &box->a, g->bits, ARF_RND_NEAR);
    arf_sub(left, high, low, g->bits, ARF_RND_NEAR);
    arf_mul_2exp_si(left, left, 1);
    narrower = arf_cmp(left, width) < 0 && arf_cmp(low, high) <= 0;
  }
  if (narrower) {
    arf_swap(&box->a, low);
    arf_swap(&box->b, high);
  }
  _arb_vec_clear(over, 2);
  arb_clear(x);
  arb_clear(value);
  arf_clear(low);
  arf_clear(high);
  arf_clear(width);
  arf_clear(left);
  return narrower;
}

/* Narrow a box over which g is monotone and changes its sign. */
static void bracket(tp_roots *roots, const tp_trig *f, arf_interval_t box, long bits) {
  const bounded own_bits = bound(f, bits), *g = &own_bits;
  const int low = sign_at(g, &box->a), high = sign_at(g, &box->b);
  if (low == 0 || high != -low) {
    roots->certain = false;
    return;
  }
  arf_t middle;
  arf_init(middle);
  for (long k = 0; k < g->bits; k++) {
    arf_add(middle, &box->a, &box->b, g->bits, ARF_RND_NEAR);
    arf_mul_2exp_si(middle, middle, -1);
    if (arf_cmp(middle, &box->a) <= 0 || arf_cmp(middle, &box->b) >= 0) break;
    if (contract(box, g, middle)) continue;
    const int own = sign_at(g, middle);
    if (own == 0) break;
    arf_set(own == low ? &box->a : &box->b, middle);
  }
  arf_clear(middle);
  arb_t radians;
  arb_init(radians);
  arf_interval_get_arb(radians, box, g->bits);
  tp_roots_keep(roots, radians, low < 0, g->bits);
  arb_clear(radians);
}

/* What Arb's isolation asks. Where a box that is halved no further stays open nothing is certain
 * any more, and the others are not looked at: with bounds too wide for this precision they would
 * all stay open. They are called free of zeros, and what is found is not used. */
typedef struct isolation {
  bounded g;
  long depth;
  bool open;
} isolation;

static int look(arb_ptr out, const arb_t angle, void *context, slong order, slong prec) {
  isolation *own = context;
  const mag_struct *radius = arb_radref(angle);
  (void)prec; /* that of g */
  if (!mag_is_zero(radius) && mag_cmp_2exp_si(radius, -own->depth) < 0) own->open = true;
  if (own->open) {
    arb_one(out);
    return ARB_CALC_SUCCESS;
  }
  series_at(out, &own->g, angle, order);
  return ARB_CALC_SUCCESS;
}

/* The zeros in a box, each narrowed with so many `bits`. */
static void isolate(tp_roots *roots, isolation *own, const arf_interval_t box, long bits) {
  arf_interval_ptr found = NULL;
  int *single = NULL;
  const slong count = arb_calc_isolate_roots(&found, &single, look, own, box, own->depth + 2,
                                             WORD_MAX, TP_ROOTS_MAX + 1, own->g.bits);
  if (own->open) roots->certain = false;
  for (slong k = 0; k < count && roots->certain; k++) {
    roots->certain = single[k] == 1;
    if (roots->certain) bracket(roots, own->g.f, found + k, bits);
  }
  _arf_interval_vec_clear(found, count);
  flint_free(single);
}

/* A double zero stays open however often its box is halved: with n bits it is not told from two
 * that lie 2^(-n / 2) apart, after as many halvings as that. */
static long most_depth(long bits) {
  enum { SPARE = 16, MOST = 360 };
  return bits / 2 + SPARE < MOST ? bits / 2 + SPARE : MOST;
}

/* The right angle rounded up, with the sign of the leading term there as at it; or where that is
 * not told from zero the angle next to it: a zero nearer to upright than 2^(-n / 3) is then beyond
 * what n bits can tell. */
static void set_end(arf_t end, const bounded *g) {
  arb_t angle;
  arb_init(angle);
  arb_const_pi(angle, g->bits);
  arb_mul_2exp_si(angle, angle, -1);
  arb_get_ubound_arf(end, angle, g->bits);
  const int leading = tp_ball_sign(g->f->of + (g->squared ? TP_SEC2 : TP_SEC));
  const int above = sign_at(g, end);
  arf_neg(end, end);
  const int below = sign_at(g, end);
  arf_neg(end, end);
  if (leading == 0 || above != leading || below != leading) {
    arf_t off;
    arf_init(off);
    arf_set_si_2exp_si(off, 1, -g->bits / 3);
    arf_sub(end, end, off, g->bits, ARF_RND_DOWN);
    arf_clear(off);
  }
  arb_clear(angle);
}

/* On either side of an angle that is not quite level, so that zeros at round angles fall inside. */
static void find(tp_roots *roots, const tp_trig *f, long few, long bits) {
  isolation own = {bound(f, few), most_depth(few), false};
  arf_interval_t below, above;
  arf_interval_init(below);
  arf_interval_init(above);
  set_end(&above->b, &own.g);
  arf_neg(&below->a, &above->b);
  arf_mul_ui(&below->b, &above->b, 5, few, ARF_RND_NEAR);
  arf_mul_2exp_si(&below->b, &below->b, -9);
  arf_set(&above->a, &below->b);
  isolate(roots, &own, below, bits);
  if (roots->certain) isolate(roots, &own, above, bits);
  arf_interval_clear(below);
  arf_interval_clear(above);
}

/* Telling zeros apart takes many looks and few bits, as a rule. */
void tp_roots_isolate(tp_roots *roots, const tp_trig *f, long bits) {
  enum { FEW_BITS = 128 };
  for (long few = FEW_BITS; few < bits; few *= 4) {
    find(roots, f, few, bits);
    if (roots->certain) return;
    roots->count = 0;
    roots->certain = true;
  }
  find(roots, f, bits, bits);
}
