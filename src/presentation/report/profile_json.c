/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The roughness of a profile as JSON (docs/schema/profile.json). Lengths are in its length unit,
 * which stands at the head. */

#include "common/host.h"
#include "output/encode.h"
#include "output/json.h"
#include "report/notes.h"
#include "report/words.h"
#include "roughness/bands.h"
#include "terms/names.h"

#include <math.h>

static void add_sampling(tp_json *j, const tp_profile *p) {
  const tp_profile_options *o = &p->options;
  tp_json_object(j, "sampling", TP_JSON_LINE);
  tp_json_count(j, "given_points", p->given_points);
  tp_json_count(j, "points", p->point_count);
  tp_json_truth(j, "even", p->even);
  tp_json_double(j, "step", p->step);
  tp_json_double(j, "least_step", p->least_step);
  tp_json_double(j, "largest_step", p->largest_step);
  tp_json_break(j);
  tp_json_string(j, "resampling", o->step > 0 ? tp_profile_resampling_name(o->resampling) : NULL);
  tp_json_string(j, "detrend", tp_profile_detrend_name(o->detrend));
  tp_json_string(j, "window", tp_profile_window_name(o->window));
  tp_json_truth(j, "mirrored", o->mirrored);
  tp_json_double(j, "scale", o->scale);
  tp_json_close(j);
}

static void add_shape(tp_json *j, const tp_profile *p) {
  tp_json_bounded(j, "length", p->length);
  tp_json_bounded(j, "length_along", p->along);
  tp_json_bounded(j, "amplitude", p->amplitude);
  tp_json_bounded(j, "rms_height", p->rms_height);
  tp_json_bounded(j, "trend_deg", p->trend_deg);
  tp_json_bounded(j, "mean_slope", p->mean_slope);
  tp_json_bounded(j, "mean_absolute_slope", p->absolute_slope);
  tp_json_bounded(j, "z2", p->z2);
  tp_json_bounded(j, "effective_angle_deg", p->effective_angle_deg);
  tp_json_bounded(j, "rp", p->rp);
  if (p->has_sf) {
    tp_json_bounded(j, "sf", p->sf);
  } else {
    tp_json_null(j, "sf");
  }
}

static void add_facing(tp_json *j, const tp_profile_facing *facing, tp_direction towards) {
  tp_json_object(j, NULL, TP_JSON_LINE);
  tp_json_string(j, "towards", tp_direction_name(towards));
  tp_json_count(j, "facets", facing->facets);
  tp_json_bounded(j, "share", facing->share);
  tp_json_bounded(j, "angle_deg", facing->angle_deg);
  tp_json_bounded(j, "steepest_deg", facing->steepest_deg);
  tp_json_break(j);
  tp_json_double(j, "exponent", facing->exponent);
  tp_json_double(j, "fit_rms", facing->fit_rms);
  tp_json_double(j, "roughness_deg", facing->roughness_deg);
  tp_json_close(j);
}

/* null where it is not found. */
static void add_estimate(tp_json *j, const char *key, const tp_profile_estimate *estimate) {
  if (!estimate->found) {
    tp_json_null(j, key);
    return;
  }
  tp_json_object(j, key, TP_JSON_LINE);
  tp_json_double(j, "value", estimate->value);
  tp_json_double(j, "low", estimate->has_range ? estimate->low : NAN);
  tp_json_double(j, "high", estimate->has_range ? estimate->high : NAN);
  tp_json_close(j);
}

static void add_hurst(tp_json *j, const char *by, const tp_profile_estimate *estimate,
                      const double fit[2]) {
  tp_json_object(j, NULL, TP_JSON_LINE);
  tp_json_string(j, "by", by);
  add_estimate(j, "exponent", estimate);
  tp_json_double(j, "from", estimate->found ? fit[0] : NAN);
  tp_json_double(j, "to", estimate->found ? fit[1] : NAN);
  tp_json_close(j);
}

static void add_correlation(tp_json *j, const tp_profile_jrc *own) {
  tp_json_object(j, NULL, TP_JSON_LINE);
  tp_json_string(j, "source", own->authors);
  tp_json_string(j, "equation", own->equation);
  tp_json_string(j, "meant_for_step", own->step[0] != '\0' ? own->step : NULL);
  tp_json_break(j);
  tp_json_double(j, "own_step", own->own_step > 0 ? own->own_step : NAN);
  tp_json_bounded(j, "input", own->input);
  tp_json_bounded(j, "jrc", own->jrc);
  tp_json_string(j, "state", tp_jrc_state_name(own->state));
  tp_json_close(j);
}

static void add_jrc(tp_json *j, const tp_profile *p) {
  tp_json_object(j, "jrc", TP_JSON_BLOCK);
  tp_json_count(j, "meant", p->jrc_meant);
  if (p->jrc_meant > 0) {
    tp_json_bounded(j, "low", p->jrc_low);
    tp_json_bounded(j, "median", p->jrc_median);
    tp_json_bounded(j, "high", p->jrc_high);
  }
  if (p->has_eq_10) {
    tp_json_object(j, "eq_10", TP_JSON_LINE);
    tp_json_double(j, "jcs_mpa", p->jcs_mpa);
    tp_json_double(j, "normal_stress_kpa", p->normal_stress_kpa);
    tp_json_bounded(j, "jrc", p->jrc_eq_10);
    tp_json_close(j);
  }
  tp_json_array(j, "correlations", TP_JSON_BLOCK);
  for (size_t k = 0; k < p->jrc_count; k++) add_correlation(j, p->jrc + k);
  tp_json_close(j);
  tp_json_close(j);
}

static void add_lags(tp_json *j, const tp_profile *p) {
  tp_json_array(j, "lags", TP_JSON_BLOCK);
  for (size_t k = 0; k < p->lag_count; k++) {
    tp_json_object(j, NULL, TP_JSON_LINE);
    tp_json_double(j, "distance", p->lags[k].distance);
    tp_json_double(j, "structure", p->lags[k].structure);
    tp_json_double(j, "correlation", p->lags[k].correlation);
    tp_json_count(j, "pairs", p->lags[k].pairs);
    tp_json_close(j);
  }
  tp_json_close(j);
}

static void add_spectrum(tp_json *j, const tp_profile *p, bool all) {
  tp_json_object(j, "spectrum", TP_JSON_BLOCK);
  tp_json_double(j, "frequency_step", p->densities[1].frequency);
  tp_json_array(j, "bands", TP_JSON_BLOCK);
  for (tp_band band = {0}; tp_band_next(&band, p);) {
    tp_json_object(j, NULL, TP_JSON_LINE);
    tp_json_double(j, "frequency", band.frequency);
    tp_json_double(j, "density", band.density);
    tp_json_count(j, "ordinates", band.count);
    tp_json_close(j);
  }
  tp_json_close(j);
  if (all) {
    tp_json_array(j, "densities", TP_JSON_LINE);
    for (size_t k = 0; k < p->density_count; k++) tp_json_double(j, NULL, p->densities[k].density);
    tp_json_close(j);
  }
  tp_json_close(j);
}

static void add_facets(tp_json *j, const tp_profile *p) {
  static const double degrees = 57.295779513082323;
  tp_json_array(j, "facets", TP_JSON_BLOCK);
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

tp_status tp_report_profile_json(char **text, const tp_profile *p, bool all) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(NULL, text);
  TP_REFUSE_NULL(NULL, p);
  tp_json j = {0};
  tp_json_report(&j);
  if (p->title != NULL) tp_json_string(&j, "title", p->title);
  tp_json_string(&j, "from", tp_profile_origin_name(p->origin));
  tp_json_string(&j, "length_unit", p->length_unit);
  add_sampling(&j, p);
  add_shape(&j, p);
  tp_json_array(&j, "facing", TP_JSON_BLOCK);
  for (int d = 0; d < 2; d++) add_facing(&j, p->facing + d, (tp_direction)d);
  tp_json_close(&j);
  add_jrc(&j, p);
  tp_json_string(&j, "series", tp_profile_series_name(p->series));
  if (p->series == TP_SERIES_GIVEN) {
    add_estimate(&j, "correlation_length", &p->correlation_length);
    tp_json_array(&j, "hurst", TP_JSON_BLOCK);
    add_hurst(&j, "structure function", &p->hurst_by_structure, p->structure_fit);
    add_hurst(&j, "spectrum", &p->hurst_by_spectrum, p->spectrum_fit);
    tp_json_close(&j);
    add_lags(&j, p);
    add_spectrum(&j, p, all);
  }
  if (all) add_facets(&j, p);
  tp_json_notes(&j, &p->notes);
  tp_json_close(&j);
  return tp_json_finish(&j, text);
}
