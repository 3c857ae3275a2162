/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Chords of a Bezier curve: de Casteljau's halving in rationals until all control points lie within
 * the tolerance of the chord. */

#include "format/curve.h"

#include <math.h>

void tp_control_points_init(tp_control_point *points, long count) {
  for (long k = 0; k < count; k++) {
    fmpq_init(points[k].x);
    fmpq_init(points[k].y);
    fmpq_init(points[k].w);
    fmpq_one(points[k].w);
  }
}

void tp_control_points_clear(tp_control_point *points, long count) {
  for (long k = 0; k < count; k++) {
    fmpq_clear(points[k].x);
    fmpq_clear(points[k].y);
    fmpq_clear(points[k].w);
  }
}

static void point_of(fmpq_t x, fmpq_t y, const tp_control_point *point) {
  fmpq_div(x, point->x, point->w);
  fmpq_div(y, point->y, point->w);
}

/* The largest distance of a control point from the chord between the first and the last. */
static double from_chord(const tp_control_point *points, int degree) {
  double u[TP_CURVE_DEGREE + 1], v[TP_CURVE_DEGREE + 1], most = 0;
  fmpq_t x0, y0, x, y;
  fmpq_init(x0);
  fmpq_init(y0);
  fmpq_init(x);
  fmpq_init(y);
  point_of(x0, y0, points);
  for (int k = 0; k <= degree; k++) { /* from the first one, before anything is rounded */
    point_of(x, y, points + k);
    fmpq_sub(x, x, x0);
    fmpq_sub(y, y, y0);
    u[k] = fmpq_get_d(x);
    v[k] = fmpq_get_d(y);
  }
  const double length = u[degree] * u[degree] + v[degree] * v[degree];
  for (int k = 1; k < degree; k++) {
    const double along = length > 0 ? (u[k] * u[degree] + v[k] * v[degree]) / length : 0;
    const double share_of = fmin(1, fmax(0, along));
    most = fmax(most, hypot(u[k] - share_of * u[degree], v[k] - share_of * v[degree]));
  }
  fmpq_clear(x0);
  fmpq_clear(y0);
  fmpq_clear(x);
  fmpq_clear(y);
  return most;
}

static void halve_between(fmpq_t value, const fmpq_t next) {
  fmpq_add(value, value, next);
  fmpq_div_2exp(value, value, 1);
}

/* de Casteljau: `first` becomes the one half of the curve, `points` the other. */
static void halve(tp_control_point *first, tp_control_point *points, int degree) {
  for (int k = 0; k <= degree; k++) {
    fmpq_set(first[k].x, points[0].x);
    fmpq_set(first[k].y, points[0].y);
    fmpq_set(first[k].w, points[0].w);
    for (int j = 0; j < degree - k; j++) {
      halve_between(points[j].x, points[j + 1].x);
      halve_between(points[j].y, points[j + 1].y);
      halve_between(points[j].w, points[j + 1].w);
    }
  }
}

typedef struct bezier {
  tp_drawing_object *object;
  int degree;
  const fmpq *grid; /* the tolerance, by which its points are rounded */
  long first;       /* points of the object before it */
  double left;      /* points that it may have yet */
  double tolerance;
  tp_mark mark;
} bezier;

/* Up to the end of the curve, which is not added. */
static tp_curve_outcome add_bezier(bezier *b, tp_control_point *points, int depth) {
  enum { DEEPEST = 40 };
  if (from_chord(points, b->degree) <= b->tolerance) return TP_CURVE_DONE;
  if (depth == DEEPEST || --b->left < 0) return TP_CURVE_TOO_FINE;
  tp_control_point first[TP_CURVE_DEGREE + 1];
  fmpq_t x, y;
  fmpq_init(x);
  fmpq_init(y);
  tp_control_points_init(first, b->degree + 1);
  halve(first, points, b->degree);
  point_of(x, y, points);
  tp_curve_round(x, b->grid);
  tp_curve_round(y, b->grid);
  tp_curve_outcome outcome = add_bezier(b, first, depth + 1);
  if (outcome == TP_CURVE_DONE && !tp_drawing_add_point(b->object, x, y, b->mark)) {
    outcome = TP_CURVE_NO_MEMORY;
  }
  if (outcome == TP_CURVE_DONE) outcome = add_bezier(b, points, depth + 1);
  tp_control_points_clear(first, b->degree + 1);
  fmpq_clear(x);
  fmpq_clear(y);
  return outcome;
}

tp_curve_outcome tp_curve_bezier(tp_drawing_object *object, tp_control_point *points, int degree,
                                 const fmpq_t tolerance, tp_mark mark) {
  bezier b = {.object = object,
              .degree = degree,
              .grid = tolerance,
              .first = object->line.count,
              .left = object->most_points - (double)object->line.count,
              .tolerance = TP_CURVE_SHARE * fmpq_get_d(tolerance),
              .mark = mark};
  fmpq_t x, y;
  fmpq_init(x);
  fmpq_init(y);
  point_of(x, y, points + degree);
  tp_curve_outcome outcome = add_bezier(&b, points, 0);
  if (outcome == TP_CURVE_DONE && !tp_drawing_add_point(object, x, y, mark)) {
    outcome = TP_CURVE_NO_MEMORY;
  }
  fmpq_clear(x);
  fmpq_clear(y);
  if (object->line.count > b.first + 1) tp_curve_deviates(object, tolerance);
  return outcome;
}
