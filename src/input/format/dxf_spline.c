/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Splines of a DXF file: knots, control points and weights are read from their groups, checked, and
 * handed to format/spline.h. */

#include "format/dxf_reader.h"
#include "format/spline.h"

#include <stdlib.h>

enum { X = 10, Y = 20, Z = 30, KNOT = 40, WEIGHT = 41, FIT = 11, FLAGS = 70, DEGREE = 71 };

static long count_of(const tp_dxf_entity *entity, int code) {
  long count = 0;
  for (size_t k = 1; k < entity->count; k++) count += entity->groups[k].code == code;
  return count;
}

/* The numbers of a code, in their order, into places `step` apart. */
static bool read_all(tp_dxf_reader *r, fmpq *values, size_t step, const tp_dxf_entity *entity,
                     int code) {
  bool done = true;
  for (size_t k = 1; k < entity->count && done; k++) {
    if (entity->groups[k].code != code) continue;
    done = tp_dxf_number(r, values, entity->groups + k);
    values = (fmpq *)((char *)values + step);
  }
  return done;
}

static bool same_heights(tp_dxf_reader *r, bool *same, const tp_dxf_entity *entity) {
  fmpq_t first, z;
  fmpq_init(first);
  fmpq_init(z);
  bool done = tp_dxf_real(r, first, entity, Z, 0);
  for (size_t k = 1; k < entity->count && done; k++) {
    if (entity->groups[k].code != Z) continue;
    done = tp_dxf_number(r, z, entity->groups + k);
    *same = *same && fmpq_equal(z, first);
  }
  fmpq_clear(first);
  fmpq_clear(z);
  return done;
}

/* Homogeneous: x and y times the weight. */
static bool read_points(tp_dxf_reader *r, tp_spline *s, const tp_dxf_entity *entity) {
  const size_t step = sizeof *s->points;
  if (!read_all(r, s->points->x, step, entity, X) || !read_all(r, s->points->y, step, entity, Y) ||
      !read_all(r, s->points->w, step, entity, WEIGHT)) {
    return false;
  }
  for (long k = 0; k < s->count; k++) {
    fmpq_mul(s->points[k].x, s->points[k].x, s->points[k].w);
    fmpq_mul(s->points[k].y, s->points[k].y, s->points[k].w);
  }
  return true;
}

/* The greater side of the box around the control points. */
static void set_size(fmpq_t size, const tp_spline *s) {
  fmpq_t x, y, low[2], high[2];
  fmpq_init(x);
  fmpq_init(y);
  for (int k = 0; k < 2; k++) {
    fmpq_init(low[k]);
    fmpq_init(high[k]);
  }
  for (long k = 0; k < s->count; k++) {
    if (fmpq_is_zero(s->points[k].w)) continue;
    fmpq_div(x, s->points[k].x, s->points[k].w);
    fmpq_div(y, s->points[k].y, s->points[k].w);
    const fmpq *const own[] = {x, y};
    for (int axis = 0; axis < 2; axis++) {
      if (k == 0 || fmpq_cmp(own[axis], low[axis]) < 0) fmpq_set(low[axis], own[axis]);
      if (k == 0 || fmpq_cmp(own[axis], high[axis]) > 0) fmpq_set(high[axis], own[axis]);
    }
  }
  fmpq_sub(size, high[0], low[0]);
  fmpq_sub(x, high[1], low[1]);
  if (fmpq_cmp(x, size) > 0) fmpq_set(size, x);
  fmpq_clear(x);
  fmpq_clear(y);
  for (int k = 0; k < 2; k++) {
    fmpq_clear(low[k]);
    fmpq_clear(high[k]);
  }
}

static bool add(tp_dxf_reader *r, tp_drawing_object *object, const tp_spline *s,
                const tp_dxf_entity *entity) {
  fmpq_t size, tolerance;
  fmpq_init(size);
  fmpq_init(tolerance);
  set_size(size, s);
  tp_curve_tolerance(tolerance, r->options, size);
  bool done = true;
  if (fmpq_is_zero(tolerance)) {
    object->problem = "is a spline in one point";
  } else {
    const tp_mark mark = {entity->groups->line, 1};
    done = tp_dxf_curve(r, object, tp_spline_add(object, s, tolerance, mark, &object->problem));
  }
  fmpq_clear(size);
  fmpq_clear(tolerance);
  return done;
}

/* Do the numbers of its groups make a spline? */
static const char *problem_of(const tp_dxf_entity *entity, long count, long degree) {
  const long weights = count_of(entity, WEIGHT);
  if (count == 0 && count_of(entity, FIT) > 0) {
    return "is a spline that has only fit points; convert it to a polyline";
  }
  if (count_of(entity, Y) != count || count_of(entity, KNOT) != count + degree + 1 ||
      (weights != 0 && weights != count) || degree < 1 || count <= degree) {
    return "is a spline whose control points, knots and weights do not go together; convert it to "
           "a polyline";
  }
  return NULL;
}

bool tp_dxf_spline(tp_dxf_reader *r, const tp_dxf_entity *entity) {
  enum { CLOSED = 1 };
  long degree = 0, flags = 0;
  bool same = true;
  if (!tp_dxf_whole(r, &degree, entity, DEGREE, 3) || !tp_dxf_whole(r, &flags, entity, FLAGS, 0) ||
      !same_heights(r, &same, entity)) {
    return false;
  }
  tp_drawing_object *object = tp_dxf_add(r, "SPLINE", entity);
  if (object == NULL) return false;
  const long count = count_of(entity, X);
  object->problem = problem_of(entity, count, degree);
  if (!same) object->problem = "leaves the plane of the drawing: its z changes";
  if (object->problem != NULL || degree > TP_CURVE_DEGREE) {
    if (object->problem == NULL) object->problem = "is a spline of a degree above 10";
    return true;
  }
  const long knots = count + degree + 1;
  tp_spline s = {.degree = (int)degree,
                 .count = count,
                 .points = calloc((size_t)count, sizeof *s.points),
                 .knots = calloc((size_t)knots, sizeof *s.knots)};
  bool done = s.points != NULL && s.knots != NULL;
  if (done) {
    tp_control_points_init(s.points, count);
    for (long k = 0; k < knots; k++) fmpq_init(s.knots + k);
    done = read_points(r, &s, entity) && read_all(r, s.knots, sizeof *s.knots, entity, KNOT) &&
           add(r, object, &s, entity);
    tp_control_points_clear(s.points, count);
    for (long k = 0; k < knots; k++) fmpq_clear(s.knots + k);
    tp_drawing_tidy(object);
    if ((flags & CLOSED) != 0) object->closure = TP_DRAWING_CLOSED;
  } else {
    tp_dxf_fail_memory(r);
  }
  free(s.points);
  free(s.knots);
  return done;
}
