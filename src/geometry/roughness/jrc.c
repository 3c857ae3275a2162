/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* All forms rise with their input P > 0, so that JRC of P - e and of P + e bound it; eight
 * roundings of its terms are added for pow and log10, which are right to one. */

#include "roughness/jrc.h"

#include "roughness/correlations_table.h"
#include "roughness/sampling.h"
#include "roughness/slopes.h"

#include <stdlib.h>

typedef enum measure { Z2, FACING, AMPLITUDE, AMPLITUDE_OVER_LENGTH, EQ_11, EQ_12 } measure;
typedef enum shape { POWER, LOGARITHM } shape;

typedef struct correlation {
  const char *authors, *equation;
  measure input;
  shape form;
  double a, b, c;
  const char *step;
  double step_from, step_to, length_from, length_to, jrc_from, jrc_to;
} correlation;

#define ROW(...) {__VA_ARGS__},
static const correlation correlations[] = {TP_JRC_CORRELATIONS(ROW)};
#undef ROW
enum { CORRELATIONS = sizeof correlations / sizeof correlations[0] };

/* What a correlation may ask of a profile sampled at one step. */
typedef struct sampled {
  double step; /* mm; 0: uneven */
  tp_bounded z2, facing;
} sampled;

static tp_bounded mean_facing(const tp_profile_facing facing[2]) {
  return tp_bounded_of((facing[0].roughness_deg + facing[1].roughness_deg) / 2, 0);
}

static bool is_whole_step(const correlation *c, double step) {
  return step >= c->step_from && step <= c->step_to;
}

/* Is it meant for one step, at which the profile can be sampled anew? */
static bool has_own_step(const correlation *c) {
  return c->step_to > 0 && c->step_to < 2 * c->step_from;
}

/* The middle of the steps it is meant for, rounded to a 20th of a mm: 0.25, 0.5, 1. */
static double own_step(const correlation *c) {
  return round((c->step_from + c->step_to) / 2 * 20) / 20;
}

/* Measure the profile anew at a step in mm; *done is false where its points lie too far apart for
 * that, or too few steps fit. */
static tp_status sample_anew(sampled *own, bool *done, const tp_profile *profile,
                             const tp_course *points, double step_mm, tp_message *message) {
  const double step = step_mm / (profile->metres_per_unit * 1e3);
  const double length = points->x[points->count - 1];
  tp_course anew = {0};
  *done = points->extent.largest_step <= step * (1 + 1e-6) &&
          length >= (double)TP_PROFILE_SERIES_LEAST * step;
  if (!*done) return TP_OK;
  const tp_status status =
      tp_course_resample(&anew, points, step, profile->options.resampling, message);
  if (status != TP_OK) return status;
  tp_course_detrend(&anew, profile->options.detrend);
  const tp_slopes slopes = tp_slopes_measure(&anew);
  tp_profile_facing facing[2];
  tp_slopes_facing(facing, &anew, slopes.along);
  *own = (sampled){.step = step_mm, .z2 = slopes.z2, .facing = mean_facing(facing)};
  tp_course_clear(&anew);
  return TP_OK;
}

/* A over L^power in the units of the table: mm over m. */
static tp_bounded amplitude_over(const tp_profile *p, double power) {
  const double metres = p->length.value * p->metres_per_unit;
  const tp_bounded over = tp_bounded_over(p->amplitude, p->length);
  const double factor = p->metres_per_unit * 1e3 * pow(metres, -power) * p->length.value;
  const double of_length = fabs(1 - power) * p->length.error / p->length.value;
  return tp_bounded_of(over.value * factor,
                       over.error * factor +
                           fabs(over.value * factor) * (of_length + 10 * tp_roundoff));
}

static tp_bounded input_of(const correlation *c, const tp_profile *p, const sampled *at) {
  const double metres = p->length.value * p->metres_per_unit;
  switch (c->input) {
  case Z2:
    return at->z2;
  case FACING:
    return at->facing;
  case AMPLITUDE:
    return amplitude_over(p, 0);
  case AMPLITUDE_OVER_LENGTH:
    return tp_bounded_over(p->amplitude, p->length);
  case EQ_11: {
    const tp_bounded over = tp_bounded_over(p->amplitude, p->length);
    const double k = 450 + 50 * log10(metres);
    const double of_k = 50 * p->length.error / p->length.value + 4 * tp_roundoff * (fabs(k) + 450);
    return tp_bounded_of(k * over.value, fabs(k) * over.error + over.value * of_k);
  }
  case EQ_12:
    return amplitude_over(p, 0.917);
  }
  return at->z2;
}

static double jrc_of(const correlation *c, double input) {
  if (c->form == LOGARITHM) return c->a * log10(input) + c->c;
  return c->a * pow(fmax(input, 0), c->b) + c->c;
}

static tp_bounded bounded_jrc(const correlation *c, tp_bounded input) {
  const double value = jrc_of(c, input.value);
  const double low = jrc_of(c, fmax(input.value - input.error, 0));
  const double high = jrc_of(c, input.value + input.error);
  return tp_bounded_of(value, fmax(value - low, high - value) +
                                  8 * tp_roundoff * (fabs(value) + 2 * fabs(c->c)));
}

static tp_jrc_state state_of(const correlation *c, const tp_profile *p, double step,
                             tp_bounded jrc) {
  static const double slack = 1e-9; /* of a length that is a limit, in other units */
  const double mm = p->length.value * p->metres_per_unit * 1e3;
  if (!isfinite(jrc.value)) return TP_JRC_NO_NUMBER;
  if (c->step_to > 0 && !is_whole_step(c, step)) return TP_JRC_OTHER_STEP;
  const bool shorter = mm<c->length_from *(1 - slack), longer = mm> c->length_to * (1 + slack);
  if (c->length_to > 0 && (shorter || longer)) return TP_JRC_OTHER_LENGTH;
  return jrc.value < c->jrc_from || jrc.value > c->jrc_to ? TP_JRC_OFF_SCALE : TP_JRC_MEANT;
}

static int compare(const void *a, const void *b) {
  const double x = ((const tp_bounded *)a)->value, y = ((const tp_bounded *)b)->value;
  return (x > y) - (x < y);
}

/* The least, the largest and the median of those that are meant for the profile. */
static void spread(tp_profile *p) {
  tp_bounded meant[CORRELATIONS];
  size_t count = 0;
  for (size_t k = 0; k < p->correlation_count; k++) {
    if (p->correlations[k].state == TP_JRC_MEANT) meant[count++] = p->correlations[k].jrc;
  }
  p->jrc_meant = count;
  if (count == 0) return;
  qsort(meant, count, sizeof *meant, compare);
  const tp_bounded low = meant[(count - 1) / 2], high = meant[count / 2];
  const double middle = low.value + (high.value - low.value) / 2;
  double widest = 0; /* neighbours within their bounds may change places */
  for (size_t k = 0; k < count; k++) widest = fmax(widest, meant[k].error);
  p->jrc_low = tp_bounded_of(meant[0].value, widest);
  p->jrc_high = tp_bounded_of(meant[count - 1].value, widest);
  p->jrc_median = tp_bounded_of(middle, widest + 2 * tp_roundoff * fabs(middle));
}

tp_status tp_jrc_measure(tp_profile *p, const tp_course *points, tp_message *message) {
  const sampled as_is = {.step = p->even ? p->step * p->metres_per_unit * 1e3 : 0,
                         .z2 = p->z2,
                         .facing = mean_facing(p->facing)};
  sampled anew = {0};
  p->correlations = calloc(CORRELATIONS, sizeof *p->correlations);
  if (p->correlations == NULL) return tp_fail_memory(message, "the correlations");
  for (; p->correlation_count < CORRELATIONS; p->correlation_count++) {
    const correlation *c = correlations + p->correlation_count;
    const sampled *at = &as_is;
    bool resampled = false;
    if (has_own_step(c) && !is_whole_step(c, as_is.step)) {
      resampled = anew.step == own_step(c);
      if (!resampled) {
        const tp_status status = sample_anew(&anew, &resampled, p, points, own_step(c), message);
        if (status != TP_OK) return status;
      }
      if (resampled) at = &anew;
    }
    const tp_bounded input = input_of(c, p, at), jrc = bounded_jrc(c, input);
    p->correlations[p->correlation_count] =
        (tp_profile_jrc){.source = c->authors,
                         .equation = c->equation,
                         .meant_for_step = c->step,
                         .own_step = resampled ? at->step / (p->metres_per_unit * 1e3) : 0,
                         .input = input,
                         .jrc = jrc,
                         .state = state_of(c, p, at->step, jrc)};
  }
  spread(p);
  return TP_OK;
}

tp_status tp_jrc_by_equation_10(tp_profile *p, double jcs_mpa, double normal_stress_kpa,
                                tp_message *message) {
  const double ratio = jcs_mpa * 1e3 / normal_stress_kpa, decades = log10(ratio);
  if (!(ratio > 1)) {
    return tp_refuse(message, TP_FAULT_RANGE, (tp_place){0},
                     "Eq. (10) needs a normal stress below JCS: %.6g kPa against %.6g MPa",
                     normal_stress_kpa, jcs_mpa);
  }
  p->has_eq_10 = true;
  p->jcs_mpa = jcs_mpa;
  p->normal_stress_kpa = normal_stress_kpa;
  p->jrc_eq_10 = tp_bounded_over(p->effective_angle_deg,
                                 tp_bounded_of(decades, 4 * tp_roundoff * (1 + fabs(decades))));
  return TP_OK;
}
