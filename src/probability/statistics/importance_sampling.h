/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The probability of failure by samples drawn where it fails: from a mixture (mixture.h) around the
 * design points of all ways to fail (Schueller and Stix, Structural Safety 4 (1987) 293-309; for
 * several points Melchers, Structural Safety 6 (1989) 3-10), each sample counted with its weight.
 *
 * Unbiased whatever the centres are; what they decide is whether a deviation tells the truth, which
 * it does not where failures have large weights and hardly a sample finds them. So the weights are
 * watched: pilot samples, half of them from the wide part, look for failures that weigh more than
 * any at a centre does; the heaviest, or the design point that the first-order method finds from
 * it, becomes a centre, and the shares follow the weights (the cross-entropy method, Rubinstein and
 * Kroese 2004). Pilot samples do not count. Nor do those after which another centre was needed. The
 * interval is that of a lognormal estimate by Student's t, of one degree fewer than the effective
 * number of samples, (sum w)^2 / sum w^2; where that is below 20, or one sample is a fifth of all,
 * there is none. It is blind, as all sampling is, to failures that no sample reaches. */

#ifndef TP_STATISTICS_IMPORTANCE_SAMPLING_H
#define TP_STATISTICS_IMPORTANCE_SAMPLING_H

#include "statistics/estimate.h"
#include "statistics/reliability.h"

typedef struct tp_importance {
  tp_estimate probability; /* undecided samples do not fail in the value and in `low`, and do in
                              `high` */
  double variation;        /* its deviation over itself; infinite where nothing failed */
  double undecided;        /* the probability that those undecided have */
  double effective;        /* number of samples */
  double largest;          /* share of one sample in the probability */
  size_t centres;          /* sampled around */
  uint64_t calls, failures;
} tp_importance;

/* Around `count` points of scores, one after another, 0 at least; at least 2 samples, by numbers
 * from the seed. TP_NO_ANSWER where their weights tell no interval. */
tp_status tp_importance_sample(tp_importance *importance, const tp_reliability *problem,
                               const double *scores, size_t count, uint64_t samples, uint64_t seed,
                               double confidence, tp_message *message) TP_MUST_USE;

#endif
