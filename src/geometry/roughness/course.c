/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Conversion of an exact chain to doubles relative to its first point, with one rounding bound for
 * each axis; checks of order, spacing and range. */

#include "roughness/course.h"

#include "number/binary.h"
#include "number/word.h"

#include <stdlib.h>
#include <string.h>

/* Off their even places, as a share of the distance: what a decimal of six digits loses. */
static const double uneven = 1e-6;

void tp_course_clear(tp_course *course) {
  free(course->x);
  free(course->y);
  memset(course, 0, sizeof *course);
}

bool tp_course_init(tp_course *course, size_t count) {
  *course = (tp_course){.count = count};
  course->x = calloc(count, sizeof *course->x);
  course->y = calloc(count, sizeof *course->y);
  if (course->x != NULL && course->y != NULL) return true;
  tp_course_clear(course);
  return false;
}

static tp_status check_chain(const tp_polyline *chain, tp_message *message) {
  if (chain->count < 2) {
    return tp_refuse(message, TP_FAULT_RANGE, tp_polyline_place(chain, -1),
                     "a profile needs at least two points");
  }
  for (long k = 1; k < chain->count; k++) {
    const int order = fmpq_cmp(chain->x + k, chain->x + k - 1);
    if (order > 0) continue;
    return tp_refuse(message, TP_FAULT_GEOMETRY, tp_polyline_place(chain, k),
                     order < 0 ? "the profile folds back: point %ld lies left of point %ld; its "
                                 "points run from left to right, with one height at each x"
                               : "the profile steps upright: point %ld lies above or below point "
                                 "%ld, and the slope between them has no value; leave one of them "
                                 "out",
                     k + 1, k);
  }
  return TP_OK;
}

/* Off by 3 u of its size at most: what FLINT makes of a rational it cuts off, by 2 u. */
static double difference(const fmpq *from, const fmpq *to, fmpq_t room) {
  static const int64_t of_double = INT64_C(1) << DBL_MANT_DIG;
  double quick;
  if (tp_word_difference(&quick, to, from)) return quick;
  if (fmpq_is_zero(from) && tp_word_is_small(fmpq_numref(to)) &&
      tp_word_is_small(fmpq_denref(to))) {
    const int64_t a = tp_word_get(fmpq_numref(to)), b = tp_word_get(fmpq_denref(to));
    if (llabs(a) <= of_double && b <= of_double) return (double)a / (double)b;
  }
  fmpq_sub(room, to, from);
  return fmpq_get_d(room);
}

void tp_course_convert(tp_course *course, const tp_polyline *chain, double scale) {
  double far = 0, high = 0;
  fmpq_t moved;
  fmpq_init(moved);
  for (size_t k = 0; k < course->count; k++) {
    course->x[k] = scale * difference(chain->x, chain->x + k, moved);
    course->y[k] = scale * difference(chain->y, chain->y + k, moved);
    far = tp_larger(far, fabs(course->x[k]));
    high = tp_larger(high, fabs(course->y[k]));
  }
  fmpq_clear(moved);
  const double roundings = scale == 1 ? 3 : 4;
  course->x_error = roundings * tp_roundoff * far * tp_room;
  course->y_error = roundings * tp_roundoff * high * tp_room;
}

/* Exact points in order may be equal as doubles, or as good as that, or beyond their range. */
static tp_status check_distances(const tp_course *course, const tp_polyline *chain,
                                 tp_message *message) {
  for (size_t k = 0; k < course->count; k++) {
    const bool apart = k == 0 || course->x[k] - course->x[k - 1] > 4 * course->x_error;
    if (apart && isfinite(course->x[k]) && isfinite(course->y[k])) continue;
    return tp_refuse(message, TP_FAULT_RANGE, tp_polyline_place(chain, (long)k),
                     "point %zu lies too far from the first one, or too near to the one before it, "
                     "for the slope there to be computed in doubles",
                     k + 1);
  }
  return TP_OK;
}

tp_status tp_course_from_chain(tp_course *course, const tp_polyline *chain, double scale,
                               tp_message *message) {
  *course = (tp_course){0};
  tp_status status = check_chain(chain, message);
  if (status != TP_OK) return status;
  if (!tp_course_init(course, (size_t)chain->count)) return tp_fail_memory(message, "the profile");
  tp_course_convert(course, chain, scale);
  status = check_distances(course, chain, message);
  if (status == TP_OK) {
    tp_course_measure(course);
  } else {
    tp_course_clear(course);
  }
  return status;
}

void tp_course_mirror(tp_course *course) {
  const size_t last = course->count - 1;
  const double length = course->x[last], height = course->y[last];
  for (size_t low = 0, high = last; low <= high; low++, high--) {
    const double x = length - course->x[low], y = course->y[low] - height;
    course->x[low] = length - course->x[high];
    course->y[low] = course->y[high] - height;
    course->x[high] = x;
    course->y[high] = y;
    if (high == 0) break;
  }
  course->extent.highest += fabs(height);
  course->x_error = (2 * course->x_error + tp_roundoff * length) * tp_room;
  course->y_error = (2 * course->y_error + tp_roundoff * course->extent.highest) * tp_room;
}

void tp_course_measure(tp_course *course) {
  tp_course_extent e = {.least_step = INFINITY, .highest = fabs(course->y[0])};
  for (size_t k = 1; k < course->count; k++) {
    const double dx = course->x[k] - course->x[k - 1], dy = course->y[k] - course->y[k - 1];
    if (dx < e.least_step) e.least_step = dx;
    e.largest_step = tp_larger(e.largest_step, dx);
    e.steepest = tp_larger(e.steepest, fabs(dy / dx));
    e.highest = tp_larger(e.highest, fabs(course->y[k]));
  }
  course->extent = e;
}

bool tp_course_are_even(const tp_course *course) {
  const double step = course->x[course->count - 1] / (double)(course->count - 1);
  for (size_t k = 0; k < course->count; k++) {
    if (fabs(course->x[k] - (double)k * step) > uneven * step + 2 * course->x_error) return false;
  }
  return true;
}
