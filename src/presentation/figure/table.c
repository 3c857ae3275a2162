/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Table of pivots below a panel, with columns as wide as their widest cell and smaller letters
 * where space is short. */

#include "figure/figure.h"
#include "report/pivots.h"
#include "report/words.h"
#include "terms/names.h"

#include <math.h>
#include <stdio.h>

/* Columns: the disc with its number, then what is known of the pivot. */
enum { COLUMNS = 7, ROWS = TP_PIVOTS_LISTED + 1, CELL_SIZE = 64 };
enum { NUMBER, KIND, X, Y, ANGLE, FACTOR, TURNING };

typedef struct table {
  size_t rows; /* the first is the head */
  char cells[ROWS][COLUMNS][CELL_SIZE];
  double widths[COLUMNS], gap, size;
} table;

static void fill_head(table *t, const tp_figure *figure) {
  const char *unit = figure->solution->length_unit;
  t->rows = 1;
  snprintf(t->cells[0][KIND], CELL_SIZE, "Pivot");
  snprintf(t->cells[0][X], CELL_SIZE, "x (%s)", unit);
  snprintf(t->cells[0][Y], CELL_SIZE, "y (%s)", unit);
  snprintf(t->cells[0][ANGLE], CELL_SIZE, "%s", tp_text_topples_at(figure->solution));
  if (figure->solution->has_tilt_angle) snprintf(t->cells[0][FACTOR], CELL_SIZE, "FoS");
  snprintf(t->cells[0][TURNING], CELL_SIZE, "turning");
}

static void fill_row(table *t, const tp_figure *figure, const tp_case *own, size_t k) {
  const tp_page page = {.solution = figure->solution};
  const tp_pivot *pivot = own->pivots + k;
  char(*cells)[CELL_SIZE] = t->cells[t->rows++];
  char n[TP_NUMBER_SIZE];
  snprintf(cells[NUMBER], CELL_SIZE, "%zu", pivot->index + 1);
  snprintf(cells[KIND], CELL_SIZE, "%s%s", pivot->rounded ? "rounded " : "",
           tp_pivot_kind_name(pivot->kind));
  snprintf(cells[X], CELL_SIZE, "%s", tp_page_coordinate(&page, n, pivot->x_m));
  snprintf(cells[Y], CELL_SIZE, "%s", tp_page_coordinate(&page, n, pivot->y_m));
  if (pivot->never || pivot->always) {
    snprintf(cells[ANGLE], CELL_SIZE, "%s", pivot->never ? "never" : "always");
  } else {
    snprintf(cells[ANGLE], CELL_SIZE, "%s°", tp_text_fixed(n, pivot->critical_angle_deg, 2));
  }
  if (figure->solution->has_tilt_angle) {
    snprintf(cells[FACTOR], CELL_SIZE, "%s", tp_page_fos(n, pivot->fos));
  }
  snprintf(cells[TURNING], CELL_SIZE, "%s", tp_text_turning(own, k));
}

/* Columns as wide as their widest cell in bold, what is left between them; smaller letters where
 * nothing is left. */
static void lay_out(table *t, cairo_t *cr, double width) {
  const double least_gap = 5, disc = 6;
  t->size = TP_BODY_SIZE;
  for (;;) {
    double sum = 0;
    for (int c = 0; c < COLUMNS; c++) {
      t->widths[c] = 0;
      tp_figure_font(cr, c == NUMBER ? TP_SMALL_SIZE : t->size, true);
      for (size_t r = 0; r < t->rows; r++) {
        t->widths[c] = fmax(t->widths[c], tp_figure_text_width(cr, t->cells[r][c]));
      }
      if (c == NUMBER) t->widths[c] += disc;
      sum += t->widths[c];
    }
    t->gap = (width - sum) / (COLUMNS - 1);
    if (t->gap >= least_gap || t->size < 2) return;
    t->size *= 0.95;
  }
}

static void rule(cairo_t *cr, double x, double y, double width, double thick) {
  tp_figure_ink(cr, TP_INK_BLACK);
  cairo_set_line_width(cr, thick);
  cairo_move_to(cr, x, y);
  cairo_line_to(cr, x + width, y);
  cairo_stroke(cr);
}

/* Words from the left of their column, numbers to the right of it. */
static void draw_row(cairo_t *cr, const table *t, size_t r, double x, double y, bool bold) {
  tp_figure_ink(cr, TP_INK_BLACK);
  tp_figure_font(cr, t->size, bold);
  for (int c = 0; c < COLUMNS; c++) {
    const char *text = t->cells[r][c];
    if (c != NUMBER && text[0] != '\0') {
      const double free = c == KIND ? 0 : t->widths[c] - tp_figure_text_width(cr, text);
      tp_figure_text(cr, x + free, y, text);
    }
    x += t->widths[c] + t->gap;
  }
}

double tp_figure_table(cairo_t *cr, const tp_figure *figure, const tp_state *state, double x,
                       double y, double width) {
  const double pitch = 11;
  const tp_case *own = state->own;
  size_t listed[TP_PIVOTS_LISTED];
  const size_t count = tp_state_pivots(listed, figure, state);
  table t = {0};
  fill_head(&t, figure);
  for (size_t k = 0; k < count; k++) fill_row(&t, figure, own, listed[k]);
  lay_out(&t, cr, width);
  rule(cr, x, y, width, 0.8);
  y += pitch - 1;
  draw_row(cr, &t, 0, x, y, false);
  y += 4;
  rule(cr, x, y, width, 0.4);
  for (size_t k = 0; k < count; k++) {
    const bool governs = own->has_toppling_pivot && listed[k] == own->toppling_pivot;
    y += pitch;
    const tp_spot disc = {x + t.widths[NUMBER] / 2, y - 0.36 * TP_BODY_SIZE};
    tp_figure_disc(cr, disc, own->pivots[listed[k]].index + 1, governs);
    draw_row(cr, &t, k + 1, x, y, governs);
  }
  y += 4;
  rule(cr, x, y, width, 0.8);
  if (count == own->candidate_count) return y;
  char more[96];
  snprintf(more, sizeof more, "and %zu more (--json --pivots=all lists all)",
           own->candidate_count - count);
  return tp_figure_paragraph(cr, x, y + 3, width, TP_BODY_SIZE, false, more);
}
