/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* From the block's metres to points of the page, and what is drawn there by Cairo. */

#include "figure/figure.h"

#include <math.h>

tp_spot tp_view_spot(const tp_view *v, tp_spot p) {
  return (tp_spot){v->x + v->scale * (v->cosine * p.x - v->sine * p.y),
                   v->y - v->scale * (v->sine * p.x + v->cosine * p.y)};
}

tp_spot tp_view_direction(const tp_view *v, tp_spot d) {
  const double length = hypot(d.x, d.y);
  return (tp_spot){(v->cosine * d.x - v->sine * d.y) / length,
                   -(v->sine * d.x + v->cosine * d.y) / length};
}

bool tp_spot_meet(tp_spot *at, tp_spot p, tp_spot u, tp_spot q, tp_spot v) {
  const double cross = u.x * v.y - u.y * v.x;
  if (fabs(cross) < 1e-4 * hypot(u.x, u.y) * hypot(v.x, v.y)) return false;
  const double t = ((q.x - p.x) * v.y - (q.y - p.y) * v.x) / cross;
  *at = (tp_spot){p.x + t * u.x, p.y + t * u.y};
  return true;
}

bool tp_figure_in_sight(const tp_figure *figure, tp_spot p) {
  const tp_box *b = &figure->shape.box;
  const double away_x = fmax(fmax(b->x0 - p.x, p.x - b->x1), 0);
  const double away_y = fmax(fmax(b->y0 - p.y, p.y - b->y1), 0);
  return hypot(away_x, away_y) < 0.8;
}

/* Draw the chain, or with cr NULL only count its nodes, dropping straight steps shorter than
 * `finest` points. */
static size_t trace(cairo_t *cr, const tp_view *view, const tp_chain *chain, double finest) {
  size_t kept = 0;
  tp_spot last = {0, 0};
  for (size_t k = 0; k < chain->count; k++) {
    const tp_chain_node *node = chain->nodes + k;
    const bool ends = k + 1 == chain->count || chain->nodes[k + 1].step != TP_STEP_LINE;
    const tp_spot at = tp_view_spot(view, node->at);
    const bool near = hypot(at.x - last.x, at.y - last.y) < finest;
    if (node->step == TP_STEP_LINE && near && !ends) continue;
    kept++;
    last = at;
    if (cr == NULL) continue;
    if (node->step == TP_STEP_JUMP) {
      if (chain->closed && k > 0) cairo_close_path(cr);
      cairo_move_to(cr, at.x, at.y);
    } else if (node->step == TP_STEP_LINE) {
      cairo_line_to(cr, at.x, at.y);
    } else {
      const tp_spot a = tp_view_spot(view, node->control[0]);
      const tp_spot b = tp_view_spot(view, node->control[1]);
      cairo_curve_to(cr, a.x, a.y, b.x, b.y, at.x, at.y);
    }
  }
  if (cr != NULL && chain->closed && chain->count > 0) cairo_close_path(cr);
  return kept;
}

void tp_view_path(cairo_t *cr, const tp_view *view, const tp_chain *chain) {
  enum { MOST_NODES = 8000 };
  double finest = 0.08;
  while (finest < 2 && trace(NULL, view, chain, finest) > MOST_NODES) finest *= 1.5;
  cairo_new_path(cr);
  trace(cr, view, chain, finest);
}

void tp_figure_ink(cairo_t *cr, tp_ink ink) {
  static const double colours[][3] = {[TP_INK_BLACK] = {0.08, 0.08, 0.08},
                                      [TP_INK_GREY] = {0.45, 0.45, 0.45},
                                      [TP_INK_WHITE] = {1, 1, 1},
                                      [TP_INK_ROCK] = {0.89, 0.88, 0.86},
                                      [TP_INK_BLOCK] = {0.84, 0.925, 0.975},
                                      [TP_INK_PART] = {0.985, 0.90, 0.68},
                                      [TP_INK_OTHER_PART] = {0.97, 0.95, .6},
                                      [TP_INK_TOPPLES] = {0.95, 0.72, 0.58},
                                      [TP_INK_SLIDES_AND_TOPPLES] = {0.80, 0.66, 0.80},
                                      [TP_INK_ORANGE] = {0.902, 0.624, 0},
                                      [TP_INK_SKY] = {0.337, 0.706, 0.914},
                                      [TP_INK_GREEN] = {0, 0.62, 0.451},
                                      [TP_INK_BLUE] = {0, 0.447, 0.698},
                                      [TP_INK_VERMILION] = {0.835, 0.369, 0},
                                      [TP_INK_PURPLE] = {0.8, 0.475, 0.655}};
  cairo_set_source_rgb(cr, colours[ink][0], colours[ink][1], colours[ink][2]);
}
