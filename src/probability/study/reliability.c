/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Reliability of first order (statistics/form.h) at the scene's tilt: it fails where an angle at
 * which it begins to move is not above the tilt, or its factor of safety not above 1. */

#include "generate/random.h"
#include "statistics/design_points.h"
#include "statistics/importance_sampling.h"
#include "statistics/subset_simulation.h"
#include "study/analyses.h"
#include "study/outcome.h"
#include "study/points.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Its seeds; the design of Sobol' indices has others, and cells are numbered from 0. */
enum { SEED_OF_IMPORTANCE = (1 << 20) + 2, SEED_OF_SUBSET, SEED_OF_DESIGN_POINTS };

/* Where a number is infinite: beyond what it can be otherwise, and still a number. */
static const double beyond = 1000;

typedef struct margin {
  const tp_study *study;
  const tp_study_options *options;
  bool stopped;
} margin;

static double margin_of(const tp_study *study, const double *numbers) {
  const double q = numbers[study->relied];
  if (isnan(q)) return NAN;
  const double held = tp_study_quantity_is_factor(study->relied) ? 1 : numbers[TP_POINT_TILT];
  return (isinf(q) ? copysign(beyond, q) : q) - held;
}

/* A study that is stopped ends the search, as if it were undecided. */
static tp_status margins(double *g, void *context, const double *x, size_t count,
                         tp_message *message) {
  margin *own = context;
  const tp_study *study = own->study;
  double *numbers = calloc(count * TP_POINT_NUMBERS, sizeof *numbers);
  if (numbers == NULL) return tp_fail_memory(message, "a reliability");
  tp_status status =
      tp_study_solve_points(numbers, study, x, count, own->options, &own->stopped, message);
  for (size_t k = 0; k < count; k++) g[k] = margin_of(study, numbers + k * TP_POINT_NUMBERS);
  if (status == TP_OK && own->stopped) {
    status = tp_fail(message, TP_UNDECIDED, (tp_place){0}, "the study was stopped");
  }
  free(numbers);
  return status;
}

/* Of the nearest design point; without one there is no number. */
static tp_status take(tp_study_result *result, const tp_study *study, const tp_design_points *found,
                      tp_message *message) {
  const tp_form *nearest = found->count > 0 ? found->points : NULL;
  const size_t count = study->variable_count;
  tp_study_reliability *own = &result->reliability;
  *own = (tp_study_reliability){.known = true,
                                .quantity = study->relied,
                                .converged = nearest != NULL,
                                .state = tp_form_state_text(found->state),
                                .beta = nearest != NULL ? nearest->beta : NAN,
                                .probability = nearest != NULL ? nearest->probability : NAN,
                                .scenes = found->calls};
  for (size_t k = 0; k < count; k++) {
    result->variables[k].design_value = nearest != NULL ? nearest->point[k] : NAN;
    result->variables[k].importance = nearest != NULL ? nearest->importance[k] : NAN;
  }
  own->design_points = calloc(found->count + 1, sizeof *own->design_points);
  if (own->design_points == NULL) return tp_fail_memory(message, "a reliability");
  for (size_t k = 0; k < found->count; k++) {
    const tp_form *form = found->points + k;
    double *values = calloc(count, sizeof *values);
    if (values == NULL) return tp_fail_memory(message, "a reliability");
    memcpy(values, form->point, count * sizeof *values);
    own->design_points[own->design_point_count++] =
        (tp_study_design_point){form->beta, form->probability, count, values};
  }
  return TP_OK;
}

void tp_study_reliability_clear(tp_study_reliability *own) {
  for (size_t k = 0; k < own->design_point_count; k++) free(own->design_points[k].values);
  free(own->design_points);
  free(own->importance.why);
  free(own->subset.why);
  *own = (tp_study_reliability){.known = false};
}

/* ---- rare events -------------------------------------------------------------------------------
 */

/* What was found; without an answer it tells why. */
static tp_status end_rare(tp_study_rare *rare, tp_status status, tp_estimate probability,
                          double variation, uint64_t calls, const tp_message *why,
                          tp_message *message) {
  *rare = (tp_study_rare){.asked = true, .known = status == TP_OK};
  if (status == TP_OK) {
    rare->probability = probability.value;
    rare->low = probability.low;
    rare->high = probability.high;
    rare->variation = variation;
    rare->scenes = calls;
    return TP_OK;
  }
  if (status != TP_UNDECIDED && status != TP_NO_ANSWER) {
    if (message != NULL) *message = *why;
    return status;
  }
  rare->why = strdup(why->text);
  return rare->why != NULL ? TP_OK : tp_fail_memory(message, "a reliability");
}

/* Around all design points; where there are none it looks for failures by itself. */
static tp_status sample_importance(tp_study_rare *rare, const tp_reliability *problem,
                                   const double *centres, size_t count, const tp_study *study,
                                   tp_message *message) {
  tp_importance own = {.calls = 0};
  tp_message why = {.text = ""};
  const tp_status status = tp_importance_sample(
      &own, problem, centres, count, study->importance,
      tp_random_bits(tp_random_mix(study->seed), SEED_OF_IMPORTANCE), 0.95, &why);
  return end_rare(rare, status, own.probability, own.variation, own.calls, &why, message);
}

static tp_status sample_subset(tp_study_rare *rare, const tp_reliability *problem,
                               const double *centres, size_t count, const tp_study *study,
                               tp_message *message) {
  tp_subsets own = {.calls = 0};
  tp_message why = {.text = ""};
  const tp_status status =
      tp_subset_simulate(&own, problem, centres, count, (size_t)study->subset,
                         tp_random_bits(tp_random_mix(study->seed), SEED_OF_SUBSET), 0.95, &why);
  return end_rare(rare, status, own.probability, own.variation, own.calls, &why, message);
}

static tp_status sample_rare(tp_study_reliability *own, const tp_reliability *problem,
                             const tp_design_points *found, const tp_study *study,
                             tp_message *message) {
  const size_t n = problem->dimensions, count = found->count;
  double *centres = calloc((count + 1) * n, sizeof *centres);
  if (centres == NULL) return tp_fail_memory(message, "a reliability");
  for (size_t k = 0; k < count; k++) {
    memcpy(centres + k * n, found->points[k].scores, n * sizeof *centres);
  }
  tp_status status = TP_OK;
  if (study->importance > 0) {
    status = sample_importance(&own->importance, problem, centres, count, study, message);
  }
  if (status == TP_OK && study->subset > 0) {
    status = sample_subset(&own->subset, problem, centres, count, study, message);
  }
  free(centres);
  return status;
}

/* ---- all of it ---------------------------------------------------------------------------------
 */

static tp_status find(tp_study_result *result, const tp_study *study, const tp_reliability *problem,
                      tp_message *message) {
  tp_design_points found = {.count = 0};
  tp_status status = tp_design_points_find(
      &found, problem, tp_random_bits(tp_random_mix(study->seed), SEED_OF_DESIGN_POINTS), message);
  if (status != TP_OK) return status;
  status = take(result, study, &found, message);
  if (status == TP_OK) status = sample_rare(&result->reliability, problem, &found, study, message);
  tp_design_points_clear(&found);
  return status;
}

tp_status tp_study_rely(tp_study_result *result, const tp_study *study,
                        const tp_study_options *options, bool *stopped, tp_message *message) {
  *stopped = false;
  if (!study->relies) return TP_OK;
  margin own = {.study = study, .options = options};
  tp_distribution *variables = calloc(study->variable_count, sizeof *variables);
  if (variables == NULL) return tp_fail_memory(message, "a reliability");
  for (size_t k = 0; k < study->variable_count; k++) {
    variables[k] = study->variables[k].distribution;
  }
  const tp_reliability problem = {.dimensions = study->variable_count,
                                  .variables = variables,
                                  .correlation = study->correlation,
                                  .limit_state = margins,
                                  .context = &own};
  tp_status status = find(result, study, &problem, message);
  *stopped = own.stopped;
  if (own.stopped) {
    tp_study_reliability_clear(&result->reliability);
    status = status == TP_UNDECIDED ? TP_OK : status;
  }
  free(variables);
  return status;
}
