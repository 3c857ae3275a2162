/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Zeros by interval bisection (docs/mechanics.md section 5): a box over which the function has no
 * zero is dropped, one over which its slope has none is narrowed by Newton's steps in intervals or
 * by bisection, any other is halved.
 *
 * Why not by arb_calc, whose isolation does the like: it settles no box without a zero by its
 * slope, and next to two zeros that all but meet the boxes that are left to it double with every
 * bit. Its Newton's method wants a start that is known to some bits of its size, which a zero at
 * level ground never is. */

#include "load/isolate.h"

#include "number/ball.h"

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

/* With p = A cos + B sin + C: p cos + D, or (p cos + D) cos + E. */
static void value_at(arb_t value, const bounded *b, const arb_t angle) {
  const arb_struct *of = b->f->of;
  arb_t sine, cosine;
  arb_init(sine);
  arb_init(cosine);
  arb_sin_cos(sine, cosine, angle, b->bits);
  arb_mul(value, of + TP_COS, cosine, b->bits);
  arb_addmul(value, of + TP_SIN, sine, b->bits);
  arb_add(value, value, of + TP_ONE, b->bits);
  arb_mul(value, value, cosine, b->bits);
  arb_add(value, value, of + TP_SEC, b->bits);
  if (b->squared) {
    arb_mul(value, value, cosine, b->bits);
    arb_add(value, value, of + TP_SEC2, b->bits);
  }
  arb_clear(sine);
  arb_clear(cosine);
}

/* With p' = B cos - A sin: p' cos - p sin, or (p' cos - 2 p sin) cos - D sin. */
static void slope_at(arb_t slope, const bounded *b, const arb_t angle) {
  const arb_struct *of = b->f->of;
  arb_t sine, cosine, p;
  arb_init(sine);
  arb_init(cosine);
  arb_init(p);
  arb_sin_cos(sine, cosine, angle, b->bits);
  arb_mul(slope, of + TP_SIN, cosine, b->bits);
  arb_submul(slope, of + TP_COS, sine, b->bits);
  arb_mul(slope, slope, cosine, b->bits);
  arb_mul(p, of + TP_COS, cosine, b->bits);
  arb_addmul(p, of + TP_SIN, sine, b->bits);
  arb_add(p, p, of + TP_ONE, b->bits);
  if (b->squared) arb_mul_2exp_si(p, p, 1);
  arb_submul(slope, p, sine, b->bits);
  if (b->squared) {
    arb_mul(slope, slope, cosine, b->bits);
    arb_submul(slope, of + TP_SEC, sine, b->bits);
  }
  arb_clear(sine);
  arb_clear(cosine);
  arb_clear(p);
}

/* An interval with ends of machine precision at first. */
typedef struct box {
  arf_t low, high;
} box;

static void box_ball(arb_t ball, const box *b, long bits) {
  arb_set_interval_arf(ball, b->low, b->high, bits);
}

static int sign_at(const bounded *g, const arf_t at) {
  arb_t x, value;
  arb_init(x);
  arb_init(value);
  arb_set_arf(x, at);
  value_at(value, g, x);
  const int sign = tp_ball_sign(value);
  arb_clear(x);
  arb_clear(value);
  return sign;
}

/* Newton's step in intervals, m - g(m) / g'(box), keeps the zero: is what is left of the box less
 * than half as wide? */
static bool contract(box *b, const bounded *g, const arf_t middle) {
  arb_t x, value, slope;
  arf_t low, high, width, left;
  arb_init(x);
  arb_init(value);
  arb_init(slope);
  arf_init(low);
  arf_init(high);
  arf_init(width);
  arf_init(left);
  box_ball(x, b, g->bits);
  slope_at(slope, g, x);
  arb_set_arf(x, middle);
  value_at(value, g, x);
  arb_div(value, value, slope, g->bits);
  arb_sub(x, x, value, g->bits);
  bool narrower = false;
  if (arb_is_finite(x)) {
    arb_get_interval_arf(low, high, x, g->bits);
    arf_max(low, low, b->low);
    arf_min(high, high, b->high);
    arf_sub(width, b->high, b->low, g->bits, ARF_RND_NEAR);
    arf_sub(left, high, low, g->bits, ARF_RND_NEAR);
    arf_mul_2exp_si(left, left, 1);
    narrower = arf_cmp(left, width) < 0 && arf_cmp(low, high) <= 0;
  }
  if (narrower) {
    arf_swap(b->low, low);
    arf_swap(b->high, high);
  }
  arb_clear(x);
  arb_clear(value);
  arb_clear(slope);
  arf_clear(low);
  arf_clear(high);
  arf_clear(width);
  arf_clear(left);
  return narrower;
}

/* Narrow a box over which g is monotone and changes its sign. */
static void bracket(tp_roots *roots, const tp_trig *f, box *b, long bits) {
  const bounded own_bits = bound(f, bits), *g = &own_bits;
  const int low = sign_at(g, b->low), high = sign_at(g, b->high);
  if (low == 0 || high != -low) {
    roots->certain = false;
    return;
  }
  arf_t middle;
  arf_init(middle);
  for (long k = 0; k < g->bits; k++) {
    arf_add(middle, b->low, b->high, g->bits, ARF_RND_NEAR);
    arf_mul_2exp_si(middle, middle, -1);
    if (arf_cmp(middle, b->low) <= 0 || arf_cmp(middle, b->high) >= 0) break;
    if (contract(b, g, middle)) continue;
    const int own = sign_at(g, middle);
    if (own == 0) break;
    arf_set(own == low ? b->low : b->high, middle);
  }
  arf_clear(middle);
  arb_t radians;
  arb_init(radians);
  box_ball(radians, b, g->bits);
  tp_roots_keep(roots, radians, low < 0, g->bits);
  arb_clear(radians);
}

/* Zeros in a box: none, one, which is narrowed with so many `bits`, or halves of it. Where one box
 * stays open to the last nothing is certain any more, and the others are not looked at: with bounds
 * too wide for this precision they would all stay open. */
static void isolate(tp_roots *roots, const bounded *g, box *b, long depth, long bits) {
  if (!roots->certain) return;
  arb_t x, value;
  arb_init(x);
  arb_init(value);
  box_ball(x, b, g->bits);
  value_at(value, g, x);
  bool settled = arb_is_finite(value) && !arb_contains_zero(value);
  if (!settled) {
    slope_at(value, g, x);
    const int low = sign_at(g, b->low), high = sign_at(g, b->high);
    if (arb_is_finite(value) && !arb_contains_zero(value) && low != 0 && high != 0) {
      settled = true;
      if (low != high) bracket(roots, g->f, b, bits);
    }
  }
  arb_clear(x);
  arb_clear(value);
  if (settled) return;
  if (depth == 0) {
    roots->certain = false;
    return;
  }
  box half[2];
  for (int k = 0; k < 2; k++) {
    arf_init(half[k].low);
    arf_init(half[k].high);
    arf_set(half[k].low, b->low);
    arf_set(half[k].high, b->high);
  }
  /* not quite in the middle, so that zeros at round angles fall inside */
  arf_sub(half[0].high, b->high, b->low, g->bits, ARF_RND_NEAR);
  arf_mul_ui(half[0].high, half[0].high, 517, g->bits, ARF_RND_NEAR);
  arf_mul_2exp_si(half[0].high, half[0].high, -10);
  arf_add(half[0].high, half[0].high, b->low, g->bits, ARF_RND_NEAR);
  arf_set(half[1].low, half[0].high);
  for (int k = 0; k < 2; k++) {
    isolate(roots, g, half + k, depth - 1, bits);
    arf_clear(half[k].low);
    arf_clear(half[k].high);
  }
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

static void find(tp_roots *roots, const tp_trig *f, long few, long bits) {
  const bounded g = bound(f, few);
  box all;
  arf_init(all.low);
  arf_init(all.high);
  set_end(all.high, &g);
  arf_neg(all.low, all.high);
  isolate(roots, &g, &all, most_depth(few), bits);
  arf_clear(all.low);
  arf_clear(all.high);
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
