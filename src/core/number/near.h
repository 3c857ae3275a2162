/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Doubles that carry a bound of their error: |truth - value| <= error. They answer many a question
 * of sign for a hundredth of what a ball of 64 bits takes; what they leave open, balls tell.
 *
 * Each operation rounds once, by less than 2 u |value| with u = 2^-53 whatever the rounding mode,
 * and by less than DBL_MIN where it underflows. Its bound takes some more operations of that kind,
 * all of terms that are not negative: their roundings are covered by a factor 1 + 16 u. An error
 * that is infinite or no number says nothing, and no comparison of it holds. */

#ifndef TP_NUMBER_NEAR_H
#define TP_NUMBER_NEAR_H

#include <float.h>
#include <math.h>
#include <stdbool.h>

typedef struct tp_near {
  double value, error;
} tp_near;

static inline tp_near tp_near_of(double value, double error) {
  return (tp_near){value, error * (1 + 8 * DBL_EPSILON) + 4 * DBL_MIN};
}

static inline tp_near tp_near_add(tp_near a, tp_near b) {
  const double sum = a.value + b.value;
  return tp_near_of(sum, a.error + b.error + fabs(sum) * DBL_EPSILON);
}

static inline tp_near tp_near_neg(tp_near a) {
  return (tp_near){-a.value, a.error};
}

static inline tp_near tp_near_sub(tp_near a, tp_near b) {
  return tp_near_add(a, tp_near_neg(b));
}

static inline tp_near tp_near_mul(tp_near a, tp_near b) {
  const double product = a.value * b.value;
  return tp_near_of(product, fabs(a.value) * b.error + a.error * (fabs(b.value) + b.error) +
                                 fabs(product) * DBL_EPSILON);
}

/* By what is certainly not zero. */
static inline tp_near tp_near_div(tp_near a, tp_near b) {
  const double quotient = a.value / b.value;
  return tp_near_of(quotient, (a.error + fabs(quotient) * b.error) / (fabs(b.value) - b.error) +
                                  fabs(quotient) * DBL_EPSILON);
}

/* Of what is certainly above zero: |sqrt(x) - sqrt(v)| = |x - v| / (sqrt(x) + sqrt(v)). */
static inline tp_near tp_near_sqrt(tp_near a) {
  if (!(a.value > a.error)) return (tp_near){0, INFINITY};
  const double root = sqrt(a.value);
  return tp_near_of(root, a.error / root + root * DBL_EPSILON);
}

/* 1 or -1; 0 where it is not told. */
static inline int tp_near_sign(tp_near a) {
  return a.value > a.error ? 1 : -a.value > a.error ? -1 : 0;
}

/* The same with exact zeros kept. */
static inline bool tp_near_is_zero(tp_near a) {
  return a.value == 0 && a.error == 0;
}

static inline tp_near tp_near_times(tp_near a, tp_near b) {
  const tp_near product = tp_near_mul(a, b);
  const bool vanishes = product.value == 0 && (tp_near_is_zero(a) || tp_near_is_zero(b));
  return vanishes ? (tp_near){0, 0} : product;
}

static inline tp_near tp_near_plus(tp_near a, tp_near b) {
  return tp_near_is_zero(a) ? b : tp_near_is_zero(b) ? a : tp_near_add(a, b);
}

static inline tp_near tp_near_minus(tp_near a, tp_near b) {
  return tp_near_plus(a, tp_near_neg(b));
}

/* sqrt(a^2 + b^2) */
static inline tp_near tp_near_length(tp_near a, tp_near b) {
  if (tp_near_is_zero(b)) return (tp_near){fabs(a.value), a.error};
  return tp_near_sqrt(tp_near_plus(tp_near_times(a, a), tp_near_times(b, b)));
}

/* The lesser of two numbers lies between the lesser of their lower and of their upper bounds. */
static inline tp_near tp_near_lesser(tp_near a, tp_near b) {
  if (!(isfinite(a.error) && isfinite(b.error))) return (tp_near){0, INFINITY};
  const double low = fmin(a.value - a.error, b.value - b.error);
  const double high = fmin(a.value + a.error, b.value + b.error);
  const double value = low + (high - low) / 2;
  return tp_near_of(value, (high - low) / 2 + (fabs(value) + fabs(low) + fabs(high)) * DBL_EPSILON);
}

static inline tp_near tp_near_larger(tp_near a, tp_near b) {
  return tp_near_neg(tp_near_lesser(tp_near_neg(a), tp_near_neg(b)));
}

#endif
