/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A probability from how often something came in independent samples, with the interval of Wilson
 * (J. American Statistical Association 22 (1927) 209-212): those p from which the count lies no
 * further than z deviations sqrt(n p (1 - p)), the quantile z of the normal distribution. It is
 * never empty, also where the count is 0 or n. Of a Latin hypercube it is too wide, if anything
 * (Stein, Technometrics 29 (1987) 143-151). */

#ifndef TP_STATISTICS_PROPORTION_H
#define TP_STATISTICS_PROPORTION_H

#include "statistics/estimate.h"

#include <stddef.h>
#include <stdint.h>

/* `count` of `samples`, which may be 0: then from 0 to 1, and the value no number. The confidence
 * lies within (0, 1): 0.95. */
tp_estimate tp_proportion(uint64_t count, uint64_t samples, double confidence);

/* Of `categories` that exclude each other, all intervals at once with the confidence (Goodman,
 * Technometrics 7 (1965) 247-254): each Wilson's with 1 - (1 - confidence) / categories. */
void tp_proportions(tp_estimate *estimates, const uint64_t *counts, size_t categories,
                    uint64_t samples, double confidence);

/* The mean of independent replicates, 2 at least, such as proportions by several shifts of Sobol'
 * points, with the interval of Student's t. */
tp_estimate tp_mean_of_replicates(const double *values, size_t replicates, double confidence);

/* How many samples narrow the interval of a proportion to this half width, as far as the count so
 * far tells. */
uint64_t tp_proportion_samples(uint64_t count, uint64_t samples, double confidence,
                               double half_width);

#endif
