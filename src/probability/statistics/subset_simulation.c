/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Levels of Markov chains, each threshold the lowest tenth of g; the variance is estimated over
 * families of samples with a common ancestor. */

#include "statistics/subset_simulation.h"

#include "generate/random.h"
#include "statistics/proportion.h"
#include "statistics/score.h"
#include "statistics/standard_space.h"

#include <gsl/gsl_cdf.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { LENGTH = 10 }; /* of a chain; a tenth of the samples begin one */

/* One level: sample k is step k / chains of chain k % chains, on the first level a number drawn. */
typedef struct level {
  tp_standard_space *space;
  size_t n, samples, chains;
  double *places;         /* all that follow lie there */
  double *z, *g;          /* of all samples */
  double *seeds, *seed_g; /* of the chains of the next level */
  double *tried, *tried_g;
  size_t *order;                /* of the samples by g */
  size_t *origin, *seed_origin; /* the sample of the first level that each descends from */
  uint64_t stream;
} level;

static tp_status init(level *v, tp_standard_space *space, const tp_reliability *problem,
                      size_t samples, uint64_t seed, tp_message *message) {
  const size_t n = problem->dimensions, chains = samples / LENGTH;
  *v = (level){.space = space, .n = n, .samples = samples, .chains = chains};
  const tp_status status = tp_standard_space_init(v->space, problem, samples, message);
  if (status != TP_OK) return status;
  v->stream = tp_random_stream(seed, TP_STREAM_SUBSETS);
  v->places = calloc((n + 1) * (samples + 2 * chains), sizeof *v->places);
  v->order = calloc(2 * samples + chains, sizeof *v->order);
  if (v->places == NULL || v->order == NULL) {
    free(v->order);
    free(v->places);
    tp_standard_space_clear(v->space);
    (void)tp_fail_memory(message, "the samples");
    return TP_OUT_OF_MEMORY;
  }
  v->origin = v->order + samples;
  v->seed_origin = v->origin + samples;
  v->z = v->places;
  v->g = v->z + n * samples;
  v->seeds = v->g + samples;
  v->seed_g = v->seeds + n * chains;
  v->tried = v->seed_g + chains;
  v->tried_g = v->tried + n * chains;
  return TP_OK;
}

static void clear(level *v) {
  tp_standard_space_clear(v->space);
  free(v->order);
  free(v->places);
}

/* g at points; undecided is no answer here, as it has no place in an order. */
static tp_status ask(level *v, double *g, const double *z, size_t count, tp_message *message) {
  const tp_status status = tp_standard_space_values(v->space, g, z, count, message);
  for (size_t k = 0; status == TP_OK && k < count; k++) {
    if (!isnan(g[k])) continue;
    return tp_fail(message, TP_UNDECIDED, (tp_place){0},
                   "the result is undecided at a sample of subset simulation: allow more digits, "
                   "or sample around the design point");
  }
  return status;
}

static tp_status begin(level *v, tp_message *message) {
  for (size_t k = 0; k < v->samples; k++) v->origin[k] = k;
  for (size_t i = 0; i < v->n; i++) {
    const uint64_t stream = tp_random_branch(v->stream, i);
    for (size_t k = 0; k < v->samples; k++) {
      v->z[k * v->n + i] = gsl_cdf_ugaussian_Pinv(tp_random_unit(tp_random_bits(stream, k)));
    }
  }
  return ask(v, v->g, v->z, v->samples, message);
}

/* A candidate from where a chain is: of each component one nearby, taken at once where it is as
 * likely, otherwise as often as it is. */
static void propose(const level *v, double *tried, const double *from, uint64_t stream,
                    uint64_t number) {
  for (size_t i = 0; i < v->n; i++) {
    const uint64_t own = tp_random_branch(stream, i);
    const double step = 2 * tp_random_unit(tp_random_bits(own, 2 * number)) - 1;
    const double chance = tp_random_unit(tp_random_bits(own, 2 * number + 1));
    const double to = from[i] + step;
    tried[i] = chance < exp((from[i] * from[i] - to * to) / 2) ? to : from[i];
  }
}

/* All samples of the next level, from the seeds: the chains go on step by step together. */
static tp_status walk(level *v, size_t number, double threshold, tp_message *message) {
  const size_t n = v->n, chains = v->chains;
  const uint64_t stream = tp_random_branch(v->stream, v->n + number);
  memcpy(v->z, v->seeds, chains * n * sizeof *v->z);
  memcpy(v->g, v->seed_g, chains * sizeof *v->g);
  for (size_t k = 0; k < v->samples; k++) v->origin[k] = v->seed_origin[k % chains];
  for (size_t step = 1; step < LENGTH; step++) {
    const double *from = v->z + (step - 1) * chains * n, *from_g = v->g + (step - 1) * chains;
    double *to = v->z + step * chains * n, *to_g = v->g + step * chains;
    for (size_t k = 0; k < chains; k++) {
      propose(v, v->tried + k * n, from + k * n, stream, step * chains + k);
    }
    const tp_status status = ask(v, v->tried_g, v->tried, chains, message);
    if (status != TP_OK) return status;
    for (size_t k = 0; k < chains; k++) {
      const bool stays = !(v->tried_g[k] <= threshold);
      memcpy(to + k * n, stays ? from + k * n : v->tried + k * n, n * sizeof *to);
      to_g[k] = stays ? from_g[k] : v->tried_g[k];
    }
  }
  return TP_OK;
}

/* Order by g, equal ones by their number: a heap, as the order is of what lies elsewhere. */
static bool is_before(const level *v, size_t a, size_t b) {
  return v->g[a] != v->g[b] ? v->g[a] < v->g[b] : a < b;
}

static void sink(level *v, size_t root, size_t end) {
  for (size_t child; (child = 2 * root + 1) < end; root = child) {
    if (child + 1 < end && is_before(v, v->order[child], v->order[child + 1])) child++;
    if (!is_before(v, v->order[root], v->order[child])) return;
    const size_t kept = v->order[root];
    v->order[root] = v->order[child];
    v->order[child] = kept;
  }
}

static void sort(level *v) {
  for (size_t k = 0; k < v->samples; k++) v->order[k] = k;
  for (size_t k = v->samples / 2; k-- > 0;) sink(v, k, v->samples);
  for (size_t end = v->samples; end-- > 1;) {
    const size_t kept = v->order[0];
    v->order[0] = v->order[end];
    v->order[end] = kept;
    sink(v, 0, end);
  }
}

/* The sum of f^2, f the share that one sample of the first level has, by those that descend from
 * it, in those of the last that fail. `order` is lost. */
static double shares_squared(level *v) {
  size_t *descendants = v->order, below = 0;
  memset(descendants, 0, v->samples * sizeof *descendants);
  for (size_t k = 0; k < v->samples; k++) {
    if (!(v->g[k] <= 0)) continue;
    descendants[v->origin[k]]++;
    below++;
  }
  double sum = 0;
  for (size_t k = 0; k < v->samples; k++) {
    const double share = (double)descendants[k] / (double)below;
    sum += share * share;
  }
  return sum;
}

/* Below a tenth of the samples lies the threshold, in the middle between it and the next. */
static double threshold_of(const level *v) {
  const double below = v->g[v->order[v->chains - 1]], above = v->g[v->order[v->chains]];
  return isinf(below) || isinf(above) ? below : below + (above - below) / 2;
}

static void take_seeds(level *v) {
  for (size_t k = 0; k < v->chains; k++) {
    memcpy(v->seeds + k * v->n, v->z + v->order[k] * v->n, v->n * sizeof *v->seeds);
    v->seed_g[k] = v->g[v->order[k]];
    v->seed_origin[k] = v->origin[v->order[k]];
  }
}

static tp_status run(level *v, tp_subsets *subsets, tp_message *message) {
  double p = 1, last = INFINITY;
  tp_status status = begin(v, message);
  for (size_t number = 0; status == TP_OK && number < TP_SUBSET_LEVELS; number++) {
    sort(v);
    const double threshold = fmax(threshold_of(v), 0);
    if (!(threshold < last)) break;
    last = threshold;
    size_t below = 0;
    for (size_t k = 0; k < v->samples; k++) below += v->g[k] <= threshold;
    const double share = (double)below / (double)v->samples;
    p *= share;
    subsets->thresholds[subsets->levels++] = threshold;
    subsets->probability.value = p;
    if (threshold == 0) return TP_OK;
    take_seeds(v);
    status = walk(v, number, threshold, message);
  }
  if (status != TP_OK) return status;
  return tp_fail(message, TP_NO_ANSWER, (tp_place){0},
                 "no sample fails in %zu levels, down to a probability of %g: failure is rarer, or "
                 "the result no longer falls towards it",
                 subsets->levels, p);
}

/* The point whose normal density is the largest there. */
static size_t nearest(const double *points, size_t count, const double *z, size_t n) {
  size_t best = 0;
  double most = -INFINITY;
  for (size_t k = 0; k < count; k++) {
    double exponent = 0;
    for (size_t i = 0; i < n; i++) exponent += points[k * n + i] * (z[i] - points[k * n + i] / 2);
    if (exponent > most) best = k;
    most = fmax(most, exponent);
  }
  return best;
}

/* Has every design point that matters its samples? */
static tp_status check_points(const level *v, const double *points, size_t count,
                              tp_message *message) {
  static const double matters = 0.25, lost = 0.25;
  double sum = 0, failing = 0;
  double *own = calloc(2 * count + 1, sizeof *own), *shares = own + count;
  if (own == NULL) return tp_fail_memory(message, "the samples");
  for (size_t k = 0; k < count; k++) {
    double square = 0;
    for (size_t i = 0; i < v->n; i++) square += points[k * v->n + i] * points[k * v->n + i];
    sum += shares[k] = gsl_cdf_ugaussian_Q(sqrt(square));
  }
  for (size_t k = 0; k < v->samples && count > 0; k++) {
    if (!(v->g[k] <= 0)) continue;
    own[nearest(points, count, v->z + k * v->n, v->n)]++;
    failing++;
  }
  bool all = true;
  for (size_t k = 0; k < count; k++) {
    const double share = shares[k] / sum;
    all = all && (share < matters || own[k] >= lost * share * failing);
  }
  free(own);
  if (all) return TP_OK;
  return tp_fail(message, TP_NO_ANSWER, (tp_place){0},
                 "almost no sample reached one of the design points: its failure mode is lost; "
                 "allow more samples, or sample around the design points");
}

/* Of a product of levels by families; of one level it is a share. */
static void tell(tp_subsets *own, level *v, double confidence) {
  const double n = (double)v->samples, sum = shares_squared(v), square = fmax(sum - 1 / n, 0);
  own->variation = sqrt(square);
  own->families = 1 / sum;
  if (own->levels == 1) {
    const uint64_t count = (uint64_t)llround(own->probability.value * n);
    own->probability = tp_proportion(count, v->samples, confidence);
    return;
  }
  const double score = tp_student_score(confidence, fmax(own->families - 1, 1));
  const double factor = exp(score * sqrt(log1p(square)));
  own->probability.low = own->probability.value / factor;
  own->probability.high = fmin(own->probability.value * factor, 1);
}

tp_status tp_subset_simulate(tp_subsets *subsets, const tp_reliability *problem,
                             const double *points, size_t count, size_t samples, uint64_t seed,
                             double confidence, tp_message *message) {
  enum { SAMPLES_LEAST = 100 };
  tp_standard_space space;
  level v;
  if (samples < SAMPLES_LEAST || samples % LENGTH != 0) {
    return tp_refuse(message, TP_FAULT_RANGE, (tp_place){0},
                     "%zu samples of a level: give a multiple of %d, at least %d", samples, LENGTH,
                     SAMPLES_LEAST);
  }
  tp_status status = init(&v, &space, problem, samples, seed, message);
  if (status != TP_OK) return status;
  tp_subsets own = {0};
  status = run(&v, &own, message);
  if (status == TP_OK && own.levels > 1) status = check_points(&v, points, count, message);
  if (status == TP_OK) {
    tell(&own, &v, confidence);
    own.calls = space.calls;
    *subsets = own;
  }
  clear(&v);
  return status;
}
