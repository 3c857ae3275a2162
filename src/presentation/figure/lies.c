/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Words around a block that is drawn as it lies: how its section lies on the map, and what the
 * report says of it first. */

#include "figure/figure.h"
#include "report/as_it_lies.h"
#include "report/earthquakes.h"
#include "report/governing.h"
#include "report/words.h"
#include "terms/names.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void tp_figure_lies_heading(tp_text *t, const tp_figure *figure, const tp_state *state) {
  const tp_solution *s = figure->solution;
  const tp_frame_result *f = &s->frame;
  char n[TP_NUMBER_SIZE];
  tp_text_add(t, "%s, the base ", tp_text_stance(s, state->own));
  if (f->dips) {
    tp_text_add(t, "dips by %s° to the %s", tp_page_degrees(n, f->dip_deg),
                tp_direction_name(f->dips_towards));
  } else {
    tp_text_add(t, "is level");
  }
  if (s->has_friction) {
    tp_text_add(t, ", φ = %s°%s", tp_page_degrees(n, s->friction_angle_deg),
                s->friction_facet_count > 0 ? " but on some facets" : "");
  }
  if (s->earthquake_count > 0) {
    tp_text_add(t, ", earthquake ");
    tp_text_earthquake(t, s, s->earthquakes);
  }
}

/* An arrow out of the panel, and beside it what lies there. */
void tp_figure_side(cairo_t *cr, bool left, const char *text, double x, double y) {
  enum { LENGTH = 12, GAP = 4 };
  const double middle = y - 0.36 * TP_BODY_SIZE, to = left ? x : x - LENGTH;
  tp_figure_font(cr, TP_BODY_SIZE, false);
  tp_figure_arrow(cr, (tp_spot){left ? to + LENGTH : to, middle},
                  (tp_spot){left ? to : to + LENGTH, middle}, 0.8);
  tp_figure_text(cr, left ? x + LENGTH + GAP : to - GAP - tp_figure_text_width(cr, text), y, text);
}

/* "left, 135° SE" */
static void draw_side(cairo_t *cr, const tp_figure *figure, bool left, double x, double y) {
  const tp_frame_result *f = &figure->solution->frame;
  char azimuth[TP_NUMBER_SIZE + 8];
  tp_text side = {0};
  tp_text_add(&side, "%s", left ? "left" : "right");
  if (tp_text_azimuth(azimuth, f, left)) tp_text_add(&side, ", %s", azimuth);
  tp_figure_tell(figure, &side);
  tp_figure_side(cr, left, side.failed ? "" : side.data, x, y);
  tp_text_drop(&side);
}

double tp_figure_sides(cairo_t *cr, const tp_figure *figure, double x, double y, double width) {
  y += TP_LINE_HEIGHT * TP_BODY_SIZE;
  tp_figure_ink(cr, TP_INK_BLACK);
  draw_side(cr, figure, true, x, y);
  draw_side(cr, figure, false, x + width, y);
  return y + 2;
}

/* Lines of the report as one. */
static void join_lines(char *text) {
  char *to = text;
  for (const char *from = text; *from != '\0'; from++) {
    if (!isspace((unsigned char)*from)) {
      *to++ = *from;
    } else if (to > text && to[-1] != ' ') {
      *to++ = ' ';
    }
  }
  *to = '\0';
}

bool tp_figure_lies_verdict(tp_text *verdict, tp_text *more, const tp_figure *figure,
                            const tp_state *state) {
  tp_page page = {.solution = figure->solution};
  if (!tp_page_lies_known(figure->solution, state->own)) return false;
  tp_page_add_as_it_lies(&page, state->own);
  verdict->failed = verdict->failed || page.text.failed;
  if (!page.text.failed) {
    const char *end = strstr(page.text.data, ".\n");
    const size_t first = end != NULL ? (size_t)(end - page.text.data) + 1 : page.text.length;
    char *rest = page.text.data + first;
    join_lines(rest);
    if (rest[0] != '\0') tp_text_add(more, "%s", rest);
    *rest = '\0';
    join_lines(page.text.data);
    tp_text_add(verdict, "%s", page.text.data);
  }
  tp_text_drop(&page.text);
  return true;
}
