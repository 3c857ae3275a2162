/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Water as areas of its pressure, bolts from head to end, pressures and surcharges as arrows. Only
 * the lengths of bolts are to scale. */

#include "figure/dxf.h"
#include "scene/anchor.h"

#include <math.h>

#define ARROW 0.08 /* of a pressure or an anchor, in units of the block's size */

/* ---- water -------------------------------------------------------------------------------------
 */

static void add_area(tp_cad *d, const tp_spot *corners, int count) {
  tp_cad_polyline(&d->text, TP_CAD_WATER, true);
  for (int k = 0; k < count; k++) {
    tp_cad_vertex(&d->text, TP_CAD_WATER, tp_cad_of_spot(d, corners[k]), 0);
  }
  tp_cad_polyline_end(&d->text, TP_CAD_WATER);
}

static void add_wet_lines(tp_cad *d, const tp_wet_lines *lines, double width) {
  tp_spot corners[4];
  for (long k = 0; k < lines->count; k++) {
    tp_figure_wet_area(corners, d->figure, lines->items + k, width);
    add_area(d, corners, 4);
  }
}

static void add_water(tp_cad *d, const tp_state *state) {
  const tp_problem *problem = d->figure->problem;
  const tp_wetted *wetted = problem->wetted + (state->own->towards == TP_TOWARDS_LEFT ? 0 : 1);
  if (tp_problem_has_wetted(problem)) {
    const double width = tp_figure_wet_width(d->figure, wetted);
    add_wet_lines(d, &wetted->faces, width);
    add_wet_lines(d, &wetted->joint, width);
    return;
  }
  tp_spot triangles[2][3];
  const int count = tp_figure_water_areas(triangles, d->figure, state);
  for (int k = 0; k < count; k++) add_area(d, triangles[k], 3);
}

/* ---- pressures ---------------------------------------------------------------------------------
 */

/* Of length 1. */
static tp_spot unit_of(tp_spot v) {
  const double length = hypot(v.x, v.y);
  return length > 0 ? (tp_spot){v.x / length, v.y / length} : v;
}

/* Arrows along a line: pressures press to its left, surcharges downwards. */
static void add_line_load(tp_cad *d, const tp_state *state, const tp_line_load *load,
                          bool surcharge) {
  enum { ARROWS = 6 };
  const tp_figure *f = d->figure;
  const tp_spot a = tp_shape_of_scene(&f->shape, f->problem, load->x0.value, load->y0.value);
  const tp_spot b = tp_shape_of_scene(&f->shape, f->problem, load->x1.value, load->y1.value);
  const tp_spot way = unit_of(surcharge ? state->gravity : (tp_spot){a.y - b.y, b.x - a.x});
  const double first = fmpq_get_d(load->first_kpa.value);
  const double last = surcharge ? first : fmpq_get_d(load->last_kpa.value);
  const double largest = fmax(fabs(first), fabs(last));
  for (int k = 0; k <= ARROWS && largest > 0; k++) {
    const double t = (double)k / ARROWS;
    const double size = ARROW * (first + t * (last - first)) / largest;
    const tp_spot tip = {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
    const tp_spot tail = {tip.x - size * way.x, tip.y - size * way.y};
    tp_cad_arrow(&d->text, TP_CAD_FORCES, tp_cad_of_spot(d, tail), tp_cad_of_spot(d, tip));
  }
}

/* ---- bolts -------------------------------------------------------------------------------------
 */

/* A bolt of a length as a line with a dot at its head; without one an arrow of its pull. */
static void add_bolt(tp_cad *d, const tp_anchor_description *anchor, const fmpq_t x, const fmpq_t y,
                     const fmpq_t direction_deg) {
  const double dot = 0.008;
  const double angle = fmpq_get_d(direction_deg) * atan(1) / 45;
  const double length =
      anchor->length.given ? fmpq_get_d(anchor->length.value) / tp_cad_unit(d) : 2 * ARROW;
  const tp_spot head = tp_shape_of_scene(&d->figure->shape, d->figure->problem, x, y);
  const tp_spot end = {head.x + length * cos(angle), head.y + length * sin(angle)};
  const tp_spot from = tp_cad_of_scene(d, x, y), to = tp_cad_of_spot(d, end);
  tp_cad_circle(&d->text, TP_CAD_BOLTS, from, dot * tp_cad_unit(d));
  if (anchor->length.given) {
    tp_cad_line(&d->text, TP_CAD_BOLTS, from, to);
  } else {
    tp_cad_arrow(&d->text, TP_CAD_BOLTS, from, to);
  }
}

static void add_anchor(tp_cad *d, const tp_anchor_description *anchor) {
  fmpq_t x, y, direction;
  fmpq_init(x);
  fmpq_init(y);
  fmpq_init(direction);
  tp_anchor_direction(direction, d->figure->problem->scene, anchor);
  for (long row = 0; row < tp_anchor_rows(anchor); row++) {
    tp_anchor_point(x, y, anchor, row);
    add_bolt(d, anchor, x, y, direction);
  }
  fmpq_clear(x);
  fmpq_clear(y);
  fmpq_clear(direction);
}

void tp_cad_add_loads(tp_cad *d, const tp_state *state) {
  const tp_loads_description *loads = &d->figure->problem->scene->loads;
  add_water(d, state);
  for (long k = 0; k < loads->pressure_count; k++) {
    add_line_load(d, state, loads->pressures + k, false);
  }
  for (long k = 0; k < loads->support_count; k++) {
    add_line_load(d, state, loads->supports + k, false);
  }
  for (long k = 0; k < loads->surcharge_count; k++) {
    add_line_load(d, state, loads->surcharges + k, true);
  }
  for (long k = 0; k < loads->anchor_count; k++) add_anchor(d, loads->anchors + k);
}
