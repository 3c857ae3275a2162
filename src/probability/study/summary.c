/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The tally made a result: shares of outcomes, quantiles, rank correlations. */

#include "number/shortest.h"
#include "statistics/quantiles.h"
#include "study/analyses.h"
#include "study/field.h"
#include "study/law.h"
#include "study/ranks.h"
#include "study/roughness.h"
#include "study/summary_samples.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double probabilities[TP_STUDY_QUANTILES] = {0.01, 0.05, 0.25, 0.5, 0.75, 0.95, 0.99};

static const double confidence = 0.95;

/* ---- tilts -------------------------------------------------------------------------------------
 */

static bool is_of_wedge(const tp_scene *scene) {
  return scene->solid.wedge.place.file != NULL;
}

/* In the frame of the world; a solid as its base or its joints dip. */
static bool lies(const tp_scene *scene) {
  return tp_scene_lies_in_place(scene) || scene->solid.dip_deg.given || is_of_wedge(scene);
}

static void fill_tilt(tp_study_tilt *tilt, const tp_tally *tally, size_t k) {
  const tp_study *study = tally->study;
  const tp_row_counts *counts = &tally->counts;
  const tp_quantity *own = &study->scene->tilt_angle_deg;
  tilt->of_scene = k == 0;
  tilt->as_it_lies = k == 0 && lies(study->scene);
  tilt->has_tilt = k > 0 || (own->given && !tilt->as_it_lies);
  tilt->tilt_varies = k == 0 && study->tilt_varies;
  if (tilt->has_tilt) tilt->tilt_deg = k > 0 ? study->tilts[k - 1] : fmpq_get_d(own->value);
  for (int j = 0; j < TP_STUDY_OUTCOMES; j++) {
    tilt->outcomes[j] = tp_row_counts_share(counts->outcomes[k][j], counts->samples);
  }
  tilt->certain_to_stand = tp_row_counts_share(tp_row_counts_stands(counts, k), counts->samples);
  tilt->certain_to_move = tp_row_counts_share(tp_row_counts_moves(counts, k), counts->samples);
  tilt->neither = tp_row_counts_share(tp_row_counts_open(counts, k), counts->samples);
}

static bool fill_tilts(tp_study_result *result, const tp_tally *tally) {
  result->tilt_count = tally->study->tilt_count + 1;
  result->tilts = calloc(result->tilt_count, sizeof *result->tilts);
  for (size_t k = 0; result->tilts != NULL && k < result->tilt_count; k++) {
    fill_tilt(result->tilts + k, tally, k);
  }
  return result->tilts != NULL;
}

/* ---- quantiles ---------------------------------------------------------------------------------
 */

/* Between numbers that are infinite there is no line: then the lower one. */
static double quantile_between(double value, const double *sorted, size_t count, double p) {
  return isnan(value) ? sorted[(size_t)(p * (double)(count - 1))] : value;
}

/* Of a column; `group` NULL, or of those that have `member` in it. */
static bool fill_spread(tp_study_spread *spread, const double *column, size_t kept,
                        const double *group, double member) {
  double *sorted = calloc(kept + 1, sizeof *sorted);
  if (sorted == NULL) return false;
  for (size_t k = 0; k < kept; k++) {
    if (isnan(column[k]) || (group != NULL && group[k] != member)) continue;
    sorted[spread->samples++] = column[k];
  }
  tp_column_sort(sorted, spread->samples);
  for (size_t k = 0; k < TP_STUDY_QUANTILES && spread->samples > 0; k++) {
    const double p = probabilities[k];
    const tp_estimate own = tp_column_quantile(sorted, spread->samples, p, confidence);
    spread->quantiles[k] = (tp_study_quantile){
        p, quantile_between(own.value, sorted, spread->samples, p), own.low, own.high};
  }
  free(sorted);
  return true;
}

static bool fill_factors(tp_study_result *result, const tp_tally *tally) {
  const double *factors = tally->columns[tally->study->variable_count + TP_STUDY_FOS];
  const double *definitions = tally->columns[tp_tally_definitions(tally->study)];
  bool filled = true;
  for (int k = 0; k < TP_FOS_DEFINITIONS && filled; k++) {
    tp_study_factor *own = result->governing_factors + k;
    own->definition = (tp_fos_definition)k;
    own->governs = tp_row_counts_share(tally->counts.definitions[k], tally->counts.samples);
    own->below_1 = tally->counts.below[k];
    filled = fill_spread(&own->spread, factors, tp_tally_kept(tally), definitions, k);
  }
  return filled;
}

/* ---- variables, columns ------------------------------------------------------------------------
 */

static bool fill_variable(tp_study_variable *variable, const tp_tally *tally, size_t k) {
  const tp_variable *own = tally->study->variables + k;
  const double *inputs = tally->columns[k];
  variable->key = strdup(own->node->key);
  variable->kind = own->kind;
  variable->law = tp_study_law(own);
  variable->unit = tp_study_field_unit(tally->study, tp_study_field_of_variable(k));
  const size_t kept = tp_tally_kept(tally);
  for (size_t j = 0; j < kept; j++) {
    if (j == 0 || inputs[j] < variable->least) variable->least = inputs[j];
    if (j == 0 || inputs[j] > variable->greatest) variable->greatest = inputs[j];
  }
  return variable->key != NULL && variable->law != NULL;
}

/* Those that are not 0, of the matrix of what is drawn. */
static bool fill_correlations(tp_study_result *result, const tp_study *study) {
  if (study->correlation == NULL) return true;
  result->correlations = calloc(study->drawn * study->drawn, sizeof *result->correlations);
  if (result->correlations == NULL) return false;
  for (size_t j = 0; j < study->variable_count; j++) {
    for (size_t k = j + 1; k < study->variable_count; k++) {
      const tp_variable *one = study->variables + j, *other = study->variables + k;
      if (one->source != TP_VARIABLE_DRAWN || other->source != TP_VARIABLE_DRAWN) continue;
      const double value = study->correlation[one->dimension * study->drawn + other->dimension];
      if (value == 0) continue;
      result->correlations[result->correlation_count++] = (tp_study_correlation){j, k, value};
    }
  }
  return true;
}

static bool fill_variables(tp_study_result *result, const tp_tally *tally) {
  const size_t count = tally->study->variable_count;
  result->variables = calloc(count, sizeof *result->variables);
  result->variable_count = result->variables != NULL ? count : 0;
  bool filled = result->variables != NULL;
  for (size_t k = 0; k < count && filled; k++) {
    filled = fill_variable(result->variables + k, tally, k);
  }
  return filled;
}

/* Is the critical angle between those of Eqs. (16) and (15), which come last? */
static void count_within(tp_study_result *result, const tp_tally *tally) {
  static const double digits = 1e-9; /* to which angles are certain: teeth lie on a bound */
  const double *angles = tally->columns[tally->study->variable_count + TP_STUDY_MOMENTS_DEG];
  const double *peak = tally->columns[tally->column_count - 2];
  const double *valley = tally->columns[tally->column_count - 1];
  const size_t kept = tp_tally_kept(tally);
  for (size_t k = 0; k < kept; k++) {
    if (isnan(peak[k]) || isnan(valley[k]) || isnan(angles[k])) continue;
    result->bracketed++;
    const double off = digits * fabs(angles[k]);
    result->within += valley[k] <= angles[k] + off && angles[k] - off <= peak[k];
  }
}

static bool fill_measures(tp_study_result *result, const tp_tally *tally) {
  const tp_study *study = tally->study;
  if (study->measure_count == 0) return true;
  result->roughness = calloc(study->measure_count, sizeof *result->roughness);
  if (result->roughness == NULL) return false;
  result->roughness_count = study->measure_count;
  for (size_t k = 0; k < study->measure_count; k++) {
    const double *column = tally->columns[tp_tally_measures(study) + k];
    tp_study_measure *own = result->roughness + k;
    *own = (tp_study_measure){.name = tp_study_measure_name(study->measures[k]),
                              .unit = tp_study_measure_unit(study, k),
                              .least = NAN,
                              .greatest = NAN};
    for (size_t j = 0; j < tp_tally_kept(tally); j++) {
      if (isnan(column[j])) continue;
      own->samples++;
      own->least = fmin(own->least, column[j]);
      own->greatest = fmax(own->greatest, column[j]);
    }
  }
  count_within(result, tally);
  return true;
}

static char *column_name(const tp_study *study, size_t k) {
  char tilt[TP_SHORTEST_SIZE];
  tp_text text = {0};
  char *name = NULL;
  const size_t quantities = study->variable_count;
  const size_t outcomes = quantities + tp_study_quantity_count(study);
  if (k < quantities) {
    tp_study_field_name(&text, study, tp_study_field_of_variable(k));
    return tp_text_finish(&text, &name) == TP_OK ? name : NULL;
  }
  if (k < outcomes) return strdup(tp_study_quantity_name((tp_study_quantity)(k - quantities)));
  if (k == outcomes) return strdup("outcome");
  if (k == tp_tally_definitions(study)) return strdup("fos_definition");
  if (k == tp_tally_factors(study)) return strdup("fos_moments");
  if (k == tp_tally_factors(study) + 1) return strdup("fos_sliding");
  if (k >= tp_tally_measures(study)) {
    tp_study_field_name(&text, study,
                        tp_study_field_of_measure(study, k - tp_tally_measures(study)));
    return tp_text_finish(&text, &name) == TP_OK ? name : NULL;
  }
  tp_text_add(&text, "outcome_at_%s_deg", tp_shortest(tilt, study->tilts[k - outcomes - 1]));
  return tp_text_finish(&text, &name) == TP_OK ? name : NULL;
}

/* They go over to the result. */
static bool fill_columns(tp_study_result *result, tp_tally *tally) {
  bool filled = true;
  result->columns = calloc(tally->column_count, sizeof *result->columns);
  if (result->columns == NULL) return false;
  result->column_count = tally->column_count;
  for (size_t k = 0; k < tally->column_count; k++) {
    result->columns[k] = (tp_study_column){column_name(tally->study, k), tally->columns[k]};
    tally->columns[k] = NULL;
    filled = filled && result->columns[k].header != NULL;
  }
  return filled;
}

/* ---- all of it ---------------------------------------------------------------------------------
 */

static bool fill(tp_study_result *result, const tp_tally *tally) {
  const tp_study *study = tally->study;
  const tp_row_counts *counts = &tally->counts;
  bool filled = tp_summary_convergence(result, tally) && fill_tilts(result, tally);
  for (size_t q = 0; q < tp_study_quantity_count(study) && filled; q++) {
    filled = fill_spread(result->quantities + q, tally->columns[study->variable_count + q],
                         tp_tally_kept(tally), NULL, 0);
  }
  filled = filled && fill_factors(result, tally) && fill_measures(result, tally) &&
           fill_variables(result, tally) && fill_correlations(result, study);
  result->of_many_blocks = tp_study_is_of_many(study);
  result->of_solid = tp_study_is_of_solid(study);
  result->of_wedge = is_of_wedge(study->scene);
  result->has_required_fos =
      (result->of_many_blocks || result->of_solid) && study->scene->required_fos.given;
  result->below_required = tp_row_counts_share(counts->below_required, counts->samples);
  result->meets_required = tp_row_counts_share(counts->meets_required, counts->samples);
  result->open_required = tp_row_counts_share(tp_row_counts_open_required(counts), counts->samples);
  result->samples = counts->samples;
  result->kept = tp_tally_kept(tally);
  result->open = counts->open;
  result->by_doubles = counts->by_doubles;
  result->doubles_seconds = 1e-9 * (double)counts->doubles_nanoseconds;
  result->ladder_seconds = 1e-9 * (double)counts->ladder_nanoseconds;
  return filled;
}

tp_status tp_tally_finish(tp_study_result *result, tp_tally *tally, tp_message *message) {
  if (!fill(result, tally)) return tp_fail_memory(message, "the summary of a study");
  tp_status status = tp_summary_invalid(result, tally, message);
  if (status == TP_OK) status = tp_tally_ranks(result, tally, message);
  if (status != TP_OK) return status;
  return fill_columns(result, tally) ? TP_OK : tp_fail_memory(message, "the summary of a study");
}

void tp_study_result_free(tp_study_result *result) {
  if (result == NULL) return;
  for (size_t k = 0; k < result->variable_count; k++) {
    free(result->variables[k].key);
    free(result->variables[k].law);
  }
  free(result->correlations);
  for (size_t k = 0; k < result->column_count; k++) {
    free(result->columns[k].header);
    free(result->columns[k].values);
  }
  for (size_t k = 0; k < result->invalid_count; k++) {
    free(result->invalid[k].settings);
    free(result->invalid[k].why);
  }
  for (size_t k = 0; k < result->design_value_count; k++) free(result->design_values[k].why);
  free(result->design_values);
  for (size_t k = 0; k < result->source_count; k++) free(result->sources[k]);
  free(result->sources);
  free(result->roughness);
  free(result->variables);
  free(result->columns);
  free(result->invalid);
  free(result->tilts);
  free(result->convergence);
  tp_study_reliability_clear(&result->reliability);
  free(result->title);
  free(result->scene);
  free(result);
}
