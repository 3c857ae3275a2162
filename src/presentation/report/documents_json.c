/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Studies, accuracy, profiles, derivations, families and verifications as JSON documents, by the
 * tables of core/terms/results; here is what these call for a profile, whose lengths are in its
 * length unit.
 */

#include "common/host.h"
#include "report/results.h"
#include "roughness/bands.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void tp_json_profile_bands(tp_json *j, const char *key, const tp_profile *p) {
  tp_json_array(j, key, TP_JSON_BLOCK);
  for (tp_band band = {0}; tp_band_next(&band, p);) {
    tp_json_object(j, NULL, TP_JSON_LINE);
    tp_json_double(j, "frequency", band.frequency);
    tp_json_double(j, "density", band.density);
    tp_json_count(j, "ordinates", band.count);
    tp_json_close(j);
  }
  tp_json_close(j);
}

void tp_json_profile_facets(tp_json *j, const char *key, const tp_profile *p) {
  static const double degrees = 57.295779513082323;
  tp_json_array(j, key, TP_JSON_BLOCK);
  for (size_t k = 1; k < p->point_count; k++) {
    const double dx = p->x[k] - p->x[k - 1], dy = p->y[k] - p->y[k - 1];
    tp_json_object(j, NULL, TP_JSON_LINE);
    tp_json_double(j, "x", p->x[k - 1]);
    tp_json_double(j, "y", p->y[k - 1]);
    tp_json_double(j, "length", sqrt(dx * dx + dy * dy));
    tp_json_double(j, "angle_deg", atan(dy / dx) * degrees);
    tp_json_close(j);
  }
  tp_json_close(j);
}

void tp_json_numbers_by_name(tp_json *j, const char *key, const char *text) {
  static const char between[] = " =,";
  char *own = strdup(text), *rest = NULL;
  if (own == NULL) {
    j->text.failed = true;
    return;
  }
  tp_json_object(j, key, TP_JSON_LINE);
  for (const char *symbol = strtok_r(own, between, &rest); symbol != NULL;
       symbol = strtok_r(NULL, between, &rest)) {
    const char *number = strtok_r(NULL, between, &rest);
    tp_json_printed(j, symbol, number != NULL ? number : "");
  }
  tp_json_close(j);
  free(own);
}

tp_status tp_report_profile_json(char **text, const tp_profile *profile, bool all) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(NULL, text);
  TP_REFUSE_NULL(NULL, profile);
  const tp_profile *p = profile;
  const tp_hurst hurst[] = {
      {"structure function", &p->hurst_by_structure, p->structure_fit[0], p->structure_fit[1]},
      {"spectrum", &p->hurst_by_spectrum, p->spectrum_fit[0], p->spectrum_fit[1]}};
  tp_json_subject x = {.all = all, .hurst = hurst};
  return tp_json_document_of_profile(text, profile, &x);
}

tp_status tp_report_derivation_json(char **text, const tp_derivation *derivation) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(NULL, text);
  TP_REFUSE_NULL(NULL, derivation);
  tp_json_subject x = {0};
  return tp_json_document_of_derive(text, derivation, &x);
}

tp_status tp_report_family_json(char **text, const tp_family *family) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(NULL, text);
  TP_REFUSE_NULL(NULL, family);
  tp_json_subject x = {.family = family};
  return tp_json_document_of_family(text, family, &x);
}

tp_status tp_report_verification_json(char **text, const tp_verification *verification) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(NULL, text);
  TP_REFUSE_NULL(NULL, verification);
  tp_json_subject x = {0};
  return tp_json_document_of_verify(text, verification, &x);
}

bool tp_study_is_upper_bound(const tp_study_result *result, tp_study_quantity quantity) {
  if (!result->of_many_blocks) return false;
  return quantity == TP_STUDY_LIMIT_DEG || quantity == TP_STUDY_ACCELERATION_G ||
         (quantity == TP_STUDY_FOS && result->open > 0);
}

size_t tp_json_study_quantities(const tp_study_result *result) {
  return result->of_many_blocks || result->of_solid ? TP_STUDY_QUANTITIES : TP_STUDY_FOS + 1;
}

tp_status tp_report_study_json(char **text, const tp_study_result *result) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(NULL, text);
  TP_REFUSE_NULL(NULL, result);
  tp_json_subject x = {.study = result};
  return tp_json_document_of_study(text, result, &x);
}

tp_status tp_report_accuracy_json(char **text, const tp_accuracy *accuracy) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(NULL, text);
  TP_REFUSE_NULL(NULL, accuracy);
  tp_json_subject x = {0};
  return tp_json_document_of_accuracy(text, accuracy, &x);
}
