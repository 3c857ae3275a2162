/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Load cases on a sheet: on the first page each against what it must reach, the one that governs
 * first; in the appendix those that the first page has no room for, and partial factors. */

#include "report/sheet.h"

#include "report/words.h"
#include "terms/names.h"

/* Rows that leave the sketch its room on a page of A4. */
enum { ON_FRONT = 12 };

static bool any_requires(const tp_load_cases *cases) {
  bool any = false;
  for (size_t k = 0; k < cases->count; k++) any = any || cases->cases[k].has_required_fos;
  return any;
}

static void add_heads(tp_document *d, bool required) {
  tp_document_word(d, "Case");
  tp_document_word(d, "FoS");
  tp_document_word(d, "Against");
  if (required) tp_document_word(d, "Required");
  tp_document_word(d, "Utilisation");
  if (required) tp_document_word(d, "Requirement");
  tp_document_word(d, "Block");
}

static void add_row(tp_sheet *s, const tp_load_case *own, bool required) {
  tp_document *d = &s->document;
  const tp_governing_fos *g = &own->solution->cases[own->direction].governing_fos;
  char n[TP_NUMBER_SIZE];
  tp_document_outside_cell(d, own->name);
  tp_sheet_add_fos(s, own->fos, g->sliding_judged && !g->complete);
  if (g->has_factor) {
    tp_sheet_add_against(s, g->factors + g->factor);
  } else {
    tp_document_word(d, "–");
  }
  if (required) {
    tp_document_cell(d, "%s",
                     own->has_required_fos ? tp_text_significant(n, own->required_fos, 5) : "–");
  }
  tp_document_cell(d, "%s",
                   own->has_design_utilisation ? tp_text_fixed_up(n, own->design_utilisation, 3)
                   : own->has_utilisation      ? tp_text_fixed_up(n, own->utilisation, 3)
                                               : "–");
  if (required) {
    tp_document_word(d, own->has_required_fos ? tp_sheet_met_words(own->meets_required) : "–");
  }
  tp_document_word(d, tp_mechanism_name(own->mechanism));
}

static void add_table(tp_sheet *s, const char *caption, size_t count) {
  const tp_load_cases *cases = s->options->load_cases;
  tp_document *d = &s->document;
  const bool required = any_requires(cases);
  tp_document_table(d, TP_TABLE_OF_COLUMNS, required ? 7 : 5, required ? 0x1a : 0xa, caption);
  add_heads(d, required);
  for (size_t k = 0; k < count; k++) {
    if (k == 0) tp_document_mark_row(d);
    add_row(s, cases->cases + k, required);
  }
}

void tp_sheet_add_load_cases(tp_sheet *s) {
  const size_t count = s->options->load_cases->count;
  add_table(s, "Load cases, the one that governs first. Utilisation: required over FoS",
            count < ON_FRONT ? count : ON_FRONT);
  if (count > ON_FRONT) {
    tp_document_add(
        &s->document, TP_PASSAGE_PARAGRAPH,
        s->scene->letterhead.brief
            ? "Load cases in all: %zu; those that govern less stand below the hand check."
            : "Load cases in all: %zu; those that govern less are in the appendix.",
        count);
  }
  tp_document_add(&s->document, TP_PASSAGE_PARAGRAPH,
                  "All that follows is of the load case that governs.");
}

void tp_sheet_add_load_case_details(tp_sheet *s) {
  const tp_load_cases *cases = s->options->load_cases;
  tp_document *d = &s->document;
  size_t factored = 0;
  if (cases == NULL) return;
  for (size_t k = 0; k < cases->count; k++) {
    factored += cases->cases[k].solution->partial_factors != NULL;
  }
  if (factored == 0 && cases->count <= ON_FRONT) return;
  tp_document_heading(d, 2, "Load cases");
  if (cases->count > ON_FRONT) add_table(s, "All load cases", cases->count);
  if (factored == 0) return;
  tp_document_table(d, TP_TABLE_OF_COLUMNS, 2, 0,
                    "Partial factors of each combination that governs");
  tp_document_word(d, "Case");
  tp_document_word(d, "Partial factors");
  for (size_t k = 0; k < cases->count; k++) {
    const char *factors = cases->cases[k].solution->partial_factors;
    if (factors == NULL) continue;
    tp_document_outside_cell(d, cases->cases[k].name);
    tp_document_told_cell(d, factors);
  }
}
