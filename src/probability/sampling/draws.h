/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Samples of d dependent numbers of (0, 1): sample k is a function of the plan and k alone, the
 * same in whatever order and from wherever one begins (threads, shards), and costs no memory.
 *
 * Monte Carlo: random numbers by a counter (generate/random.h). Latin hypercube (McKay, Beckman and
 * Conover, Technometrics 21 (1979) 239-245): each variable falls once into each of `samples` equal
 * strata, in an order computed index by index (permutation.h). Sobol' points (sobol_points.h) with
 * a digital shift drawn from the seed, by which they are random numbers, and so several shifts give
 * an interval: `replicates` of them, sample k being point k / replicates of shift k % replicates.
 *
 * A correlation makes them dependent by a Gaussian copula (copula.h). Strata and Sobol' points are
 * then those of the independent numbers behind; of the first variable they stay. */

#ifndef TP_SAMPLING_DRAWS_H
#define TP_SAMPLING_DRAWS_H

#include "common/message.h"

#include <stdint.h>

typedef enum tp_draw_method {
  TP_DRAW_MONTE_CARLO,
  TP_DRAW_LATIN_HYPERCUBE,
  TP_DRAW_SOBOL
} tp_draw_method;

/* Of all dimensions, those of Sobol' points apart (40), and of samples. */
enum { TP_DRAWS_DIMENSIONS = 1000 };
#define TP_DRAWS_SAMPLES (UINT64_C(1) << 48)

typedef struct tp_draws {
  tp_draw_method method;
  uint64_t seed;
  uint64_t samples;          /* strata of a Latin hypercube; no sample beyond is drawn */
  uint64_t replicates;       /* of Sobol' points; 0 is taken for 1, others take no notice */
  size_t dimensions;         /* at least 1 */
  const double *correlation; /* dimensions x dimensions, of the normal scores; NULL: independent */
} tp_draws;

/* monte_carlo, latin_hypercube, sobol; NULL for a number that is no method. */
const char *tp_draw_method_name(tp_draw_method method);

/* Samples from one on. */
typedef struct tp_draws_walk tp_draws_walk;

/* Begin at sample `first`, 0 ... samples. TP_BAD_INPUT with what is wrong and what to do: counts
 * out of range, a matrix that is no correlation (`names`, or NULL, tell its variables). The plan
 * and its matrix are not needed any more. `walk` is left to tp_draws_end. */
tp_status tp_draws_begin(tp_draws_walk **walk, const tp_draws *draws, uint64_t first,
                         const char *const *names, tp_message *message) TP_MUST_USE;

/* The next sample: `dimensions` numbers of (0, 1). Past the last one it goes on from sample 0. */
void tp_draws_next(tp_draws_walk *walk, double *u);

/* The same as normal scores, for tp_distribution_at_score, which keeps the upper tail. */
void tp_draws_next_scores(tp_draws_walk *walk, double *z);

/* NULL is let pass. */
void tp_draws_end(tp_draws_walk *walk);

#endif
