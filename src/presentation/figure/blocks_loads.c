/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Loads on many blocks as arrows of one length, but for those along a line, whose lengths go with
 * the pressure; bolts as bars, to scale; the surface of water. */

#include "figure/blocks.h"

#include <math.h>

#define ARROW 15.0 /* points */
#define SIGN 4.0   /* half the width of the triangle on the water */

static void draw_onto(const tp_blocks_panel *p, tp_spot at, tp_spot way, double length) {
  const tp_spot tip = tp_view_spot(&p->view, at);
  tp_figure_arrow(p->cr, (tp_spot){tip.x - length * way.x, tip.y - length * way.y}, tip, 0.9);
}

/* Down the page. */
static const tp_spot down = {0, 1};

static void draw_line_load(const tp_blocks_panel *p, const tp_load_shape *l) {
  enum { ARROWS = 6 };
  static const double least = 0.05; /* of the largest */
  const double largest = fmax(l->first, l->last);
  const tp_spot way =
      l->kind == TP_LOAD_WEIGHS
          ? down
          : tp_view_direction(&p->view, (tp_spot){l->at.y - l->to.y, l->to.x - l->at.x});
  for (int k = 0; k <= ARROWS && largest > 0; k++) {
    const double t = (double)k / ARROWS, share = (l->first + t * (l->last - l->first)) / largest;
    if (share < least) continue;
    draw_onto(p, (tp_spot){l->at.x + t * (l->to.x - l->at.x), l->at.y + t * (l->to.y - l->at.y)},
              way, ARROW * share);
  }
}

/* Its head is a disc, and its pull begins there. */
static void draw_bolt(const tp_blocks_panel *p, const tp_load_shape *l) {
  const double turn = 8 * atan(1);
  const tp_spot at = tp_view_spot(&p->view, l->at), way = tp_view_direction(&p->view, l->along);
  if (l->ends) {
    const tp_spot end = tp_view_spot(&p->view, l->to);
    cairo_new_path(p->cr);
    cairo_move_to(p->cr, at.x, at.y);
    cairo_line_to(p->cr, end.x, end.y);
    cairo_set_line_width(p->cr, 1.6);
    cairo_stroke(p->cr);
  }
  cairo_new_path(p->cr);
  cairo_arc(p->cr, at.x, at.y, 2, 0, turn);
  cairo_fill(p->cr);
  tp_figure_arrow(p->cr, at, (tp_spot){at.x + 2 * ARROW * way.x, at.y + 2 * ARROW * way.y}, 1.4);
}

/* The usual triangle stands on it; false: not within the drawing here. */
static bool mark_water(const tp_blocks_panel *p, double x) {
  const tp_chain *water = &p->figure->loads.water;
  for (size_t k = 0; k + 1 < water->count; k++) {
    const tp_spot a = tp_view_spot(&p->view, water->nodes[k].at);
    const tp_spot b = tp_view_spot(&p->view, water->nodes[k + 1].at);
    const double share = (x - a.x) / (b.x - a.x), y = a.y + share * (b.y - a.y);
    if (!(share >= 0 && share <= 1)) continue;
    if (y < p->area.y0 + 2 * SIGN || y > p->area.y1) return false;
    cairo_move_to(p->cr, x, y);
    cairo_line_to(p->cr, x + SIGN, y - 1.6 * SIGN);
    cairo_line_to(p->cr, x - SIGN, y - 1.6 * SIGN);
    cairo_close_path(p->cr);
    cairo_stroke(p->cr);
    return true;
  }
  return false;
}

static void draw_water(const tp_blocks_panel *p) {
  const tp_chain *water = &p->figure->loads.water;
  if (water->count < 2) return;
  tp_figure_ink(p->cr, TP_INK_BLUE);
  cairo_set_line_width(p->cr, 1);
  cairo_new_path(p->cr);
  for (size_t k = 0; k < water->count; k++) {
    const tp_spot at = tp_view_spot(&p->view, water->nodes[k].at);
    cairo_line_to(p->cr, at.x, at.y);
  }
  cairo_stroke(p->cr);
  const double aside = 4 * SIGN;
  if (!mark_water(p, p->area.x1 - aside) && !mark_water(p, p->area.x0 + aside)) {
    (void)mark_water(p, (p->area.x0 + p->area.x1) / 2);
  }
}

void tp_blocks_draw_loads(const tp_blocks_panel *p) {
  const tp_load_shapes *loads = &p->figure->loads;
  draw_water(p);
  tp_figure_ink(p->cr, TP_INK_PURPLE);
  for (size_t k = 0; k < loads->count; k++) {
    const tp_load_shape *l = loads->items + k;
    switch (l->kind) {
    case TP_LOAD_PRESSES:
    case TP_LOAD_WEIGHS:
      draw_line_load(p, l);
      break;
    case TP_LOAD_PULLS:
      draw_bolt(p, l);
      break;
    case TP_LOAD_PUSHES:
      draw_onto(p, l->at, tp_view_direction(&p->view, l->along), 2 * ARROW);
      break;
    }
  }
}

bool tp_blocks_pulled(const tp_blocks_figure *f, bool by_bolts) {
  for (size_t k = 0; k < f->loads.count; k++) {
    if ((f->loads.items[k].kind == TP_LOAD_PULLS) == by_bolts) return true;
  }
  return false;
}
