/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Rows of chosen moments of a tilt test drawn by Cairo at half the size of the view, table turned
 * by its tilt, with words above and below. */

#include "figure/tilt_frames.h"

#include "report/tilt_svg.h"
#include "report/words.h"

#include <math.h>
#include <stdio.h>

#define HALF 0.5   /* frames are drawn at half the size of the view */
#define BELOW 44.0 /* for words above and below a row */

static void trace(cairo_t *cr, const tp_tilt_view *view, const tp_tilt_point *points,
                  size_t count) {
  for (size_t k = 0; k < count; k++) {
    cairo_line_to(cr, tp_tilt_view_x(view, points[k].x_m), tp_tilt_view_y(view, points[k].y_m));
  }
  cairo_close_path(cr);
}

static void draw_frame(cairo_t *cr, const tp_tilt_view *view, const tp_tilt_moment *m) {
  static const double dashes[] = {4, 3};
  const tp_tilt_case *own = view->own;
  cairo_scale(cr, HALF, HALF);
  cairo_rectangle(cr, 0, 0, view->width, view->height);
  cairo_clip(cr);
  cairo_translate(cr, -view->left, -view->top);
  cairo_rotate(cr, tp_tilt_view_turn(view, m->angle_deg) * (M_PI / 180));
  trace(cr, view, own->base, own->base_count);
  tp_figure_ink(cr, TP_INK_ROCK);
  cairo_fill_preserve(cr);
  tp_figure_ink(cr, TP_INK_BLACK);
  cairo_set_line_width(cr, 1);
  cairo_stroke(cr);
  trace(cr, view, own->outline, own->outline_count);
  tp_figure_ink(cr, TP_INK_GREY);
  cairo_set_dash(cr, dashes, 2, 0);
  cairo_stroke(cr);
  cairo_set_dash(cr, dashes, 0, 0);
  cairo_translate(cr, view->scale * m->moved_x_m, -view->scale * m->moved_y_m);
  cairo_rotate(cr, -m->turned_deg * (M_PI / 180));
  trace(cr, view, own->outline, own->outline_count);
  tp_figure_ink(cr, TP_INK_BLOCK);
  cairo_fill_preserve(cr);
  tp_figure_ink(cr, TP_INK_BLACK);
  cairo_set_line_width(cr, 1.5);
  cairo_stroke(cr);
}

static void draw_row(cairo_t *cr, const tp_tilt_test *test, const tp_tilt_view *view, double top) {
  size_t chosen[TP_TILT_FRAMES] = {0};
  const size_t count = tp_tilt_frames_choose(chosen, view);
  const tp_tilt_engine engine = test->settings.engine;
  char words[160];
  tp_figure_ink(cr, TP_INK_BLACK);
  tp_figure_font(cr, 12, false);
  snprintf(words, sizeof words, "%s, %s: %s", tp_text_table(test, view->own),
           tp_tilt_engine_name(engine), tp_tilt_end_name(view->own->end));
  tp_figure_text(cr, 8, top + 16, words);
  for (size_t k = 0; k < count; k++) {
    const tp_tilt_moment *m = view->own->moments + chosen[k];
    const double left = (double)k * view->width * HALF;
    cairo_save(cr);
    cairo_translate(cr, left, top + 22);
    draw_frame(cr, view, m);
    cairo_restore(cr);
    tp_figure_ink(cr, TP_INK_BLACK);
    tp_figure_font(cr, 12, false);
    if (engine == TP_TILT_PATH) {
      snprintf(words, sizeof words, "tilt %.2f°", m->angle_deg);
    } else {
      snprintf(words, sizeof words, "tilt %.2f°, %.3g s", m->angle_deg, m->time_s);
    }
    tp_figure_text(cr, left + 8, top + 22 + view->height * HALF + 14, words);
  }
}

static bool draw(cairo_t *cr, const void *context) {
  const tp_tilt_test *test = context;
  double top = 0;
  for (size_t k = 0; k < test->case_count; k++) {
    const tp_tilt_view view = tp_tilt_view_of(test->cases + k);
    draw_row(cr, test, &view, top);
    top += view.height * HALF + BELOW;
  }
  return true;
}

tp_vector_picture tp_tilt_frames_drawing(const tp_tilt_test *test) {
  tp_vector_picture own = {draw, test, 0, 0};
  for (size_t k = 0; k < test->case_count; k++) {
    const tp_tilt_view view = tp_tilt_view_of(test->cases + k);
    own.width = fmax(own.width, TP_TILT_FRAMES * view.width * HALF);
    own.height += view.height * HALF + BELOW;
  }
  return own;
}
