/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "format/spline.h"

/* point = ((high - at) point + (at - low) next) / (high - low), in all three coordinates. */
static void blend(tp_control_point *point, const tp_control_point *next, const fmpq *low,
                  const fmpq *high, const fmpq *at) {
  fmpq_t share, difference;
  fmpq_init(share);
  fmpq_init(difference);
  fmpq_sub(share, at, low);
  fmpq_sub(difference, high, low);
  fmpq_div(share, share, difference);
  fmpq *const own[] = {point->x, point->y, point->w};
  const fmpq *const other[] = {next->x, next->y, next->w};
  for (int k = 0; k < 3; k++) {
    fmpq_sub(difference, other[k], own[k]);
    fmpq_addmul(own[k], difference, share);
  }
  fmpq_clear(share);
  fmpq_clear(difference);
}

static void copy(tp_control_point *to, const tp_control_point *from) {
  fmpq_set(to->x, from->x);
  fmpq_set(to->y, from->y);
  fmpq_set(to->w, from->w);
}

/* The polar form over the span that begins with knot `span`, at the beginning of it but for `ends`
 * times its end. */
static void polar(tp_control_point *value, const tp_spline *s, long span, int ends) {
  tp_control_point d[TP_CURVE_DEGREE + 1];
  tp_control_points_init(d, s->degree + 1);
  for (int k = 0; k <= s->degree; k++) copy(d + k, s->points + span - s->degree + k);
  for (int level = 1; level <= s->degree; level++) {
    const fmpq *at = s->knots + (level <= ends ? span + 1 : span);
    for (int k = 0; k <= s->degree - level; k++) {
      const long low = span - s->degree + k + level;
      blend(d + k, d + k + 1, s->knots + low, s->knots + low + s->degree - level + 1, at);
    }
  }
  copy(value, d);
  tp_control_points_clear(d, s->degree + 1);
}

static void point_of(fmpq_t x, fmpq_t y, const tp_control_point *point) {
  fmpq_div(x, point->x, point->w);
  fmpq_div(y, point->y, point->w);
}

/* The first point of the spline, or what the last span ended in. */
static bool begin_span(tp_drawing_object *object, const tp_control_point *first, bool *breaks,
                       fmpq_t end_x, fmpq_t end_y, tp_mark mark) {
  fmpq_t x, y;
  fmpq_init(x);
  fmpq_init(y);
  point_of(x, y, first);
  bool done = true;
  if (object->line.count == 0) {
    done = tp_drawing_add_point(object, x, y, mark);
  } else {
    *breaks = *breaks || !fmpq_equal(x, end_x) || !fmpq_equal(y, end_y);
  }
  fmpq_clear(x);
  fmpq_clear(y);
  return done;
}

static bool check_order(const tp_spline *s) {
  for (long k = 0; k < s->count + s->degree; k++) {
    if (fmpq_cmp(s->knots + k, s->knots + k + 1) > 0) return false;
  }
  return fmpq_cmp(s->knots + s->degree, s->knots + s->count) < 0;
}

static bool check_weights(const tp_spline *s) {
  for (long k = 0; k < s->count; k++) {
    if (fmpq_sgn(s->points[k].w) <= 0) return false;
  }
  return true;
}

static tp_curve_outcome add_spans(tp_drawing_object *object, const tp_spline *s,
                                  const fmpq_t tolerance, tp_mark mark, bool *breaks) {
  tp_curve_outcome outcome = TP_CURVE_DONE;
  tp_control_point points[TP_CURVE_DEGREE + 1];
  fmpq_t end_x, end_y;
  fmpq_init(end_x);
  fmpq_init(end_y);
  tp_control_points_init(points, s->degree + 1);
  for (long span = s->degree; span < s->count && outcome == TP_CURVE_DONE; span++) {
    if (fmpq_equal(s->knots + span, s->knots + span + 1)) continue;
    for (int k = 0; k <= s->degree; k++) polar(points + k, s, span, k);
    const bool is_last = fmpq_equal(s->knots + span + 1, s->knots + s->count);
    if (!begin_span(object, points, breaks, end_x, end_y, mark)) {
      outcome = TP_CURVE_NO_MEMORY;
      break;
    }
    point_of(end_x, end_y, points + s->degree);
    outcome = tp_curve_bezier(object, points, s->degree, tolerance, mark);
    const long last = object->line.count - 1;
    if (outcome == TP_CURVE_DONE && !is_last) {
      tp_curve_round(object->line.x + last, tolerance);
      tp_curve_round(object->line.y + last, tolerance);
    }
  }
  tp_control_points_clear(points, s->degree + 1);
  fmpq_clear(end_x);
  fmpq_clear(end_y);
  return outcome;
}

tp_curve_outcome tp_spline_add(tp_drawing_object *object, const tp_spline *spline,
                               const fmpq_t tolerance, tp_mark mark, const char **problem) {
  if (spline->degree < 1 || spline->degree > TP_CURVE_DEGREE || spline->count <= spline->degree) {
    *problem = "is a spline of a degree below 1 or above 10, or with too few control points; "
               "convert it to a polyline";
    return TP_CURVE_DONE;
  }
  if (!check_order(spline) || !check_weights(spline)) {
    *problem = "is a spline whose knots are not in order, or whose weights are not above zero; "
               "convert it to a polyline";
    return TP_CURVE_DONE;
  }
  bool breaks = false;
  const tp_curve_outcome outcome = add_spans(object, spline, tolerance, mark, &breaks);
  if (breaks) *problem = "is a spline in pieces; convert it to polylines";
  return outcome;
}
