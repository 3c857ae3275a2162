/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Tables of moments: loads about the governing pivot, and the account by elements. */

#include "report/sheet.h"

#include "report/account_units.h"
#include "report/loads.h"
#include "report/words.h"
#include "terms/names.h"

#include <string.h>

/* Elements that are listed; JSON has all. */
enum { LISTED = 60 };

/* Of a force, in two cells. */
static void add_arm(tp_sheet *s, const tp_load_result *l) {
  const tp_page page = {.solution = s->solution};
  char n[TP_NUMBER_SIZE];
  if (!l->has_arm) {
    tp_document_word(&s->document, "–");
    tp_document_word(&s->document, "–");
    return;
  }
  tp_document_cell(&s->document, "%s", tp_text_significant(n, tp_sheet_force(s, l->force_n), 6));
  tp_document_cell(&s->document, "%s", tp_page_length(&page, n, l->arm_m, 6));
}

void tp_sheet_add_loads(tp_sheet *s, const tp_case *c) {
  tp_document *d = &s->document;
  tp_page page = {.solution = s->solution};
  if (!s->solution->loaded) return;
  tp_document_heading(d, 3, "Loads");
  tp_page_add_balance(&page, c);
  tp_sheet_prose(d, TP_PASSAGE_PARAGRAPH, &page.text);
  if (!c->has_toppling_pivot || c->load_count == 0) {
    tp_document_add(d, TP_PASSAGE_PARAGRAPH,
                    "Their moments are given about a governing pivot %s, where there are both.",
                    tp_document_say(d, tp_text_present(s->solution)));
    return;
  }
  tp_document_table(d, TP_TABLE_OF_COLUMNS, 6, 0xe,
                    s->solution->frame.world
                        ? "Moments about the governing pivot as it lies, overturning positive"
                        : "Moments about the governing pivot at the scene's tilt, overturning "
                          "positive");
  tp_document_cell(d, "Load");
  tp_document_cell(d, "Force (%s)", tp_sheet_force_unit(s));
  tp_document_cell(d, "Arm (%s)", s->solution->length_unit);
  tp_document_cell(d, "Moment (%s)", tp_sheet_turning_unit(s));
  tp_document_cell(d, "Counts as");
  tp_document_cell(d, "Required by");
  for (size_t k = 0; k < c->load_count; k++) {
    const tp_load_result *l = c->loads + k;
    char n[TP_NUMBER_SIZE];
    tp_document_word(d, l->name);
    add_arm(s, l);
    tp_document_cell(d, "%s", tp_text_significant(n, tp_sheet_turning(s, l->moment_nm), 6));
    tp_document_word(d, tp_load_side_name(l->side));
    tp_document_told_cell(d, l->called_for_by);
  }
}

static void add_heads(tp_sheet *s, const tp_account_units *units) {
  tp_document *d = &s->document;
  const char *unit = s->solution->length_unit;
  tp_document_cell(d, "Element");
  tp_document_cell(d, "Form");
  tp_document_cell(d, "Area (%s²)", unit);
  tp_document_cell(d, "Centroid x (%s)", unit);
  tp_document_cell(d, "Centroid y (%s)", unit);
  tp_document_cell(d, "Weight (%s)", units->weight);
  tp_document_cell(d, "Stabilising (%s)", units->moment);
  tp_document_cell(d, "Overturning (%s)", units->moment);
}

static const char *area_of(const tp_sheet *s, char n[TP_NUMBER_SIZE], tp_bounded area_m2) {
  const double unit = s->solution->metres_per_unit;
  return tp_text_significant(n, tp_text_over(tp_text_over(area_m2, unit), unit), 6);
}

static void add_element(tp_sheet *s, const tp_element *e, size_t k, const tp_account_units *units) {
  tp_document *d = &s->document;
  const tp_page page = {.solution = s->solution};
  char n[TP_NUMBER_SIZE];
  tp_document_cell(d, "%zu", k + 1);
  tp_document_word(d, tp_element_kind_name(e->kind));
  tp_document_cell(d, "%s", area_of(s, n, e->area_m2));
  tp_document_cell(d, "%s", tp_page_coordinate(&page, n, e->centroid_x_m));
  tp_document_cell(d, "%s", tp_page_coordinate(&page, n, e->centroid_y_m));
  tp_document_cell(d, "%s", tp_text_significant(n, tp_page_in(e->weight, units->force), 6));
  tp_document_cell(d, "%s", tp_account_moment(&page, n, e->stabilising, units));
  tp_document_cell(d, "%s", tp_account_moment(&page, n, e->overturning, units));
}

static void add_sums(tp_sheet *s, const tp_account *a, const tp_account_units *units) {
  tp_document *d = &s->document;
  const tp_block_result *b = &s->solution->block;
  const tp_page page = {.solution = s->solution};
  char n[TP_NUMBER_SIZE];
  tp_document_mark_row(d);
  tp_document_cell(d, "All");
  tp_document_cell(d, "%zu elements", a->account_count);
  tp_document_cell(d, "%s", area_of(s, n, b->area_m2));
  tp_document_cell(d, "%s", tp_page_coordinate(&page, n, b->centroid_x_m));
  tp_document_cell(d, "%s", tp_page_coordinate(&page, n, b->centroid_y_m));
  tp_document_cell(d, "%s",
                   b->has_weight ? tp_text_significant(n, tp_page_in(b->weight_n, units->force), 6)
                                 : "1");
  tp_document_cell(d, "%s", tp_account_moment(&page, n, a->stabilising, units));
  tp_document_cell(d, "%s", tp_account_moment(&page, n, a->overturning, units));
}

/* Why there is none, of a block that no slabs and triangles make up. */
static void add_reason(tp_sheet *s) {
  bool round = s->solution->block.vertices == 0; /* an ellipse */
  for (size_t k = 0; k < s->solution->effect_count; k++) {
    const char *name = s->solution->effects[k].name;
    round = round || strcmp(name, "arcs") == 0 || strcmp(name, "rounding") == 0;
  }
  if (!round || s->solution->loaded) return;
  tp_document_add(&s->document, TP_PASSAGE_PARAGRAPH,
                  "No account of moments by elements: slabs and triangles do not make up a block "
                  "with arcs, which is why the factor by elements is missing too. Its area and "
                  "centroid are integrals along the arcs, as certain as all numbers here.");
}

void tp_sheet_add_account(tp_sheet *s, const tp_case *c) {
  tp_document *d = &s->document;
  const tp_account *a = &c->elements;
  const bool left = c->towards == TP_TOWARDS_LEFT;
  const tp_account_units units = tp_account_units_of(s->solution);
  char n[TP_NUMBER_SIZE];
  if (a->account_count == 0 && c->has_toppling_pivot) add_reason(s);
  if (a->account_count == 0 || !c->has_toppling_pivot) return;
  tp_document_heading(d, 3, "Account of moments by elements");
  tp_document_add(d, TP_PASSAGE_PARAGRAPH,
                  "The section is cut into slabs and triangles (drawn in the figure). About pivot "
                  "%zu, at α = %s°%s, each element k of weight W and centroid (x, y) has the two "
                  "moments below: of above 0 the first stabilises and the second overturns, of "
                  "below 0 it is the other way round. All: sums of areas, weights and moments, and "
                  "the centroid of the weight.",
                  c->pivots[c->toppling_pivot].index + 1, tp_page_degrees(n, a->angle_deg),
                  a->at_critical_angle ? tp_document_say(d, ", the critical angle") : "");
  tp_document_add(d, TP_PASSAGE_EQUATION,
                  "M_{1k} = W_k (%s) \\cos α \\\\ M_{2k} = W_k (y_k − y_P) \\sin α \\\\"
                  "x_G = \\frac{\\sum W_k x_k}{\\sum W_k} \\\\"
                  "y_G = \\frac{\\sum W_k y_k}{\\sum W_k}",
                  left ? "x_k − x_P" : "x_P − x_k");
  tp_document_table(d, TP_TABLE_OF_COLUMNS, 8, 0xfc,
                    "Moments about the governing pivot by elements");
  add_heads(s, &units);
  for (size_t k = 0; k < a->account_count && k < LISTED; k++)
    add_element(s, a->account + k, k, &units);
  add_sums(s, a, &units);
  if (a->account_count > LISTED) {
    tp_document_add(
        d, TP_PASSAGE_PARAGRAPH,
        "The first %d elements are listed; the sums are of all (topple solve --elements "
        "lists them).",
        LISTED);
  }
}
