/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The formulas of a case with their numbers put in. Each side of an equation that holds numbers
 * alone is the same number within what its printed digits leave open:
 * tests/program/test_report_sheets.py recomputes them by intervals. Equations of Alejano et al.
 * bear their numbers. */

#include "report/sheet.h"

#include "report/words.h"

#include <math.h>
#include <stdio.h>

/* The lever arms of the weight about the governing pivot; false where loads act, or the weight
 * lies not above it, in the drawing or along the plane. */
static bool has_arms(const tp_sheet *s, const tp_case *c) {
  if (s->solution->loaded || !c->has_toppling_pivot) return false;
  const tp_pivot *p = c->pivots + c->toppling_pivot;
  const tp_bounded y_m = s->solution->block.centroid_y_m, angle = p->critical_angle_deg;
  const double upright = 90;
  return y_m.value - y_m.error > p->y_m.value + p->y_m.error &&
         fabs(angle.value) + angle.error < upright;
}

static void add_critical_angle(tp_sheet *s, const tp_case *c) {
  const tp_block_result *b = &s->solution->block;
  const tp_pivot *p = c->pivots + c->toppling_pivot;
  const bool left = c->towards == TP_TOWARDS_LEFT;
  const tp_sheet_turn turn = tp_sheet_turn_of(s, c);
  const tp_sheet_number gx = tp_sheet_coordinate(s, b->centroid_x_m),
                        gy = tp_sheet_coordinate(s, b->centroid_y_m),
                        px = tp_sheet_coordinate(s, p->x_m), py = tp_sheet_coordinate(s, p->y_m);
  tp_document_add(&s->document, TP_PASSAGE_PARAGRAPH,
                  "Critical angle of toppling about pivot %zu, by moments: at it the line of the "
                  "weight passes through the pivot. G is the centroid of the weight, P the pivot.",
                  p->index + 1);
  tp_document_add(&s->document, TP_PASSAGE_EQUATION,
                  "α_c = %s\\arctan \\frac{%s}{y_G − y_P} \\\\"
                  "α_c = %s\\arctan \\frac{%s − %s}{%s − %s} = %s",
                  turn.letter, left ? "x_G − x_P" : "x_P − x_G", turn.number,
                  left ? gx.text : px.text, left ? px.text : gx.text, gy.text, py.text,
                  tp_sheet_angle(p->critical_angle_deg).text);
}

static void add_resultant(tp_sheet *s, const tp_case *c) {
  const tp_pivot *p = c->pivots + c->toppling_pivot;
  if (p->fos.state != TP_FOS_NUMBER || p->critical_angle_deg.value <= 0) return;
  const tp_bounded tilt = s->solution->tilt_angle_deg;
  tp_document_add(&s->document, TP_PASSAGE_PARAGRAPH,
                  "Factor of safety against toppling about it, by the resultant (Eq. 2): "
                  "stabilising over overturning moment.");
  tp_document_add(&s->document, TP_PASSAGE_EQUATION,
                  "\\text{FoS} = \\frac{\\tan α_c}{\\tan α} = \\frac{\\tan %s}{\\tan %s} = %s",
                  tp_sheet_angle(p->critical_angle_deg).text, tp_sheet_angle(tilt).text,
                  tp_sheet_factor(p->fos.value).text);
}

/* Where loads act: the sums of the table of loads. */
static void add_loaded(tp_sheet *s, const tp_case *c) {
  const tp_pivot *p = c->pivots + c->toppling_pivot;
  tp_text equation = {0};
  if (p->fos.state != TP_FOS_NUMBER || c->load_count == 0) return;
  tp_document_add(&s->document, TP_PASSAGE_PARAGRAPH,
                  "Factor of safety against toppling about pivot %zu: the moments in the table of "
                  "loads, stabilising over overturning less those that reduce overturning.",
                  p->index + 1);
  tp_text_add(&equation, "\\text{FoS} = \\frac{");
  for (int under = 0; under < 2; under++) {
    bool any = false;
    for (size_t k = 0; k < c->load_count; k++) {
      const tp_load_result *l = c->loads + k;
      char n[TP_NUMBER_SIZE];
      if ((l->side == TP_STABILISES) == (under == 1)) continue;
      tp_bounded moment = tp_sheet_turning(s, l->moment_nm);
      if (!under) moment.value = -moment.value;
      const bool below = moment.value < 0;
      if (below) moment.value = -moment.value;
      tp_text_add(&equation, "%s%s",
                  below ? " − "
                  : any ? " + "
                        : "",
                  tp_text_significant(n, moment, 6));
      any = true;
    }
    if (!any) tp_text_add(&equation, "0");
    tp_text_add(&equation, under ? "} = %s" : "}{", tp_sheet_factor(p->fos.value).text);
  }
  tp_document_take(&s->document, TP_PASSAGE_EQUATION, 0, &equation);
}

static void add_elements(tp_sheet *s, const tp_case *c) {
  const tp_account *a = &c->elements;
  const tp_pivot *p = c->pivots + c->toppling_pivot;
  if (a->account_count == 0 || p->fos_elements.state != TP_FOS_NUMBER) return;
  tp_document_add(&s->document, TP_PASSAGE_PARAGRAPH,
                  "The same by elements (Eq. A1.3): of each element both components of its weight, "
                  "each with the side that its sign puts it on; the sums of the account below.");
  tp_document_add(
      &s->document, TP_PASSAGE_EQUATION,
      "\\text{FoS}_{\\text{el}} = \\frac{\\sum M_{\\text{stab}}}{\\sum M_{\\text{over}}} = "
      "\\frac{%s}{%s} = %s",
      tp_sheet_moment(s, a->stabilising).text, tp_sheet_moment(s, a->overturning).text,
      tp_sheet_factor(p->fos_elements.value).text);
}

/* "FoS = min{1.938, 3.104} = 1.938", of those that count and are numbers, of a block that stands.
 */
static void add_least(tp_sheet *s, const tp_governing_fos *g) {
  tp_text equation = {0};
  size_t count = 0;
  if (g->fos.state != TP_FOS_NUMBER || g->fos.value.value < 1) return;
  tp_text_add(&equation, "\\text{FoS} = \\min (");
  for (size_t k = 0; k < g->factor_count; k++) {
    const tp_factor *factor = g->factors + k;
    if (!factor->counts || factor->fos.state != TP_FOS_NUMBER) continue;
    tp_text_add(&equation, "%s%s", count++ > 0 ? ", " : "",
                tp_sheet_factor(factor->fos.value).text);
  }
  tp_text_add(&equation, ") = %s", tp_sheet_factor(g->fos.value).text);
  if (count > 1) {
    tp_document_add(&s->document, TP_PASSAGE_PARAGRAPH, "The governing factor:");
    tp_document_take(&s->document, TP_PASSAGE_EQUATION, 0, &equation);
  } else {
    tp_text_drop(&equation);
  }
}

/* What δ is, where formulas have it. */
static void add_turn(tp_sheet *s, const tp_case *c) {
  const tp_sheet_turn turn = tp_sheet_turn_of(s, c);
  if (*turn.letter == '\0') return;
  tp_document_add(&s->document, TP_PASSAGE_PARAGRAPH,
                  "Coordinates are those of the drawing, which is turned by δ = %s where the tilt "
                  "is 0.",
                  tp_sheet_angle(turn.degrees).text);
}

void tp_sheet_add_formulas(tp_sheet *s, const tp_case *c) {
  tp_document_heading(&s->document, 3, "Formulas with their numbers");
  tp_document_add(&s->document, TP_PASSAGE_PARAGRAPH,
                  "All printed digits are certain; a recalculation from them agrees except "
                  "possibly in the last digit. Lengths are in %s, angles in degrees.",
                  s->solution->length_unit);
  add_turn(s, c);
  if (has_arms(s, c)) {
    add_critical_angle(s, c);
    if (s->solution->has_tilt_angle) add_resultant(s, c);
  }
  if (s->solution->loaded && c->has_toppling_pivot) add_loaded(s, c);
  if (c->has_toppling_pivot) add_elements(s, c);
  tp_sheet_add_sliding_formulas(s, c);
  tp_sheet_add_strength_formulas(s, c);
  tp_sheet_add_onset_formula(s, c);
  add_least(s, &c->governing_fos);
  tp_sheet_add_balance(s, c);
}
