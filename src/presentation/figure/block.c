/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Draws the rock below the shown piece of the profile, the block with its parts and holes, and the
 * contact facets. */

#include "figure/drawn_names.h"
#include "figure/figure.h"

#include <math.h>

#define ROCK_BESIDE                                                                                \
  0.3 /* how much of a base that goes on is shown, in units of the block's size                    \
       */
#define ROCK_BELOW 0.22

/* The height of the profile at an abscissa between two of its nodes. */
static tp_spot cut(tp_spot a, tp_spot b, double x) {
  const double t = b.x > a.x ? (x - a.x) / (b.x - a.x) : 0;
  return (tp_spot){x, a.y + t * (b.y - a.y)};
}

tp_rock tp_figure_rock(const tp_figure *figure) {
  const tp_chain *base = &figure->shape.base;
  const tp_box *block = &figure->shape.box;
  tp_rock rock = {.x0 = fmax(base->nodes[0].at.x, block->x0 - ROCK_BESIDE),
                  .x1 = fmin(base->nodes[base->count - 1].at.x, block->x1 + ROCK_BESIDE),
                  .bottom = INFINITY};
  for (size_t k = 0; k < base->count; k++) {
    const tp_spot p = base->nodes[k].at;
    if (p.x >= rock.x0 && p.x <= rock.x1) rock.bottom = fmin(rock.bottom, p.y);
  }
  /* a long facet may have no node within what is shown */
  for (size_t k = 1; k < base->count; k++) {
    const tp_spot a = base->nodes[k - 1].at, b = base->nodes[k].at;
    if (a.x < rock.x0 && b.x > rock.x0) rock.bottom = fmin(rock.bottom, cut(a, b, rock.x0).y);
    if (a.x < rock.x1 && b.x > rock.x1) rock.bottom = fmin(rock.bottom, cut(a, b, rock.x1).y);
  }
  rock.bottom -= ROCK_BELOW;
  return rock;
}

/* The shown piece of the profile; false when memory is exhausted. */
static bool clip_profile(tp_chain *clipped, const tp_figure *figure, const tp_rock *rock) {
  const tp_chain *base = &figure->shape.base;
  bool done = true;
  for (size_t k = 0; k < base->count && done; k++) {
    const tp_spot p = base->nodes[k].at;
    if (k > 0) {
      const tp_spot before = base->nodes[k - 1].at;
      if (before.x < rock->x0 && p.x > rock->x0) {
        done = tp_chain_add(clipped, TP_STEP_LINE, cut(before, p, rock->x0));
      }
      if (before.x < rock->x1 && p.x > rock->x1 && done) {
        done = tp_chain_add(clipped, TP_STEP_LINE, cut(before, p, rock->x1));
      }
    }
    if (p.x < rock->x0 || p.x > rock->x1 || !done) continue;
    done = tp_chain_add(clipped, TP_STEP_LINE, p);
  }
  if (clipped->count > 0) clipped->nodes[0].step = TP_STEP_JUMP;
  return done;
}

bool tp_figure_draw_base(const tp_panel *p) {
  const tp_rock rock = tp_figure_rock(p->figure);
  tp_chain profile = {0};
  const bool done = clip_profile(&profile, p->figure, &rock);
  if (done && profile.count > 0) {
    const tp_spot right = tp_view_spot(&p->view, (tp_spot){rock.x1, rock.bottom});
    const tp_spot left = tp_view_spot(&p->view, (tp_spot){rock.x0, rock.bottom});
    tp_view_path(p->cr, &p->view, &profile);
    cairo_line_to(p->cr, right.x, right.y);
    cairo_line_to(p->cr, left.x, left.y);
    cairo_close_path(p->cr);
    tp_figure_ink(p->cr, TP_INK_ROCK);
    cairo_fill(p->cr);
    tp_view_path(p->cr, &p->view, &profile);
    const tp_chain *base = &p->figure->shape.base;
    if (base->nodes[base->count - 1].at.x <= rock.x1) cairo_line_to(p->cr, right.x, right.y);
    if (base->nodes[0].at.x >= rock.x0) {
      const tp_spot end = tp_view_spot(&p->view, profile.nodes[0].at);
      cairo_move_to(p->cr, left.x, left.y);
      cairo_line_to(p->cr, end.x, end.y);
    }
    tp_figure_ink(p->cr, TP_INK_GREY);
    cairo_set_line_width(p->cr, 0.8);
    cairo_stroke(p->cr);
  }
  tp_chain_clear(&profile);
  return done;
}

void tp_figure_draw_block(const tp_panel *p) {
  const tp_shape *shape = &p->figure->shape;
  cairo_set_fill_rule(p->cr, CAIRO_FILL_RULE_EVEN_ODD); /* holes */
  tp_view_path(p->cr, &p->view, &shape->outline);
  tp_figure_ink(p->cr, TP_INK_BLOCK);
  cairo_fill(p->cr);
  for (size_t k = 0; k < shape->part_count; k++) {
    tp_view_path(p->cr, &p->view, shape->parts + k);
    const int tint = tp_part_tint(p->figure->problem->scene, (long)k);
    tp_figure_ink(p->cr, tint == 0 ? TP_INK_PART : TP_INK_OTHER_PART);
    cairo_fill_preserve(p->cr);
    tp_figure_ink(p->cr, TP_INK_GREY);
    cairo_set_line_width(p->cr, 0.5);
    cairo_stroke(p->cr);
  }
  tp_figure_ink(p->cr, TP_INK_GREY);
  cairo_set_line_width(p->cr, 0.35);
  tp_view_path(p->cr, &p->view, &shape->elements);
  cairo_stroke(p->cr);
  tp_figure_ink(p->cr, TP_INK_BLACK);
  cairo_set_line_width(p->cr, 0.9);
  tp_view_path(p->cr, &p->view, &shape->outline);
  cairo_stroke(p->cr);
}

void tp_figure_draw_contact(const tp_panel *p) {
  tp_view_path(p->cr, &p->view, &p->figure->shape.contact);
  tp_figure_ink(p->cr, TP_INK_GREEN);
  cairo_set_line_width(p->cr, 2);
  cairo_stroke(p->cr);
}
