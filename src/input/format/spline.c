/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* De Boor's algorithm in rationals on a grid of powers of two gives the Bezier points of each span
 * (polar form); format/curve.h turns these into chords. */

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

/* Exact values have thousands of digits: denominators of all knots multiply. In between they are
 * rounded to whole multiples of powers of two, of x and y, and of the weight. A blend is a mean, so
 * that it passes errors on no larger than they were, and adds one rounding. By ten of these at
 * most, each by 2^-21 of the tolerance times the least weight, and for the weight over the largest
 * coordinate, points move by less than 1/10000 of the tolerance. */
typedef struct grid {
  slong length, weight; /* exponents of two */
} grid;

static slong log2_above(const fmpq_t value) {
  return (slong)fmpz_bits(fmpq_numref(value)) - (slong)fmpz_bits(fmpq_denref(value)) + 1;
}

static grid grid_of(const tp_spline *s, const fmpq_t tolerance) {
  enum { FINER = 21 };
  const fmpq *least = s->points[0].w;
  slong most = log2_above(tolerance); /* of a coordinate */
  fmpq_t place;
  fmpq_init(place);
  for (long k = 0; k < s->count; k++) {
    if (fmpq_cmp(s->points[k].w, least) < 0) least = s->points[k].w;
    const fmpq *const both[] = {s->points[k].x, s->points[k].y};
    for (int axis = 0; axis < 2; axis++) {
      fmpq_div(place, both[axis], s->points[k].w);
      if (!fmpq_is_zero(place) && log2_above(place) > most) most = log2_above(place);
    }
  }
  fmpq_clear(place);
  const slong length = log2_above(tolerance) - 2 + log2_above(least) - 2 - FINER;
  return (grid){length, length - most};
}

static void round_to(fmpq_t value, slong exponent) {
  fmpq_div_2exp(value, value, exponent > 0 ? (ulong)exponent : 0);
  fmpq_mul_2exp(value, value, exponent < 0 ? (ulong)-exponent : 0);
  fmpz_fdiv_q(fmpq_numref(value), fmpq_numref(value), fmpq_denref(value));
  fmpz_one(fmpq_denref(value));
  fmpq_mul_2exp(value, value, exponent > 0 ? (ulong)exponent : 0);
  fmpq_div_2exp(value, value, exponent < 0 ? (ulong)-exponent : 0);
}

static void round_point(tp_control_point *point, const grid *g) {
  round_to(point->x, g->length);
  round_to(point->y, g->length);
  round_to(point->w, g->weight);
}

/* The polar form over the span that begins with knot `span`, at the beginning of it but for `ends`
 * times its end; exact without a grid. */
static void polar(tp_control_point *value, const tp_spline *s, long span, int ends,
                  const grid *rounded) {
  tp_control_point d[TP_CURVE_DEGREE + 1];
  tp_control_points_init(d, s->degree + 1);
  for (int k = 0; k <= s->degree; k++) copy(d + k, s->points + span - s->degree + k);
  for (int level = 1; level <= s->degree; level++) {
    const fmpq *at = s->knots + (level <= ends ? span + 1 : span);
    for (int k = 0; k <= s->degree - level; k++) {
      const long low = span - s->degree + k + level;
      blend(d + k, d + k + 1, s->knots + low, s->knots + low + s->degree - level + 1, at);
      if (rounded != NULL) round_point(d + k, rounded);
    }
  }
  copy(value, d);
  tp_control_points_clear(d, s->degree + 1);
}

static void point_of(fmpq_t x, fmpq_t y, const tp_control_point *point) {
  fmpq_div(x, point->x, point->w);
  fmpq_div(y, point->y, point->w);
}

/* The first point of the spline. */
static bool add_first(tp_drawing_object *object, const tp_control_point *first, tp_mark mark) {
  fmpq_t x, y;
  fmpq_init(x);
  fmpq_init(y);
  point_of(x, y, first);
  const bool done = tp_drawing_add_point(object, x, y, mark);
  fmpq_clear(x);
  fmpq_clear(y);
  return done;
}

/* Is it in pieces? Only where a knot within it has as many copies as an order, so that one span
 * ends in a control point and the next begins in another. */
static bool has_break(const tp_spline *s) {
  fmpq_t end_x, end_y, x, y;
  fmpq_init(end_x);
  fmpq_init(end_y);
  fmpq_init(x);
  fmpq_init(y);
  bool breaks = false;
  for (long k = s->degree + 1; k < s->count - 1 && !breaks; k++) {
    const bool whole = fmpq_equal(s->knots + k, s->knots + k + s->degree);
    const bool within = fmpq_cmp(s->knots + s->degree, s->knots + k) < 0 &&
                        fmpq_cmp(s->knots + k, s->knots + s->count) < 0;
    if (!whole || !within) continue;
    point_of(end_x, end_y, s->points + k - 1);
    point_of(x, y, s->points + k);
    breaks = !fmpq_equal(x, end_x) || !fmpq_equal(y, end_y);
  }
  fmpq_clear(end_x);
  fmpq_clear(end_y);
  fmpq_clear(x);
  fmpq_clear(y);
  return breaks;
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
                                  const fmpq_t tolerance, tp_mark mark) {
  tp_curve_outcome outcome = TP_CURVE_DONE;
  tp_control_point points[TP_CURVE_DEGREE + 1];
  const grid rounded = grid_of(s, tolerance);
  tp_control_points_init(points, s->degree + 1);
  for (long span = s->degree; span < s->count && outcome == TP_CURVE_DONE; span++) {
    if (fmpq_equal(s->knots + span, s->knots + span + 1)) continue;
    const bool is_first = object->line.count == 0;
    const bool is_last = fmpq_equal(s->knots + span + 1, s->knots + s->count);
    for (int k = 0; k <= s->degree; k++) {
      const bool is_end = (is_first && k == 0) || (is_last && k == s->degree);
      polar(points + k, s, span, k, is_end ? NULL : &rounded);
    }
    if (is_first && !add_first(object, points, mark)) outcome = TP_CURVE_NO_MEMORY;
    if (outcome == TP_CURVE_DONE) {
      outcome = tp_curve_bezier(object, points, s->degree, tolerance, mark);
    }
    const long last = object->line.count - 1;
    if (outcome == TP_CURVE_DONE && !is_last) {
      tp_curve_round(object->line.x + last, tolerance);
      tp_curve_round(object->line.y + last, tolerance);
    }
  }
  tp_control_points_clear(points, s->degree + 1);
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
  const tp_curve_outcome outcome = add_spans(object, spline, tolerance, mark);
  if (has_break(spline)) *problem = "is a spline in pieces; convert it to polylines";
  return outcome;
}
