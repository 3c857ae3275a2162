/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The page: title, a panel for each direction of tilt, legend. Everything that is text stands above
 * or below the drawings, or where tp_label_room_find found room for it. */

#include "figure/figure.h"
#include "output/encode.h"

#include <math.h>
#include <stdlib.h>

#define WIDTH_ALONE 360.0 /* of a panel, points */
#define WIDTH_OF_TWO 270.0
#define GAP 18.0
#define HIGHEST 330.0 /* of a drawing */
#define BORDER 20.0   /* around what must be seen, for labels */

static double panel_width(const tp_figure *figure) {
  return figure->panel_count == 1 ? WIDTH_ALONE : WIDTH_OF_TWO;
}

double tp_figure_width(const tp_figure *figure) {
  const double panels = (double)figure->panel_count;
  return 2 * TP_FIGURE_MARGIN + panels * panel_width(figure) + (panels - 1) * GAP;
}

static tp_view turned(const tp_state *state, double scale) {
  return (tp_view){.cosine = cos(state->turn), .sine = sin(state->turn), .scale = scale};
}

static void include(tp_box *box, tp_spot p) {
  *box = (tp_box){fmin(box->x0, p.x), fmin(box->y0, p.y), fmax(box->x1, p.x), fmax(box->y1, p.y)};
}

static void include_force(tp_box *box, const tp_view *view, tp_spot at, tp_spot share,
                          double times) {
  include(box, tp_view_spot(view, (tp_spot){at.x + times * share.x, at.y + times * share.y}));
}

/* What is needed to see the panel: a box on a page of scale 1, the frame's origin at 0. */
static tp_box find_extent(cairo_t *cr, const tp_figure *figure, const tp_state *state) {
  const double large = 1000; /* points a unit: curves are flattened in points */
  const tp_view view = turned(state, large);
  const tp_rock rock = tp_figure_rock(figure);
  tp_box box = {0};
  tp_view_path(cr, &view, &figure->shape.outline);
  cairo_path_extents(cr, &box.x0, &box.y0, &box.x1, &box.y1);
  cairo_new_path(cr);
  const tp_box *block = &figure->shape.box;
  const double high = fmin(block->y0, rock.bottom);
  include(&box, tp_view_spot(&view, (tp_spot){rock.x0, high}));
  include(&box, tp_view_spot(&view, (tp_spot){rock.x1, high}));
  include_force(&box, &view, state->centroid, state->gravity, state->arrow);
  for (size_t k = 0; k < state->reaction_count; k++) {
    include_force(&box, &view, state->reactions[k].at, state->reactions[k].share, -state->arrow);
  }
  if (state->has_resultant) {
    include_force(&box, &view, state->resultant.at, state->resultant.share, 0);
    include_force(&box, &view, state->resultant.at, state->resultant.share, state->arrow);
  }
  if (state->meets) include(&box, tp_view_spot(&view, state->meeting));
  if (state->shows_centre) include(&box, tp_view_spot(&view, state->centre));
  return (tp_box){box.x0 / large, box.y0 / large, box.x1 / large, box.y1 / large};
}

/* One scale for all panels, so that they can be compared. */
static double fit(const tp_box extents[2], const tp_figure *figure) {
  double scale = INFINITY;
  for (size_t k = 0; k < figure->panel_count; k++) {
    const tp_box *e = extents + k;
    scale = fmin(scale, (panel_width(figure) - 2 * BORDER) / (e->x1 - e->x0));
    scale = fmin(scale, (HIGHEST - 2 * BORDER) / (e->y1 - e->y0));
  }
  return scale;
}

static bool draw_panel(cairo_t *cr, const tp_figure *figure, size_t own, const tp_box *extent,
                       double scale, tp_box area) {
  tp_panel p = {.cr = cr, .figure = figure, .state = figure->states + own};
  p.view = turned(p.state, scale);
  p.view.x = (area.x0 + area.x1) / 2 - scale * (extent->x0 + extent->x1) / 2;
  p.view.y = (area.y0 + area.y1) / 2 - scale * (extent->y0 + extent->y1) / 2;
  if (!tp_label_room_init(&p.room, cr, figure, &p.view, area)) return false;
  cairo_save(cr);
  cairo_rectangle(cr, area.x0, area.y0, area.x1 - area.x0, area.y1 - area.y0);
  cairo_clip(cr);
  const bool done = tp_figure_draw_base(&p);
  tp_figure_draw_block(&p);
  tp_figure_draw_loads(&p);
  tp_figure_draw_contact(&p);
  tp_figure_draw_forces(&p);
  tp_figure_draw_tilt(&p);
  tp_figure_draw_pivots(&p);
  tp_figure_label_forces(&p);
  tp_figure_label_tilt(&p);
  cairo_restore(cr);
  tp_label_room_clear(&p.room);
  return done;
}

/* "2 cautions: see the report." Where there are none, nothing. */
static double add_cautions(cairo_t *cr, const tp_figure *figure, double x, double y, double width) {
  const tp_notes *notes = &figure->solution->notes;
  size_t count = 0;
  for (size_t k = 0; k < notes->count; k++) count += notes->items[k].kind == TP_CAUTION;
  if (count == 0) return y;
  char line[64];
  snprintf(line, sizeof line, "%zu caution%s: see the report.", count, count == 1 ? "" : "s");
  tp_figure_ink(cr, TP_INK_BLACK);
  return tp_figure_paragraph(cr, x, y + 3, width, TP_BODY_SIZE, true, line);
}

bool tp_figure_page(double *height, cairo_t *cr, const tp_figure *figure) {
  const double left = TP_FIGURE_MARGIN, width = panel_width(figure);
  const double all = tp_figure_width(figure) - 2 * left;
  double y = left, below[2] = {0, 0}, top = 0, tall = 0;
  tp_box extents[2];
  if (figure->solution->title != NULL && !figure->sketch) {
    tp_text title = {0};
    tp_text_add(&title, "%s", ""); /* a text, also of an empty title */
    tp_encode_plain(&title, figure->solution->title);
    const bool done = !title.failed;
    tp_figure_ink(cr, TP_INK_BLACK);
    if (done) y = tp_figure_paragraph(cr, left, y, all, TP_TITLE_SIZE, true, title.data) + 3;
    free(title.data);
    if (!done) return false;
  }
  for (size_t k = 0; k < figure->panel_count; k++) {
    const double x = left + (double)k * (width + GAP);
    double end = y;
    if (!tp_figure_heading(&end, cr, figure, figure->states + k, x, width)) return false;
    top = fmax(top, end);
    extents[k] = find_extent(cr, figure, figure->states + k);
  }
  top += 3;
  const double scale = fit(extents, figure);
  for (size_t k = 0; k < figure->panel_count; k++) {
    tall = fmax(tall, scale * (extents[k].y1 - extents[k].y0) + 2 * BORDER);
  }
  for (size_t k = 0; k < figure->panel_count; k++) {
    const double x = left + (double)k * (width + GAP);
    const tp_state *state = figure->states + k;
    const tp_box area = {x, top, x + width, top + tall};
    below[k] = area.y1 + 4;
    if (!draw_panel(cr, figure, k, extents + k, scale, area) ||
        !(figure->sketch || tp_figure_verdict(below + k, cr, figure, state, x, width))) {
      return false;
    }
  }
  y = fmax(below[0], below[1]) + 5; /* so that the tables stand side by side */
  for (size_t k = 0; k < figure->panel_count && !figure->sketch; k++) {
    const double x = left + (double)k * (width + GAP);
    below[k] = tp_figure_table(cr, figure, figure->states + k, x, y, width);
  }
  y = fmax(below[0], below[1]) + 4;
  if (!tp_figure_legend(&y, cr, figure, scale, left, all)) return false;
  if (!figure->sketch) y = add_cautions(cr, figure, left, y, all);
  *height = y + left;
  return true;
}
