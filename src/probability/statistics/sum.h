/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A sum with what its roundings lost (Neumaier, ZAMM 54 (1974) 39-51): right to one rounding and
 * n^2 2^-106 of the sum of magnitudes. */

#ifndef TP_STATISTICS_SUM_H
#define TP_STATISTICS_SUM_H

#include <math.h>

typedef struct tp_sum {
  double sum, lost;
} tp_sum;

static inline void tp_sum_add(tp_sum *s, double value) {
  const double sum = s->sum + value;
  s->lost += fabs(s->sum) >= fabs(value) ? (s->sum - sum) + value : (value - sum) + s->sum;
  s->sum = sum;
}

static inline double tp_sum_value(const tp_sum *s) {
  return s->sum + s->lost;
}

#endif
