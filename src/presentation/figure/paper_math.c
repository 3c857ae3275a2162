/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Equations on paper: each sign is a box with a width and what it reaches above and below the line;
 * a row of signs, a fraction and an index are boxes of boxes. A box is measured, or drawn, by the
 * same function. */

#include "document/math.h"
#include "figure/paper.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define SIZE 10.0
#define INDEX_SIZE 0.72 /* of what it stands at */

typedef struct box {
  double width, above, below;
} box;

typedef struct pen {
  cairo_t *cr;
  double x, y; /* on the line */
  double size;
  bool draws; /* else it only measures */
} pen;

static box row_box(pen p, const char *at, const char *end);

static box text_box(pen p, const char *text, size_t length, cairo_font_slant_t slant) {
  char own[128];
  snprintf(own, sizeof own, "%.*s", (int)length, text);
  cairo_select_font_face(p.cr, "DejaVu Serif", slant, CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(p.cr, p.size);
  if (p.draws) tp_figure_text(p.cr, p.x, p.y, own);
  return (box){tp_figure_text_width(p.cr, own), 0.76 * p.size, 0.22 * p.size};
}

/* What the next sign, or group, is; it is stepped past. */
static tp_math_sign next_argument(const char **at, const char *end) {
  return tp_math_next(at, end);
}

static box argument_box(pen p, const tp_math_sign *s) {
  return row_box(p, s->text, s->text + s->length);
}

static box fraction_box(pen p, const char **at, const char *end) {
  const tp_math_sign over = next_argument(at, end), under = next_argument(at, end);
  pen quiet = p;
  quiet.draws = false;
  const box a = argument_box(quiet, &over), b = argument_box(quiet, &under);
  const double width = fmax(a.width, b.width) + 0.3 * p.size, axis = 0.27 * p.size;
  const double gap = 0.16 * p.size;
  const box all = {width + 0.2 * p.size, a.above + a.below + gap + axis,
                   b.above + b.below + gap - axis};
  if (!p.draws) return all;
  pen own = p;
  own.x = p.x + 0.1 * p.size + (width - a.width) / 2;
  own.y = p.y - axis - gap - a.below;
  (void)argument_box(own, &over);
  own.x = p.x + 0.1 * p.size + (width - b.width) / 2;
  own.y = p.y - axis + gap + b.above;
  (void)argument_box(own, &under);
  cairo_set_line_width(p.cr, 0.06 * p.size);
  cairo_move_to(p.cr, p.x + 0.1 * p.size, p.y - axis);
  cairo_line_to(p.cr, p.x + 0.1 * p.size + width, p.y - axis);
  cairo_stroke(p.cr);
  return all;
}

static box bar_box(pen p, const char **at, const char *end) {
  const tp_math_sign s = next_argument(at, end);
  box own = argument_box(p, &s);
  if (p.draws) {
    cairo_set_line_width(p.cr, 0.06 * p.size);
    cairo_move_to(p.cr, p.x + 0.05 * p.size, p.y - 0.66 * p.size);
    cairo_line_to(p.cr, p.x + own.width, p.y - 0.66 * p.size);
    cairo_stroke(p.cr);
  }
  return own;
}

/* Signs between two numbers stand apart from them. */
static box operator_box(pen p, const tp_math_sign *s) {
  const bool close = s->length == 1 && strchr("()[],/", *s->text) != NULL;
  const bool minus = s->length == 1 && *s->text == '-';
  const double gap = close ? 0.04 * p.size : 0.24 * p.size;
  pen own = p;
  own.x += gap;
  box all = text_box(own, minus ? "−" : s->text, minus ? strlen("−") : s->length,
                     CAIRO_FONT_SLANT_NORMAL);
  all.width += 2 * gap;
  return all;
}

static box sign_box(pen p, const tp_math_sign *s, const char **at, const char *end) {
  box own;
  switch (s->kind) {
  case TP_MATH_LETTER:
    return text_box(p, s->text, s->length, CAIRO_FONT_SLANT_ITALIC);
  case TP_MATH_GROUP:
    return argument_box(p, s);
  case TP_MATH_FRACTION:
    return fraction_box(p, at, end);
  case TP_MATH_BAR:
    return bar_box(p, at, end);
  case TP_MATH_FUNCTION:
    own = text_box(p, s->text, s->length, CAIRO_FONT_SLANT_NORMAL);
    own.width += 0.18 * p.size;
    return own;
  case TP_MATH_NUMBER:
  case TP_MATH_WORDS:
    return text_box(p, s->text, s->length, CAIRO_FONT_SLANT_NORMAL);
  default:
    return operator_box(p, s);
  }
}

/* The index behind a sign, lower, or higher, and smaller. */
static box index_box(pen p, const char **at, const char *end) {
  const bool below = tp_math_next(at, end).kind == TP_MATH_BELOW;
  const tp_math_sign s = next_argument(at, end);
  const double shift = below ? 0.2 * p.size : -0.38 * p.size;
  p.y += shift;
  p.size *= INDEX_SIZE;
  box own = argument_box(p, &s);
  own.above -= shift;
  own.below += shift;
  return own;
}

static box row_box(pen p, const char *at, const char *end) {
  box all = {0, 0.76 * p.size, 0.22 * p.size};
  const double from = p.x;
  for (;;) {
    const tp_math_sign s = tp_math_next(&at, end);
    if (s.kind == TP_MATH_END) break;
    box own = sign_box(p, &s, &at, end);
    p.x += own.width;
    while (tp_math_follows(at, end, TP_MATH_BELOW) || tp_math_follows(at, end, TP_MATH_ABOVE)) {
      const box index = index_box(p, &at, end);
      p.x += index.width + 0.06 * p.size;
      own.above = fmax(own.above, index.above);
      own.below = fmax(own.below, index.below);
    }
    all.above = fmax(all.above, own.above);
    all.below = fmax(all.below, own.below);
  }
  all.width = p.x - from;
  return all;
}

void tp_paper_add_equation(tp_paper *p, const char *equation) {
  for (const char *at = equation; *at != '\0';) {
    const char *line = strstr(at, "\\\\");
    const char *end = line != NULL ? line : at + strlen(at);
    pen own = {.cr = p->cr, .x = TP_PAPER_LEFT + 16, .size = SIZE};
    const box all = row_box(own, at, end);
    own.size *= fmin(1, (TP_PAPER_ROOM - 16) / all.width); /* a long sum is set smaller */
    tp_paper_need(p, all.above + all.below + 5);
    tp_figure_ink(p->cr, TP_INK_BLACK);
    own.draws = true;
    own.y = p->y + all.above + 2;
    (void)row_box(own, at, end);
    p->y += all.above + all.below + 5;
    at = line != NULL ? line + 2 : end;
  }
  p->y += 3;
}
