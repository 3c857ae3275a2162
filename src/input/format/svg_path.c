/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Path data of SVG, command by command: lines, Bezier curves, reflected control points and arcs,
 * absolute and relative, in exact numbers. */

#include "format/svg_path.h"

#include "format/drawing_work.h"

#include <ctype.h>
#include <string.h>

/* ---- objects -----------------------------------------------------------------------------------
 */

tp_drawing_object *tp_svg_begin(tp_svg_target *t) {
  tp_drawing_object *object = tp_drawing_add(t->drawing, t->kind, t->layer, t->name, t->mark);
  if (object == NULL) t->no_memory = true;
  return object;
}

bool tp_svg_tolerance(fmpq_t tolerance, const tp_svg_target *t, const fmpq_t size) {
  fmpq_t stretch, mapped;
  fmpq_init(stretch);
  fmpq_init(mapped);
  tp_affine_map_stretch(stretch, t->map);
  fmpq_mul(mapped, size, stretch);
  tp_curve_tolerance(tolerance, t->options, mapped);
  const bool done = fmpq_sgn(stretch) > 0 && fmpq_sgn(tolerance) > 0;
  if (done) fmpq_div(tolerance, tolerance, stretch);
  fmpq_clear(stretch);
  fmpq_clear(mapped);
  return done;
}

bool tp_svg_finish(tp_svg_target *t, tp_drawing_object *object) {
  if (tp_drawing_has_arcs(object) && !tp_affine_map_keeps_circles(t->map)) {
    fmpq_t size, other;
    fmpq_init(size);
    fmpq_init(other);
    tp_polyline_size(size, other, &object->line);
    if (fmpq_cmp(other, size) > 0) fmpq_swap(other, size);
    tp_curve_outcome outcome = TP_CURVE_DONE;
    if (tp_svg_tolerance(other, t, size)) outcome = tp_curve_flatten(object, other);
    if (outcome == TP_CURVE_TOO_FINE) {
      object->problem = TP_CURVE_TOO_FINE_TEXT;
    }
    t->no_memory = t->no_memory || outcome == TP_CURVE_NO_MEMORY;
    fmpq_clear(size);
    fmpq_clear(other);
  }
  tp_affine_map_object(object, t->map);
  tp_drawing_tidy(object);
  if (!t->no_memory) t->status = tp_drawing_count(t->drawing, object, t->message);
  if (object->line.count == 0) tp_drawing_drop(t->drawing);
  return !t->no_memory && t->status == TP_OK;
}

/* ---- a path ------------------------------------------------------------------------------------
 */

enum { NUMBERS = 6 };

typedef struct path {
  tp_svg_target *target;
  tp_svg_text *text;
  tp_drawing_object *object;     /* NULL: none is begun */
  fmpq_t x, y, start_x, start_y; /* where it is, and where the object began */
  fmpq_t control_x, control_y;   /* the last control point, ... */
  char control;                  /* ... of a 'C' or a 'Q'; 0: there is none */
  fmpq n[NUMBERS];
} path;

static bool end_object(path *p) {
  tp_drawing_object *object = p->object;
  p->object = NULL;
  return object == NULL || tp_svg_finish(p->target, object);
}

static bool begin_object(path *p) {
  if (p->object != NULL) return true;
  fmpq_set(p->start_x, p->x);
  fmpq_set(p->start_y, p->y);
  p->object = tp_svg_begin(p->target);
  if (p->object == NULL) return false;
  if (tp_drawing_add_point(p->object, p->x, p->y, p->target->mark)) return true;
  p->target->no_memory = true;
  return false;
}

/* `count` numbers, in pairs relative to where the path is. */
static bool read_points(path *p, int count, bool relative) {
  for (int k = 0; k < count; k++) {
    if (!tp_svg_number(p->text, p->n + k)) return false;
    if (relative) fmpq_add(p->n + k, p->n + k, k % 2 == 0 ? p->x : p->y);
  }
  return true;
}

static bool move_to(path *p, const fmpq *x, const fmpq *y) {
  fmpq_set(p->x, x);
  fmpq_set(p->y, y);
  return true;
}

static bool line_to(path *p, const fmpq *x, const fmpq *y) {
  p->control = 0;
  if (!begin_object(p)) return false;
  if (!tp_drawing_add_point(p->object, x, y, p->target->mark)) {
    p->target->no_memory = true;
    return false;
  }
  return move_to(p, x, y);
}

/* The point opposite to the last control point, or where the path is. */
static void reflect(fmpq_t x, fmpq_t y, const path *p, char kind) {
  fmpq_set(x, p->x);
  fmpq_set(y, p->y);
  if (p->control != kind) return;
  fmpq_add(x, x, p->x);
  fmpq_sub(x, x, p->control_x);
  fmpq_add(y, y, p->y);
  fmpq_sub(y, y, p->control_y);
}

/* The greater side of the box of the control points. */
static void set_size(fmpq_t size, const tp_control_point *points, int degree) {
  tp_polyline line = {.file = NULL};
  fmpq_t other;
  fmpq_init(other);
  fmpq_zero(size);
  bool done = true;
  for (int k = 0; k <= degree && done; k++) {
    done = tp_polyline_append(&line, points[k].x, points[k].y, (tp_mark){0, 0});
  }
  if (done) tp_polyline_size(size, other, &line);
  if (fmpq_cmp(other, size) > 0) fmpq_swap(other, size);
  tp_polyline_clear(&line);
  fmpq_clear(other);
}

/* By 2 or 3 points that stand in p->n. */
static bool curve_to(path *p, int degree) {
  enum { MOST = 4 };
  if (!begin_object(p)) return false;
  tp_control_point points[MOST];
  fmpq_t size;
  fmpq_init(size);
  tp_control_points_init(points, MOST);
  fmpq_set(points[0].x, p->x);
  fmpq_set(points[0].y, p->y);
  for (int k = 1; k <= degree; k++) {
    fmpq_set(points[k].x, p->n + 2 * k - 2);
    fmpq_set(points[k].y, p->n + 2 * k - 1);
  }
  set_size(size, points, degree);
  p->control = degree == 3 ? 'C' : 'Q';
  fmpq_set(p->control_x, points[degree - 1].x);
  fmpq_set(p->control_y, points[degree - 1].y);
  move_to(p, p->n + 2 * degree - 2, p->n + 2 * degree - 1);
  tp_curve_outcome outcome = TP_CURVE_DONE;
  if (tp_svg_tolerance(size, p->target, size)) {
    outcome = tp_curve_bezier(p->object, points, degree, size, p->target->mark);
  }
  if (outcome == TP_CURVE_NO_MEMORY) p->target->no_memory = true;
  if (outcome == TP_CURVE_TOO_FINE) {
    p->object->problem = TP_CURVE_TOO_FINE_TEXT;
  }
  tp_control_points_clear(points, MOST);
  fmpq_clear(size);
  return outcome != TP_CURVE_NO_MEMORY;
}

/* Control points and end behind a first one that is reflected. */
static bool smooth_to(path *p, int degree, bool relative) {
  if (!read_points(p, 2 * degree - 2, relative)) return false;
  for (int k = 2 * degree - 3; k >= 0; k--) fmpq_set(p->n + k + 2, p->n + k);
  reflect(p->n, p->n + 1, p, degree == 3 ? 'C' : 'Q');
  return curve_to(p, degree);
}

static bool read_flag(path *p, bool *flag) {
  if (!tp_svg_at_number(p->text) || (*p->text->at != '0' && *p->text->at != '1')) {
    if (p->text->problem == NULL) p->text->problem = "has an arc whose flags are not 0 or 1";
    return false;
  }
  *flag = *p->text->at++ == '1';
  return true;
}

static bool arc_to(path *p, bool relative) {
  tp_svg_arc arc;
  fmpq *const numbers[] = {arc.rx, arc.ry, arc.degrees, arc.x, arc.y};
  for (int k = 0; k < 5; k++) fmpq_init(numbers[k]);
  bool done = begin_object(p);
  for (int k = 0; k < 3 && done; k++) done = tp_svg_number(p->text, numbers[k]);
  done =
      done && read_flag(p, &arc.large) && read_flag(p, &arc.sweep) && read_points(p, 2, relative);
  if (done) {
    fmpq_set(arc.x, p->n);
    fmpq_set(arc.y, p->n + 1);
    done = tp_svg_add_arc(p->target, p->object, &arc) && move_to(p, p->n, p->n + 1);
  }
  for (int k = 0; k < 5; k++) fmpq_clear(numbers[k]);
  p->control = 0;
  return done;
}

/* Along x or y alone. */
static bool line_along(path *p, bool along_x, bool relative) {
  if (!tp_svg_number(p->text, p->n)) return false;
  if (relative) fmpq_add(p->n, p->n, along_x ? p->x : p->y);
  fmpq_set(p->n + 1, along_x ? p->y : p->x);
  return along_x ? line_to(p, p->n, p->n + 1) : line_to(p, p->n + 1, p->n);
}

static bool close_path(path *p) {
  p->control = 0;
  if (p->object == NULL) return true;
  p->object->closure = TP_DRAWING_CLOSED;
  move_to(p, p->start_x, p->start_y);
  return end_object(p);
}

/* One command with its numbers. A further pair behind M is a line. */
static bool run(path *p, char command, bool first) {
  const bool relative = islower((unsigned char)command);
  switch (toupper((unsigned char)command)) {
  case 'M':
    if (!read_points(p, 2, relative)) return false;
    if (!first) return line_to(p, p->n, p->n + 1);
    p->control = 0;
    return end_object(p) && move_to(p, p->n, p->n + 1);
  case 'L':
    return read_points(p, 2, relative) && line_to(p, p->n, p->n + 1);
  case 'H':
    return line_along(p, true, relative);
  case 'V':
    return line_along(p, false, relative);
  case 'C':
    return read_points(p, 6, relative) && curve_to(p, 3);
  case 'S':
    return smooth_to(p, 3, relative);
  case 'Q':
    return read_points(p, 4, relative) && curve_to(p, 2);
  case 'T':
    return smooth_to(p, 2, relative);
  case 'A':
    return arc_to(p, relative);
  case 'Z':
    return close_path(p);
  default:
    p->text->problem = "has a command that is none of M L H V C S Q T A Z";
    return false;
  }
}

static bool run_all(path *p) {
  char command = 0;
  bool first = true;
  for (;;) {
    const bool number = tp_svg_at_number(p->text);
    if (p->text->at == p->text->end) return end_object(p);
    if (!number) {
      if (command == 0 && toupper((unsigned char)*p->text->at) != 'M') {
        p->text->problem = "does not begin with the command M";
        return false;
      }
      command = *p->text->at++;
      first = true;
    } else if (command == 0 || toupper((unsigned char)command) == 'Z') {
      p->text->problem = "has a number where a command belongs";
      return false;
    }
    if (!run(p, command, first)) return false;
    first = false;
  }
}

bool tp_svg_path(tp_svg_target *target, tp_svg_text *text) {
  path p = {.target = target, .text = text};
  fmpq *const numbers[] = {p.x, p.y, p.start_x, p.start_y, p.control_x, p.control_y};
  for (size_t k = 0; k < sizeof numbers / sizeof numbers[0]; k++) fmpq_init(numbers[k]);
  for (int k = 0; k < NUMBERS; k++) fmpq_init(p.n + k);
  const bool done = run_all(&p);
  for (size_t k = 0; k < sizeof numbers / sizeof numbers[0]; k++) fmpq_clear(numbers[k]);
  for (int k = 0; k < NUMBERS; k++) fmpq_clear(p.n + k);
  return done;
}
