/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Rows of chosen moments of a tilt test drawn by Cairo at half the size of the view, table turned
 * by its tilt, with words above and below. */

#include "figure/tilt_frames.h"

#include "report/tilt_svg.h"
#include "report/tilt_turn.h"
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

/* Words of the drawing, which are dropped. */
static void draw_words(cairo_t *cr, double x, double y, tp_text *words) {
  tp_figure_ink(cr, TP_INK_BLACK);
  tp_figure_font(cr, 12, false);
  if (words->data != NULL && !words->failed) tp_figure_text(cr, x, y, words->data);
  tp_text_drop(words);
}

static void draw_row(cairo_t *cr, const tp_tilt_drawing *d, const tp_tilt_view *view, double top) {
  size_t chosen[TP_TILT_FRAMES] = {0};
  const size_t count = tp_tilt_frames_choose(chosen, view);
  tp_text head = {0};
  tp_tilt_frames_head(&head, d->test, view->own, d->language, d->comma);
  draw_words(cr, 8, top + 16, &head);
  for (size_t k = 0; k < count; k++) {
    const tp_tilt_moment *m = view->own->moments + chosen[k];
    const double left = (double)k * view->width * HALF;
    cairo_save(cr);
    cairo_translate(cr, left, top + 22);
    draw_frame(cr, view, m);
    cairo_restore(cr);
    tp_text foot = {0};
    tp_tilt_frames_foot(&foot, d->test, m, d->language, d->comma);
    draw_words(cr, left + 8, top + 22 + view->height * HALF + 14, &foot);
  }
}

static void draw_level(cairo_t *cr, const tp_turn_strip *s, double turned_deg) {
  const double y = tp_turn_strip_y(s, turned_deg);
  cairo_move_to(cr, tp_turn_strip_x(s, 0), y);
  cairo_line_to(cr, tp_turn_strip_x(s, s->end_s), y);
  cairo_stroke(cr);
}

static void draw_strip(cairo_t *cr, const tp_tilt_drawing *d, const tp_turn_strip *s, double top) {
  static const double dashes[] = {5, 3};
  const tp_tilt_case *own = s->own;
  double balance = 0;
  tp_text words = {0};
  if (s->height == 0) return;
  cairo_save(cr);
  cairo_translate(cr, 0, top);
  tp_turn_strip_words(&words, s, d->language, d->comma);
  draw_words(cr, 8, 12, &words);
  cairo_set_line_width(cr, 1);
  tp_figure_ink(cr, TP_INK_GREY);
  draw_level(cr, s, 0);
  cairo_set_dash(cr, dashes, 2, 0);
  tp_figure_ink(cr, TP_INK_BLACK);
  if (tp_turn_strip_balance(&balance, s)) draw_level(cr, s, balance);
  cairo_set_dash(cr, dashes, 0, 0);
  tp_figure_ink(cr, TP_INK_BLUE);
  for (size_t k = 0; k < own->moment_count && own->moments[k].time_s <= s->end_s; k++) {
    cairo_line_to(cr, tp_turn_strip_x(s, own->moments[k].time_s),
                  tp_turn_strip_y(s, own->moments[k].turned_deg));
  }
  cairo_stroke(cr);
  cairo_arc(cr, tp_turn_strip_x(s, own->peak_turn_s), tp_turn_strip_y(s, own->peak_turn_deg), 2.5,
            0, 2 * M_PI);
  cairo_fill(cr);
  cairo_restore(cr);
}

static bool draw(cairo_t *cr, const void *context) {
  const tp_tilt_drawing *drawing = context;
  const tp_tilt_test *test = drawing->test;
  double top = 0;
  for (size_t k = 0; k < test->case_count; k++) {
    const tp_tilt_view view = tp_tilt_view_of(test->cases + k);
    draw_row(cr, drawing, &view, top);
    top += view.height * HALF + BELOW;
    const tp_turn_strip strip = tp_turn_strip_of(&view);
    draw_strip(cr, drawing, &strip, top);
    top += strip.height;
  }
  return true;
}

tp_vector_picture tp_tilt_frames_drawing(const tp_tilt_drawing *drawing) {
  const tp_tilt_test *test = drawing->test;
  tp_vector_picture own = {draw, drawing, 0, 0};
  for (size_t k = 0; k < test->case_count; k++) {
    const tp_tilt_view view = tp_tilt_view_of(test->cases + k);
    own.width = fmax(own.width, TP_TILT_FRAMES * view.width * HALF);
    own.height += view.height * HALF + BELOW + tp_turn_strip_of(&view).height;
  }
  return own;
}
