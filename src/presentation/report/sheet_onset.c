/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The onset by a formula with its numbers, where one gives it: a block under its weight alone that
 * can begin to topple about a point which the line of its weight passes there, or to slide at
 * φ + i. The solution holds no reason of the onset, so a formula is printed only where it gives the
 * same angle, within the bounds of all its numbers and the rounding of a few doubles. Elsewhere the
 * sheet says why there is none. */

#include "report/sheet.h"

#include <float.h>
#include <math.h>

/* The same angle, within both bounds and the rounding of what was computed here. */
static bool is_onset(const tp_onset *o, double angle_deg, double error_deg) {
  const double rounding = 64 * DBL_EPSILON * 90;
  return fabs(angle_deg - o->critical_angle_deg.value) <=
         error_deg + o->critical_angle_deg.error + rounding;
}

/* Arms of the weight about the centre of rotation as it is drawn, the horizontal one towards the
 * lowered side. */
typedef struct arms {
  double along, up, error;
} arms;

static arms arms_of(const tp_sheet *s, const tp_case *c) {
  const tp_block_result *b = &s->solution->block;
  const tp_onset *o = &c->onset;
  const double x = b->centroid_x_m.value - o->centre_x_m.value;
  return (arms){c->towards == TP_TOWARDS_LEFT ? x : -x, b->centroid_y_m.value - o->centre_y_m.value,
                b->centroid_x_m.error + b->centroid_y_m.error + o->centre_x_m.error +
                    o->centre_y_m.error};
}

/* An arctangent of arms off by e in all is off by at most e over their hypotenuse. */
static bool passes_centre(const tp_sheet *s, const tp_case *c) {
  const tp_onset *o = &c->onset;
  if (o->mechanism != TP_TOPPLES || !o->has_centre) return false;
  const arms a = arms_of(s, c);
  const double degree = 180 / acos(-1);
  const tp_bounded turn = tp_sheet_turn_of(s, c).degrees;
  return a.up > a.error && is_onset(o, turn.value + atan2(a.along, a.up) * degree,
                                    turn.error + a.error / hypot(a.along, a.up) * degree);
}

static void add_toppling(tp_sheet *s, const tp_case *c) {
  const tp_block_result *b = &s->solution->block;
  const tp_onset *o = &c->onset;
  const bool left = c->towards == TP_TOWARDS_LEFT;
  const tp_sheet_turn turn = tp_sheet_turn_of(s, c);
  const tp_sheet_number gx = tp_sheet_coordinate(s, b->centroid_x_m),
                        gy = tp_sheet_coordinate(s, b->centroid_y_m),
                        cx = tp_sheet_coordinate(s, o->centre_x_m),
                        cy = tp_sheet_coordinate(s, o->centre_y_m);
  tp_document_add(&s->document, TP_PASSAGE_PARAGRAPH,
                  "Onset: toppling about C is possible from the tilt at which the line of the "
                  "weight passes C.");
  tp_document_add(&s->document, TP_PASSAGE_EQUATION,
                  "α_s = %s\\arctan \\frac{%s}{y_G − y_C} \\\\"
                  "α_s = %s\\arctan \\frac{%s − %s}{%s − %s} = %s",
                  turn.letter, left ? "x_G − x_C" : "x_C − x_G", turn.number,
                  left ? gx.text : cx.text, left ? cx.text : gx.text, gy.text, cy.text,
                  tp_sheet_angle(o->critical_angle_deg).text);
}

static bool slides_at_angle(const tp_case *c) {
  const tp_sliding *own = &c->sliding;
  return c->onset.mechanism == TP_SLIDES && own->known && !own->never && !own->always &&
         is_onset(&c->onset, own->critical_angle_deg.value, own->critical_angle_deg.error);
}

void tp_sheet_add_onset_formula(tp_sheet *s, const tp_case *c) {
  tp_document *d = &s->document;
  const tp_onset *o = &c->onset;
  if (o->kind != TP_ONSET_AT_ANGLE) return;
  if (!s->solution->loaded && passes_centre(s, c)) {
    add_toppling(s, c);
  } else if (!s->solution->loaded && slides_at_angle(c)) {
    tp_document_add(d, TP_PASSAGE_PARAGRAPH, "Onset: sliding is possible from that angle.");
    tp_document_add(d, TP_PASSAGE_EQUATION, "α_s = φ + i = %s + %s = %s",
                    tp_sheet_angle(c->sliding.friction_angle_deg).text,
                    tp_sheet_angle(c->sliding.facet_angle_deg).text,
                    tp_sheet_angle(o->critical_angle_deg).text);
  } else if (!o->below_limit && c->limit.kind == TP_LIMIT_AT_ANGLE) {
    tp_document_add(d, TP_PASSAGE_PARAGRAPH,
                    "Onset: α_s is the static limit, to within 0.000001°. The forces of the base "
                    "that are listed there, which balance the weight, are the check of both.");
  } else {
    tp_document_add(
        d, TP_PASSAGE_PARAGRAPH,
        "The onset has no one-line formula here: it is the least tilt at which "
        "some mode of the contacts satisfies the conditions of Newton and "
        "Coulomb. topple derive --limit gives these in symbols; docs/onset.md explains the "
        "method.");
  }
}
