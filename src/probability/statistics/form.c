/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Rackwitz-Fiessler steps with central differences and a line search on |z|^2 / 2 + c |g|. */

#include "statistics/form.h"

#include "statistics/standard_space.h"

#include <gsl/gsl_cdf.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double farthest = 37;

const char *tp_form_state_text(tp_form_state state) {
  switch (state) {
  case TP_FORM_CONVERGED:
    return "the design point was found";
  case TP_FORM_FLAT:
    return "no design point: the result does not change near where the search stopped; vary what "
           "it depends on";
  case TP_FORM_STUCK:
    return "no design point: the result is discontinuous or kinked where the search "
           "stopped; use the sampling";
  case TP_FORM_STEPS:
    return "no design point within the steps allowed; allow more, or use the sampling";
  case TP_FORM_UNDECIDED:
    return "no design point: the result is undecided where the search stopped; allow more digits";
  case TP_FORM_FAR:
    return "no design point within 37 deviations: the failure probability is too small for a "
           "double";
  }
  return "unknown state";
}

tp_form_options tp_form_options_default(void) {
  return (tp_form_options){.step = 1e-3, .tolerance = 1e-6, .most_steps = 100};
}

/* The search: where it is, g and its gradient there, and places to work in. */
typedef struct search {
  tp_standard_space *space;
  const tp_form_options *options;
  size_t n;
  double g;
  double *places;                      /* all that follow lie there */
  double *z, *gradient, *move, *tried; /* n each */
  double *around, *values;             /* 2 n points, and g at each */
} search;

static double dot(const double *a, const double *b, size_t n) {
  double sum = 0;
  for (size_t k = 0; k < n; k++) sum += a[k] * b[k];
  return sum;
}

static tp_status init(search *s, tp_standard_space *space, const tp_reliability *problem,
                      const tp_form_options *options, tp_message *message) {
  const size_t n = problem->dimensions;
  *s = (search){.space = space, .options = options, .n = n};
  const tp_status status = tp_standard_space_init(s->space, problem, 2 * n, message);
  if (status != TP_OK) return status;
  s->places = calloc(6 * n + 2 * n * n, sizeof *s->places);
  if (s->places == NULL) {
    tp_standard_space_clear(s->space);
    (void)tp_fail_memory(message, "a design point");
    return TP_OUT_OF_MEMORY;
  }
  s->z = s->places;
  s->gradient = s->z + n;
  s->move = s->z + 2 * n;
  s->tried = s->z + 3 * n;
  s->values = s->z + 4 * n;
  s->around = s->z + 6 * n;
  return TP_OK;
}

static void clear(search *s) {
  tp_standard_space_clear(s->space);
  free(s->places);
}

/* g with its bulges. */
static tp_status values(search *s, double *g, const double *z, size_t count, tp_message *message) {
  const tp_status status = tp_standard_space_values(s->space, g, z, count, message);
  if (status != TP_OK) return status;
  for (size_t k = 0; k < count; k++) {
    for (size_t b = 0; b < s->options->bulge_count; b++) {
      const tp_form_bulge *own = s->options->bulges + b;
      double within = own->radius * own->radius;
      for (size_t i = 0; i < s->n; i++) {
        within -= (z[k * s->n + i] - own->centre[i]) * (z[k * s->n + i] - own->centre[i]);
      }
      if (within > 0) g[k] += own->height * within * within;
    }
  }
  return TP_OK;
}

static tp_status differentiate(search *s, tp_message *message) {
  const size_t n = s->n;
  const double h = s->options->step;
  for (size_t k = 0; k < 2 * n; k++) {
    memcpy(s->around + k * n, s->z, n * sizeof *s->z);
    s->around[k * n + k / 2] += k % 2 == 0 ? h : -h;
  }
  const tp_status status = values(s, s->values, s->around, 2 * n, message);
  if (status != TP_OK) return status;
  for (size_t k = 0; k < n; k++) {
    s->gradient[k] = (s->values[2 * k] - s->values[2 * k + 1]) / (2 * h);
  }
  return TP_OK;
}

/* From z to the foot of the origin on the plane where g, made linear, is 0. */
static void aim(search *s) {
  const double square = dot(s->gradient, s->gradient, s->n);
  const double reach = (dot(s->gradient, s->z, s->n) - s->g) / square;
  for (size_t k = 0; k < s->n; k++) s->move[k] = reach * s->gradient[k] - s->z[k];
}

/* c > |z| / |gradient| makes the move one along which |z|^2 / 2 + c |g| falls at first. */
static double penalty(const search *s) {
  const double slope = sqrt(dot(s->gradient, s->gradient, s->n));
  double square = 0;
  for (size_t k = 0; k < s->n; k++) square += (s->z[k] + s->move[k]) * (s->z[k] + s->move[k]);
  const double least = sqrt(dot(s->z, s->z, s->n)) / slope;
  return 2 * fmax(least, fabs(s->g) > s->options->tolerance * slope ? square / 2 / fabs(s->g) : 0);
}

/* The longest of the move's halves that falls by a share of what it promises; false where none. */
static tp_status advance(search *s, bool *moved, tp_message *message) {
  enum { HALVES = 30 };
  static const double share = 0.1;
  const double c = penalty(s), before = dot(s->z, s->z, s->n) / 2 + c * fabs(s->g);
  const double sign = s->g > 0 ? 1 : s->g < 0 ? -1 : 0;
  const double slope = dot(s->z, s->move, s->n) + c * sign * dot(s->gradient, s->move, s->n);
  double length = 1, g;
  *moved = false;
  for (int k = 0; k < HALVES; k++, length /= 2) {
    for (size_t i = 0; i < s->n; i++) s->tried[i] = s->z[i] + length * s->move[i];
    const tp_status status = values(s, &g, s->tried, 1, message);
    if (status != TP_OK) return status;
    const double after = dot(s->tried, s->tried, s->n) / 2 + c * fabs(g);
    if (!(after <= before + share * length * slope)) continue; /* nor where it is undecided */
    memcpy(s->z, s->tried, s->n * sizeof *s->z);
    s->g = g;
    *moved = true;
    return TP_OK;
  }
  return TP_OK;
}

/* Both at once: on the surface, and the origin straight below, where an error of direction t
 * changes the distance by t^2 / 2 beta only. */
static bool converged(const search *s) {
  static const double direction = 100;
  const double slope = sqrt(dot(s->gradient, s->gradient, s->n));
  const double tolerance = s->options->tolerance;
  return fabs(s->g) <= tolerance * slope &&
         sqrt(dot(s->move, s->move, s->n)) <= direction * tolerance;
}

static tp_status run(search *s, tp_form_state *state, int *steps, tp_message *message) {
  for (*steps = 0; *steps <= s->options->most_steps; (*steps)++) {
    tp_status status = differentiate(s, message);
    if (status != TP_OK) return status;
    const double square = dot(s->gradient, s->gradient, s->n);
    *state = !isfinite(s->g) || !isfinite(square) ? TP_FORM_UNDECIDED : TP_FORM_FLAT;
    if (!(square > 0) || !isfinite(square) || !isfinite(s->g)) return TP_OK;
    aim(s);
    *state = TP_FORM_CONVERGED;
    if (converged(s)) return TP_OK;
    bool moved;
    status = advance(s, &moved, message);
    if (status != TP_OK) return status;
    *state = TP_FORM_STUCK;
    if (!moved) return TP_OK;
    *state = TP_FORM_FAR;
    if (dot(s->z, s->z, s->n) > farthest * farthest) return TP_OK;
  }
  *state = TP_FORM_STEPS;
  return TP_OK;
}

/* The gradient over the dependent scores y, L' a = gradient from the last row on; a variable that
 * those before it tell has no share. */
static void share_out(const search *s, double *importance) {
  const double *factor = s->space->factor;
  const size_t n = s->n;
  memcpy(importance, s->gradient, n * sizeof *importance);
  for (size_t k = n; factor != NULL && k-- > 0;) {
    for (size_t j = k + 1; j < n; j++) importance[k] -= factor[j * n + k] * importance[j];
    importance[k] = factor[k * n + k] > 0 ? importance[k] / factor[k * n + k] : 0;
  }
  const double square = dot(importance, importance, n);
  for (size_t k = 0; k < n; k++) {
    importance[k] = square > 0 ? importance[k] * importance[k] / square : 0;
  }
}

static void report(tp_form *form, const search *s, double at_origin) {
  const double distance = sqrt(dot(s->z, s->z, s->n));
  form->beta = at_origin < 0 ? -distance : distance;
  form->probability = gsl_cdf_ugaussian_P(-form->beta);
  form->calls = s->space->calls;
  form->slope = sqrt(dot(s->gradient, s->gradient, s->n));
  memcpy(form->scores, s->z, s->n * sizeof *s->z);
  tp_standard_space_point(s->space, form->point, s->z);
  share_out(s, form->importance);
}

tp_status tp_form_find(tp_form *form, const tp_reliability *problem, const tp_form_options *options,
                       tp_message *message) {
  const size_t n = problem->dimensions;
  tp_standard_space space;
  search s;
  tp_status status = init(&s, &space, problem, options, message);
  if (status != TP_OK) return status;
  double *scores = calloc(3 * n, sizeof *scores);
  if (scores == NULL) {
    clear(&s);
    return tp_fail_memory(message, "a design point");
  }
  tp_form own = {
      .dimensions = n, .scores = scores, .point = scores + n, .importance = scores + 2 * n};
  double at_origin = 0;
  status = tp_standard_space_values(&space, &at_origin, s.z, 1, message);
  if (options->start != NULL) memcpy(s.z, options->start, n * sizeof *s.z);
  if (status == TP_OK && options->start == NULL && options->bulge_count == 0) {
    s.g = at_origin;
  } else if (status == TP_OK) {
    status = values(&s, &s.g, s.z, 1, message);
  }
  if (status == TP_OK) status = run(&s, &own.state, &own.steps, message);
  if (status == TP_OK) {
    report(&own, &s, at_origin);
    *form = own;
  } else {
    tp_form_clear(&own);
  }
  clear(&s);
  return status;
}

void tp_form_clear(tp_form *form) {
  free(form->scores);
  form->scores = form->point = form->importance = NULL;
}
