/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What contact forces say: the forces that hold the block at its limit, which anyone can add up,
 * and the motions that can begin at the scene's tilt. */

#include "report/sheet.h"

#include "report/limit.h"
#include "report/words.h"

static void add_reactions(tp_sheet *s, const tp_limit *l) {
  tp_document *d = &s->document;
  const tp_page page = {.solution = s->solution};
  const char *unit = s->solution->length_unit;
  char n[TP_NUMBER_SIZE];
  tp_document_table(d, TP_TABLE_OF_COLUMNS, 5, 0x1e,
                    "Forces of the base on the block at the limit, as shares of its weight W");
  tp_document_cell(d, "Contact");
  tp_document_cell(d, "x (%s)", unit);
  tp_document_cell(d, "y (%s)", unit);
  tp_document_cell(d, "Along x (W)");
  tp_document_cell(d, "Along y (W)");
  for (size_t k = 0; k < l->reaction_count; k++) {
    const tp_reaction *r = l->reactions + k;
    if (r->of_facet) {
      tp_document_cell(d, r->at_right_end ? "facet %zu, right end" : "facet %zu, left end",
                       r->facet + 1);
    } else {
      tp_document_cell(d, "base past the toe");
    }
    tp_document_cell(d, "%s", tp_page_coordinate(&page, n, r->x_m));
    tp_document_cell(d, "%s", tp_page_coordinate(&page, n, r->y_m));
    tp_document_cell(d, "%s", tp_text_fixed(n, r->share_x, 6));
    tp_document_cell(d, "%s", tp_text_fixed(n, r->share_y, 6));
  }
}

/* Forces along x and y, of the weight alone. */
static void add_balance(tp_sheet *s, const tp_case *c) {
  const tp_limit *l = &c->limit;
  const bool left = c->towards == TP_TOWARDS_LEFT;
  tp_text x = {0}, y = {0};
  for (size_t k = 0; k < l->reaction_count; k++) {
    tp_text_add(&x, "%s%s", k > 0 ? " + " : "", tp_sheet_share(l->reactions[k].share_x).text);
    tp_text_add(&y, "%s%s", k > 0 ? " + " : "", tp_sheet_share(l->reactions[k].share_y).text);
  }
  const tp_sheet_number angle = tp_sheet_angle(l->critical_angle_deg);
  if (x.data != NULL && y.data != NULL) {
    tp_document_add(&s->document, TP_PASSAGE_PARAGRAPH,
                    "They balance the weight, whose components at the limit are W sin α_w down-dip "
                    "and W cos α_w into the base; and their moments about the centroid cancel.");
    tp_document_add(&s->document, TP_PASSAGE_EQUATION,
                    "\\sum \\frac{R_x}{W} = %s = %s\\sin %s \\\\"
                    "\\sum \\frac{R_y}{W} = %s = \\cos %s",
                    x.data, left ? "" : "−", angle.text, y.data, angle.text);
  }
  s->document.failed = s->document.failed || x.failed || y.failed;
  tp_text_drop(&x);
  tp_text_drop(&y);
}

void tp_sheet_add_limit(tp_sheet *s, const tp_case *c) {
  const tp_limit *l = &c->limit;
  tp_page page = {.solution = s->solution};
  if (l->kind == TP_LIMIT_NOT_ASKED) return;
  tp_document_heading(&s->document, 3, "The static limit by contact forces");
  tp_page_add_limit(&page, c);
  tp_sheet_prose(&s->document, TP_PASSAGE_PARAGRAPH, &page.text);
  if (l->kind != TP_LIMIT_AT_ANGLE || l->reaction_count == 0) return;
  add_reactions(s, l);
  if (!s->solution->loaded) add_balance(s, c);
}

static void add_motion(tp_sheet *s, const tp_motion *m) {
  tp_document *d = &s->document;
  const tp_page page = {.solution = s->solution};
  char n[2][TP_NUMBER_SIZE];
  tp_document_word(d, tp_mechanism_name(m->mechanism));
  if (m->has_centre) {
    tp_document_cell(d, "(%s, %s)", tp_page_coordinate(&page, n[0], m->centre_x_m),
                     tp_page_coordinate(&page, n[1], m->centre_y_m));
  } else {
    tp_document_cell(d, "–");
  }
  tp_document_word(d, m->accelerations_fixed ? "these" : m->greatest ? "at most" : "at least");
  tp_document_cell(d, "%s", tp_text_significant(n[0], m->acceleration_x_g, 4));
  tp_document_cell(d, "%s", tp_text_significant(n[0], m->acceleration_y_g, 4));
  tp_document_cell(d, "%s", tp_text_significant(n[0], m->angular_g_per_m, 4));
}

void tp_sheet_add_motions(tp_sheet *s, const tp_case *c) {
  tp_document *d = &s->document;
  const tp_onset *o = &c->onset;
  if (!o->has_motions || o->motion_count == 0) return;
  tp_document_heading(d, 3, "Motions that can begin %s",
                      tp_document_say(d, tp_text_present(s->solution)));
  tp_document_table(d, TP_TABLE_OF_COLUMNS, 6, 0x38, "Accelerations of the centroid, g gravity");
  tp_document_cell(d, "Motion");
  tp_document_cell(d, "About (%s)", s->solution->length_unit);
  tp_document_cell(d, "Accelerations");
  tp_document_cell(d, "x (g)");
  tp_document_cell(d, "y (g)");
  tp_document_cell(d, "Turning (g/m)");
  for (size_t k = 0; k < o->motion_count; k++) add_motion(s, o->motions + k);
}
