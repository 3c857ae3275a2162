/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Linear: an abscissa that is off by e moves a height by steepest e at most; the node k step rounds
 * once, the formula four times on sizes up to three times the highest. The spline's second
 * derivatives M solve a tridiagonal system, strictly dominant on its diagonal, by elimination
 * without pivoting (de Boor, A Practical Guide to Splines, chapter IV); GSL's own asks for memory
 * in a way that ends the process. Its samples are where bounds begin. */

#include "roughness/sampling.h"

#include <stdlib.h>

static const double most_samples = 50e6;

/* The first derivative of nothing: natural ends, M = 0. `m` gets M at every point; `c` is room for
 * as many. */
static void spline_curvatures(double *m, double *c, const tp_course *p) {
  const size_t last = p->count - 1;
  m[0] = c[0] = m[last] = 0;
  for (size_t k = 1; k < last; k++) {
    const double before = p->x[k] - p->x[k - 1], after = p->x[k + 1] - p->x[k];
    const double bend = (p->y[k + 1] - p->y[k]) / after - (p->y[k] - p->y[k - 1]) / before;
    const double pivot = 2 * (before + after) - before * c[k - 1];
    c[k] = after / pivot;
    m[k] = (6 * bend - before * m[k - 1]) / pivot;
  }
  for (size_t k = last; k-- > 1;) m[k] -= c[k] * m[k + 1];
}

static double spline_height(const tp_course *p, const double *m, size_t k, double x) {
  const double h = p->x[k + 1] - p->x[k];
  const double a = (p->x[k + 1] - x) / h, b = (x - p->x[k]) / h;
  return a * p->y[k] + b * p->y[k + 1] +
         ((a * a * a - a) * m[k] + (b * b * b - b) * m[k + 1]) * h * h / 6;
}

static double linear_height(const tp_course *p, size_t k, double x) {
  const double slope = (p->y[k + 1] - p->y[k]) / (p->x[k + 1] - p->x[k]);
  return p->y[k] + (x - p->x[k]) * slope;
}

static void sample(tp_course *sampled, const tp_course *p, double step, const double *curvatures) {
  size_t k = 0;
  for (size_t j = 0; j < sampled->count; j++) {
    const double x = (double)j * step;
    while (k + 2 < p->count && p->x[k + 1] <= x) k++;
    sampled->x[j] = x;
    sampled->y[j] =
        curvatures != NULL ? spline_height(p, curvatures, k, x) : linear_height(p, k, x);
  }
}

static tp_status sample_spline(tp_course *sampled, const tp_course *p, double step,
                               tp_message *message) {
  double *room = calloc(2 * p->count, sizeof *room);
  if (room == NULL) return tp_fail_memory(message, "the spline");
  spline_curvatures(room, room + p->count, p);
  sample(sampled, p, step, room);
  free(room);
  sampled->x_error = sampled->y_error = 0;
  return TP_OK;
}

static void sample_linear(tp_course *sampled, const tp_course *p, double step) {
  const double length = p->x[p->count - 1];
  sample(sampled, p, step, NULL);
  sampled->x_error = tp_roundoff * length * tp_room;
  sampled->y_error = (p->y_error + 3 * p->extent.steepest * (p->x_error + sampled->x_error) +
                      12 * tp_roundoff * p->extent.highest) *
                     tp_room;
}

tp_status tp_course_resample(tp_course *sampled, const tp_course *course, double step,
                             tp_profile_resampling resampling, tp_message *message) {
  /* an end that lies but a rounding beyond the last step belongs to it */
  const double length = course->x[course->count - 1], slack = 4 * tp_roundoff * length;
  const double steps = floor((length + slack + 2 * course->x_error) / step);
  *sampled = (tp_course){0};
  if (!(steps >= 2)) {
    return tp_refuse(message, TP_FAULT_RANGE, (tp_place){0},
                     "a step of %.6g is too coarse for a profile of length %.6g: at least two must "
                     "fit",
                     step, length);
  }
  if (steps > most_samples) {
    return tp_refuse(
        message, TP_FAULT_RANGE, (tp_place){0},
        "a step of %.6g is too fine for a profile of length %.6g: more than 50 million", step,
        length);
  }
  if (!tp_course_init(sampled, (size_t)steps + 1)) return tp_fail_memory(message, "the samples");
  tp_status status = TP_OK;
  if (resampling == TP_RESAMPLE_SPLINE) {
    status = sample_spline(sampled, course, step, message);
  } else {
    sample_linear(sampled, course, step);
  }
  if (status == TP_OK) {
    tp_course_measure(sampled);
  } else {
    tp_course_clear(sampled);
  }
  return status;
}

/* About the middle of the length, z = x - L / 2, the slope is the integral of z y over that of z^2,
 * L^3 / 12; on a piece from (z0, y0) to (z1, y1) the first is dx (2 z0 y0 + z0 y1 + z1 y0 + 2 z1
 * y1) / 6. Sizes: |z| <= L / 2, |y| <= H, so an abscissa or height off by e or f costs a piece dx
 * times (e H + f L / 2), and 2 e H L for dx itself at most; ten roundings of dx H L / 2. */
tp_bounded tp_course_trend(const tp_course *p, tp_bounded *middle) {
  const double length = p->x[p->count - 1], half = length / 2;
  const double highest = p->extent.highest;
  tp_bounded_sum first = {0, 0}, area = {0, 0};
  for (size_t k = 1; k < p->count; k++) {
    const double dx = p->x[k] - p->x[k - 1], y0 = p->y[k - 1], y1 = p->y[k];
    const double z0 = p->x[k - 1] - half, z1 = p->x[k] - half;
    const double ends = z0 * (2 * y0 + y1) + z1 * (y0 + 2 * y1);
    const double of_size = dx * highest * half;
    tp_bounded_add(&first, dx * ends / 6,
                   dx * (p->x_error * 2 * highest + p->y_error * half) +
                       2 * p->x_error * highest * half + 10 * tp_roundoff * of_size);
    tp_bounded_add(&area, dx * (y0 + y1) / 2,
                   dx * p->y_error + 2 * p->x_error * highest + 4 * tp_roundoff * dx * highest);
  }
  const double cube = length * length * length / 12;
  const tp_bounded span = tp_bounded_of(length, p->x_error);
  const tp_bounded spread =
      tp_bounded_of(cube, cube * (3 * p->x_error / length + 4 * tp_roundoff) * tp_room);
  *middle = tp_bounded_over(tp_bounded_total(area), span);
  return tp_bounded_over(tp_bounded_total(first), spread);
}

void tp_course_detrend(tp_course *p, tp_profile_detrend detrend) {
  if (detrend == TP_DETREND_NONE || detrend == TP_DETREND_TURN) return;
  const double length = p->x[p->count - 1], highest = p->extent.highest;
  double slope, at_zero, error;
  if (detrend == TP_DETREND_ENDS) {
    at_zero = p->y[0];
    slope = (p->y[p->count - 1] - p->y[0]) / length;
    error = 2 * p->y_error + fabs(slope) * (2 * p->x_error);
  } else {
    tp_bounded middle;
    const tp_bounded trend = tp_course_trend(p, &middle);
    slope = trend.value;
    at_zero = middle.value - slope * length / 2;
    error = middle.error + trend.error * length / 2 + fabs(slope) * p->x_error;
  }
  for (size_t k = 0; k < p->count; k++) p->y[k] -= at_zero + slope * p->x[k];
  p->extent.steepest += fabs(slope);
  p->extent.highest += fabs(at_zero) + fabs(slope) * length;
  p->y_error = (p->y_error + error + fabs(slope) * p->x_error +
                8 * tp_roundoff * (2 * highest + fabs(slope) * length)) *
               tp_room;
}
