/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Where all of a solved scene lies, for programs that draw it: outlines as path data of SVG (y up),
 * loads, and how the coordinates of the scene lie among these. Plain doubles in metres from an
 * origin, for drawing alone. */

#include "common/host.h"
#include "common/message.h"
#include "problem/problem.h"
#include "report/path_json.h"
#include "report/solution_json.h"
#include "scene/anchor.h"
#include "shape/shape.h"

#include <math.h>

/* ---- paths -------------------------------------------------------------------------------------
 */

static void add_paths(tp_json *j, const tp_shape *s) {
  tp_json_double(j, "origin_x_m", s->origin_x_m);
  tp_json_double(j, "origin_y_m", s->origin_y_m);
  tp_json_array(j, "box_m", TP_JSON_LINE);
  tp_json_double(j, NULL, s->box.x0 * s->unit_m);
  tp_json_double(j, NULL, s->box.y0 * s->unit_m);
  tp_json_double(j, NULL, s->box.x1 * s->unit_m);
  tp_json_double(j, NULL, s->box.y1 * s->unit_m);
  tp_json_close(j);
  tp_json_path(j, "block", &s->outline, s->unit_m);
  tp_json_array(j, "parts", TP_JSON_LIST);
  for (size_t k = 0; k < s->part_count; k++) tp_json_path(j, NULL, s->parts + k, s->unit_m);
  tp_json_close(j);
  tp_json_path(j, "base", &s->base, s->unit_m);
  tp_json_path(j, "contact", &s->contact, s->unit_m);
  tp_json_path(j, "elements", &s->elements, s->unit_m);
}

/* ---- loads -------------------------------------------------------------------------------------
 */

static void add_at(tp_json *j, const char *keys[2], tp_spot at, double unit_m) {
  tp_json_double(j, keys[0], at.x * unit_m);
  tp_json_double(j, keys[1], at.y * unit_m);
}

static void add_line_load(tp_json *j, const tp_shape *s, const tp_problem *problem,
                          const tp_line_load *load, bool surcharge) {
  tp_json_object(j, NULL, TP_JSON_LINE);
  add_at(j, (const char *[]){"x0_m", "y0_m"},
         tp_shape_of_scene(s, problem, load->x0.value, load->y0.value), s->unit_m);
  add_at(j, (const char *[]){"x1_m", "y1_m"},
         tp_shape_of_scene(s, problem, load->x1.value, load->y1.value), s->unit_m);
  const double first = fmpq_get_d(load->first_kpa.value);
  tp_json_double(j, "first_kpa", first);
  tp_json_double(j, "last_kpa", surcharge ? first : fmpq_get_d(load->last_kpa.value));
  tp_json_close(j);
}

/* A row of bolts as one that bears what they do on the thickness. */
static void add_row(tp_json *j, const tp_shape *s, const tp_problem *problem,
                    const tp_anchor_description *anchor, long row) {
  fmpq_t x, y, number;
  fmpq_init(x);
  fmpq_init(y);
  fmpq_init(number);
  tp_anchor_point(x, y, anchor, row);
  tp_json_object(j, NULL, TP_JSON_LINE);
  add_at(j, (const char *[]){"x_m", "y_m"}, tp_shape_of_scene(s, problem, x, y), s->unit_m);
  tp_anchor_direction(number, problem->scene, anchor);
  tp_json_double(j, "direction_deg", fmpq_get_d(number));
  tp_anchor_row_force(number, problem->scene, anchor);
  tp_json_double(j, "force_kn", fmpq_get_d(number));
  tp_json_close(j);
  fmpq_clear(x);
  fmpq_clear(y);
  fmpq_clear(number);
}

static void add_anchor(tp_json *j, const tp_shape *s, const tp_problem *problem,
                       const tp_anchor_description *anchor) {
  for (long row = 0; row < tp_anchor_rows(anchor); row++) add_row(j, s, problem, anchor, row);
}

static void add_loads(tp_json *j, const tp_shape *s, const tp_problem *problem) {
  const tp_loads_description *loads = &problem->scene->loads;
  const tp_wetted *wetted = problem->wetted + (problem->scene->towards_left ? 0 : 1);
  const tp_wet_lines *const wet[] = {&wetted->faces, &wetted->joint, &wetted->ice};
  if (loads->water.given && !loads->water.lifts_alone && !tp_problem_has_wetted(problem)) {
    tp_json_object(j, "water", TP_JSON_LINE);
    tp_json_double(j, "height_m",
                   fmpq_get_d(loads->water.height.value) *
                       fmpq_get_d(problem->scene->metres_per_unit));
    tp_json_truth(j, "stays_level", loads->water.stays_level);
    tp_json_truth(j, "uplift", loads->water.uplift);
    tp_json_close(j);
  }
  tp_json_array(j, "pressures", TP_JSON_LIST);
  for (long k = 0; k < loads->pressure_count; k++) {
    add_line_load(j, s, problem, loads->pressures + k, false);
  }
  for (int kind = 0; kind < 3; kind++) {
    for (long k = 0; k < wet[kind]->count; k++) {
      add_line_load(j, s, problem, wet[kind]->items + k, false);
    }
  }
  for (long k = 0; k < loads->support_count; k++) {
    add_line_load(j, s, problem, loads->supports + k, false);
  }
  tp_json_close(j);
  tp_json_array(j, "surcharges", TP_JSON_LIST);
  for (long k = 0; k < loads->surcharge_count; k++) {
    add_line_load(j, s, problem, loads->surcharges + k, true);
  }
  tp_json_close(j);
  tp_json_array(j, "anchors", TP_JSON_LIST);
  for (long k = 0; k < loads->anchor_count; k++) add_anchor(j, s, problem, loads->anchors + k);
  tp_json_close(j);
}

/* ---- the scene's own coordinates ---------------------------------------------------------------
 */

/* Points as a scene has them, in its lengths, and as they were laid, in metres from the origin. */
typedef struct laid {
  const tp_polyline *given;
  const tp_shape *shape;
  const tp_lattice *lattice;
  long first; /* of the lattice's points */
} laid;

static tp_spot given_spot(const laid *l, long k, double metres_per_unit) {
  return (tp_spot){fmpq_get_d(l->given->x + k) * metres_per_unit,
                   fmpq_get_d(l->given->y + k) * metres_per_unit};
}

static tp_spot laid_spot(const laid *l, long k) {
  const tp_spot spot = tp_shape_of_point(l->shape, l->lattice, l->first + k);
  return (tp_spot){spot.x * l->shape->unit_m, spot.y * l->shape->unit_m};
}

/* A turn and a shift tell all: by the first point and the one farthest from it. */
static void add_placed(tp_json *j, const char *key, const laid *l, long count,
                       double metres_per_unit) {
  if (l->given->count != count || count < 2) {
    tp_json_null(j, key);
    return;
  }
  const tp_spot a = given_spot(l, 0, metres_per_unit);
  double farthest = 0;
  tp_spot b = a;
  long last = 0;
  for (long k = 1; k < count; k++) {
    const tp_spot other = given_spot(l, k, metres_per_unit);
    const double distance = hypot(other.x - a.x, other.y - a.y);
    if (distance > farthest) {
      farthest = distance;
      b = other;
      last = k;
    }
  }
  const tp_spot p = laid_spot(l, 0), q = laid_spot(l, last);
  const tp_spot from = {b.x - a.x, b.y - a.y}, to = {q.x - p.x, q.y - p.y};
  const double cosine = (from.x * to.x + from.y * to.y) / farthest / farthest;
  const double sine = (from.x * to.y - from.y * to.x) / farthest / farthest;
  tp_json_object(j, key, TP_JSON_LINE);
  tp_json_double(j, "cosine", cosine);
  tp_json_double(j, "sine", sine);
  tp_json_double(j, "x_m", p.x - (cosine * a.x - sine * a.y));
  tp_json_double(j, "y_m", p.y - (sine * a.x + cosine * a.y));
  tp_json_close(j);
}

/* The same of points of the results. */
static void add_results(tp_json *j, const tp_shape *s) {
  const tp_spot *o = &s->drawn_origin_m, *axis = &s->axis;
  tp_json_object(j, "results", TP_JSON_LINE);
  tp_json_double(j, "cosine", axis->x);
  tp_json_double(j, "sine", -axis->y);
  tp_json_double(j, "x_m", -(axis->x * o->x + axis->y * o->y));
  tp_json_double(j, "y_m", axis->y * o->x - axis->x * o->y);
  tp_json_close(j);
}

static tp_status add_frames(tp_json *j, const tp_shape *shape, const tp_problem *problem,
                            const tp_scene *scene, tp_message *message) {
  const tp_lattice *l = &problem->lattice;
  const double metres_per_unit = fmpq_get_d(scene->metres_per_unit);
  tp_section section; /* as the scene has it, before it was laid */
  const tp_status status = tp_section_init(&section, &scene->block, message);
  if (status != TP_OK) return status;
  tp_json_object(j, "placed", TP_JSON_BLOCK);
  tp_json_double(j, "metres_per_unit", metres_per_unit);
  add_placed(j, "block", &(laid){section.rings, shape, l, 0}, l->start[1], metres_per_unit);
  add_results(j, shape);
  const laid base = {&scene->base.profile, shape, l, l->start[problem->section.ring_count]};
  add_placed(j, "base", &base, problem->base.edge_count + 1, metres_per_unit);
  tp_json_close(j);
  tp_section_clear(&section);
  return TP_OK;
}

/* ---- all of it ---------------------------------------------------------------------------------
 */

/* What the report is of. */
typedef struct report {
  const tp_scene *scene;
  const tp_solution *solution;
  tp_pivots_listed listed;
  char **text;
} report;

static tp_status write_all(const tp_problem *problem, const tp_shape *shape, void *context,
                           tp_message *message) {
  const report *own = context;
  tp_json j = {0};
  tp_json_report(&j);
  tp_json_solution(&j, own->solution, own->listed);
  tp_json_object(&j, "outlines", TP_JSON_BLOCK);
  add_paths(&j, shape);
  add_loads(&j, shape, problem);
  tp_status status = add_frames(&j, shape, problem, own->scene, message);
  tp_json_close(&j);
  tp_json_close(&j);
  if (status != TP_OK) {
    tp_text_drop(&j.text);
    return status;
  }
  status = tp_json_finish(&j, own->text);
  return status == TP_OUT_OF_MEMORY ? tp_fail_memory(message, "the report") : status;
}

tp_status tp_report_json_outlines(char **text, const tp_scene *scene, const tp_solution *solution,
                                  tp_pivots_listed listed, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, text);
  TP_REFUSE_NULL(message, scene);
  TP_REFUSE_NULL(message, solution);
  report own = {scene, solution, listed, text};
  return tp_shape_work_on(scene, solution, write_all, &own, message);
}
