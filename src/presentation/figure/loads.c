/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Loads that act at a point or on a line: water, pressures, surcharges, anchors. Their sizes are
 * not to scale, but lengths of bolts are. */

#include "figure/figure.h"

#include "load/bolt_way.h"
#include "scene/anchor.h"

#include <math.h>

#define LOAD_ARROW 15.0 /* points */
#define WATER_WIDTH 0.3 /* of the height: how wide the triangle of its pressure is drawn */

static double in_units(const tp_figure *figure, const fmpq *length) {
  return fmpq_get_d(length) * figure->solution->metres_per_unit / figure->shape.unit_m;
}

static void fill_triangle(const tp_panel *p, const tp_spot corners[3]) {
  for (int k = 0; k < 3; k++) {
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

/* An end of the joint that water fills: as the contact's where it is that, so that a rounded corner
 * ends where it is drawn. */
static tp_spot joint_spot(const tp_figure *figure, const tp_state *state, int side) {
  const tp_problem *problem = figure->problem;
  const tp_contact *contact = &problem->contact;
  const tp_base_joint *joint = &problem->joint;
  const tp_case *own = state->own;
  const size_t end = side == 0 ? 0 : own->candidate_count - 1;
  const size_t listed = side == 0 ? 0 : own->pivot_count - 1;
  if (joint->vertex[side] == tp_contact_extreme(contact, side == 0).point &&
      own->pivots[listed].index == end) {
    return tp_figure_pivot_spot(figure, own, listed);
  }
  fmpq_t x, y;
  fmpq_init(x);
  fmpq_init(y);
  fmpq_div(x, joint->x + side, problem->scene->metres_per_unit);
  fmpq_div(y, joint->y + side, problem->scene->metres_per_unit);
  const tp_spot spot = tp_shape_of_scene(&figure->shape, problem, x, y);
  fmpq_clear(x);
  fmpq_clear(y);
  return spot;
}

int tp_figure_water_areas(tp_spot areas[2][3], const tp_figure *figure, const tp_state *state) {
  const tp_water_description *water = &figure->problem->scene->loads.water;
  int count = 0;
  if (!water->given || figure->problem->contact.point_count == 0) return 0;
  /* behind a block that goes down-dip, before one that goes up-dip */
  const bool left = (state->own->towards == TP_TOWARDS_LEFT) != water->lifts_alone;
  const tp_spot heel = joint_spot(figure, state, left ? 1 : 0);
  const tp_spot toe = joint_spot(figure, state, left ? 0 : 1);
  double height = in_units(figure, water->height.value);
  if (water->stays_level && !water->lifts_alone) height /= fmax(cos(state->turn), 0.05);
  const double width = WATER_WIDTH * height, side = left ? 1 : -1;
  if (!water->lifts_alone) {
    areas[count][0] = heel;
    areas[count][1] = (tp_spot){heel.x + side * width, heel.y};
    areas[count++][2] = (tp_spot){heel.x, heel.y + height};
  }
  if (!water->uplift) return count;
  areas[count][0] = heel;
  areas[count][1] = toe;
  areas[count++][2] = (tp_spot){heel.x, heel.y - width / 2};
  return count;
}

static void draw_water(const tp_panel *p) {
  tp_spot areas[2][3];
  const int count = tp_figure_water_areas(areas, p->figure, p->state);
  cairo_new_path(p->cr);
  for (int k = 0; k < count; k++) fill_triangle(p, areas[k]);
}

static void arrow_onto(tp_panel *p, tp_spot tip, tp_spot direction, double length) {
  const tp_spot at = tp_view_spot(&p->view, tip);
  const tp_spot tail = {at.x - length * direction.x, at.y - length * direction.y};
  tp_figure_ink(p->cr, TP_INK_PURPLE);
  tp_figure_arrow(p->cr, tail, at, 0.9);
  tp_label_room_line(&p->room, tail, at);
}

/* Arrows along a line: pressures press to its left, surcharges downwards. */
static void draw_line_load(tp_panel *p, const tp_line_load *load, bool surcharge) {
  enum { ARROWS = 6 };
  const tp_problem *problem = p->figure->problem;
  const tp_spot a = tp_shape_of_scene(&p->figure->shape, problem, load->x0.value, load->y0.value);
  const tp_spot b = tp_shape_of_scene(&p->figure->shape, problem, load->x1.value, load->y1.value);
  const double first = fmpq_get_d(load->first_kpa.value);
  const double last = surcharge ? first : fmpq_get_d(load->last_kpa.value);
  const double largest = fmax(fabs(first), fabs(last));
  const tp_spot direction =
      tp_view_direction(&p->view, surcharge ? p->state->gravity : (tp_spot){a.y - b.y, b.x - a.x});
  for (int k = 0; k <= ARROWS && largest > 0; k++) {
    const double t = (double)k / ARROWS, share = (first + t * (last - first)) / largest;
    if (fabs(share) < 0.05) continue;
    const tp_spot at = {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
    arrow_onto(p, at, direction, LOAD_ARROW * share);
  }
}

static void draw_line(const tp_panel *p, tp_spot from, tp_spot to, double width) {
  cairo_new_path(p->cr);
  cairo_move_to(p->cr, from.x, from.y);
  cairo_line_to(p->cr, to.x, to.y);
  cairo_set_line_width(p->cr, width);
  cairo_stroke(p->cr);
}

/* A bolt of a length: its head across it, the bar, and thicker what is beyond the block. */
static void draw_bolt(tp_panel *p, const tp_anchor_description *anchor, const fmpq_t x,
                      const fmpq_t y, const fmpq_t direction_deg, tp_spot along) {
  enum { BITS = 64, HEAD = 5 };
  const tp_problem *problem = p->figure->problem;
  const tp_spot own = tp_shape_of_scene(&p->figure->shape, problem, x, y);
  const double length = in_units(p->figure, anchor->length.value);
  arb_t way;
  arb_init(way);
  (void)tp_bolt_way(way, problem->section.rings, x, y, direction_deg, BITS);
  const double share = arf_get_d(arb_midref(way), ARF_RND_NEAR) / fmpq_get_d(anchor->length.value);
  arb_clear(way);
  const tp_spot at = tp_view_spot(&p->view, own);
  const tp_spot end =
      tp_view_spot(&p->view, (tp_spot){own.x + length * along.x, own.y + length * along.y});
  const tp_spot out = {at.x + share * (end.x - at.x), at.y + share * (end.y - at.y)};
  const tp_spot d = tp_view_direction(&p->view, along);
  draw_line(p, (tp_spot){at.x - HEAD * d.y, at.y + HEAD * d.x},
            (tp_spot){at.x + HEAD * d.y, at.y - HEAD * d.x}, 2.2);
  draw_line(p, at, out, 0.9);
  draw_line(p, out, end, 2.6);
  tp_label_room_line(&p->room, at, end);
}

static void draw_row(tp_panel *p, const tp_anchor_description *anchor, const fmpq_t x,
                     const fmpq_t y, const fmpq_t direction_deg) {
  const double angle = fmpq_get_d(direction_deg) * atan(1) / 45;
  const tp_spot along = {cos(angle), sin(angle)};
  const tp_spot at =
      tp_view_spot(&p->view, tp_shape_of_scene(&p->figure->shape, p->figure->problem, x, y));
  const tp_spot d = tp_view_direction(&p->view, along);
  const tp_spot tip = {at.x + 2 * LOAD_ARROW * d.x, at.y + 2 * LOAD_ARROW * d.y};
  tp_figure_ink(p->cr, TP_INK_PURPLE);
  cairo_new_path(p->cr);
  cairo_arc(p->cr, at.x, at.y, 2, 0, 8 * atan(1));
  cairo_fill(p->cr);
  tp_figure_arrow(p->cr, at, tip, 1.4);
  tp_label_room_line(&p->room, at, tip);
  if (anchor->length.given) draw_bolt(p, anchor, x, y, direction_deg, along);
}

static void draw_anchor(tp_panel *p, const tp_anchor_description *anchor) {
  fmpq_t x, y, direction;
  fmpq_init(x);
  fmpq_init(y);
  fmpq_init(direction);
  tp_anchor_direction(direction, p->figure->problem->scene, anchor);
  for (long row = 0; row < tp_anchor_rows(anchor); row++) {
    tp_anchor_point(x, y, anchor, row);
    draw_row(p, anchor, x, y, direction);
  }
  fmpq_clear(x);
  fmpq_clear(y);
  fmpq_clear(direction);
}

void tp_figure_draw_loads(tp_panel *p) {
  const tp_loads_description *loads = &p->figure->problem->scene->loads;
  if (tp_problem_has_wetted(p->figure->problem)) {
    tp_figure_draw_wetted(p);
  } else {
    draw_water(p);
  }
  for (long k = 0; k < loads->pressure_count; k++) draw_line_load(p, loads->pressures + k, false);
  for (long k = 0; k < loads->support_count; k++) draw_line_load(p, loads->supports + k, false);
  for (long k = 0; k < loads->surcharge_count; k++) draw_line_load(p, loads->surcharges + k, true);
  for (long k = 0; k < loads->anchor_count; k++) draw_anchor(p, loads->anchors + k);
}
