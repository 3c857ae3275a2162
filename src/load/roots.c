/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "load/isolate.h"

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

void tp_roots_keep(tp_roots *roots, const arb_t radians, bool rising, long bits) {
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

/* Keep an angle if its cosine, reduced to the circle, is above zero. One that many bits do not tell
 * from a right angle is out of range. */
static void keep_within(tp_roots *roots, const arb_t angle, bool rising, long bits) {
  enum { SETTLING_BITS = 1280 };
  arb_t sine, cosine, radians;
  arb_init(sine);
  arb_init(cosine);
  arb_init(radians);
  arb_sin_cos(sine, cosine, angle, bits);
  if (arb_is_positive(cosine)) {
    arb_atan2(radians, sine, cosine, bits);
    tp_roots_keep(roots, radians, rising, bits);
  } else if (!arb_is_negative(cosine)) {
    const bool narrow = mag_get_d_log2_approx(arb_radref(cosine)) <= -0.5 * (double)bits;
    if (bits < SETTLING_BITS || !narrow) roots->certain = false;
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

void tp_roots_find(tp_roots *roots, const tp_trig *f, long bits) {
  roots->count = 0;
  roots->certain = true;
  if (arb_is_zero(f->of + TP_SEC) && arb_is_zero(f->of + TP_SEC2)) {
    closed_form(roots, f, bits);
  } else {
    tp_roots_isolate(roots, f, bits);
  }
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
    if (arb_contains_zero(roots->degrees + k)) roots->certain = false; /* on which side of level? */
    const bool above = arf_sgn(arb_midref(roots->degrees + k)) > 0;
    if (!roots->rising[k] || above != stable) continue;
    arb_set(degrees, roots->degrees + k);
    found = true;
    if (stable) break; /* the first above; of those below the last */
  }
  return found;
}
