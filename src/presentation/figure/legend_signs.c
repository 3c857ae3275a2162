/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A legend: the scale bar, and signs with their words, on as many lines as they take. */

#include "figure/legend.h"

#include <math.h>
#include <stdio.h>

#define SWATCH_WIDTH 18.0
#define PITCH 12.0

/* A length of 1, 2 or 5 times a power of ten, at most `longest`. */
static double round_length(double longest) {
  const double power = pow(10, floor(log10(longest)));
  const double ratio = longest / power;
  return (ratio >= 5 ? 5 : ratio >= 2 ? 2 : 1) * power;
}

static double scale_bar(cairo_t *cr, const tp_legend *l, double x, double y) {
  const double most_points = 90;
  const double length = round_length(most_points / l->points), points = length * l->points;
  char text[64];
  snprintf(text, sizeof text, "%.7g %s", length, l->length_unit);
  if (l->comma) tp_language_set_commas(text);
  tp_figure_ink(cr, TP_INK_BLACK);
  cairo_set_line_width(cr, 1);
  cairo_move_to(cr, x, y - 5.5);
  cairo_line_to(cr, x, y - 0.5);
  cairo_move_to(cr, x, y - 3);
  cairo_line_to(cr, x + points, y - 3);
  cairo_move_to(cr, x + points, y - 5.5);
  cairo_line_to(cr, x + points, y - 0.5);
  cairo_stroke(cr);
  tp_figure_font(cr, TP_BODY_SIZE, false);
  tp_figure_text(cr, x + points + 5, y, text);
  return points + 5 + tp_figure_text_width(cr, text);
}

static void draw_swatch(cairo_t *cr, const tp_legend_entry *e, double x, double y) {
  static const double dashes[] = {3, 2};
  const double middle = y - 3, right = x + SWATCH_WIDTH - 4;
  tp_figure_ink(cr, e->ink);
  cairo_save(cr);
  cairo_new_path(cr);
  switch (e->sign) {
  case TP_SIGN_TINT:
    cairo_rectangle(cr, x, middle - 3.5, SWATCH_WIDTH - 4, 7);
    cairo_fill_preserve(cr);
    tp_figure_ink(cr, TP_INK_GREY);
    cairo_set_line_width(cr, 0.4);
    cairo_stroke(cr);
    break;
  case TP_SIGN_LINE:
  case TP_SIGN_THIN:
  case TP_SIGN_DASHES:
    cairo_set_line_width(cr, e->sign == TP_SIGN_LINE ? 2 : 0.6);
    if (e->sign == TP_SIGN_DASHES) cairo_set_dash(cr, dashes, 2, 0);
    cairo_move_to(cr, x, middle);
    cairo_line_to(cr, right, middle);
    cairo_stroke(cr);
    break;
  case TP_SIGN_ARROW:
    tp_figure_arrow(cr, (tp_spot){x, middle}, (tp_spot){right, middle}, 1.4);
    break;
  case TP_SIGN_CROSS:
    cairo_set_line_width(cr, 1.6);
    cairo_move_to(cr, x + 3, middle - 4);
    cairo_line_to(cr, x + 11, middle + 4);
    cairo_move_to(cr, x + 3, middle + 4);
    cairo_line_to(cr, x + 11, middle - 4);
    cairo_stroke(cr);
    break;
  case TP_SIGN_DISC:
  case TP_SIGN_CENTROID:
    cairo_arc(cr, x + 7, middle, 3, 0, 8 * atan(1));
    tp_figure_ink(cr, e->sign == TP_SIGN_DISC ? e->ink : TP_INK_WHITE);
    cairo_fill_preserve(cr);
    tp_figure_ink(cr, TP_INK_BLACK);
    cairo_set_line_width(cr, 0.5);
    cairo_stroke(cr);
    for (int k = 0; k < 4 && e->sign == TP_SIGN_CENTROID; k += 2) {
      cairo_move_to(cr, x + 7, middle);
      cairo_arc(cr, x + 7, middle, 3, k * 2 * atan(1), (k + 1) * 2 * atan(1));
      cairo_close_path(cr);
      cairo_fill(cr);
    }
    break;
  }
  cairo_restore(cr);
}

/* Where an entry ends on its line; before it a new one where it does not fit. */
static double draw_entry(double *y, cairo_t *cr, const tp_legend *l, const tp_legend_entry *e,
                         double at, double x, double width) {
  char text[TP_LINE_SIZE];
  snprintf(text, sizeof text, "%s", tp_say(l->language, e->text));
  tp_figure_font(cr, TP_BODY_SIZE, false);
  tp_figure_shorten(cr, text, width - SWATCH_WIDTH);
  const double needed = SWATCH_WIDTH + tp_figure_text_width(cr, text);
  if (at > x && at + needed > x + width) {
    at = x;
    *y += PITCH;
  }
  draw_swatch(cr, e, at, *y);
  tp_figure_ink(cr, TP_INK_BLACK);
  tp_figure_text(cr, at + SWATCH_WIDTH, *y, text);
  return at + needed + 10;
}

double tp_legend_draw(cairo_t *cr, const tp_legend *l, double x, double y, double width) {
  y += PITCH;
  double at = x + scale_bar(cr, l, x, y) + 14;
  for (size_t k = 0; k < l->count; k++) {
    if (l->entries[k].shown) at = draw_entry(&y, cr, l, l->entries + k, at, x, width);
  }
  return y + 2;
}
