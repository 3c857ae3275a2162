/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* How an estimate settles: a probability (Wilson's interval) or a mean (Student's t) of the samples
 * so far, kept at 1, 2, 4, ... of them. The mean and the squares about it by Welford's recurrence
 * (Technometrics 4 (1962) 419-420), one sample after another, so that the bits depend on their
 * order alone. */

#ifndef TP_STATISTICS_CONVERGENCE_H
#define TP_STATISTICS_CONVERGENCE_H

#include "statistics/estimate.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct tp_convergence_point {
  uint64_t samples;
  tp_estimate estimate;
} tp_convergence_point;

enum { TP_CONVERGENCE_POINTS = 64 };

typedef struct tp_convergence {
  bool proportion;
  double confidence;
  uint64_t samples, hits;
  double mean, squares;
  size_t count; /* of the points */
  tp_convergence_point points[TP_CONVERGENCE_POINTS];
} tp_convergence;

/* Of a probability, whose samples are 0 or 1, or of a mean. */
tp_convergence tp_convergence_begin(bool proportion, double confidence);

void tp_convergence_add(tp_convergence *c, double value);

/* Of all samples so far; of one alone a mean has an infinite interval. */
tp_estimate tp_convergence_now(const tp_convergence *c);

#endif
