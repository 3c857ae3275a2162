/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Sobol' indices: the share of the variance of a result that a variable has by itself (first
 * order), and with all in which it takes part (total). By the design of Saltelli et al. (Computer
 * Physics Communications 181 (2010) 259-270): from samples of 2 d independent numbers A and B, d
 * each, and AB_i, A with variable i of B, d + 2 results a sample. First order their estimator (b),
 * of results about their mean; total that of Jansen (ibid. 117 (1999) 35-43):
 *
 *     S_i = mean (B (AB_i - A)) / V,   T_i = mean ((A - AB_i)^2) / 2 V.
 *
 * Intervals by the bootstrap over samples, percentiles of resamples drawn from a seed (Archer,
 * Saltelli and Sobol', J. Statistical Computation and Simulation 58 (1997) 99-120); of Sobol'
 * points too wide, if anything. For variables that depend on each other the indices have no such
 * meaning. */

#ifndef TP_STATISTICS_SOBOL_INDICES_H
#define TP_STATISTICS_SOBOL_INDICES_H

#include "common/message.h"
#include "statistics/estimate.h"

#include <stdint.h>

/* Point `which` of a sample: 0 is A, 1 is B, 2 + i is AB_i. `pair` are the 2 d numbers drawn. */
void tp_sobol_design_point(double *point, const double *pair, size_t dimensions, size_t which);

typedef struct tp_sobol_index {
  tp_estimate first, total;
} tp_sobol_index;

typedef struct tp_sobol_results {
  const double *values; /* of sample k: A, B, AB_0 ... at k (dimensions + 2); all finite */
  size_t samples, dimensions;
} tp_sobol_results;

/* An index for every variable, by so many resamples, 100 at least. TP_NO_ANSWER where the result
 * does not vary. */
tp_status tp_sobol_indices(tp_sobol_index *indices, const tp_sobol_results *results,
                           size_t resamples, uint64_t seed, double confidence,
                           tp_message *message) TP_MUST_USE;

#endif
