/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Where the means themselves fail, z* lies on the side of what holds: then that is the rare event
 * that is sampled, and failure is the rest. */

#include "statistics/importance_sampling.h"

#include "generate/random.h"
#include "statistics/score.h"
#include "statistics/standard_space.h"
#include "statistics/sum.h"

#include <gsl/gsl_cdf.h>
#include <stdlib.h>

enum { BATCH = 1024 };

/* Weights of the samples that are the event, their squares, and of those undecided. */
typedef struct tally {
  tp_sum weights, squares, undecided, undecided_squares;
  uint64_t failures;
} tally;

static double score(uint64_t stream, uint64_t k) {
  const uint64_t bits = tp_random_bits(stream, k);
  const double tail =
      tp_random_unit(bits) / 2; /* the last bits of the 64, which it leaves, say which */
  return (bits & 1U) != 0 ? gsl_cdf_ugaussian_Pinv(tail) : gsl_cdf_ugaussian_Qinv(tail);
}

/* Points from sample `first` on, and the logarithms of their weights. */
static void draw(double *z, double *weights, const double *centre, size_t n, uint64_t stream,
                 uint64_t first, size_t count) {
  for (size_t k = 0; k < count; k++) {
    double exponent = 0;
    for (size_t i = 0; i < n; i++) {
      const double own = score(tp_random_branch(stream, i), first + k);
      z[k * n + i] = centre[i] + own;
      exponent -= centre[i] * (own + centre[i] / 2);
    }
    weights[k] = exp(exponent);
  }
}

static void count_in(tally *t, const double *g, const double *weights, size_t count, bool fails) {
  for (size_t k = 0; k < count; k++) {
    if (isnan(g[k])) {
      tp_sum_add(&t->undecided, weights[k]);
      tp_sum_add(&t->undecided_squares, weights[k] * weights[k]);
    } else {
      t->failures += g[k] <= 0;
      if ((g[k] <= 0) != fails) continue;
      tp_sum_add(&t->weights, weights[k]);
      tp_sum_add(&t->squares, weights[k] * weights[k]);
    }
  }
}

/* The deviation of a mean of weights with this sum and sum of squares. */
static double deviation(double sum, double squares, double n) {
  return sqrt(fmax(squares / n - sum / n * (sum / n), 0) / (n - 1));
}

static tp_estimate estimate(const tally *t, double n, double confidence, bool fails) {
  const double z = tp_normal_score(confidence, 1);
  const double sum = tp_sum_value(&t->weights), squares = tp_sum_value(&t->squares);
  const double all = sum + tp_sum_value(&t->undecided);
  const double all_squares = squares + tp_sum_value(&t->undecided_squares);
  const double low = fmax(sum / n - z * deviation(sum, squares, n), 0);
  const double high = fmin(all / n + z * deviation(all, all_squares, n), 1);
  if (fails) return (tp_estimate){sum / n, low, high};
  return (tp_estimate){fmax(1 - all / n, 0), 1 - high, 1 - low};
}

static tp_status sample(tally *t, tp_standard_space *space, double *places, const double *centre,
                        bool fails, uint64_t samples, uint64_t seed, tp_message *message) {
  const size_t n = space->problem->dimensions;
  const uint64_t stream = tp_random_stream(seed, TP_STREAM_IMPORTANCE);
  double *g = places + BATCH * n, *weights = g + BATCH;
  for (uint64_t first = 0; first < samples; first += BATCH) {
    const size_t count = samples - first < BATCH ? (size_t)(samples - first) : BATCH;
    draw(places, weights, centre, n, stream, first, count);
    const tp_status status = tp_standard_space_values(space, g, places, count, message);
    if (status != TP_OK) return status;
    count_in(t, g, weights, count, fails);
  }
  return TP_OK;
}

tp_status tp_importance_sample(tp_importance *importance, const tp_reliability *problem,
                               const double *scores, uint64_t samples, uint64_t seed,
                               double confidence, tp_message *message) {
  const size_t n = problem->dimensions;
  tp_standard_space space;
  tally t = {0};
  if (samples < 2) {
    return tp_fail(message, TP_BAD_INPUT, (tp_place){0}, "at least 2 samples must be drawn");
  }
  tp_status status = tp_standard_space_init(&space, problem, BATCH, message);
  if (status != TP_OK) return status;
  double *places = calloc(BATCH * (n + 2), sizeof *places), at_origin = 0;
  if (places == NULL) {
    tp_standard_space_clear(&space);
    return tp_fail_memory(message, "the samples");
  }
  status = tp_standard_space_values(&space, &at_origin, places, 1, message);
  const bool fails = !(at_origin <= 0);
  if (status == TP_OK) {
    status = sample(&t, &space, places, scores, fails, samples, seed, message);
  }
  if (status == TP_OK) {
    const double count = (double)samples, sum = tp_sum_value(&t.weights);
    const tp_estimate p = estimate(&t, count, confidence, fails);
    const double own = deviation(sum, tp_sum_value(&t.squares), count);
    *importance = (tp_importance){.probability = p,
                                  .variation = p.value > 0 ? own / p.value : INFINITY,
                                  .undecided = tp_sum_value(&t.undecided) / count,
                                  .calls = space.calls,
                                  .failures = t.failures};
  }
  free(places);
  tp_standard_space_clear(&space);
  return status;
}
