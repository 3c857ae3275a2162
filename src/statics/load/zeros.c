/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Zeros of a load function of the tilt in (-90, 90) degrees: psi +- acos(-C / R) in closed form, or
 * isolation by load/isolate.h (docs/mechanics.md section 5). */

#include "load/zeros.h"

#include "load/isolate.h"
#include "number/ball.h"
#include "number/ladder.h"

/* Keep an angle if its cosine, reduced to the circle, is above zero. One that many bits do not tell
 * from a right angle is out of range. */
static void keep_within(tp_roots *roots, const arb_t angle, bool rising, long bits) {
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
    if (bits < TP_SETTLING_BITS || !narrow) roots->certain = false;
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
