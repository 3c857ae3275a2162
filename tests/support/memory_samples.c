/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "memory_samples.h"

#include "memory_expect.h"
#include "sampling/draws.h"
#include "statistics/form.h"
#include "statistics/importance_sampling.h"
#include "statistics/rank_correlation.h"
#include "statistics/sobol_indices.h"
#include "statistics/subset_simulation.h"

static const double correlation[] = {1, 0.5, 0.5, 1};

/* A call without an output to be freed. */
static bool went(tp_status status, const tp_message *message) {
  return done(status, status == TP_OK ? "" : NULL, message);
}

void draw_samples(void) {
  static const tp_draw_method methods[] = {TP_DRAW_MONTE_CARLO, TP_DRAW_LATIN_HYPERCUBE,
                                           TP_DRAW_SOBOL};
  tp_message message = {.text = ""};
  for (int k = 0; k < 6; k++) {
    const tp_draws draws = {methods[k / 2], 1, 20, 2, 2, k % 2 == 0 ? NULL : correlation};
    tp_draws_walk *walk = NULL;
    double u[2];
    if (DONE(tp_draws_begin(&walk, &draws, 3, NULL, &message), walk)) tp_draws_next(walk, u);
    tp_draws_end(walk);
  }
}

void measure_sensitivity(void) {
  static const double values[] = {1, 2, 3, 2, 4, 3, 5, 1, 2};
  const tp_sobol_results results = {values, 3, 1};
  tp_message message = {.text = ""};
  for (int k = 0; k < 5; k++) {
    tp_sobol_index index;
    double ranks[9];
    (void)went(tp_sobol_indices(&index, &results, 100, 1, 0.95, &message), &message);
    (void)went(tp_ranks(ranks, values, 9, &message), &message);
  }
}

static tp_status plane(double *g, void *context, const double *x, size_t count,
                       tp_message *message) {
  (void)context, (void)message;
  for (size_t k = 0; k < count; k++) g[k] = 2 - x[2 * k] - x[2 * k + 1];
  return TP_OK;
}

void find_reliability(void) {
  const tp_distribution z = tp_distribution_normal(0, 1), two[] = {z, z};
  const tp_reliability problem = {2, two, correlation, plane, NULL};
  const tp_form_options options = tp_form_options_default();
  static const double centre[] = {1, 1};
  tp_message message = {.text = ""};
  tp_form form;
  tp_importance importance;
  tp_subsets subsets;
  if (went(tp_form_find(&form, &problem, &options, &message), &message)) tp_form_clear(&form);
  (void)went(tp_importance_sample(&importance, &problem, centre, 1, 100, 1, 0.95, &message),
             &message);
  (void)went(tp_subset_simulate(&subsets, &problem, NULL, 0, 100, 1, 0.95, &message), &message);
}
