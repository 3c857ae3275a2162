/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* With the tilt a, f = L cos a + R sin a + C = H cos(a - d) + C, H = |(L, R)|: in a quarter of a
 * turn two zeros at most. Where its signs on level ground, of L + C, and upright, of R + C, differ,
 * it has one; where they do not it has none, unless it turns in between, L and R being of the other
 * sign, and passes zero there, H > |C|.
 *
 * At a zero (cos a, sin a) = (-C L -+ q R, -C R +- q L) / H^2 with q^2 = H^2 - C^2, the upper signs
 * where f falls. Both are positive there, and where the terms of one cancel it is what their
 * product with the other sign is over it: C^2 R^2 - q^2 L^2 = (C^2 - L^2) H^2, likewise with L and
 * R changed. */

#include "case_filter/tilt_form.h"

tp_near tp_tilt_secant(tp_near tangent) {
  static const tp_near one = {1, 0};
  return tp_near_is_zero(tangent) ? one
                                  : tp_near_sqrt(tp_near_add(one, tp_near_mul(tangent, tangent)));
}

/* a + b, where they cancel from (a + b) (a - b) = (c + e) (c - e) h. */
static tp_near sum(tp_near a, tp_near b, tp_near c, tp_near e, tp_near h) {
  if ((a.value < 0) == (b.value < 0)) return tp_near_plus(a, b);
  const tp_near product = tp_near_times(tp_near_times(tp_near_plus(c, e), tp_near_minus(c, e)), h);
  return tp_near_is_zero(product) ? product : tp_near_div(product, tp_near_minus(a, b));
}

/* The one zero, where f falls through it. */
static tp_near zero_of(tp_near l, tp_near r, tp_near c) {
  const tp_near h = tp_near_plus(tp_near_times(l, l), tp_near_times(r, r));
  const tp_near q = tp_near_sqrt(tp_near_minus(h, tp_near_times(c, c)));
  const tp_near rest = tp_near_neg(c);
  const tp_near sine = sum(tp_near_times(rest, r), tp_near_times(q, l), c, l, h);
  const tp_near cosine = sum(tp_near_times(rest, l), tp_near_neg(tp_near_times(q, r)), c, r, h);
  return tp_near_div(sine, cosine);
}

/* Is it zero, or of the sign? */
static bool is_of(tp_near number, int sign) {
  return tp_near_is_zero(number) || tp_near_sign(number) == sign;
}

/* With one sign at both ends it keeps that, but where it turns in between on the other side. */
static bool keeps(const tp_tilt_form *f, int sign) {
  if (is_of(f->level, sign) || is_of(f->rise, sign)) return true;
  const tp_near h =
      tp_near_plus(tp_near_times(f->level, f->level), tp_near_times(f->rise, f->rise));
  return tp_near_sign(tp_near_minus(tp_near_times(f->fixed, f->fixed), h)) > 0;
}

bool tp_tilt_form_change(tp_tilt_change *change, const tp_tilt_form *f) {
  change->level = tp_near_sign(tp_near_plus(f->level, f->fixed));
  change->upright = tp_near_sign(tp_near_plus(f->rise, f->fixed));
  if (tp_near_is_zero(f->rise) && tp_near_is_zero(f->fixed)) change->upright = change->level;
  if (change->level == 0 || change->upright == 0) return false;
  if (change->level == change->upright) return keeps(f, change->level);
  const tp_tilt_form falls = change->level > 0 ? *f : tp_tilt_form_neg(*f);
  change->tangent = zero_of(falls.level, falls.rise, falls.fixed);
  return isfinite(change->tangent.error) && tp_near_sign(change->tangent) > 0;
}
