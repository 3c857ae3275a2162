/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Tables on paper: rows are never cut, and a table that goes on over the page repeats its heads. */

#include "figure/paper.h"

#include <math.h>
#include <string.h>

#define SIZE 7.5
#define STEP (TP_LINE_HEIGHT * SIZE)
#define PADDING 4.0

typedef struct layout {
  tp_paper *paper;
  const tp_table *table;
  double widths[TP_TABLE_COLUMNS];
} layout;

static size_t head_rows(const tp_table *t) {
  return t->kind == TP_TABLE_OF_COLUMNS ? 1 : 0;
}

static const char *cell_at(const tp_table *t, size_t line, size_t column) {
  return line < head_rows(t) ? tp_table_head(t, column)
                             : tp_table_cell(t, line - head_rows(t), column);
}

static bool is_bold(const tp_table *t, size_t line, size_t column) {
  if (t->kind == TP_TABLE_OF_FACTS) return column == 0;
  return line < head_rows(t) || (t->has_mark && t->mark + head_rows(t) == line);
}

/* How wide the column would be, if nothing was broken. */
static double natural_width(const layout *l, size_t column) {
  const size_t lines = head_rows(l->table) + tp_table_rows(l->table);
  double widest = 0;
  for (size_t k = 0; k < lines; k++) {
    tp_figure_font(l->paper->cr, SIZE, is_bold(l->table, k, column));
    widest = fmax(widest, tp_figure_text_width(l->paper->cr, cell_at(l->table, k, column)));
  }
  return widest + 2 * PADDING;
}

/* Where all columns do not fit, the widest give way to one width, which heads of numbers share. */
static void find_widths(layout *l) {
  const size_t columns = l->table->columns;
  double natural[TP_TABLE_COLUMNS], sum = 0;
  for (size_t k = 0; k < columns; k++) {
    natural[k] = natural_width(l, k);
    sum += natural[k];
  }
  double most = sum;
  for (int step = 0; step < 50 && sum > TP_PAPER_ROOM; step++) {
    most *= 0.93;
    sum = 0;
    for (size_t k = 0; k < columns; k++) sum += fmin(natural[k], most);
  }
  for (size_t k = 0; k < columns; k++) l->widths[k] = fmin(natural[k], most);
}

/* Draw a cell, or only measure it; how many lines it takes. */
static int cell_lines(const layout *l, size_t line, size_t column, double x, bool draw) {
  cairo_t *cr = l->paper->cr;
  const char *text = cell_at(l->table, line, column);
  const bool number = (l->table->numeric >> column & 1) != 0;
  const double room = l->widths[column] - 2 * PADDING + 0.01;
  char words[TP_PAPER_LINE];
  int count = 0;
  tp_figure_font(cr, SIZE, is_bold(l->table, line, column));
  while (tp_paper_line(cr, words, &text, room)) {
    const double left = number ? room - tp_figure_text_width(cr, words) : 0;
    if (draw) {
      tp_figure_text(cr, x + PADDING + left, l->paper->y + 2 + SIZE + count * STEP, words);
    }
    count++;
  }
  return count > 0 ? count : 1;
}

static double row_height(const layout *l, size_t line) {
  int most = 1;
  for (size_t k = 0; k < l->table->columns; k++) {
    most = (int)fmax(most, cell_lines(l, line, k, 0, false));
  }
  return most * STEP + 4;
}

static void draw_row(const layout *l, size_t line) {
  cairo_t *cr = l->paper->cr;
  const double height = row_height(l, line);
  double x = TP_PAPER_LEFT;
  tp_figure_ink(cr, TP_INK_BLACK);
  for (size_t k = 0; k < l->table->columns; k++) {
    (void)cell_lines(l, line, k, x, true);
    x += l->widths[k];
  }
  l->paper->y += height;
  const bool head = line < head_rows(l->table);
  tp_figure_ink(cr, head ? TP_INK_BLACK : TP_INK_GREY);
  cairo_set_line_width(cr, head ? 1 : 0.4);
  cairo_move_to(cr, TP_PAPER_LEFT, l->paper->y - 0.5);
  cairo_line_to(cr, x, l->paper->y - 0.5);
  cairo_stroke(cr);
}

static void draw_caption(tp_paper *p, const char *caption) {
  char words[TP_PAPER_LINE];
  tp_figure_ink(p->cr, TP_INK_BLACK);
  cairo_select_font_face(p->cr, "DejaVu Sans", CAIRO_FONT_SLANT_ITALIC, CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(p->cr, SIZE);
  while (tp_paper_line(p->cr, words, &caption, TP_PAPER_ROOM)) {
    tp_figure_text(p->cr, TP_PAPER_LEFT, p->y + SIZE, words);
    p->y += STEP;
  }
  p->y += 1;
}

void tp_paper_add_table(tp_paper *p, const tp_passage *passage) {
  layout own = {.paper = p, .table = &passage->table};
  const size_t heads = head_rows(own.table), lines = heads + tp_table_rows(own.table);
  if (lines == heads) return;
  find_widths(&own);
  const double head = heads > 0 ? row_height(&own, 0) : 0;
  double together = 2 * STEP + head; /* the caption, with the first rows below it */
  for (size_t k = heads; k < lines && k < heads + 3; k++) together += row_height(&own, k);
  tp_paper_need(p, together);
  draw_caption(p, passage->text);
  for (size_t k = 0; k < lines; k++) {
    const int page = p->page;
    tp_paper_need(p, row_height(&own, k));
    if (p->page != page && heads > 0 && k > 0) draw_row(&own, 0);
    draw_row(&own, k);
  }
  p->y += 7;
}
