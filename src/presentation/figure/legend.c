/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What the colours and signs of a block's figure mean: those that it uses. */

#include "figure/legend.h"
#include "figure/drawn_names.h"

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
  const tp_legend_entry entries[] = {
      {true, TP_SIGN_TINT, TP_INK_BLOCK, names->block.data},
      {drawn != NULL && drawn->hole_count > 0, TP_SIGN_TINT, TP_INK_WHITE, names->hole.data},
      {names->has_part[0], TP_SIGN_TINT, TP_INK_PART, names->parts[0].data},
      {names->has_part[1], TP_SIGN_TINT, TP_INK_OTHER_PART, names->parts[1].data},
      {figure->shape.elements.count > 0, TP_SIGN_THIN, TP_INK_GREY, "element"},
      {true, TP_SIGN_TINT, TP_INK_ROCK, names->base.data},
      {figure->shape.contact.count > 0, TP_SIGN_LINE, TP_INK_GREEN, "contact"},
      {true, TP_SIGN_CENTROID, TP_INK_BLACK, "centroid"},
      {true, TP_SIGN_ARROW, TP_INK_BLACK, "weight W"},
      {shakes && loads->horizontal.given, TP_SIGN_ARROW, TP_INK_GREY, "earthquake"},
      {combined, TP_SIGN_ARROW, TP_INK_ORANGE, "weight and loads"},
      {reacts, TP_SIGN_ARROW, TP_INK_BLUE, "reaction R of the base"},
      {lines, TP_SIGN_DASHES, TP_INK_GREY, "line of action"},
      {turns, TP_SIGN_CROSS, TP_INK_VERMILION, "centre of rotation"},
      {true, TP_SIGN_DISC, TP_INK_WHITE, "pivot"},
      {governs, TP_SIGN_DISC, TP_INK_VERMILION, "governing pivot"},
      {loads->water.given, TP_SIGN_TINT, TP_INK_SKY, "water pressure"},
      {loads->anchor_count > 0, TP_SIGN_ARROW, TP_INK_PURPLE, "anchor"},
      {!fmpq_is_zero(loads->water.ice_kpa.value), TP_SIGN_ARROW, TP_INK_PURPLE, "ice"},
      {loads->pressure_count + loads->surcharge_count > 0, TP_SIGN_ARROW, TP_INK_PURPLE,
       "pressure or surcharge"},
      {loads->support_count > 0, TP_SIGN_ARROW, TP_INK_PURPLE, "pressure of a lining or a wall"},
      {has_length(loads), TP_SIGN_LINE, TP_INK_PURPLE, "length of bolts beyond the block"}};
  const double unit = figure->shape.unit_m / figure->solution->metres_per_unit; /* scene lengths */
  const tp_legend legend = {.points = scale / unit,
                            .length_unit = figure->solution->length_unit,
                            .language = figure->language,
                            .comma = figure->comma,
                            .count = sizeof entries / sizeof entries[0],
                            .entries = entries};
  *y = tp_legend_draw(cr, &legend, x, *y, width);
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
