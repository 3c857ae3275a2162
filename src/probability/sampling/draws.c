/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* State of a walk through the samples: per variable a random stream, a permutation of strata or
 * Sobol' directions with a digital shift; scores by the normal quantile and the copula. */

#include "sampling/draws.h"

#include "generate/random.h"
#include "sampling/copula.h"
#include "sampling/permutation.h"
#include "sampling/sobol_points.h"

#include <gsl/gsl_cdf.h>
#include <inttypes.h>
#include <stdlib.h>

/* One variable: its random numbers; its order of the strata; its Sobol' point. */
typedef struct column {
  uint64_t stream;
  tp_permutation strata;
  uint64_t directions[TP_SOBOL_BITS];
  uint64_t coordinate;
} column;

struct tp_draws_walk {
  tp_draw_method method;
  uint64_t samples, replicates, next;
  unsigned stratum_bits;
  size_t dimensions;
  double *factor; /* of the copula; NULL: independent */
  column *columns;
};

const char *tp_draw_method_name(tp_draw_method method) {
  switch (method) {
  case TP_DRAW_MONTE_CARLO:
    return "monte_carlo";
  case TP_DRAW_LATIN_HYPERCUBE:
    return "latin_hypercube";
  case TP_DRAW_SOBOL:
    return "sobol";
  }
  return NULL;
}

static tp_status check_plan(const tp_draws *draws, uint64_t first, tp_message *message) {
  const tp_place nowhere = {0};
  if (tp_draw_method_name(draws->method) == NULL) {
    return tp_refuse(message, TP_FAULT_ARGUMENT, nowhere, "%d is not a method of sampling",
                     (int)draws->method);
  }
  if (draws->samples < 1 || draws->samples > TP_DRAWS_SAMPLES) {
    return tp_refuse(message, TP_FAULT_RANGE, nowhere,
                     "%" PRIu64 " samples: there can be from 1 to %" PRIu64, draws->samples,
                     TP_DRAWS_SAMPLES);
  }
  if (first > draws->samples) {
    return tp_refuse(message, TP_FAULT_ARGUMENT, nowhere,
                     "sample %" PRIu64 " of %" PRIu64 ": there is none", first, draws->samples);
  }
  if (draws->dimensions < 1 || draws->dimensions > TP_DRAWS_DIMENSIONS) {
    return tp_refuse(message, TP_FAULT_RANGE, nowhere, "%zu variables: there can be from 1 to %d",
                     draws->dimensions, TP_DRAWS_DIMENSIONS);
  }
  if (draws->method == TP_DRAW_SOBOL && draws->dimensions > TP_SOBOL_DIMENSIONS) {
    return tp_refuse(message, TP_FAULT_RANGE, nowhere,
                     "%zu variables, and Sobol' points have %d at most: draw a Latin hypercube",
                     draws->dimensions, TP_SOBOL_DIMENSIONS);
  }
  return TP_OK;
}

static void begin_column(column *own, const tp_draws_walk *walk, uint64_t seed, size_t k) {
  static const tp_stream streams[] = {[TP_DRAW_MONTE_CARLO] = TP_STREAM_SAMPLES,
                                      [TP_DRAW_LATIN_HYPERCUBE] = TP_STREAM_STRATA,
                                      [TP_DRAW_SOBOL] = TP_STREAM_SHIFTS};
  own->stream = tp_random_branch(tp_random_stream(seed, streams[walk->method]), k);
  own->strata = tp_permutation_of(walk->samples, tp_random_mix(own->stream));
  if (walk->method != TP_DRAW_SOBOL) return;
  tp_sobol_directions(own->directions, k);
  own->coordinate = tp_sobol_coordinate(own->directions, walk->next / walk->replicates);
}

tp_status tp_draws_begin(tp_draws_walk **walk, const tp_draws *draws, uint64_t first,
                         const char *const *names, tp_message *message) {
  tp_status status = check_plan(draws, first, message);
  if (status != TP_OK) return status;
  const size_t n = draws->dimensions;
  tp_draws_walk *own = calloc(1, sizeof *own);
  if (own == NULL) return tp_fail_memory(message, "the samples");
  *own = (tp_draws_walk){.method = draws->method,
                         .samples = draws->samples,
                         .replicates = draws->replicates > 0 ? draws->replicates : 1,
                         .next = first % draws->samples,
                         .dimensions = n,
                         .columns = calloc(n, sizeof *own->columns)};
  if (draws->correlation != NULL) own->factor = calloc(n * n, sizeof *own->factor);
  if (own->columns == NULL || (draws->correlation != NULL && own->factor == NULL)) {
    tp_draws_end(own);
    return tp_fail_memory(message, "the samples");
  }
  if (own->factor != NULL) {
    status = tp_copula_factor(own->factor, draws->correlation, n, names, message);
    if (status != TP_OK) {
      tp_draws_end(own);
      return status;
    }
  }
  while (UINT64_C(1) << own->stratum_bits < own->samples) own->stratum_bits++;
  for (size_t k = 0; k < n; k++) begin_column(own->columns + k, own, draws->seed, k);
  *walk = own;
  return TP_OK;
}

/* Of 52 binary places in all, so that stratum and place in it are told apart, and neither 0 nor 1
 * comes out. */
static double in_stratum(const tp_draws_walk *walk, const column *own) {
  const uint64_t stratum = tp_permutation_at(&own->strata, walk->next);
  const unsigned places = TP_SOBOL_BITS - walk->stratum_bits;
  const uint64_t part = tp_random_bits(own->stream, walk->next) >> (64U - places);
  const double within = ((double)part + 0.5) / (double)(UINT64_C(1) << places);
  return ((double)stratum + within) / (double)walk->samples;
}

static double independent(const tp_draws_walk *walk, const column *own) {
  switch (walk->method) {
  case TP_DRAW_LATIN_HYPERCUBE:
    return in_stratum(walk, own);
  case TP_DRAW_SOBOL: {
    const uint64_t shift = tp_random_bits(own->stream, walk->next % walk->replicates) >> 12;
    return ((double)(own->coordinate ^ shift) + 0.5) * 0x1p-52;
  }
  default:
    return tp_random_unit(tp_random_bits(own->stream, walk->next));
  }
}

/* Sobol' points go on where the last of the shifts has had this one. */
static void step(tp_draws_walk *walk) {
  walk->next++;
  if (walk->next == walk->samples) walk->next = 0;
  if (walk->method != TP_DRAW_SOBOL || walk->next % walk->replicates != 0) return;
  const uint64_t point = walk->next / walk->replicates;
  const unsigned bit = point > 0 ? tp_sobol_step(point - 1) : 0;
  for (size_t k = 0; k < walk->dimensions; k++) {
    column *own = walk->columns + k;
    own->coordinate = point > 0 ? own->coordinate ^ own->directions[bit] : 0;
  }
}

void tp_draws_next_scores(tp_draws_walk *walk, double *z) {
  for (size_t k = 0; k < walk->dimensions; k++) {
    const double u = independent(walk, walk->columns + k);
    z[k] = u < 0.5 ? gsl_cdf_ugaussian_Pinv(u) : gsl_cdf_ugaussian_Qinv(1 - u);
  }
  if (walk->factor != NULL) tp_copula_apply(walk->factor, walk->dimensions, z);
  step(walk);
}

void tp_draws_next(tp_draws_walk *walk, double *u) {
  static const double least = 0x1p-53;
  if (walk->factor == NULL) {
    for (size_t k = 0; k < walk->dimensions; k++) u[k] = independent(walk, walk->columns + k);
    step(walk);
    return;
  }
  tp_draws_next_scores(walk, u);
  for (size_t k = 0; k < walk->dimensions; k++) {
    const double own = gsl_cdf_ugaussian_P(u[k]);
    u[k] = own < least ? least : own > 1 - least ? 1 - least : own;
  }
}

void tp_draws_end(tp_draws_walk *walk) {
  if (walk == NULL) return;
  free(walk->factor);
  free(walk->columns);
  free(walk);
}
