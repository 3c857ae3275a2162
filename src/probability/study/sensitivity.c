/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Sobol' indices of each quantity (statistics/sobol_indices.h), from a design of its own: samples
 * of twice as many numbers as vary, and as many results a sample as there are numbers, and two. */

#include "generate/random.h"
#include "statistics/sobol_indices.h"
#include "study/analyses.h"
#include "study/points.h"

#include <math.h>
#include <stdlib.h>

enum { RESAMPLES = 1000 };

/* Its seeds: of the design, which no cell of the study has, and of the bootstrap. */
enum { SEED_OF_DESIGN = 1 << 20, SEED_OF_RESAMPLES };

/* The points of a design, their results, and one quantity of them. */
typedef struct design {
  const tp_study *study;
  size_t samples, results; /* results: of a sample */
  double *values, *numbers, *column;
} design;

static bool make_room(design *d) {
  const size_t points = d->samples * d->results;
  d->values = calloc(points * d->study->variable_count, sizeof *d->values);
  d->numbers = calloc(points * TP_POINT_NUMBERS, sizeof *d->numbers);
  d->column = calloc(points, sizeof *d->column);
  return d->values != NULL && d->numbers != NULL && d->column != NULL;
}

static void clear(design *d) {
  free(d->values);
  free(d->numbers);
  free(d->column);
}

/* The points of a sample, from its pair of scores. */
static void put_points(design *d, size_t sample, const double *pair, double *scores) {
  const tp_study *study = d->study;
  for (size_t k = 0; k < d->results; k++) {
    double *values = d->values + (sample * d->results + k) * study->variable_count;
    tp_sobol_design_point(scores, pair, study->drawn, k);
    for (size_t j = 0; j < study->variable_count; j++) {
      values[j] = tp_variable_drawn(study->variables + j, scores);
    }
  }
}

static tp_status draw(design *d, tp_message *message) {
  const tp_study *study = d->study;
  const tp_draws draws = {.method = study->method,
                          .seed = tp_random_bits(tp_random_mix(study->seed), SEED_OF_DESIGN),
                          .samples = d->samples,
                          .dimensions = 2 * study->drawn};
  tp_draws_walk *walk = NULL;
  double *pair = calloc(3 * study->drawn, sizeof *pair);
  if (pair == NULL) return tp_fail_memory(message, "the design of a sensitivity");
  const tp_status status = tp_draws_begin(&walk, &draws, 0, NULL, message);
  for (size_t k = 0; k < d->samples && status == TP_OK; k++) {
    tp_draws_next_scores(walk, pair);
    put_points(d, k, pair, pair + 2 * study->drawn);
  }
  tp_draws_end(walk);
  free(pair);
  return status;
}

/* One quantity of all points; false where one of them has no number, or all have the same. */
static bool take_column(design *d, size_t quantity) {
  const size_t points = d->samples * d->results;
  bool varies = false;
  for (size_t k = 0; k < points; k++) {
    d->column[k] = d->numbers[k * TP_POINT_NUMBERS + quantity];
    if (!isfinite(d->column[k])) return false;
    varies = varies || d->column[k] != d->column[0];
  }
  return varies;
}

static tp_status fill_quantity(tp_study_result *result, design *d, size_t quantity,
                               tp_sobol_index *indices, tp_message *message) {
  const tp_study *study = d->study;
  if (!take_column(d, quantity)) return TP_OK;
  const tp_sobol_results results = {d->column, d->samples, study->drawn};
  const tp_status status = tp_sobol_indices(
      indices, &results, RESAMPLES, tp_random_bits(tp_random_mix(study->seed), SEED_OF_RESAMPLES),
      0.95, message);
  if (status == TP_NO_ANSWER) return TP_OK;
  for (size_t k = 0; k < study->variable_count && status == TP_OK; k++) {
    const tp_sobol_index *own = indices + study->variables[k].dimension;
    result->variables[k].sobol_indices[quantity] = (tp_study_index){
        true,           own->first.value, own->first.low, own->first.high, own->total.value,
        own->total.low, own->total.high};
  }
  return status;
}

static tp_status sense(tp_study_result *result, design *d, tp_sobol_index *indices,
                       const tp_study_options *options, bool *stopped, tp_message *message) {
  tp_status status = draw(d, message);
  if (status == TP_OK) {
    status = tp_study_solve_points(d->numbers, d->study, d->values, d->samples * d->results,
                                   options, stopped, message);
  }
  for (size_t q = 0; q < TP_STUDY_QUANTITIES && status == TP_OK && !*stopped; q++) {
    status = fill_quantity(result, d, q, indices, message);
  }
  if (status == TP_OK && !*stopped) result->sensitivity_samples = d->samples;
  return status;
}

tp_status tp_study_sense(tp_study_result *result, const tp_study *study,
                         const tp_study_options *options, bool *stopped, tp_message *message) {
  *stopped = false;
  if (study->sensitivity == 0) return TP_OK;
  design d = {.study = study, .samples = (size_t)study->sensitivity, .results = study->drawn + 2};
  tp_sobol_index *indices = calloc(study->drawn, sizeof *indices);
  const bool room = make_room(&d) && indices != NULL;
  const tp_status status = room ? sense(result, &d, indices, options, stopped, message)
                                : tp_fail_memory(message, "the design of a sensitivity");
  clear(&d);
  free(indices);
  return status;
}
