/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What the settings of a tilt test take from its answer, as JSON (docs/schema/converge.json).
 * Simulated numbers are plain: they have no proven error. */

#include "report/converge_json.h"

#include "common/host.h"
#include "report/notes.h"
#include "report/words.h"
#include "terms/names.h"

static const char *key_of(tp_converge_setting setting) {
  static const char *const keys[TP_CONVERGE_SETTINGS] = {
      [TP_CONVERGE_TOLERANCE] = "tolerance_deg",
      [TP_CONVERGE_STIFFNESS] = "normal_stiffness_pa_m",
      [TP_CONVERGE_STIFFNESS_RATIO] = "stiffness_ratio",
      [TP_CONVERGE_TIME_STEP] = "time_step_s",
      [TP_CONVERGE_DAMPING] = "damping",
      [TP_CONVERGE_ROUNDING] = "rounding_m",
      [TP_CONVERGE_STEP_TOLERANCE] = "step_tolerance",
      [TP_CONVERGE_LEAST_BOUNCE] = "least_bounce"};
  return keys[setting];
}

static void json_range(tp_json *j, const char *key, bool known, double least, double most) {
  if (!known) {
    tp_json_null(j, key);
    return;
  }
  tp_json_object(j, key, TP_JSON_LINE);
  tp_json_double(j, "least", least);
  tp_json_double(j, "most", most);
  tp_json_close(j);
}

static void json_level(tp_json *j, const tp_converge_level *level) {
  tp_json_object(j, NULL, TP_JSON_LINE);
  tp_json_double(j, "value", level->value);
  tp_json_truth(j, "own", level->own);
  json_range(j, "bracket", level->known, level->least, level->most);
  tp_json_count(j, "runs", level->runs);
  tp_json_significant(j, "seconds", level->seconds, 6);
  tp_json_close(j);
}

static void json_finding(tp_json *j, const tp_converge_finding *f,
                         const tp_tilt_convergence_case *c) {
  tp_json_object(j, NULL, TP_JSON_BLOCK);
  tp_json_string(j, "setting", key_of(f->setting));
  tp_json_string(j, "verdict", tp_converge_verdict_name(f->verdict));
  tp_json_double(j, "spread", f->spread);
  if (f->has_needed) {
    tp_json_double(j, "needed", f->needed);
  } else {
    tp_json_null(j, "needed");
  }
  tp_json_array(j, "levels", TP_JSON_BLOCK);
  for (size_t k = 0; k < f->count; k++) json_level(j, c->levels + f->first + k);
  tp_json_close(j);
  tp_json_close(j);
}

static void json_case(tp_json *j, const tp_tilt_convergence_case *c) {
  tp_json_object(j, NULL, TP_JSON_BLOCK);
  tp_json_string(j, "towards", tp_direction_name(c->towards));
  if (c->has_onset) tp_json_double(j, "onset_deg", c->onset_deg);
  if (c->has_limit) tp_json_double(j, "limit_deg", c->limit_deg);
  json_range(j, "as_set", c->known, c->own_least, c->own_most);
  json_range(j, "over_settings", c->known, c->least, c->most);
  tp_json_truth(j, "converged", c->converged);
  tp_json_array(j, "settings", TP_JSON_BLOCK);
  for (size_t k = 0; k < c->finding_count; k++) json_finding(j, c->findings + k, c);
  tp_json_close(j);
  tp_json_close(j);
}

void tp_json_convergence(tp_json *j, const tp_tilt_convergence *c) {
  tp_json_string(j, "engine", tp_tilt_engine_name(c->settings.engine));
  tp_json_string(j, "protocol", tp_tilt_protocol_name(c->settings.protocol));
  tp_json_string(j, "quantity", tp_converge_quantity_name(c->quantity));
  tp_json_double(j, "asked", c->asked);
  tp_json_array(j, "cases", TP_JSON_BLOCK);
  for (size_t k = 0; k < c->case_count; k++) json_case(j, c->cases + k);
  tp_json_close(j);
}

tp_status tp_report_tilt_convergence_json(char **text, const tp_tilt_convergence *convergence) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(NULL, text);
  TP_REFUSE_NULL(NULL, convergence);
  tp_json j = {0};
  tp_json_report(&j);
  tp_json_string(&j, "title", convergence->title);
  tp_json_convergence(&j, convergence);
  tp_json_notes(&j, &convergence->notes);
  tp_json_close(&j);
  return tp_json_finish(&j, text);
}
