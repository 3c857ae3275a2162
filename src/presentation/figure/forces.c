/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Weight, reactions and resultant as arrows, their lines of action, the centre of rotation. */

#include "figure/figure.h"

#include <math.h>
#include <stdio.h>

#define FORCE_WIDTH 1.4

void tp_figure_arrow(cairo_t *cr, tp_spot tail, tp_spot tip, double width) {
  const double dx = tip.x - tail.x, dy = tip.y - tail.y, length = hypot(dx, dy);
  const double head = fmin(5 * width, 0.6 * length), half = 0.38 * head;
  if (!(length > 0)) return;
  const tp_spot d = {dx / length, dy / length}, neck = {tip.x - head * d.x, tip.y - head * d.y};
  cairo_set_line_width(cr, width);
  cairo_move_to(cr, tail.x, tail.y);
  cairo_line_to(cr, neck.x, neck.y);
  cairo_stroke(cr);
  cairo_move_to(cr, tip.x, tip.y);
  cairo_line_to(cr, neck.x - half * d.y, neck.y + half * d.x);
  cairo_line_to(cr, neck.x + half * d.y, neck.y - half * d.x);
  cairo_close_path(cr);
  cairo_fill(cr);
}

static void dashed(tp_panel *p, tp_spot from, tp_spot to, tp_ink ink) {
  static const double dashes[] = {3, 2};
  const tp_spot a = tp_view_spot(&p->view, from), b = tp_view_spot(&p->view, to);
  const double length = hypot(b.x - a.x, b.y - a.y), beyond = 8;
  if (!(length > 0)) return;
  const tp_spot end = {b.x + (b.x - a.x) * beyond / length, b.y + (b.y - a.y) * beyond / length};
  tp_figure_ink(p->cr, ink);
  cairo_save(p->cr);
  cairo_set_dash(p->cr, dashes, 2, 0);
  cairo_set_line_width(p->cr, 0.5);
  cairo_move_to(p->cr, a.x, a.y);
  cairo_line_to(p->cr, end.x, end.y);
  cairo_stroke(p->cr);
  tp_label_room_line(&p->room, a, end);
  cairo_restore(p->cr);
}

static tp_spot along(tp_spot from, tp_spot vector, double times) {
  return (tp_spot){from.x + times * vector.x, from.y + times * vector.y};
}

/* The lines of action: to where they meet, or a way into the block. */
static void draw_lines(tp_panel *p) {
  const tp_state *s = p->state;
  for (size_t k = 0; k < s->reaction_count && s->reaction_count == 2; k++) {
    const tp_force *r = s->reactions + k;
    const double away = r->size.value > 0 ? 0.2 / r->size.value : 0;
    dashed(p, r->at, s->meets ? s->meeting : along(r->at, r->share, away), TP_INK_BLUE);
  }
  if (s->has_resultant) {
    const bool one = s->reaction_count == 1;
    if (s->meets || one) {
      dashed(p, s->resultant.at, one ? s->reactions[0].at : s->meeting, TP_INK_ORANGE);
    }
    return;
  }
  if (s->meets) dashed(p, s->centroid, s->meeting, TP_INK_BLACK);
  /* The weight passes the pivot that the block is about to turn on. */
  const bool at_pivot = s->kind == TP_STATE_MOMENTS && s->own->has_toppling_pivot;
  if (!at_pivot && s->reaction_count != 1) return;
  const tp_spot pivot = at_pivot ? tp_figure_pivot_spot(p->figure, s->own, s->own->toppling_pivot)
                                 : s->reactions[0].at;
  dashed(p, s->centroid, pivot, TP_INK_BLACK);
}

static void draw_force(tp_panel *p, tp_spot tail, tp_spot tip, tp_ink ink) {
  const tp_spot a = tp_view_spot(&p->view, tail), b = tp_view_spot(&p->view, tip);
  tp_figure_ink(p->cr, ink);
  tp_figure_arrow(p->cr, a, b, FORCE_WIDTH);
  tp_label_room_line(&p->room, a, b);
}

void tp_figure_label_forces(tp_panel *p) {
  const tp_state *s = p->state;
  tp_figure_font(p->cr, TP_BODY_SIZE, true);
  tp_figure_ink(p->cr, TP_INK_BLUE);
  for (size_t k = 0; k < s->reaction_count; k++) {
    const tp_force *r = s->reactions + k;
    if (!(r->size.value > 0)) continue;
    const char *label = s->reaction_count == 1 ? "R" : k == 0 ? "R₁" : "R₂";
    const tp_spot tail = tp_view_spot(&p->view, along(r->at, r->share, -s->arrow));
    const tp_spot back = tp_view_direction(&p->view, (tp_spot){-r->share.x, -r->share.y});
    const double width = tp_figure_text_width(p->cr, label) + 2;
    tp_box box;
    if (tp_label_room_find(&box, &p->room, tail, back, width, TP_BODY_SIZE + 1, 20, false)) {
      tp_figure_text_in(p->cr, box, label);
    }
  }
}

static void draw_centroid(const tp_panel *p) {
  const tp_spot g = tp_view_spot(&p->view, p->state->centroid);
  const double radius = 2.6, quarter = 2 * atan(1);
  cairo_new_path(p->cr);
  cairo_arc(p->cr, g.x, g.y, radius, 0, 4 * quarter);
  tp_figure_ink(p->cr, TP_INK_WHITE);
  cairo_fill_preserve(p->cr);
  tp_figure_ink(p->cr, TP_INK_BLACK);
  cairo_set_line_width(p->cr, 0.6);
  cairo_stroke(p->cr);
  for (int k = 0; k < 4; k += 2) {
    cairo_move_to(p->cr, g.x, g.y);
    cairo_arc(p->cr, g.x, g.y, radius, k * quarter, (k + 1) * quarter);
    cairo_close_path(p->cr);
    cairo_fill(p->cr);
  }
}

static void draw_centre(tp_panel *p) {
  if (!p->state->shows_centre) return;
  const tp_spot c = tp_view_spot(&p->view, p->state->centre);
  const double arm = 4.5;
  tp_figure_ink(p->cr, TP_INK_VERMILION);
  cairo_set_line_width(p->cr, 1.6);
  for (int k = -1; k <= 1; k += 2) {
    cairo_move_to(p->cr, c.x - arm, c.y - k * arm);
    cairo_line_to(p->cr, c.x + arm, c.y + k * arm);
    cairo_stroke(p->cr);
    tp_label_room_line(&p->room, (tp_spot){c.x - arm, c.y - k * arm},
                       (tp_spot){c.x + arm, c.y + k * arm});
  }
}

/* Of a block as it lies: the direction of k_h and k_v at the centroid, its size not to scale. */
static void draw_earthquake(tp_panel *p) {
  const tp_state *s = p->state;
  const tp_loads_description *loads = &p->figure->problem->scene->loads;
  const double side = s->own->towards == TP_TOWARDS_LEFT ? -1 : 1;
  const double across = side * fmpq_get_d(loads->horizontal.value);
  const double up = fmpq_get_d(loads->vertical.value);
  const tp_spot push = {-across * s->gravity.y - up * s->gravity.x,
                        across * s->gravity.x - up * s->gravity.y};
  const double size = hypot(push.x, push.y);
  if (s->kind != TP_STATE_LIES || !(size > 0)) return;
  draw_force(p, s->centroid, along(s->centroid, push, 0.6 * s->arrow / size), TP_INK_GREY);
}

void tp_figure_draw_forces(tp_panel *p) {
  const tp_state *s = p->state;
  draw_lines(p);
  draw_earthquake(p);
  draw_force(p, s->centroid, along(s->centroid, s->gravity, s->arrow), TP_INK_BLACK);
  if (s->has_resultant) {
    draw_force(p, s->resultant.at, along(s->resultant.at, s->resultant.share, s->arrow),
               TP_INK_ORANGE);
  }
  for (size_t k = 0; k < s->reaction_count; k++) {
    const tp_force *r = s->reactions + k;
    draw_force(p, along(r->at, r->share, -s->arrow), r->at, TP_INK_BLUE);
  }
  draw_centroid(p);
  draw_centre(p);
}
