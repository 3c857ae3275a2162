/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The summary of a study as JSON (docs/schema/study.json). A number that is infinite is a word:
 * always, where it holds at every tilt, and never. */

#include "common/host.h"
#include "output/json.h"
#include "report/study_words.h"
#include "terms/names.h"

#include <math.h>

static void add_share_members(tp_json *j, const tp_study_share *share) {
  tp_json_count(j, "samples", share->count);
  tp_json_double(j, "share", share->share);
  tp_json_double(j, "low", share->low);
  tp_json_double(j, "high", share->high);
}

static void add_share(tp_json *j, const char *key, const tp_study_share *share) {
  tp_json_object(j, key, TP_JSON_LINE);
  add_share_members(j, share);
  tp_json_close(j);
}

static void add_tilt(tp_json *j, const tp_study_tilt *tilt) {
  tp_json_object(j, NULL, TP_JSON_BLOCK);
  tp_json_truth(j, "of_scene", tilt->of_scene);
  tp_json_truth(j, "as_it_lies", tilt->as_it_lies);
  tp_json_truth(j, "tilt_varies", tilt->tilt_varies);
  if (tilt->has_tilt && !tilt->tilt_varies) {
    tp_json_double(j, "tilt_deg", tilt->tilt_deg);
  } else {
    tp_json_null(j, "tilt_deg");
  }
  tp_json_array(j, "outcomes", TP_JSON_BLOCK);
  for (int k = 0; k < TP_STUDY_OUTCOMES; k++) {
    tp_json_object(j, NULL, TP_JSON_LINE);
    tp_json_string(j, "outcome", tp_study_outcome_name((tp_study_outcome)k));
    add_share_members(j, tilt->outcomes + k);
    tp_json_close(j);
  }
  tp_json_close(j);
  add_share(j, "certain_to_stand", &tilt->stands);
  add_share(j, "certain_to_move", &tilt->moves);
  tp_json_close(j);
}

/* A number, or the word for one that is infinite. */
static void add_number(tp_json *j, const char *key, double value) {
  if (isinf(value)) {
    tp_json_string(j, key, value > 0 ? "always" : "never");
  } else {
    tp_json_double(j, key, value);
  }
}

/* An end of an interval: null, where so few samples do not tell. */
static void add_quantile(tp_json *j, const tp_study_quantile *own) {
  tp_json_object(j, NULL, TP_JSON_LINE);
  tp_json_double(j, "probability", own->probability);
  add_number(j, "value", own->value);
  tp_json_double(j, "low", own->low);
  tp_json_double(j, "high", own->high);
  tp_json_close(j);
}

static void add_quantiles(tp_json *j, const tp_study_spread *spread) {
  tp_json_count(j, "samples", spread->count);
  tp_json_array(j, "quantiles", TP_JSON_BLOCK);
  for (size_t k = 0; k < TP_STUDY_QUANTILES && spread->count > 0; k++) {
    add_quantile(j, spread->quantiles + k);
  }
  tp_json_close(j);
}

static void add_spread(tp_json *j, const tp_study_result *r, tp_study_quantity quantity) {
  const tp_study_spread *spread = r->spreads + quantity;
  tp_json_object(j, NULL, TP_JSON_BLOCK);
  tp_json_string(j, "quantity", tp_study_quantity_name(quantity));
  add_quantiles(j, spread);
  tp_json_close(j);
}

static void add_factors(tp_json *j, const tp_study_result *r) {
  tp_json_array(j, "governing_factors", TP_JSON_BLOCK);
  for (int k = 0; k < TP_FOS_DEFINITIONS; k++) {
    const tp_study_factor *own = r->factors + k;
    tp_json_object(j, NULL, TP_JSON_BLOCK);
    tp_json_string(j, "definition", tp_fos_definition_name(own->definition));
    add_share(j, "governs", &own->governs);
    tp_json_count(j, "below_1", own->below);
    add_quantiles(j, &own->spread);
    tp_json_close(j);
  }
  tp_json_close(j);
}

static void add_rank(tp_json *j, const tp_study_rank *rank, tp_study_quantity quantity) {
  tp_json_object(j, NULL, TP_JSON_LINE);
  tp_json_string(j, "quantity", tp_study_quantity_name(quantity));
  tp_json_double(j, "value", rank->value);
  tp_json_double(j, "low", rank->low);
  tp_json_double(j, "high", rank->high);
  tp_json_close(j);
}

static void add_index(tp_json *j, const tp_study_index *own, tp_study_quantity quantity) {
  tp_json_object(j, NULL, TP_JSON_LINE);
  tp_json_string(j, "quantity", tp_study_quantity_name(quantity));
  tp_json_double(j, "first", own->first);
  tp_json_double(j, "first_low", own->first_low);
  tp_json_double(j, "first_high", own->first_high);
  tp_json_double(j, "total", own->total);
  tp_json_double(j, "total_low", own->total_low);
  tp_json_double(j, "total_high", own->total_high);
  tp_json_close(j);
}

/* What the analyses besides the samples tell of a number. */
static void add_analyses(tp_json *j, const tp_study_result *r, const tp_study_variable *own) {
  if (r->sensitivity_samples > 0) {
    tp_json_array(j, "sobol_indices", TP_JSON_BLOCK);
    for (int q = 0; q < TP_STUDY_QUANTITIES; q++) {
      if (own->indices[q].known) add_index(j, own->indices + q, (tp_study_quantity)q);
    }
    tp_json_close(j);
  }
  if (r->reliability.known) {
    tp_json_double(j, "design_value", own->design_value);
    tp_json_double(j, "importance", own->importance);
  }
}

static void add_rare(tp_json *j, const char *key, const tp_study_rare *own) {
  if (!own->asked) return;
  tp_json_object(j, key, TP_JSON_LINE);
  tp_json_truth(j, "known", own->known);
  if (own->known) {
    tp_json_double(j, "probability", own->probability);
    tp_json_double(j, "low", own->low);
    tp_json_double(j, "high", own->high);
    tp_json_double(j, "variation", own->variation);
    tp_json_count(j, "scenes", own->calls);
  } else {
    tp_json_string(j, "why", own->why);
  }
  tp_json_close(j);
}

static void add_reliability(tp_json *j, const tp_study_reliability *own) {
  if (!own->known) return;
  tp_json_object(j, "reliability", TP_JSON_BLOCK);
  tp_json_string(j, "quantity", tp_study_quantity_name(own->quantity));
  tp_json_truth(j, "converged", own->converged);
  tp_json_string(j, "state", own->state);
  tp_json_double(j, "beta", own->beta);
  tp_json_double(j, "probability", own->probability);
  tp_json_count(j, "scenes", own->calls);
  tp_json_array(j, "design_points", TP_JSON_BLOCK);
  for (size_t k = 0; k < own->point_count; k++) {
    tp_json_object(j, NULL, TP_JSON_LINE);
    tp_json_double(j, "beta", own->points[k].beta);
    tp_json_double(j, "probability", own->points[k].probability);
    tp_json_array(j, "values", TP_JSON_LINE);
    for (size_t i = 0; i < own->points[k].value_count; i++) {
      tp_json_double(j, NULL, own->points[k].values[i]);
    }
    tp_json_close(j);
    tp_json_close(j);
  }
  tp_json_close(j);
  add_rare(j, "importance", &own->importance);
  add_rare(j, "subset", &own->subset);
  tp_json_close(j);
}

static void add_design(tp_json *j, const tp_study_result *r, const tp_study_design *own) {
  tp_json_object(j, NULL, TP_JSON_LINE);
  tp_json_string(j, "key", r->variables[own->variable].key);
  tp_json_double(j, "probability", own->probability);
  tp_json_string(j, "quantity", tp_study_quantity_name(own->quantity));
  tp_json_double(j, "scene_value", own->scene_value);
  tp_json_truth(j, "known", own->known);
  if (own->known) {
    tp_json_double(j, "value", own->value);
    tp_json_double(j, "low", own->low);
    tp_json_double(j, "high", own->high);
    tp_json_string(j, "safe", own->low_is_safe ? "low" : "high");
    add_number(j, "quantity_value", own->quantity_value);
  } else {
    tp_json_string(j, "why", own->why);
  }
  tp_json_count(j, "scenes", own->calls);
  tp_json_close(j);
}

static void add_designs(tp_json *j, const tp_study_result *r) {
  if (r->design_count == 0) return;
  tp_json_array(j, "design_values", TP_JSON_BLOCK);
  for (size_t k = 0; k < r->design_count; k++) add_design(j, r, r->designs + k);
  tp_json_close(j);
}

static void add_ranks(tp_json *j, const tp_study_rank ranks[TP_STUDY_QUANTITIES]) {
  tp_json_array(j, "rank_correlations", TP_JSON_BLOCK);
  for (int q = 0; q < TP_STUDY_QUANTITIES; q++) {
    if (ranks[q].known) add_rank(j, ranks + q, (tp_study_quantity)q);
  }
  tp_json_close(j);
}

static void add_variable(tp_json *j, const tp_study_result *r, const tp_study_variable *own) {
  tp_json_object(j, NULL, TP_JSON_BLOCK);
  tp_json_string(j, "key", own->key);
  tp_json_string(j, "kind", own->kind);
  tp_json_string(j, "unit", own->unit);
  tp_json_string(j, "law", own->law);
  if (r->kept > 0) {
    tp_json_double(j, "least", own->least);
    tp_json_double(j, "greatest", own->greatest);
  }
  add_ranks(j, own->ranks);
  add_analyses(j, r, own);
  tp_json_close(j);
}

static void add_correlations(tp_json *j, const tp_study_result *r) {
  if (r->correlation_count == 0) return;
  tp_json_array(j, "correlations", TP_JSON_BLOCK);
  for (size_t k = 0; k < r->correlation_count; k++) {
    const tp_study_correlation *own = r->correlations + k;
    tp_json_object(j, NULL, TP_JSON_LINE);
    tp_json_string(j, "one", r->variables[own->one].key);
    tp_json_string(j, "other", r->variables[own->other].key);
    tp_json_double(j, "value", own->value);
    tp_json_close(j);
  }
  tp_json_close(j);
}

static void add_measures(tp_json *j, const tp_study_result *r) {
  if (r->measure_count == 0) return;
  tp_json_array(j, "roughness", TP_JSON_BLOCK);
  for (size_t k = 0; k < r->measure_count; k++) {
    const tp_study_measure *own = r->measures + k;
    tp_json_object(j, NULL, TP_JSON_BLOCK);
    tp_json_string(j, "name", own->name);
    tp_json_string(j, "unit", own->unit);
    tp_json_count(j, "samples", own->count);
    tp_json_double(j, "least", own->least);
    tp_json_double(j, "greatest", own->greatest);
    add_ranks(j, own->ranks);
    tp_json_close(j);
  }
  tp_json_close(j);
  tp_json_count(j, "bracketed", r->bracketed);
  tp_json_count(j, "within", r->within);
}

static void add_head(tp_json *j, const tp_study_result *r) {
  tp_json_string(j, "title", r->title);
  tp_json_string(j, "scene", r->scene);
  tp_json_string(j, "method", r->method);
  tp_json_count(j, "seed", r->seed);
  tp_json_count(j, "planned", r->planned);
  tp_json_count(j, "samples", r->samples);
  tp_json_count(j, "kept", r->kept);
  tp_json_string(j, "end", tp_study_end_name(r->end));
  tp_json_count(j, "shard", r->shard);
  tp_json_count(j, "shards", r->shards);
  tp_json_count(j, "open", r->open);
  tp_json_count(j, "by_doubles", r->by_doubles);
}

static void add_bad(tp_json *j, const tp_study_result *r) {
  tp_json_array(j, "invalid", TP_JSON_BLOCK);
  for (size_t k = 0; k < r->bad_count; k++) {
    tp_json_object(j, NULL, TP_JSON_LINE);
    tp_json_count(j, "sample", r->bad[k].sample);
    tp_json_string(j, "settings", r->bad[k].settings);
    tp_json_string(j, "why", r->bad[k].why);
    tp_json_close(j);
  }
  tp_json_close(j);
}

static void add_steps(tp_json *j, const tp_study_result *r) {
  tp_json_array(j, "convergence", TP_JSON_BLOCK);
  for (size_t k = 0; k < r->step_count; k++) {
    tp_json_object(j, NULL, TP_JSON_LINE);
    tp_json_count(j, "of_samples", r->steps[k].samples);
    add_share(j, "certain_to_move", &r->steps[k].moves);
    tp_json_close(j);
  }
  tp_json_close(j);
}

tp_status tp_report_study_json(char **text, const tp_study_result *result) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(NULL, text);
  TP_REFUSE_NULL(NULL, result);
  tp_json j = {0};
  tp_json_report(&j);
  add_head(&j, result);
  tp_json_array(&j, "variables", TP_JSON_BLOCK);
  for (size_t k = 0; k < result->variable_count; k++) {
    add_variable(&j, result, result->variables + k);
  }
  tp_json_close(&j);
  add_correlations(&j, result);
  add_measures(&j, result);
  tp_json_array(&j, "tilts", TP_JSON_BLOCK);
  for (size_t k = 0; k < result->tilt_count; k++) add_tilt(&j, result->tilts + k);
  tp_json_close(&j);
  tp_json_array(&j, "quantities", TP_JSON_BLOCK);
  for (int q = 0; q < TP_STUDY_QUANTITIES; q++) add_spread(&j, result, (tp_study_quantity)q);
  tp_json_close(&j);
  add_factors(&j, result);
  if (result->sensitivity_samples > 0) {
    tp_json_count(&j, "sensitivity_samples", result->sensitivity_samples);
  }
  add_reliability(&j, &result->reliability);
  add_designs(&j, result);
  add_steps(&j, result);
  add_bad(&j, result);
  tp_json_close(&j);
  return tp_json_finish(&j, text);
}
