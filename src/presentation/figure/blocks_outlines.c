/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Draws the ground, the free blocks by how they move, and where the mechanism takes them. */

#include "figure/blocks.h"

#include <math.h>

#define OUTLINE_WIDTH 0.7

/* ---- the ground --------------------------------------------------------------------------------
 */

/* One side of a box: what lies beyond it is cut off. */
typedef struct edge {
  bool across; /* of x, else of y */
  double sign, at;
} edge;

static double inside(const edge *e, tp_spot p) {
  return e->sign * ((e->across ? p.x : p.y) - e->at);
}

/* A ring with what lies beyond one side of a box cut off (Sutherland and Hodgman 1974); what is
 * left of it may run along that side. */
static bool cut(tp_chain *kept, const tp_chain *ring, const edge *e) {
  bool done = true;
  for (size_t k = 0; k < ring->count && done; k++) {
    const tp_spot p = ring->nodes[k].at, q = ring->nodes[k + 1 < ring->count ? k + 1 : 0].at;
    const double a = inside(e, p), b = inside(e, q);
    const tp_chain_step step = kept->count == 0 ? TP_STEP_JUMP : TP_STEP_LINE;
    if (a >= 0) done = tp_chain_add(kept, step, p);
    if ((a >= 0) == (b >= 0) || !done) continue;
    const double t = a / (a - b);
    const tp_spot between = {p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)};
    done = tp_chain_add(kept, kept->count == 0 ? TP_STEP_JUMP : TP_STEP_LINE, between);
  }
  return done;
}

/* The ring on the page, cut at twice the area: Cairo's coordinates are bounded, and ground may be
 * much larger than what is seen of it. */
static bool clip(tp_chain *ring, const tp_box *area) {
  const double width = area->x1 - area->x0, height = area->y1 - area->y0;
  const edge edges[] = {{true, 1, area->x0 - width / 2},
                        {true, -1, area->x1 + width / 2},
                        {false, 1, area->y0 - height / 2},
                        {false, -1, area->y1 + height / 2}};
  for (size_t k = 0; k < sizeof edges / sizeof edges[0]; k++) {
    tp_chain kept = {.closed = true};
    const bool done = cut(&kept, ring, edges + k);
    tp_chain_clear(ring);
    *ring = kept;
    if (!done) return false;
  }
  return true;
}

/* All pieces of a chain, clipped, as one path. */
static bool clipped_path(const tp_blocks_panel *p, const tp_chain *chain) {
  bool done = true;
  cairo_new_path(p->cr);
  for (size_t k = 0; k < chain->count && done;) {
    tp_chain ring = {.closed = true};
    do {
      done = tp_chain_add(&ring, TP_STEP_LINE, tp_view_spot(&p->view, chain->nodes[k++].at));
    } while (k < chain->count && chain->nodes[k].step != TP_STEP_JUMP && done);
    done = done && clip(&ring, &p->area);
    for (size_t n = 0; n < ring.count && done; n++) {
      const tp_spot at = ring.nodes[n].at;
      (n == 0 ? cairo_move_to : cairo_line_to)(p->cr, at.x, at.y);
    }
    if (ring.count > 0) cairo_close_path(p->cr);
    tp_chain_clear(&ring);
  }
  return done;
}

bool tp_blocks_draw_ground(const tp_blocks_panel *p) {
  const tp_blocks_figure *f = p->figure;
  bool done = true;
  cairo_set_fill_rule(p->cr, CAIRO_FILL_RULE_EVEN_ODD); /* holes */
  for (size_t k = 0; k < f->shapes.count && done; k++) {
    if (!f->system->blocks[k].ground) continue;
    done = clipped_path(p, &f->shapes.blocks[k].outline);
    tp_figure_ink(p->cr, TP_INK_ROCK);
    cairo_fill_preserve(p->cr);
    tp_figure_ink(p->cr, TP_INK_GREY);
    cairo_set_line_width(p->cr, 0.8);
    cairo_stroke(p->cr);
  }
  return done;
}

/* ---- free blocks -------------------------------------------------------------------------------
 */

void tp_blocks_draw_free(const tp_blocks_panel *p) {
  const tp_blocks_figure *f = p->figure;
  cairo_set_fill_rule(p->cr, CAIRO_FILL_RULE_EVEN_ODD);
  for (size_t k = 0; k < f->shapes.count; k++) {
    const tp_block_shape *own = f->shapes.blocks + k;
    if (f->system->blocks[k].ground) continue;
    tp_view_path(p->cr, &p->view, &own->outline);
    tp_figure_ink(p->cr, tp_blocks_tint(f, k));
    cairo_fill_preserve(p->cr);
    tp_figure_ink(p->cr, TP_INK_BLACK);
    cairo_set_line_width(p->cr, OUTLINE_WIDTH);
    cairo_stroke(p->cr);
    tp_view_path(p->cr, &p->view, &own->parts);
    tp_figure_ink(p->cr, TP_INK_GREY);
    cairo_set_line_width(p->cr, 0.5);
    cairo_stroke(p->cr);
  }
}

/* The outline where the mechanism takes it, as far as its beginning goes on; empty where no printer
 * tells it from where it is. */
static bool moved_path(const tp_blocks_panel *p, size_t block) {
  const double least = 0.7;
  const tp_chain *outline = &p->figure->shapes.blocks[block].outline;
  tp_chain moved = {.closed = true};
  bool done = true;
  double most = 0;
  for (size_t k = 0; k < outline->count && done; k++) {
    const tp_chain_node *node = outline->nodes + k;
    const tp_spot to = tp_blocks_moved(p->figure, block, node->at);
    most = fmax(most, p->view.scale * hypot(to.x - node->at.x, to.y - node->at.y));
    done = tp_chain_add(&moved, node->step, to);
  }
  cairo_new_path(p->cr);
  if (done && most > least) tp_view_path(p->cr, &p->view, &moved);
  tp_chain_clear(&moved);
  return done;
}

bool tp_blocks_draw_mechanism(const tp_blocks_panel *p) {
  static const double dashes[] = {3, 2};
  bool done = true;
  cairo_save(p->cr);
  cairo_set_dash(p->cr, dashes, 2, 0);
  cairo_set_line_width(p->cr, 0.6);
  tp_figure_ink(p->cr, TP_INK_VERMILION);
  for (size_t k = 0; k < p->figure->shapes.count && done; k++) {
    if (!tp_blocks_moves(p->figure, k)) continue;
    done = moved_path(p, k);
    cairo_stroke(p->cr);
  }
  cairo_restore(p->cr);
  return done;
}
