/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Vectors of doubles with bounds in which an exact zero stays one (number/near.h). */

#ifndef TP_CASE_FILTER_NEAR_VECTOR_H
#define TP_CASE_FILTER_NEAR_VECTOR_H

#include "number/near.h"

#include <stdbool.h>

static inline bool tp_near_is_zero(tp_near a) {
  return a.value == 0 && a.error == 0;
}

static inline tp_near tp_near_times(tp_near a, tp_near b) {
  return tp_near_is_zero(a) || tp_near_is_zero(b) ? (tp_near){0, 0} : tp_near_mul(a, b);
}

static inline tp_near tp_near_plus(tp_near a, tp_near b) {
  return tp_near_is_zero(a) ? b : tp_near_is_zero(b) ? a : tp_near_add(a, b);
}

static inline tp_near tp_near_minus(tp_near a, tp_near b) {
  return tp_near_plus(a, tp_near_neg(b));
}

static inline void tp_near_vector_cross(tp_near product[3], const tp_near a[3],
                                        const tp_near b[3]) {
  for (int e = 0; e < 3; e++) {
    const int next = (e + 1) % 3, last = (e + 2) % 3;
    product[e] = tp_near_minus(tp_near_times(a[next], b[last]), tp_near_times(a[last], b[next]));
  }
}

static inline tp_near tp_near_vector_dot(const tp_near a[3], const tp_near b[3]) {
  return tp_near_plus(tp_near_plus(tp_near_times(a[0], b[0]), tp_near_times(a[1], b[1])),
                      tp_near_times(a[2], b[2]));
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
