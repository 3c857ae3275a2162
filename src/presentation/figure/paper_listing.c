/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Lines of a file on the page. Short ones, a number each as in a DXF, stand in columns: down the
 * first, then down the next, page by page. */

#include "figure/paper.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double size = 7;
static const double gutter = 14;

enum { FEW_LINES = 24, TOGETHER = 12, MOST_COLUMNS = 6 };

static void set_letters(cairo_t *cr) {
  tp_figure_ink(cr, TP_INK_BLACK);
  cairo_select_font_face(cr, "DejaVu Sans Mono", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(cr, size);
}

/* The next line, cut where it is wider than the room, and step past it. */
static void draw_line(cairo_t *cr, const char **text, double x, double y, double room) {
  char line[TP_PAPER_LINE];
  const size_t length = strcspn(*text, "\n");
  const size_t part = length > 0 ? tp_paper_fitting(cr, *text, length, room) : 0;
  snprintf(line, sizeof line, "%.*s", (int)part, *text);
  tp_figure_text(cr, x, y + size, line);
  *text += part;
  if (part == length && **text == '\n') ++*text;
}

/* How many columns the lines fit into, and how many lines there are. */
static int count_columns(cairo_t *cr, const char *text, long *lines) {
  char line[TP_PAPER_LINE];
  double widest = 1;
  *lines = 0;
  while (*text != '\0') {
    const size_t length = strcspn(text, "\n");
    ++*lines;
    if (length >= sizeof line) return 1;
    snprintf(line, sizeof line, "%.*s", (int)length, text);
    widest = fmax(widest, tp_figure_text_width(cr, line));
    if (2 * widest + gutter > TP_PAPER_ROOM) return 1;
    text += length + (text[length] == '\n');
  }
  return (int)fmin(MOST_COLUMNS, floor((TP_PAPER_ROOM + gutter) / (widest + gutter)));
}

static void draw_columns(tp_paper *p, const char *text, long lines, int columns) {
  const double step = TP_LINE_HEIGHT * size;
  const double width = (TP_PAPER_ROOM + gutter) / columns;
  while (lines > 0) {
    tp_paper_need(p, fmin((double)lines, TOGETHER) * step);
    set_letters(p->cr);
    const long room = (long)floor((TP_PAPER_BOTTOM - p->y) / step);
    const long all = (lines + columns - 1) / columns, rows = all < room ? all : room;
    for (int column = 0; column < columns && lines > 0; column++) {
      for (long row = 0; row < rows && lines > 0; row++, lines--) {
        draw_line(p->cr, &text, TP_PAPER_LEFT + column * width, p->y + (double)row * step, width);
      }
    }
    p->y += (double)rows * step;
  }
}

void tp_paper_add_listing(tp_paper *p, const char *text) {
  const double step = TP_LINE_HEIGHT * size;
  long lines = 0;
  set_letters(p->cr);
  const int columns = count_columns(p->cr, text, &lines);
  if (columns > 1 && lines > FEW_LINES) {
    draw_columns(p, text, lines, columns);
  } else {
    while (*text != '\0') {
      tp_paper_need(p, step);
      set_letters(p->cr);
      draw_line(p->cr, &text, TP_PAPER_LEFT, p->y, TP_PAPER_ROOM);
      p->y += step;
    }
  }
  p->y += 4;
}
