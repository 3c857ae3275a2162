/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Doubles with a running bound. u = 2^-53 is the unit roundoff, rounding to nearest. A sum collects
 * the errors of its terms, and u times each partial sum for the addition itself; what the
 * collecting rounds, n u of it for n terms, is covered by the last factor for any n below 10^9. */

#ifndef TP_NUMBER_BOUNDED_H
#define TP_NUMBER_BOUNDED_H

#include "topple_basics.h"

#include <float.h>
#include <math.h>

static const double tp_roundoff = DBL_EPSILON / 2, tp_room = 1 + 1e-6;

typedef struct tp_bounded_sum {
  double sum, error;
} tp_bounded_sum;

static inline void tp_bounded_add(tp_bounded_sum *s, double term, double error) {
  s->sum += term;
  s->error += error + tp_roundoff * fabs(s->sum);
}

static inline tp_bounded tp_bounded_of(double value, double error) {
  return (tp_bounded){.value = value, .error = error * tp_room};
}

static inline tp_bounded tp_bounded_total(tp_bounded_sum s) {
  return tp_bounded_of(s.sum, s.error);
}

/* The quotient by what is certain to be above zero; without a bound where that is not. */
static inline tp_bounded tp_bounded_over(tp_bounded a, tp_bounded b) {
  const double value = a.value / b.value, least = b.value - b.error;
  if (!(least > 0)) return tp_bounded_of(value, INFINITY);
  return tp_bounded_of(value,
                       (a.error + fabs(value) * b.error) / least + tp_roundoff * fabs(value));
}

/* |sqrt(a) - sqrt(b)| is at most sqrt|a - b|, and at most |a - b| / sqrt(a). */
static inline tp_bounded tp_bounded_root(tp_bounded a) {
  const double value = sqrt(a.value), least = sqrt(a.error);
  const double share = value > 0 ? a.error / value : INFINITY;
  return tp_bounded_of(value, fmin(least, share) + tp_roundoff * value);
}

/* atan in degrees: the tangent's error at most, and four roundings of the angle. */
static inline tp_bounded tp_bounded_atan_deg(tp_bounded tangent) {
  static const double degrees = 57.295779513082323;
  const double value = atan(tangent.value) * degrees;
  return tp_bounded_of(value, tangent.error * degrees + 4 * tp_roundoff * fabs(value));
}

#endif
