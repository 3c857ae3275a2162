/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Attributes as exact lengths; line, polyline, polygon, rect with rounded corners, circle, ellipse
 * and path become points and arcs. */

#include "format/svg_shape.h"

#include <string.h>

const char *tp_svg_attribute(const char *const *attributes, const char *name) {
  for (; *attributes != NULL; attributes += 2) {
    if (strcmp(*attributes, name) == 0) return attributes[1];
  }
  return NULL;
}

static tp_svg_text text_of(const char *value) {
  return (tp_svg_text){value, value + strlen(value), NULL};
}

/* A length of the user's unit: a number, with "px" or nothing behind it. Zero where there is none.
 */
static bool read_length(fmpq_t length, const char *const *attributes, const char *name,
                        const char **problem) {
  const char *value = tp_svg_attribute(attributes, name);
  fmpq_zero(length);
  if (value == NULL) return true;
  tp_svg_text text = text_of(value);
  if (tp_svg_number(&text, length)) {
    while (text.at < text.end && *text.at == ' ') text.at++;
    if (text.at == text.end || strcmp(text.at, "px") == 0) return true;
    text.problem = "has a length with a unit; lengths are in units of the drawing, without one";
  }
  *problem = text.problem;
  return false;
}

typedef bool (*shape_reader)(tp_svg_target *t, const char *const *attributes, fmpq *n,
                             const char **problem);

static bool add_point(tp_svg_target *t, tp_drawing_object *object, const fmpq *x, const fmpq *y) {
  if (object != NULL && tp_drawing_add_point(object, x, y, t->mark)) return true;
  t->no_memory = true;
  return false;
}

static bool read_line(tp_svg_target *t, const char *const *attributes, fmpq *n,
                      const char **problem) {
  static const char *const names[] = {"x1", "y1", "x2", "y2"};
  for (int k = 0; k < 4; k++) {
    if (!read_length(n + k, attributes, names[k], problem)) return false;
  }
  tp_drawing_object *object = tp_svg_begin(t);
  return add_point(t, object, n, n + 1) && add_point(t, object, n + 2, n + 3) &&
         tp_svg_finish(t, object);
}

static bool read_points(tp_svg_target *t, const char *const *attributes, fmpq *n,
                        const char **problem) {
  const char *value = tp_svg_attribute(attributes, "points");
  tp_drawing_object *object = tp_svg_begin(t);
  if (object == NULL) return false;
  if (t->kind[strlen(t->kind) - 1] == 'n') object->closure = TP_DRAWING_CLOSED; /* polygon */
  tp_svg_text text = text_of(value != NULL ? value : "");
  while (tp_svg_at_number(&text)) {
    if (!tp_svg_number(&text, n) || !tp_svg_number(&text, n + 1)) break;
    if (!add_point(t, object, n, n + 1)) return false;
  }
  if (text.problem == NULL && text.at < text.end) text.problem = "has points that are not numbers";
  *problem = text.problem;
  return text.problem == NULL && tp_svg_finish(t, object);
}

/* A corner of a rounded rectangle, to (x, y). */
static bool round_corner(tp_svg_target *t, tp_drawing_object *object, const fmpq *rx,
                         const fmpq *ry, const fmpq_t x, const fmpq_t y) {
  tp_svg_arc arc = {.sweep = true};
  fmpq *const numbers[] = {arc.rx, arc.ry, arc.degrees, arc.x, arc.y};
  for (int k = 0; k < 5; k++) fmpq_init(numbers[k]);
  fmpq_set(arc.rx, rx);
  fmpq_set(arc.ry, ry);
  fmpq_set(arc.x, x);
  fmpq_set(arc.y, y);
  const bool done = tp_svg_add_arc(t, object, &arc);
  for (int k = 0; k < 5; k++) fmpq_clear(numbers[k]);
  return done;
}

/* Corner k at the end of side k - 1, as SVG draws it: along x, down, back, up; n holds x, y, width,
 * height, rx, ry. */
static bool add_side(tp_svg_target *t, tp_drawing_object *object, const fmpq *n, int k) {
  fmpq_t x, y, from_x, from_y;
  fmpq_init(x);
  fmpq_init(y);
  fmpq_init(from_x);
  fmpq_init(from_y);
  const bool right = k == 1 || k == 2, low = k == 2 || k == 3;
  const bool along = k % 2 == 1; /* the side before it is along x */
  fmpq_set(x, n);
  fmpq_set(y, n + 1);
  if (right) fmpq_add(x, x, n + 2);
  if (low) fmpq_add(y, y, n + 3);
  fmpq_set(from_x, x);
  fmpq_set(from_y, y);
  /* the arc begins rx or ry before the corner, and ends as far behind it */
  fmpq *const before = along ? from_x : from_y, *const after = along ? y : x;
  const fmpq *const first = along ? n + 4 : n + 5, *const second = along ? n + 5 : n + 4;
  (k == 1 || k == 2 ? fmpq_sub : fmpq_add)(before, before, first);
  (k == 1 || k == 0 ? fmpq_add : fmpq_sub)(after, after, second);
  const bool done = add_point(t, object, from_x, from_y) &&
                    (fmpq_is_zero(n + 4) || round_corner(t, object, n + 4, n + 5, x, y));
  fmpq_clear(x);
  fmpq_clear(y);
  fmpq_clear(from_x);
  fmpq_clear(from_y);
  return done;
}

/* One half-axis stands for both, and none is longer than half of its side. */
static void set_rounding(fmpq *n, const char *const *attributes) {
  fmpq_t half;
  fmpq_init(half);
  if (tp_svg_attribute(attributes, "rx") == NULL) fmpq_set(n + 4, n + 5);
  if (tp_svg_attribute(attributes, "ry") == NULL) fmpq_set(n + 5, n + 4);
  for (int k = 0; k < 2; k++) {
    fmpq_div_2exp(half, n + 2 + k, 1);
    if (fmpq_cmp(n + 4 + k, half) > 0) fmpq_set(n + 4 + k, half);
  }
  if (fmpq_sgn(n + 4) <= 0 || fmpq_sgn(n + 5) <= 0) {
    fmpq_zero(n + 4);
    fmpq_zero(n + 5);
  }
  fmpq_clear(half);
}

static bool read_rectangle(tp_svg_target *t, const char *const *attributes, fmpq *n,
                           const char **problem) {
  static const char *const names[] = {"x", "y", "width", "height", "rx", "ry"};
  for (int k = 0; k < 6; k++) {
    if (!read_length(n + k, attributes, names[k], problem)) return false;
  }
  if (fmpq_sgn(n + 2) <= 0 || fmpq_sgn(n + 3) <= 0) return true; /* SVG draws nothing */
  set_rounding(n, attributes);
  tp_drawing_object *object = tp_svg_begin(t);
  if (object == NULL) return false;
  for (int k = 1; k <= 4; k++) {
    if (!add_side(t, object, n, k % 4)) return false;
  }
  object->closure = TP_DRAWING_CLOSED;
  return tp_svg_finish(t, object);
}

/* The unit circle, by a map that makes it this one. */
static bool read_round(tp_svg_target *t, const char *const *attributes, fmpq *n,
                       const char **problem) {
  const bool circle = strcmp(t->kind, "circle") == 0;
  if (!read_length(n, attributes, "cx", problem) ||
      !read_length(n + 1, attributes, "cy", problem) ||
      !read_length(n + 2, attributes, circle ? "r" : "rx", problem) ||
      !read_length(n + 3, attributes, circle ? "r" : "ry", problem)) {
    return false;
  }
  if (fmpq_sgn(n + 2) <= 0 || fmpq_sgn(n + 3) <= 0) return true; /* SVG draws nothing */
  tp_affine_map map;
  tp_affine_map_init(&map);
  tp_affine_map_set(&map, t->map);
  tp_affine_map_shift(&map, n, n + 1);
  tp_affine_map_scale(&map, n + 2, n + 3);
  tp_drawing_object *object = tp_svg_begin(t);
  fmpq_zero(n);
  fmpq_one(n + 1);
  bool done = object != NULL && tp_curve_circle(object, n, n, n + 1, t->mark);
  if (!done) t->no_memory = true;
  const tp_affine_map *outer = t->map;
  t->map = &map;
  done = done && tp_svg_finish(t, object);
  t->map = outer;
  tp_affine_map_clear(&map);
  return done;
}

static bool read_path(tp_svg_target *t, const char *const *attributes, fmpq *n,
                      const char **problem) {
  (void)n;
  const char *data = tp_svg_attribute(attributes, "d");
  tp_svg_text text = text_of(data != NULL ? data : "");
  const bool done = tp_svg_path(t, &text);
  *problem = text.problem;
  return done;
}

static const struct {
  const char *kind;
  shape_reader read;
} shapes[] = {{"path", read_path},    {"polygon", read_points}, {"polyline", read_points},
              {"line", read_line},    {"rect", read_rectangle}, {"circle", read_round},
              {"ellipse", read_round}};

enum { SHAPES = sizeof shapes / sizeof shapes[0], NUMBERS = 6 };

const char *tp_svg_shape_kind(const char *element) {
  for (int k = 0; k < SHAPES; k++) {
    if (strcmp(element, shapes[k].kind) == 0) return shapes[k].kind;
  }
  return NULL;
}

bool tp_svg_shape(tp_svg_target *target, const char *const *attributes, const char **problem) {
  fmpq numbers[NUMBERS];
  bool done = false;
  for (int k = 0; k < NUMBERS; k++) fmpq_init(numbers + k);
  for (int k = 0; k < SHAPES; k++) {
    if (strcmp(target->kind, shapes[k].kind) != 0) continue;
    done = shapes[k].read(target, attributes, numbers, problem);
  }
  for (int k = 0; k < NUMBERS; k++) fmpq_clear(numbers + k);
  return done;
}
