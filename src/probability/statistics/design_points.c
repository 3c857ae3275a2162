/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Repeated searches by the first-order method with bulges on known design points, from the axes and
 * from random directions; points nearer than a tenth of their distance are one. */

#include "statistics/design_points.h"

#include "generate/random.h"
#include "statistics/standard_space.h"

#include <gsl/gsl_cdf.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static double squared_distance(const double *a, const double *b, size_t n) {
  double sum = 0;
  for (size_t i = 0; i < n; i++) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return sum;
}

/* ---- what is found -----------------------------------------------------------------------------
 */

static bool is_known(const tp_design_points *found, const tp_form *form) {
  static const double apart = 0.1; /* in deviations, and of the distance */
  const double room = apart * fmax(1, fabs(form->beta));
  for (size_t k = 0; k < found->count; k++) {
    const double *z = found->points[k].scores;
    if (squared_distance(z, form->scores, form->dimensions) < room * room) return true;
  }
  return false;
}

/* Those that the nearest outweighs. */
static void drop_unlikely(tp_design_points *found) {
  static const double least = 1e-4;
  const double nearest = found->points[0].beta;
  while (found->count > 1) {
    const double beta = found->points[found->count - 1].beta;
    if (exp((nearest * nearest - beta * beta) / 2) >= least) return;
    tp_form_clear(found->points + --found->count);
  }
}

/* Takes the form, or frees it. */
static bool take(tp_design_points *found, tp_form *form) {
  found->calls += form->calls;
  if (form->state != TP_FORM_CONVERGED || is_known(found, form) ||
      found->count == TP_DESIGN_POINTS) {
    tp_form_clear(form);
    return false;
  }
  const double *own = form->scores;
  size_t at = found->count++;
  for (; at > 0 && fabs(found->points[at - 1].beta) > fabs(form->beta); at--) {
    found->points[at] = found->points[at - 1];
  }
  found->points[at] = *form;
  found->state = TP_FORM_CONVERGED;
  drop_unlikely(found);
  for (size_t k = 0; k < found->count; k++) {
    if (found->points[k].scores == own) return true;
  }
  return false;
}

tp_status tp_design_points_add(tp_design_points *found, bool *added, const tp_reliability *problem,
                               const double *start, tp_message *message) {
  tp_form_options options = tp_form_options_default();
  tp_form form;
  options.start = start;
  options.most_steps = 30;
  const tp_status status = tp_form_find(&form, problem, &options, message);
  *added = status == TP_OK && take(found, &form);
  return status;
}

/* ---- searches ----------------------------------------------------------------------------------
 */

/* On a known point, as the reference has it: it reaches the origin, and lifts g most at the point.
 */
static tp_form_bulge bulge_on(const tp_form *form, bool means_fail) {
  static const double reach = 1.1, lifted = 0.75;
  const double beta = fmax(fabs(form->beta), 1e-3), radius = reach * beta, near = lifted * beta;
  const double room = radius * radius - near * near;
  const double height = near * form->slope / (room * room);
  return (tp_form_bulge){form->scores, radius, means_fail ? -height : height};
}

/* With all bulges, and from where that ends without, until nothing is new. */
static tp_status go_elsewhere(tp_design_points *found, const tp_reliability *problem,
                              tp_message *message) {
  enum { ROUNDS = 6 };
  bool added = found->count > 0;
  tp_status status = TP_OK;
  for (int round = 0; round < ROUNDS && added && status == TP_OK; round++) {
    tp_form_bulge bulges[TP_DESIGN_POINTS];
    tp_form_options options = tp_form_options_default();
    tp_form form;
    for (size_t k = 0; k < found->count; k++) {
      bulges[k] = bulge_on(found->points + k, !(found->at_origin > 0));
    }
    options.bulges = bulges;
    options.bulge_count = found->count;
    options.most_steps = 30;
    status = tp_form_find(&form, problem, &options, message);
    if (status != TP_OK) return status;
    found->calls += form.calls;
    status = tp_design_points_add(found, &added, problem, form.scores, message);
    tp_form_clear(&form);
  }
  return status;
}

/* A direction of length 1: along an axis, or at random. */
static void aim(double *direction, size_t n, size_t number, uint64_t stream) {
  double square = 0;
  for (size_t i = 0; i < n; i++) {
    const uint64_t bits = tp_random_bits(tp_random_branch(stream, i), number);
    direction[i] = number < 2 * n ? (i == number / 2 ? number % 2 == 0 ? 1 : -1 : 0)
                                  : gsl_cdf_ugaussian_Pinv(tp_random_unit(bits));
    square += direction[i] * direction[i];
  }
  for (size_t i = 0; i < n; i++) direction[i] /= sqrt(square);
}

static tp_status go_around(tp_design_points *found, const tp_reliability *problem, uint64_t seed,
                           tp_message *message) {
  enum { RANDOM = 8, MOST_AXES = 10 };
  static const double unknown = 3; /* deviations, where no point is known */
  const size_t n = problem->dimensions;
  const size_t first = n <= MOST_AXES ? 0 : 2 * n; /* many axes cost too much */
  const uint64_t stream = tp_random_stream(seed, TP_STREAM_DIRECTIONS);
  double *start = calloc(n, sizeof *start);
  tp_status status = start != NULL ? TP_OK : tp_fail_memory(message, "a design point");
  for (size_t k = first; k < 2 * n + RANDOM && status == TP_OK; k++) {
    const double distance = found->count > 0 ? fabs(found->points[0].beta) : unknown;
    bool added;
    aim(start, n, k, stream);
    for (size_t i = 0; i < n; i++) start[i] *= fmax(distance, 1);
    status = tp_design_points_add(found, &added, problem, start, message);
  }
  free(start);
  return status;
}

static tp_status look_at_origin(tp_design_points *found, const tp_reliability *problem,
                                tp_message *message) {
  tp_standard_space space;
  double *z = calloc(problem->dimensions, sizeof *z);
  if (z == NULL) return tp_fail_memory(message, "a design point");
  tp_status status = tp_standard_space_init(&space, problem, 1, message);
  if (status == TP_OK) {
    status = tp_standard_space_values(&space, &found->at_origin, z, 1, message);
    found->calls += space.calls;
    tp_standard_space_clear(&space);
  }
  free(z);
  return status;
}

tp_status tp_design_points_find(tp_design_points *found, const tp_reliability *problem,
                                uint64_t seed, tp_message *message) {
  const tp_form_options options = tp_form_options_default();
  tp_design_points own = {.count = 0};
  tp_form form;
  tp_status status = look_at_origin(&own, problem, message);
  if (status == TP_OK) status = tp_form_find(&form, problem, &options, message);
  if (status == TP_OK) {
    own.state = form.state;
    (void)take(&own, &form);
    status = go_elsewhere(&own, problem, message);
  }
  if (status == TP_OK) status = go_around(&own, problem, seed, message);
  if (status == TP_OK) status = go_elsewhere(&own, problem, message);
  if (status == TP_OK) {
    *found = own;
  } else {
    tp_design_points_clear(&own);
  }
  return status;
}

void tp_design_points_clear(tp_design_points *found) {
  for (size_t k = 0; k < found->count; k++) tp_form_clear(found->points + k);
  found->count = 0;
}
