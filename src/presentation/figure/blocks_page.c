/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The page of many blocks: title, how they lie, the drawing, the verdict, the legend. */

#include "figure/blocks.h"
#include "output/encode.h"

#include <math.h>
#include <stdlib.h>

#define WIDTH 558.0   /* of the drawing, points */
#define HIGHEST 400.0 /* of it */
#define BORDER 10.0   /* around what must be seen, */
#define LOADED 24.0   /* and where loads stand on it */
#define BESIDE 0.1    /* how much of the ground is shown, of the size of what is free */

double tp_blocks_page_width(void) {
  return 2 * TP_FIGURE_MARGIN + WIDTH;
}

/* ---- what must be seen -------------------------------------------------------------------------
 */

static void include(tp_box *box, tp_spot p) {
  *box = (tp_box){fmin(box->x0, p.x), fmin(box->y0, p.y), fmax(box->x1, p.x), fmax(box->y1, p.y)};
}

/* On a page of scale 1: the free blocks, where they go, and what presses them; beside and below
 * these as much ground as there is, up to a share of their size. */
static tp_box find_extent(const tp_blocks_figure *f, const tp_view *view) {
  const tp_box nothing = {INFINITY, INFINITY, -INFINITY, -INFINITY};
  tp_box free = nothing, all = nothing;
  for (size_t k = 0; k < f->shapes.count; k++) {
    const tp_chain *outline = &f->shapes.blocks[k].outline;
    for (size_t n = 0; n < outline->count; n++) {
      const tp_spot at = outline->nodes[n].at;
      include(&all, tp_view_spot(view, at));
      if (f->system->blocks[k].ground) continue;
      include(&free, tp_view_spot(view, at));
      include(&free, tp_view_spot(view, tp_blocks_moved(f, k, at)));
    }
  }
  for (size_t k = 0; k < f->own->force_count; k++) {
    tp_spot from, to;
    if (tp_blocks_force(&from, &to, f, k)) include(&free, tp_view_spot(view, from));
  }
  const double beside = BESIDE * fmax(free.x1 - free.x0, free.y1 - free.y0);
  return (tp_box){
      fmin(free.x0, fmax(free.x0 - beside, all.x0)), fmin(free.y0, fmax(free.y0 - beside, all.y0)),
      fmax(free.x1, fmin(free.x1 + beside, all.x1)), fmax(free.y1, fmin(free.y1 + beside, all.y1))};
}

/* ---- the page ----------------------------------------------------------------------------------
 */

static bool draw_panel(tp_blocks_panel *p) {
  const tp_box *area = &p->area;
  cairo_save(p->cr);
  cairo_rectangle(p->cr, area->x0, area->y0, area->x1 - area->x0, area->y1 - area->y0);
  cairo_clip(p->cr);
  bool done = tp_blocks_draw_ground(p);
  tp_blocks_draw_free(p);
  done = done && tp_blocks_draw_mechanism(p);
  done = done && tp_blocks_draw_forces(p);
  tp_blocks_draw_loads(p);
  done = done && tp_blocks_draw_names(p);
  cairo_restore(p->cr);
  free(p->arrows);
  return done;
}

static bool draw_title(double *y, cairo_t *cr, const char *outside) {
  if (outside == NULL) return true;
  tp_text title = {0};
  tp_text_add(&title, "%s", ""); /* a text, also of an empty title */
  tp_encode_plain(&title, outside);
  const bool done = !title.failed;
  tp_figure_ink(cr, TP_INK_BLACK);
  if (done) {
    *y = tp_figure_paragraph(cr, TP_FIGURE_MARGIN, *y, WIDTH, TP_TITLE_SIZE, true, title.data) + 3;
  }
  tp_text_drop(&title);
  return done;
}

bool tp_blocks_page(double *height, cairo_t *cr, const tp_blocks_figure *f) {
  const double left = TP_FIGURE_MARGIN;
  double y = left;
  if (!f->sketch && !draw_title(&y, cr, f->system->title)) return false;
  if (!tp_blocks_heading(&y, cr, f, left, WIDTH)) return false;
  tp_view view = {.cosine = cos(f->turn), .sine = sin(f->turn), .scale = 1};
  const tp_box extent = find_extent(f, &view);
  const double border = f->loads.count > 0 ? LOADED : BORDER;
  view.scale = fmin((WIDTH - 2 * border) / (extent.x1 - extent.x0),
                    (HIGHEST - 2 * border) / (extent.y1 - extent.y0));
  const double tall = view.scale * (extent.y1 - extent.y0) + 2 * border;
  view.x = left + WIDTH / 2 - view.scale * (extent.x0 + extent.x1) / 2;
  view.y = y + tall / 2 - view.scale * (extent.y0 + extent.y1) / 2;
  tp_blocks_panel panel = {
      .cr = cr, .figure = f, .view = view, .area = {left, y, left + WIDTH, y + tall}};
  if (!draw_panel(&panel)) return false;
  y += tall + 4;
  if (!f->sketch && !tp_blocks_verdict(&y, cr, f, left, WIDTH)) return false;
  *height = tp_blocks_legend(&panel, left, y + 4, WIDTH) + left;
  return true;
}
