/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Measures of a profile in their order (docs/profile.md): scaling, turning and sampling, then
 * slopes, series of heights, lags, spectrum, Hurst exponent and JRC, with notes on what limits
 * them. */

#include "roughness/profile.h"

#include "common/host.h"
#include "common/notes.h"
#include "common/options.h"
#include "roughness/hurst.h"
#include "roughness/jrc.h"
#include "roughness/sampling.h"
#include "roughness/slopes.h"
#include "roughness/turn.h"
#include "scene/exact.h"
#include "scene/scene.h"
#include "scene_reading/csv.h"

#include <stdlib.h>
#include <string.h>

/* Degrees by which a profile may lean before the page speaks of it. */
static const double much_lean_deg = 1;

void tp_profile_free(tp_profile *profile) {
  if (profile == NULL) return;
  free(profile->title);
  tp_notes_clear(&profile->notes);
  for (size_t k = 0; k < profile->source_count; k++) free(profile->sources[k]);
  free(profile->sources);
  free(profile->x);
  free(profile->y);
  free(profile->lags);
  free(profile->densities);
  free(profile->correlations);
  free(profile);
}

static bool copy_names(tp_profile *p, const tp_profile_subject *subject) {
  if (subject->title != NULL) {
    p->title = strdup(subject->title);
    if (p->title == NULL) return false;
  }
  p->sources = calloc(subject->source_count + 1, sizeof *p->sources);
  for (size_t k = 0; k < subject->source_count && p->sources != NULL; k++) {
    p->sources[k] = strdup(subject->sources[k]);
    if (p->sources[k] == NULL) return false;
    p->source_count++;
  }
  return p->sources != NULL;
}

/* The points that are measured, from those that were given, scaled and mirrored. */
static tp_status sample(tp_course *sampled, const tp_course *given, const tp_profile_options *o,
                        tp_message *message) {
  if (o->step > 0) return tp_course_resample(sampled, given, o->step, o->resampling, message);
  if (!tp_course_init(sampled, given->count)) return tp_fail_memory(message, "the profile");
  memcpy(sampled->x, given->x, given->count * sizeof *given->x);
  memcpy(sampled->y, given->y, given->count * sizeof *given->y);
  sampled->x_error = given->x_error;
  sampled->y_error = given->y_error;
  sampled->extent = given->extent;
  return TP_OK;
}

static void measure_slopes(tp_profile *p, const tp_course *points) {
  const tp_slopes s = tp_slopes_measure(points);
  p->even = tp_course_are_even(points);
  p->least_step = points->extent.least_step;
  p->largest_step = points->extent.largest_step;
  p->step = s.length.value / (double)(points->count - 1);
  p->length = s.length;
  p->length_along = s.along;
  p->amplitude = s.amplitude;
  p->rms_height = s.rms_height;
  p->mean_slope = s.mean_slope;
  p->mean_absolute_slope = s.absolute_slope;
  p->z2 = s.z2;
  p->effective_angle_deg = s.effective_angle_deg;
  p->rp = s.rp;
  p->has_sf = p->even;
  if (p->even) p->sf = s.sf;
  tp_slopes_facing(p->facing, points, s.along);
}

static tp_status measure_lags(tp_profile *p, const tp_heights *heights, tp_message *message) {
  const size_t most = (heights->count - 1) / 2, count = tp_lag_steps(NULL, most);
  size_t *steps = calloc(count, sizeof *steps);
  p->lags = calloc(count, sizeof *p->lags);
  if (steps == NULL || p->lags == NULL) {
    free(steps);
    return tp_fail_memory(message, "the structure function");
  }
  p->lag_count = tp_lag_steps(steps, most);
  for (size_t k = 0; k < count; k++) p->lags[k] = tp_lag_measure(heights, steps[k]);
  free(steps);
  p->correlation_length = tp_correlation_length(heights, p->lags, p->lag_count);
  return TP_OK;
}

static tp_status measure_spectrum(tp_profile *p, const tp_heights *h, tp_message *message) {
  tp_spectrum spectrum;
  if (!tp_spectrum_init(&spectrum, h, p->options.window)) {
    return tp_fail_memory(message, "the spectrum");
  }
  p->density_count = spectrum.count;
  p->densities = spectrum.densities;
  tp_hurst_by_structure(&p->hurst_by_structure, p->structure_fit, h, p->lags);
  if (tp_hurst_by_spectrum(&p->hurst_by_spectrum, p->spectrum_fit, &spectrum, h->count, h->step,
                           p->options.window)) {
    return TP_OK;
  }
  return tp_fail_memory(message, "the self-affine exponent");
}

/* What needs heights at even distances: about their mean. */
static tp_status measure_series(tp_profile *p, const tp_course *points, tp_message *message) {
  p->series = !p->even                                  ? TP_SERIES_UNEVEN
              : points->count < TP_PROFILE_SERIES_LEAST ? TP_SERIES_SHORT
                                                        : TP_SERIES_GIVEN;
  if (p->series != TP_SERIES_GIVEN) return TP_OK;
  double *values = calloc(points->count, sizeof *values), mean = 0, squares = 0;
  if (values == NULL) return tp_fail_memory(message, "the heights");
  for (size_t k = 0; k < points->count; k++) mean += points->y[k] / (double)points->count;
  for (size_t k = 0; k < points->count; k++) {
    values[k] = points->y[k] - mean;
    squares += values[k] * values[k];
  }
  const tp_heights heights = {values, points->count, p->step, squares / (double)points->count};
  tp_status status = measure_lags(p, &heights, message);
  if (status == TP_OK) status = measure_spectrum(p, &heights, message);
  free(values);
  return status;
}

/* What the numbers rest on, and may be wrong with. */
static tp_status add_notes(tp_profile *p, const tp_course *given, tp_place place,
                           tp_message *message) {
  const double least = given->extent.least_step;
  tp_status status = TP_OK;
  if (p->options.step > 0 && p->options.step < least * (1 - 1e-6)) {
    status = tp_notes_add(&p->notes, message, TP_CAUTION, place,
                          "the step of %.6g is finer than any distance between the points, the "
                          "least of which is %.6g: what lies between them is the interpolation's",
                          p->options.step, least);
  }
  const bool leans = fabs(p->trend_deg.value) > much_lean_deg;
  if (status == TP_OK && leans && p->options.detrend == TP_DETREND_NONE) {
    status = tp_notes_add(&p->notes, message, TP_NOTE, place,
                          "the profile leans by %.3g° against x, which counts as roughness; "
                          "detrend takes it off",
                          p->trend_deg.value);
  }
  return status;
}

static tp_status measure(tp_profile *p, const tp_profile_subject *subject, tp_message *message) {
  tp_course given = {0}, points = {0};
  const bool turns = p->options.detrend == TP_DETREND_TURN;
  tp_bounded turned_deg = {0};
  tp_status status =
      turns ? tp_course_turned(&given, &turned_deg, subject->chain, p->options.scale, message)
            : tp_course_from_chain(&given, subject->chain, p->options.scale, message);
  if (status != TP_OK) return status;
  if (p->options.mirrored) tp_course_mirror(&given);
  p->given_points = given.count;
  status = sample(&points, &given, &p->options, message);
  if (status == TP_OK) {
    tp_bounded middle;
    p->trend_deg = turns ? turned_deg : tp_bounded_atan_deg(tp_course_trend(&points, &middle));
    tp_course_detrend(&points, p->options.detrend);
    measure_slopes(p, &points);
    status = measure_series(p, &points, message);
  }
  if (status == TP_OK) status = tp_jrc_measure(p, &given, message);
  if (status == TP_OK) {
    status = add_notes(p, &given, (tp_place){subject->chain->file, 0, 0}, message);
  }
  p->point_count = points.count;
  p->x = points.x;
  p->y = points.y;
  tp_course_clear(&given);
  return status;
}

tp_status tp_profile_measure(tp_profile **profile, const tp_profile_subject *subject,
                             const tp_profile_options *options, tp_message *message) {
  if ((options->jcs_mpa > 0) != (options->normal_stress_kpa > 0)) {
    return tp_refuse(message, TP_FAULT_GEOMETRY, (tp_place){0},
                     "Eq. (10) needs %s; a scene with a unit weight and Barton's law has both",
                     options->jcs_mpa > 0 ? "a normal stress beside JCS"
                                          : "JCS beside the normal stress");
  }
  tp_profile *own = calloc(1, sizeof *own);
  if (own == NULL) return tp_fail_memory(message, "the profile");
  own->size = sizeof *own;
  own->options = *options;
  own->origin = subject->origin;
  own->length_unit = subject->length_unit;
  own->metres_per_unit = subject->metres_per_unit;
  tp_status status = copy_names(own, subject) ? TP_OK : tp_fail_memory(message, "the profile");
  if (status == TP_OK) status = measure(own, subject, message);
  if (status == TP_OK && options->jcs_mpa > 0 && options->normal_stress_kpa > 0) {
    status = tp_jrc_by_equation_10(own, options->jcs_mpa, options->normal_stress_kpa, message);
  }
  if (status == TP_OK) {
    *profile = own;
  } else {
    tp_profile_free(own);
  }
  return status;
}

/* The unit by its name, as a scene has it. */
static tp_status read_unit(tp_profile_subject *subject, const char *length_unit, const char *call,
                           tp_message *message) {
  tp_scene *scene = tp_scene_make(call);
  if (scene == NULL) return tp_fail_memory(message, "the length unit");
  const tp_status status = tp_scene_use_unit(scene, length_unit, (tp_place){call, 0, 0}, message);
  subject->length_unit = scene->length_unit;
  subject->metres_per_unit = tp_metres_of_unit(scene->metres_per_unit);
  tp_scene_free(scene);
  return status;
}

/* Before its own notes. */
static tp_status prepend_notes(tp_profile *p, tp_notes *first, tp_message *message) {
  const tp_status status = tp_notes_append(first, &p->notes, message);
  if (status != TP_OK) return status;
  tp_notes_clear(&p->notes);
  p->notes = *first;
  *first = (tp_notes){0};
  return TP_OK;
}

tp_status tp_profile_of_file(tp_profile **profile, const char *path, const char *length_unit,
                             const tp_profile_options *options, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, profile);
  TP_REFUSE_NULL(message, path);
  TP_REFUSE_NULL(message, length_unit);
  TP_REFUSE_NULL(message, options);
  tp_profile_options taken = tp_profile_options_default();
  TP_TAKE_OPTIONS(message, taken, options);
  tp_profile_subject subject = {
      .origin = TP_PROFILE_FILE, .title = path, .source_count = 1, .sources = &path};
  tp_polyline line = {0};
  tp_notes notes = {0};
  tp_profile *own = NULL;
  tp_status status = tp_profile_check_options(options, message);
  if (status == TP_OK) status = read_unit(&subject, length_unit, __func__, message);
  const char *unit = NULL;
  if (status == TP_OK) status = tp_csv_read(&line, &unit, path, false, &notes, message);
  if (status == TP_OK) {
    status = tp_csv_check_unit(unit, length_unit, path,
                               "the profile's unit, mm where none is given,", message);
  }
  subject.chain = &line;
  if (status == TP_OK) status = tp_profile_measure(&own, &subject, options, message);
  if (own != NULL) status = prepend_notes(own, &notes, message);
  tp_polyline_clear(&line);
  tp_notes_clear(&notes);
  if (status == TP_OK) {
    *profile = own;
  } else {
    tp_profile_free(own);
  }
  return status;
}

tp_status tp_profile_of_points(tp_profile **profile, tp_coordinates points, const char *length_unit,
                               const tp_profile_options *options, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, profile);
  TP_REFUSE_NULL(message, length_unit);
  TP_REFUSE_NULL(message, options);
  tp_profile_options taken = tp_profile_options_default();
  TP_TAKE_OPTIONS(message, taken, options);
  tp_profile_subject subject = {.origin = TP_PROFILE_POINTS};
  tp_polyline line = {0};
  tp_status status = tp_profile_check_options(options, message);
  if (status == TP_OK) status = read_unit(&subject, length_unit, __func__, message);
  if (status == TP_OK) {
    status = tp_coordinates_read(&line, points, false, "points", __func__, 0, message);
  }
  subject.chain = &line;
  if (status == TP_OK) status = tp_profile_measure(profile, &subject, options, message);
  tp_polyline_clear(&line);
  return status;
}
