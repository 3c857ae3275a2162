/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "load/roots.h"

#include "number/ball.h"

void tp_roots_init(tp_roots *roots) {
  roots->count = 0;
  roots->certain = true;
  for (int k = 0; k < TP_ROOTS_MAX; k++) arb_init(roots->degrees + k);
}

void tp_roots_clear(tp_roots *roots) {
  for (int k = 0; k < TP_ROOTS_MAX; k++) arb_clear(roots->degrees + k);
}

static void to_degrees(arb_t degrees, const arb_t radians, long bits) {
  arb_t pi;
  arb_init(pi);
  arb_const_pi(pi, bits);
  arb_mul_ui(degrees, radians, 180, bits);
  arb_div(degrees, degrees, pi, bits);
  arb_clear(pi);
}

/* Keep a zero, in its place. */
static void keep(tp_roots *roots, const arb_t radians, bool rising, long bits) {
  if (roots->count == TP_ROOTS_MAX) {
    roots->certain = false;
    return;
  }
  long at = roots->count++;
  arb_t degrees;
  arb_init(degrees);
  to_degrees(degrees, radians, bits);
  for (; at > 0 && arf_cmp(arb_midref(roots->degrees + at - 1), arb_midref(degrees)) > 0; at--) {
    arb_swap(roots->degrees + at, roots->degrees + at - 1);
    roots->rising[at] = roots->rising[at - 1];
  }
  arb_swap(roots->degrees + at, degrees);
  roots->rising[at] = rising;
  arb_clear(degrees);
}

/* Keep an angle if its cosine, reduced to the circle, is above zero. One at a right angle as far as
 * half the precision tells is out of range. */
static void keep_within(tp_roots *roots, const arb_t angle, bool rising, long bits) {
  arb_t sine, cosine, radians;
  arb_init(sine);
  arb_init(cosine);
  arb_init(radians);
  arb_sin_cos(sine, cosine, angle, bits);
  if (arb_is_positive(cosine)) {
    arb_atan2(radians, sine, cosine, bits);
    keep(roots, radians, rising, bits);
  } else if (!arb_is_negative(cosine) &&
             mag_get_d_log2_approx(arb_radref(cosine)) > -0.5 * (double)bits) {
    roots->certain = false;
  }
  arb_clear(sine);
  arb_clear(cosine);
  arb_clear(radians);
}

/* The direction of (A, B). Where A is below zero and the sign of B is not known it is half a turn
 * from that of (-A, -B), which is known. */
static void set_direction(arb_t psi, const tp_trig *f, long bits) {
  if (!arb_is_negative(f->of + TP_COS) || !arb_contains_zero(f->of + TP_SIN)) {
    arb_atan2(psi, f->of + TP_SIN, f->of + TP_COS, bits);
    return;
  }
  arb_t a, b;
  arb_init(a);
  arb_init(b);
  arb_neg(a, f->of + TP_COS);
  arb_neg(b, f->of + TP_SIN);
  arb_atan2(psi, b, a, bits);
  arb_const_pi(a, bits);
  arb_add(psi, psi, a, bits);
  arb_clear(a);
  arb_clear(b);
}

static void closed_form(tp_roots *roots, const tp_trig *f, long bits) {
  arb_t size, share, psi, delta, angle;
  arb_init(size);
  arb_init(share);
  arb_init(psi);
  arb_init(delta);
  arb_init(angle);
  arb_hypot(size, f->of + TP_COS, f->of + TP_SIN, bits);
  arb_abs(share, f->of + TP_ONE);
  if (arb_gt(size, share)) {
    arb_div(share, f->of + TP_ONE, size, bits);
    arb_neg(share, share);
    arb_acos(delta, share, bits);
    set_direction(psi, f, bits);
    arb_sub(angle, psi, delta, bits);
    keep_within(roots, angle, true, bits);
    arb_add(angle, psi, delta, bits);
    keep_within(roots, angle, false, bits);
  } else if (!arb_lt(size, share)) {
    roots->certain = false; /* a double zero, or nothing acts */
  }
  arb_clear(size);
  arb_clear(share);
  arb_clear(psi);
  arb_clear(delta);
  arb_clear(angle);
}

static void value_at(arb_t value, const tp_trig *f, const arb_t angle, long bits) {
  arb_t sine, cosine;
  arb_init(sine);
  arb_init(cosine);
  arb_sin_cos(sine, cosine, angle, bits);
  tp_trig_evaluate(value, f, sine, cosine, bits);
  arb_clear(sine);
  arb_clear(cosine);
}

/* f' = -A sin + B cos + (D + 2 E / cos) sin / cos^2 */
static void slope_at(arb_t slope, const tp_trig *f, const arb_t angle, long bits) {
  arb_t sine, cosine, term;
  arb_init(sine);
  arb_init(cosine);
  arb_init(term);
  arb_sin_cos(sine, cosine, angle, bits);
  arb_mul_2exp_si(term, f->of + TP_SEC2, 1);
  arb_div(term, term, cosine, bits);
  arb_add(term, term, f->of + TP_SEC, bits);
  arb_div(term, term, cosine, bits);
  arb_div(term, term, cosine, bits);
  arb_sub(term, term, f->of + TP_COS, bits);
  arb_mul(slope, term, sine, bits);
  arb_addmul(slope, f->of + TP_SIN, cosine, bits);
  arb_clear(sine);
  arb_clear(cosine);
  arb_clear(term);
}

/* An interval with ends of machine precision at first. */
typedef struct box {
  arf_t low, high;
} box;

static void box_ball(arb_t ball, const box *b, long bits) {
  arb_set_interval_arf(ball, b->low, b->high, bits);
}

static int sign_at(const tp_trig *f, const arf_t at, long bits) {
  arb_t x, value;
  arb_init(x);
  arb_init(value);
  arb_set_arf(x, at);
  value_at(value, f, x, bits);
  const int sign = arb_is_positive(value) ? 1 : arb_is_negative(value) ? -1 : 0;
  arb_clear(x);
  arb_clear(value);
  return sign;
}

/* Narrow a box over which f is monotone and changes its sign. */
static void bracket(tp_roots *roots, const tp_trig *f, box *b, long bits) {
  const int low = sign_at(f, b->low, bits);
  arf_t middle;
  arf_init(middle);
  for (long k = 0; k < bits; k++) {
    arf_add(middle, b->low, b->high, bits, ARF_RND_NEAR);
    arf_mul_2exp_si(middle, middle, -1);
    const int own = sign_at(f, middle, bits);
    if (own == 0) break;
    arf_set(own == low ? b->low : b->high, middle);
  }
  arf_clear(middle);
  arb_t radians;
  arb_init(radians);
  box_ball(radians, b, bits);
  keep(roots, radians, low < 0, bits);
  arb_clear(radians);
}

/* Zeros in a box: none, one, or halves of it. Where one box stays open to the last nothing is
 * certain any more, and the others are not looked at: with bounds too wide for this precision they
 * would all stay open, 2^60 of them. */
static void isolate(tp_roots *roots, const tp_trig *f, box *b, int depth, long bits) {
  enum { MOST_DEPTH = 60 };
  if (!roots->certain) return;
  arb_t x, value;
  arb_init(x);
  arb_init(value);
  box_ball(x, b, bits);
  value_at(value, f, x, bits);
  bool settled = arb_is_finite(value) && !arb_contains_zero(value);
  if (!settled) {
    slope_at(value, f, x, bits);
    const int low = sign_at(f, b->low, bits), high = sign_at(f, b->high, bits);
    if (arb_is_finite(value) && !arb_contains_zero(value) && low != 0 && high != 0) {
      settled = true;
      if (low != high) bracket(roots, f, b, bits);
    }
  }
  arb_clear(x);
  arb_clear(value);
  if (settled) return;
  if (depth == MOST_DEPTH) {
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
  arf_sub(half[0].high, b->high, b->low, bits, ARF_RND_NEAR);
  arf_mul_ui(half[0].high, half[0].high, 517, bits, ARF_RND_NEAR);
  arf_mul_2exp_si(half[0].high, half[0].high, -10);
  arf_add(half[0].high, half[0].high, b->low, bits, ARF_RND_NEAR);
  arf_set(half[1].low, half[0].high);
  for (int k = 0; k < 2; k++) {
    isolate(roots, f, half + k, depth + 1, bits);
    arf_clear(half[k].low);
    arf_clear(half[k].high);
  }
}

void tp_roots_find(tp_roots *roots, const tp_trig *f, const arb_t limit, long bits) {
  roots->count = 0;
  roots->certain = true;
  if (arb_is_zero(f->of + TP_SEC) && arb_is_zero(f->of + TP_SEC2)) {
    closed_form(roots, f, bits);
    return;
  }
  box all;
  arf_init(all.low);
  arf_init(all.high);
  arb_get_lbound_arf(all.high, limit, bits);
  arf_neg(all.low, all.high);
  isolate(roots, f, &all, 0, bits);
  arf_clear(all.low);
  arf_clear(all.high);
}

/* The zero that may be level ground itself: its index where it is the only one and rising, else -1.
 * If what is level is stable by less than its ball tells, it is the first zero above; if not, the
 * last one below; if it is just in balance, it is level: in all cases the one within the ball. */
static long zero_at_level(const tp_roots *roots) {
  long found = -1;
  for (long k = 0; k < roots->count; k++) {
    if (!arb_contains_zero(roots->degrees + k)) continue;
    if (found >= 0 || !roots->rising[k]) return -1;
    found = k;
  }
  return found;
}

bool tp_roots_critical(arb_t degrees, bool *always, tp_roots *roots, const arb_t level) {
  const bool stable = arb_is_negative(level) != 0;
  *always = !stable;
  if (!stable && !arb_is_positive(level)) {
    const long at = zero_at_level(roots);
    if (at >= 0) {
      arb_set(degrees, roots->degrees + at);
      return true;
    }
    roots->certain = false;
  }
  bool found = false;
  for (long k = 0; k < roots->count; k++) {
    const bool above = arf_sgn(arb_midref(roots->degrees + k)) > 0;
    if (!roots->rising[k] || above != stable) continue;
    arb_set(degrees, roots->degrees + k);
    found = true;
    if (stable) break; /* the first above; of those below the last */
  }
  return found;
}
