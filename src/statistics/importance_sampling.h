/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The probability of failure by samples drawn around the design point z* of the first-order method,
 * where about half of them fail: independent normal n, z = z* + n, each counted with its weight
 * phi(z) / phi(n) = exp(-z*.n - |z*|^2 / 2) (Schueller and Stix, Structural Safety 4 (1987)
 * 293-309). Unbiased whatever z* is, but blind where failures elsewhere have large weights and no
 * sample finds them: its deviation then is too small, too. */

#ifndef TP_STATISTICS_IMPORTANCE_SAMPLING_H
#define TP_STATISTICS_IMPORTANCE_SAMPLING_H

#include "statistics/estimate.h"
#include "statistics/reliability.h"

typedef struct tp_importance {
  tp_estimate probability; /* undecided samples do not fail in the value and in `low`, and do in
                              `high` */
  double variation;        /* its deviation over itself; infinite where nothing failed */
  double undecided;        /* the probability that those undecided have */
  uint64_t calls, failures;
} tp_importance;

/* `scores` is z*; at least 2 samples, by numbers from the seed. */
tp_status tp_importance_sample(tp_importance *importance, const tp_reliability *problem,
                               const double *scores, uint64_t samples, uint64_t seed,
                               double confidence, tp_message *message) TP_MUST_USE;

#endif
