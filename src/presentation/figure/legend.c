/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The scale bar, and what the colours and signs mean: those that the figure uses. */

#include "figure/drawn_names.h"
#include "figure/figure.h"

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

static double scale_bar(cairo_t *cr, const tp_figure *figure, double scale, double x, double y) {
  const double most_points = 90;
  const double unit = figure->shape.unit_m / figure->solution->metres_per_unit; /* scene lengths */
  const double length = round_length(most_points / scale * unit), points = length / unit * scale;
  char text[64];
  snprintf(text, sizeof text, "%.7g %s", length, figure->solution->length_unit);
  tp_figure_set_decimals(figure, text);
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

typedef enum swatch { TINT, LINE, THIN, DASHES, ARROW, CROSS, DISC, CENTROID } swatch;

typedef struct entry {
  bool shown;
  swatch swatch;
  tp_ink ink;
  const char *text;
} entry;

static void draw_swatch(cairo_t *cr, const entry *e, double x, double y) {
  static const double dashes[] = {3, 2};
  const double middle = y - 3, right = x + SWATCH_WIDTH - 4;
  tp_figure_ink(cr, e->ink);
  cairo_save(cr);
  cairo_new_path(cr);
  switch (e->swatch) {
  case TINT:
    cairo_rectangle(cr, x, middle - 3.5, SWATCH_WIDTH - 4, 7);
    cairo_fill_preserve(cr);
    tp_figure_ink(cr, TP_INK_GREY);
    cairo_set_line_width(cr, 0.4);
    cairo_stroke(cr);
    break;
  case LINE:
  case THIN:
  case DASHES:
    cairo_set_line_width(cr, e->swatch == LINE ? 2 : 0.6);
    if (e->swatch == DASHES) cairo_set_dash(cr, dashes, 2, 0);
    cairo_move_to(cr, x, middle);
    cairo_line_to(cr, right, middle);
    cairo_stroke(cr);
    break;
  case ARROW:
    tp_figure_arrow(cr, (tp_spot){x, middle}, (tp_spot){right, middle}, 1.4);
    break;
  case CROSS:
    cairo_set_line_width(cr, 1.6);
    cairo_move_to(cr, x + 3, middle - 4);
    cairo_line_to(cr, x + 11, middle + 4);
    cairo_move_to(cr, x + 3, middle + 4);
    cairo_line_to(cr, x + 11, middle - 4);
    cairo_stroke(cr);
    break;
  case DISC:
  case CENTROID:
    cairo_arc(cr, x + 7, middle, 3, 0, 8 * atan(1));
    tp_figure_ink(cr, e->swatch == DISC ? e->ink : TP_INK_WHITE);
    cairo_fill_preserve(cr);
    tp_figure_ink(cr, TP_INK_BLACK);
    cairo_set_line_width(cr, 0.5);
    cairo_stroke(cr);
    for (int k = 0; k < 4 && e->swatch == CENTROID; k += 2) {
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
static double draw_entry(double *y, cairo_t *cr, const tp_figure *figure, const entry *e, double at,
                         double x, double width) {
  char text[TP_LINE_SIZE];
  snprintf(text, sizeof text, "%s", tp_figure_word(figure, e->text));
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

/* Is a bolt drawn with its length? */
static bool has_length(const tp_loads_description *loads) {
  bool any = false;
  for (long k = 0; k < loads->anchor_count; k++) any = any || loads->anchors[k].length.given;
  return any;
}

static void draw_legend(double *y, cairo_t *cr, const tp_figure *figure,
                        const tp_drawn_names *names, double scale, double x, double width) {
  bool reacts = false, shakes = false, lines = false, turns = false, combined = false,
       governs = false;
  for (size_t k = 0; k < figure->panel_count; k++) {
    const tp_state *s = figure->states + k;
    reacts = reacts || s->reaction_count > 0;
    lines = lines || s->reaction_count > 0 || s->meets;
    shakes = shakes || s->kind == TP_STATE_LIES;
    combined = combined || s->has_resultant;
    turns = turns || s->shows_centre;
    governs = governs || s->own->has_toppling_pivot;
  }
  const tp_loads_description *loads = &figure->problem->scene->loads;
  const tp_drawn *drawn = figure->problem->scene->drawn;
  const entry entries[] = {
      {true, TINT, TP_INK_BLOCK, names->block.data},
      {drawn != NULL && drawn->hole_count > 0, TINT, TP_INK_WHITE, names->hole.data},
      {names->has_part[0], TINT, TP_INK_PART, names->parts[0].data},
      {names->has_part[1], TINT, TP_INK_OTHER_PART, names->parts[1].data},
      {figure->shape.elements.count > 0, THIN, TP_INK_GREY, "element"},
      {true, TINT, TP_INK_ROCK, names->base.data},
      {figure->shape.contact.count > 0, LINE, TP_INK_GREEN, "contact"},
      {true, CENTROID, TP_INK_BLACK, "centroid"},
      {true, ARROW, TP_INK_BLACK, "weight W"},
      {shakes && loads->horizontal.given, ARROW, TP_INK_GREY, "earthquake"},
      {combined, ARROW, TP_INK_ORANGE, "weight and loads"},
      {reacts, ARROW, TP_INK_BLUE, "reaction R of the base"},
      {lines, DASHES, TP_INK_GREY, "line of action"},
      {turns, CROSS, TP_INK_VERMILION, "centre of rotation"},
      {true, DISC, TP_INK_WHITE, "pivot"},
      {governs, DISC, TP_INK_VERMILION, "governing pivot"},
      {loads->water.given, TINT, TP_INK_SKY, "water pressure"},
      {loads->anchor_count > 0, ARROW, TP_INK_PURPLE, "anchor"},
      {!fmpq_is_zero(loads->water.ice_kpa.value), ARROW, TP_INK_PURPLE, "ice"},
      {loads->pressure_count + loads->surcharge_count > 0, ARROW, TP_INK_PURPLE,
       "pressure or surcharge"},
      {loads->support_count > 0, ARROW, TP_INK_PURPLE, "pressure of a lining or a wall"},
      {has_length(loads), LINE, TP_INK_PURPLE, "length of bolts beyond the block"}};
  *y += PITCH;
  double at = x + scale_bar(cr, figure, scale, x, *y) + 14;
  for (size_t k = 0; k < sizeof entries / sizeof entries[0]; k++) {
    if (entries[k].shown) at = draw_entry(y, cr, figure, entries + k, at, x, width);
  }
  *y += 2;
  if (names->unused.length == 0) return;
  *y = tp_figure_paragraph(cr, x, *y + 3, width, TP_BODY_SIZE, false, names->unused.data);
}

bool tp_figure_legend(double *y, cairo_t *cr, const tp_figure *figure, double scale, double x,
                      double width) {
  tp_drawn_names names;
  const bool done = tp_drawn_names_init(&names, figure);
  if (done) draw_legend(y, cr, figure, &names, scale, x, width);
  tp_drawn_names_clear(&names);
  return done;
}
