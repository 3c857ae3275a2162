/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Sited water: over each line that it presses on an area as wide as a share of the depth, and on
 * each side its level with the usual triangle; ice as arrows. */

#include "figure/figure.h"

#include <math.h>

#define WIDTH 0.3  /* of the depth: how wide the pressure is drawn */
#define WIDEST 0.2 /* of the height of the figure */
#define SIGN 4.0   /* points: half the width of the triangle on the level */
#define REACH 26.0 /* points: how far the level is drawn from the block */
#define ARROW 12.0

static double depth_of(const tp_figure *figure, const fmpq *kpa) {
  const tp_problem *problem = figure->problem;
  const double gamma = fmpq_get_d(problem->scene->loads.water.unit_weight_kn_m3.value);
  return gamma > 0 ? fmpq_get_d(kpa) / gamma / figure->shape.unit_m : 0;
}

double tp_figure_wet_width(const tp_figure *figure, const tp_wetted *wetted) {
  const tp_wet_lines *const all[] = {&wetted->faces, &wetted->joint};
  const double height = figure->shape.box.y1 - figure->shape.box.y0;
  double deepest = 0;
  for (int kind = 0; kind < 2; kind++) {
    for (long k = 0; k < all[kind]->count; k++) {
      const tp_line_load *line = all[kind]->items + k;
      deepest = fmax(deepest, fmax(depth_of(figure, line->first_kpa.value),
                                   depth_of(figure, line->last_kpa.value)));
    }
  }
  return deepest * WIDTH > height * WIDEST ? height * WIDEST / deepest : WIDTH;
}

static tp_spot spot_of(const tp_figure *figure, const fmpq *x, const fmpq *y) {
  return tp_shape_of_scene(&figure->shape, figure->problem, x, y);
}

/* A unit away from the block, which lies to the left of the line. */
static tp_spot outwards(tp_spot a, tp_spot b) {
  const double length = fmax(hypot(b.x - a.x, b.y - a.y), 1e-300);
  return (tp_spot){(b.y - a.y) / length, -(b.x - a.x) / length};
}

void tp_figure_wet_area(tp_spot corners[4], const tp_figure *figure, const tp_line_load *line,
                        double width) {
  const tp_spot a = spot_of(figure, line->x0.value, line->y0.value);
  const tp_spot b = spot_of(figure, line->x1.value, line->y1.value);
  const tp_spot out = outwards(a, b);
  const double first = width * depth_of(figure, line->first_kpa.value);
  const double last = width * depth_of(figure, line->last_kpa.value);
  corners[0] = a;
  corners[1] = b;
  corners[2] = (tp_spot){b.x + last * out.x, b.y + last * out.y};
  corners[3] = (tp_spot){a.x + first * out.x, a.y + first * out.y};
}

static void draw_pressure(const tp_panel *p, const tp_line_load *line, double width) {
  tp_spot corners[4];
  tp_figure_wet_area(corners, p->figure, line, width);
  cairo_new_path(p->cr);
  for (int k = 0; k < 4; k++) {
    const tp_spot at = tp_view_spot(&p->view, corners[k]);
    cairo_line_to(p->cr, at.x, at.y);
  }
  cairo_close_path(p->cr);
  tp_figure_ink(p->cr, TP_INK_SKY);
  cairo_fill_preserve(p->cr);
  tp_figure_ink(p->cr, TP_INK_BLUE);
  cairo_set_line_width(p->cr, 0.5);
  cairo_stroke(p->cr);
}

/* The level through a point of the water, away from the block, with a triangle that stands on it.
 */
static void draw_level(const tp_panel *p, tp_spot point, double side) {
  const tp_spot at = tp_view_spot(&p->view, point);
  const tp_spot down = tp_view_direction(&p->view, p->state->gravity);
  const tp_spot away = {side * down.y, -side * down.x};
  const tp_spot foot = {at.x + REACH / 2 * away.x, at.y + REACH / 2 * away.y};
  const tp_spot top = {foot.x - 1.6 * SIGN * down.x, foot.y - 1.6 * SIGN * down.y};
  tp_figure_ink(p->cr, TP_INK_BLUE);
  cairo_set_line_width(p->cr, 0.7);
  cairo_new_path(p->cr);
  cairo_move_to(p->cr, at.x, at.y);
  cairo_line_to(p->cr, at.x + REACH * away.x, at.y + REACH * away.y);
  cairo_stroke(p->cr);
  cairo_move_to(p->cr, foot.x, foot.y);
  cairo_line_to(p->cr, top.x + SIGN * away.x, top.y + SIGN * away.y);
  cairo_line_to(p->cr, top.x - SIGN * away.x, top.y - SIGN * away.y);
  cairo_close_path(p->cr);
  cairo_stroke(p->cr);
}

/* Above the least depth of the lines, which is nothing where the water ends on a face. */
static void draw_level_of(const tp_panel *p, const tp_line_load *lines, long count, double side) {
  double least = INFINITY;
  tp_spot at = {0, 0};
  for (long k = 0; k < count; k++) {
    const tp_line_load *l = lines + k;
    const double first = depth_of(p->figure, l->first_kpa.value),
                 last = depth_of(p->figure, l->last_kpa.value);
    if (first < least) at = spot_of(p->figure, l->x0.value, l->y0.value);
    least = fmin(least, first);
    if (last < least) at = spot_of(p->figure, l->x1.value, l->y1.value);
    least = fmin(least, last);
  }
  if (count == 0) return;
  const tp_spot down = p->state->gravity;
  const double up = least / fmax(hypot(down.x, down.y), 1e-300);
  draw_level(p, (tp_spot){at.x - up * down.x, at.y - up * down.y}, side);
}

static void draw_ice(const tp_panel *p, const tp_line_load *line) {
  const tp_spot a = spot_of(p->figure, line->x0.value, line->y0.value);
  const tp_spot b = spot_of(p->figure, line->x1.value, line->y1.value);
  const tp_spot at = tp_view_spot(&p->view, (tp_spot){(a.x + b.x) / 2, (a.y + b.y) / 2});
  const tp_spot out = tp_view_direction(&p->view, outwards(a, b));
  tp_figure_ink(p->cr, TP_INK_PURPLE);
  tp_figure_arrow(p->cr, (tp_spot){at.x + ARROW * out.x, at.y + ARROW * out.y}, at, 0.9);
}

void tp_figure_draw_wetted(const tp_panel *p) {
  const bool left = p->state->own->towards == TP_TOWARDS_LEFT;
  const tp_wetted *wetted = p->figure->problem->wetted + (left ? 0 : 1);
  const long split = wetted->from_right;
  const double width = tp_figure_wet_width(p->figure, wetted);
  for (long k = 0; k < wetted->faces.count; k++) draw_pressure(p, wetted->faces.items + k, width);
  for (long k = 0; k < wetted->joint.count; k++) draw_pressure(p, wetted->joint.items + k, width);
  for (long k = 0; k < wetted->ice.count; k++) draw_ice(p, wetted->ice.items + k);
  draw_level_of(p, wetted->faces.items, split, -1);
  draw_level_of(p, wetted->faces.items + split, wetted->faces.count - split, 1);
}
