/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Arcs as chords within a tolerance by r (A / n)^2 / 8, with points that are rational in bulge and
 * ends, and arcs cut into pieces. */

#include "format/curve.h"

#include <math.h>
#include <stdlib.h>

typedef struct arc {
  fmpq_t px, py, dx, dy, bulge; /* its beginning, its chord */
} arc;

static void arc_init(arc *a) {
  fmpq_init(a->px);
  fmpq_init(a->py);
  fmpq_init(a->dx);
  fmpq_init(a->dy);
  fmpq_init(a->bulge);
}

static void arc_clear(arc *a) {
  fmpq_clear(a->px);
  fmpq_clear(a->py);
  fmpq_clear(a->dx);
  fmpq_clear(a->dy);
  fmpq_clear(a->bulge);
}

static void arc_set(arc *a, const tp_polyline *line, long edge, const fmpq *bulge) {
  const long next = edge + 1 == line->count ? 0 : edge + 1;
  fmpq_set(a->px, line->x + edge);
  fmpq_set(a->py, line->y + edge);
  fmpq_sub(a->dx, line->x + next, line->x + edge);
  fmpq_sub(a->dy, line->y + next, line->y + edge);
  fmpq_set(a->bulge, bulge);
}

/* The point in which a piece of it ends that begins with it and has the tangent t of a quarter of
 * its angle. A chord is 2 r sin(2 atan t) long and turned against the tangent at its beginning by
 * 2 atan t, and exp(2 i atan t) = (1 + i t)^2 / (1 + t^2), so as complex numbers
 *   chord(t) = chord(b) (t / b) ((1 + i t) (1 - i b))^2 / (1 + t^2)^2. */
static void arc_point(fmpq_t x, fmpq_t y, const arc *a, const fmpq_t t) {
  fmpq_t m, n, factor;
  fmpq_init(m);
  fmpq_init(n);
  fmpq_init(factor);
  fmpq_mul(factor, t, t);
  fmpq_add_si(factor, factor, 1);
  fmpq_mul(factor, factor, factor);
  fmpq_mul(factor, factor, a->bulge);
  fmpq_div(factor, t, factor);
  fmpq_mul(m, t, a->bulge);
  fmpq_add_si(m, m, 1);
  fmpq_sub(n, t, a->bulge);
  fmpq_mul(x, m, m);
  fmpq_submul(x, n, n);
  fmpq_mul(y, m, n);
  fmpq_mul_2exp(y, y, 1);
  fmpq_mul(m, x, factor); /* cosine and sine, scaled */
  fmpq_mul(n, y, factor);
  fmpq_mul(x, a->dx, m);
  fmpq_submul(x, a->dy, n);
  fmpq_mul(y, a->dx, n);
  fmpq_addmul(y, a->dy, m);
  fmpq_add(x, x, a->px);
  fmpq_add(y, y, a->py);
  fmpq_clear(m);
  fmpq_clear(n);
  fmpq_clear(factor);
}

/* r (A / n)^2 / 8 = share * tolerance. */
static double chords_of(const arc *a, const fmpq_t tolerance) {
  const double dx = fmpq_get_d(a->dx), dy = fmpq_get_d(a->dy), b = fabs(fmpq_get_d(a->bulge));
  const double radius = hypot(dx, dy) * (1 + b * b) / (4 * b), angle = 4 * atan(b);
  return 1 + floor(angle * sqrt(radius / (8 * TP_CURVE_SHARE * fmpq_get_d(tolerance))));
}

/* The tangent of a share of the quarter angle, as a multiple of 2^-30. */
static void set_tangent(fmpq_t t, const arc *a, double part) {
  enum { STEPS = 30 };
  const double tangent = tan(atan(fmpq_get_d(a->bulge)) * part);
  fmpz_set_d(fmpq_numref(t), nearbyint(ldexp(tangent, STEPS)));
  fmpz_one(fmpq_denref(t));
  fmpq_div_2exp(t, t, STEPS);
}

static tp_curve_outcome add_chords(tp_polyline *line, const arc *a, const fmpq_t tolerance,
                                   double most, tp_mark mark) {
  const double count = chords_of(a, tolerance);
  if (!(count <= most - (double)line->count)) return TP_CURVE_TOO_FINE;
  fmpq_t t, x, y;
  fmpq_init(t);
  fmpq_init(x);
  fmpq_init(y);
  bool done = tp_polyline_append(line, a->px, a->py, mark);
  for (long k = 1; k < (long)count && done; k++) {
    set_tangent(t, a, (double)k / count);
    arc_point(x, y, a, t);
    tp_curve_round(x, tolerance);
    tp_curve_round(y, tolerance);
    done = tp_polyline_append(line, x, y, mark);
  }
  fmpq_clear(t);
  fmpq_clear(x);
  fmpq_clear(y);
  return done ? TP_CURVE_DONE : TP_CURVE_NO_MEMORY;
}

tp_curve_outcome tp_curve_flatten(tp_drawing_object *object, const fmpq_t tolerance) {
  if (!tp_drawing_has_arcs(object)) return TP_CURVE_DONE;
  const tp_polyline *line = &object->line;
  tp_polyline chords = {.file = line->file, .mark = line->mark};
  tp_curve_outcome outcome = TP_CURVE_DONE;
  arc a;
  arc_init(&a);
  for (long k = 0; k < line->count && outcome == TP_CURVE_DONE; k++) {
    const fmpq *bulge = tp_drawing_bulge(object, k);
    if (bulge != NULL) {
      arc_set(&a, line, k, bulge);
      outcome = add_chords(&chords, &a, tolerance, object->most_points, line->marks[k]);
    } else if (!tp_polyline_append(&chords, line->x + k, line->y + k, line->marks[k])) {
      outcome = TP_CURVE_NO_MEMORY;
    }
  }
  arc_clear(&a);
  if (outcome != TP_CURVE_DONE) {
    tp_polyline_clear(&chords);
    return outcome;
  }
  tp_polyline_clear(&object->line);
  object->line = chords;
  tp_drawing_straighten(object);
  tp_curve_deviates(object, tolerance);
  return TP_CURVE_DONE;
}

/* Half of the quarter angle, near enough, by the tangent t; the rest has (b - t) / (1 + b t). */
static bool split(tp_drawing_object *whole, const tp_polyline *line, long edge, const fmpq *bulge) {
  arc a;
  fmpq_t t, x, y;
  arc_init(&a);
  fmpq_init(t);
  fmpq_init(x);
  fmpq_init(y);
  arc_set(&a, line, edge, bulge);
  set_tangent(t, &a, 0.5);
  arc_point(x, y, &a, t);
  bool done = tp_drawing_add_point(whole, a.px, a.py, line->marks[edge]) &&
              tp_drawing_bend(whole, t) && tp_drawing_add_point(whole, x, y, line->marks[edge]);
  fmpq_mul(x, bulge, t);
  fmpq_add_si(x, x, 1);
  fmpq_sub(y, bulge, t);
  fmpq_div(x, y, x);
  done = done && tp_drawing_bend(whole, x);
  arc_clear(&a);
  fmpq_clear(t);
  fmpq_clear(x);
  fmpq_clear(y);
  return done;
}

bool tp_curve_split_lens(tp_drawing_object *object) {
  tp_polyline line = object->line;
  if (object->closure != TP_DRAWING_CLOSED || line.count != 2 || !tp_drawing_has_arcs(object)) {
    return true;
  }
  fmpq *bulges = object->bulges;
  const long room = object->bulge_room;
  object->line = (tp_polyline){.file = line.file, .mark = line.mark};
  object->bulges = NULL;
  object->bulge_room = 0;
  bool done = true;
  for (long k = 0; k < 2 && done; k++) {
    const bool bent = k < room && !fmpq_is_zero(bulges + k);
    done = bent ? split(object, &line, k, bulges + k)
                : tp_drawing_add_point(object, line.x + k, line.y + k, line.marks[k]);
  }
  for (long k = 0; k < room; k++) fmpq_clear(bulges + k);
  free(bulges);
  tp_polyline_clear(&line);
  return done;
}
