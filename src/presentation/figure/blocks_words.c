/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Words around the figure of many blocks: how they lie, verdict and numbers, what is drawn. */

#include "block_system/governing_case.h"
#include "figure/blocks.h"
#include "figure/legend.h"
#include "report/column_page.h"
#include "report/page.h"
#include "report/sheet.h"
#include "report/system_words.h"
#include "terms/names.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* In the language of the figure. */
static void tell(tp_text *t, const tp_blocks_figure *f) {
  tp_figure_tell_in(t, f->language, f->comma);
}

/* "φ = 31°", "φ from 17° to 31°" */
static void add_friction(tp_text *t, const tp_block_system *s) {
  char n[2][TP_NUMBER_SIZE];
  if (s->contact_count == 0) return;
  tp_bounded least = s->contacts[0].friction_angle_deg, most = least;
  for (size_t k = 1; k < s->contact_count; k++) {
    const tp_bounded own = s->contacts[k].friction_angle_deg;
    if (own.value < least.value) least = own;
    if (own.value > most.value) most = own;
  }
  tp_page_degrees(n[0], least);
  tp_page_degrees(n[1], most);
  if (least.value < most.value) {
    tp_text_add(t, ", φ from %s° to %s°", n[0], n[1]);
  } else {
    tp_text_add(t, ", φ = %s°", n[0]);
  }
}

bool tp_blocks_heading(double *y, cairo_t *cr, const tp_blocks_figure *f, double x, double width) {
  const tp_block_system *s = f->system;
  tp_text t = {0};
  tp_text_system_stance(&t, s, f->own);
  add_friction(&t, s);
  if (s->case_count > 1) {
    tp_text_add(&t, tp_blocks_governs(f) ? "; the direction that governs"
                                         : "; the first of two directions");
  }
  tell(&t, f);
  const bool done = !t.failed;
  if (done) {
    tp_figure_ink(cr, TP_INK_BLACK);
    *y = tp_figure_paragraph(cr, x, *y, width, TP_HEAD_SIZE, false, t.data);
    *y += TP_LINE_HEIGHT * TP_BODY_SIZE;
    tp_figure_side(cr, true, tp_say(f->language, tp_direction_name(TP_TOWARDS_LEFT)), x, *y);
    tp_figure_side(cr, false, tp_say(f->language, tp_direction_name(TP_TOWARDS_RIGHT)), x + width,
                   *y);
    *y += 2;
  }
  tp_text_drop(&t);
  return done;
}

/* ---- below the drawing -------------------------------------------------------------------------
 */

/* The one that governs, and the upper bounds by what forces can hold. */
static void add_both_factors(tp_text *t, const tp_system_case *c) {
  tp_text_add(t, "Factor of safety: ");
  tp_text_system_safety(t, &c->governing_fos);
  tp_text_system_against(t, &c->governing_fos);
  tp_text_add(t, "; forces can hold, with strength divided by, ");
  tp_text_system_factor(t, c);
  if (c->fos_driving.state == TP_FOS_NO_OVERTURNING) return;
  tp_text_add(t, ", with driving loads times, ");
  tp_text_system_driving(t, c);
}

static void add_required(tp_text *t, const tp_block_system *s, const tp_system_case *c) {
  char n[TP_NUMBER_SIZE];
  if (!c->has_required_fos) return;
  tp_text_add(t, "%sRequired factor of safety %s: %s.", t->length > 0 ? " " : "",
              tp_text_significant(n, s->required_fos, 6), tp_sheet_met_words(c->meets_required));
}

void tp_blocks_factors(tp_text *t, const tp_block_system *s, const tp_system_case *c) {
  if (c->fos.state != TP_FOS_NOT_ASKED) {
    add_both_factors(t, c);
    tp_text_add(t, c->goodman_bray.applies ? "; by Goodman and Bray: " : ".");
    if (c->goodman_bray.applies) {
      tp_text_goodman_bray_factor(t, &c->goodman_bray);
      tp_text_add(t, ".");
    }
  }
  if (tp_system_case_moves_sooner(c)) {
    tp_text_add(t, "%sA motion can begin with strength divided by ", t->length > 0 ? " " : "");
    tp_text_system_moving(t, c);
    tp_text_add(t, ".");
  }
  add_required(t, s, c);
}

static void add_numbers(tp_text *t, const tp_blocks_figure *f) {
  const tp_system_case *c = f->own;
  char n[TP_NUMBER_SIZE];
  tp_text factors = {0};
  tp_blocks_factors(&factors, f->system, c);
  tp_text_add(t, "%s", tp_system_verdict_name(tp_system_case_worst_verdict(c)));
  if (tp_system_case_worst_verdict(c) != c->verdict) tp_text_add(t, " without the earthquake");
  tp_text_add(t, ".");
  if (!t->failed) t->data[0] = (char)toupper((unsigned char)t->data[0]);
  if (factors.data != NULL) tp_text_add(t, " %s", factors.data);
  t->failed = t->failed || factors.failed;
  tp_text_drop(&factors);
  const char *limit = tp_text_system_limit_name(f->system);
  tp_text_add(t, " %c%s: ", toupper((unsigned char)limit[0]), limit + 1);
  tp_text_system_limit(t, c);
  tp_text_add(t, ".");
  if (tp_system_case_has_critical_acceleration(c)) {
    tp_text_add(t, " Critical horizontal acceleration: %s g.",
                tp_text_significant(n, c->critical_acceleration_g, 5));
    if (tp_system_case_shakes_sooner(c)) {
      static const double fifth = 1e5;
      tp_text_add(t, " A motion can begin from %.5f g.",
                  ceil(c->moving_acceleration_g * fifth) / fifth);
    } else if (!c->has_standing_acceleration) {
      tp_text_add(t, " That a motion begins at less is not excluded.");
    }
  }
}

static void add_drawn(tp_text *t, const tp_blocks_figure *f) {
  const tp_system_case *c = f->own;
  size_t moving = 0, all = 0;
  for (size_t k = 0; k < f->system->block_count; k++) {
    moving += tp_blocks_moves(f, k);
    all += !f->system->blocks[k].ground;
  }
  if (c->verdict == TP_SYSTEM_CAN_HOLD) {
    tp_text_add(t, "Forces within the strength of the joints hold all blocks; that a motion "
                   "begins all the same is neither excluded nor proven. ");
  }
  if (c->verdict == TP_SYSTEM_MAY_MOVE) {
    tp_text_add(t, "Forces within the strength of the joints can hold all blocks, but a motion can "
                   "begin all the same. ");
  }
  if (c->motion_count == 0) {
    tp_text_add(t, "No mechanism is known.");
    return;
  }
  tp_text_add(t,
              "Drawn: the collapse %s, %zu of %zu blocks moving, and forces that hold the blocks "
              "just before it; one mechanism and one distribution of many.",
              tp_text_system_collapse(f->system, c), moving, all);
}

/* "2 cautions: see the report." */
static void add_cautions(tp_text *t, const tp_notes *notes) {
  size_t count = 0;
  for (size_t k = 0; k < notes->count; k++) count += notes->items[k].kind == TP_CAUTION;
  if (count > 0) tp_text_add(t, " %zu caution%s: see the report.", count, count == 1 ? "" : "s");
}

bool tp_blocks_verdict(double *y, cairo_t *cr, const tp_blocks_figure *f, double x, double width) {
  tp_text numbers = {0}, drawn = {0};
  add_numbers(&numbers, f);
  add_drawn(&drawn, f);
  add_cautions(&drawn, &f->system->notes);
  const bool done = !numbers.failed && !drawn.failed;
  if (done) {
    tp_figure_ink(cr, TP_INK_BLACK);
    *y = tp_figure_paragraph(cr, x, *y, width, TP_BODY_SIZE, true, numbers.data);
    *y = tp_figure_paragraph(cr, x, *y + 1, width, TP_BODY_SIZE, false, drawn.data);
  }
  tp_text_drop(&numbers);
  tp_text_drop(&drawn);
  return done;
}

/* ---- the legend --------------------------------------------------------------------------------
 */

/* To three digits, as numbers without bounds are told. */
static double rounded(double value) {
  const double power = pow(10, floor(log10(value)) - 2);
  return round(value / power) * power;
}

double tp_blocks_legend(const tp_blocks_panel *p, double x, double y, double width) {
  const tp_blocks_figure *f = p->figure;
  const tp_block_system *s = f->system;
  bool rests = false, parts = false, slides = false, topples = false, both = false;
  for (size_t k = 0; k < s->block_count; k++) {
    if (s->blocks[k].ground) continue;
    const tp_ink tint = tp_blocks_tint(f, k);
    parts = parts || f->shapes.blocks[k].parts.count > 0;
    rests = rests || tint == TP_INK_BLOCK;
    slides = slides || tint == TP_INK_PART;
    topples = topples || tint == TP_INK_TOPPLES;
    both = both || tint == TP_INK_SLIDES_AND_TOPPLES;
  }
  const bool collapses = f->own->motion_count > 0;
  char force[96] = "force in a contact";
  tp_text longest = {0};
  if (f->own->has_forces && f->largest_n_m > 0) {
    tp_text_add(&longest, tp_say(f->language, "force in a contact, the longest %.7g kN/m"),
                rounded(f->largest_n_m / 1e3));
    if (f->comma && !longest.failed) tp_language_set_commas(longest.data);
    if (!longest.failed) snprintf(force, sizeof force, "%s", longest.data);
    tp_text_drop(&longest);
  }
  const tp_legend_entry entries[] = {
      {rests, TP_SIGN_TINT, TP_INK_BLOCK, collapses ? "at rest" : "block"},
      {slides, TP_SIGN_TINT, TP_INK_PART, tp_mechanism_name(TP_SLIDES)},
      {topples, TP_SIGN_TINT, TP_INK_TOPPLES, tp_mechanism_name(TP_TOPPLES)},
      {both, TP_SIGN_TINT, TP_INK_SLIDES_AND_TOPPLES, tp_mechanism_name(TP_SLIDES_AND_TOPPLES)},
      {true, TP_SIGN_TINT, TP_INK_ROCK, "ground"},
      {parts, TP_SIGN_THIN, TP_INK_GREY, "part of another unit weight"},
      {collapses, TP_SIGN_DASHES, TP_INK_VERMILION, "how they begin to move, magnified"},
      {f->largest_n_m > 0, TP_SIGN_ARROW, TP_INK_BLUE, force},
      {p->has_thrust, TP_SIGN_DASHES, TP_INK_BLUE, "line of thrust"},
      {tp_blocks_pulled(f, false), TP_SIGN_ARROW, TP_INK_PURPLE, "load, not to scale"},
      {tp_blocks_pulled(f, true), TP_SIGN_LINE, TP_INK_PURPLE, "bolt"},
      {f->loads.water.count > 0, TP_SIGN_LINE, TP_INK_BLUE, "water"}};
  const tp_legend legend = {.points = p->view.scale * s->metres_per_unit / f->shapes.unit_m,
                            .length_unit = s->length_unit,
                            .language = f->language,
                            .comma = f->comma,
                            .count = sizeof entries / sizeof entries[0],
                            .entries = entries};
  return tp_legend_draw(p->cr, &legend, x, y, width);
}
