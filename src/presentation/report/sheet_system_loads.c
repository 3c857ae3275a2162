/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Loads besides weights, and the support for a wanted factor, on the sheet of many blocks. */

#include "report/sheet_system.h"

#include "report/system_words.h"

#include "terms/names.h"

/* So many rows of a table; --json has all. */
enum { MOST_ROWS = 120 };

static const double kilo = 1e3;

static void add_force(tp_document *d, tp_bounded newtons) {
  char n[TP_NUMBER_SIZE];
  tp_document_cell(d, "%s", tp_text_significant(n, tp_text_over(newtons, kilo), 5));
}

void tp_system_sheet_add_loads(tp_system_sheet *s, const tp_system_case *c) {
  static const char *const heads[] = {"Load", "On", "x (kN/m)", "y (kN/m)", "M (kN m/m)"};
  tp_document *d = &s->document;
  if (c->load_count == 0) return;
  tp_document_table(d, TP_TABLE_OF_COLUMNS, 5, 0x1c,
                    "Loads besides weights, in the axes of the scene, with moments about the "
                    "centroids of the blocks");
  for (size_t k = 0; k < 5; k++) tp_document_word(d, heads[k]);
  for (size_t k = 0; k < c->load_count && k < MOST_ROWS; k++) {
    const tp_system_load *load = c->loads + k;
    tp_document_word(d, tp_system_load_kind_name(load->kind));
    tp_document_outside_cell(d, s->system->blocks[load->block].name);
    add_force(d, load->force_x_n_m);
    add_force(d, load->force_y_n_m);
    add_force(d, load->moment_n);
  }
  if (c->load_count <= MOST_ROWS) return;
  tp_document_add(d, TP_PASSAGE_PARAGRAPH, "And %zu more, which topple solve --json has.",
                  c->load_count - MOST_ROWS);
}

static void add_place(tp_document *d, const tp_block_system *s, const tp_system_support *own) {
  char n[2][TP_NUMBER_SIZE];
  tp_document_word(d, "On");
  tp_document_outside_cell(d, s->blocks[own->block].name);
  tp_document_word(d, "At");
  tp_document_cell(
      d, "(%s, %s) %s", tp_text_significant(n[0], tp_text_over(own->x_m, s->metres_per_unit), 6),
      tp_text_significant(n[1], tp_text_over(own->y_m, s->metres_per_unit), 6), s->length_unit);
  tp_document_word(d, "Direction");
  tp_document_cell(d, "%s° from x towards y", tp_text_significant(n[0], own->direction_deg, 5));
}

static void add_words(tp_document *d, const char *word, tp_text *words) {
  tp_document_word(d, word);
  tp_document_told_cell(d, words->failed || words->data == NULL ? "" : words->data);
  d->failed = d->failed || words->failed;
}

void tp_system_sheet_add_support(tp_system_sheet *s, const tp_system_case *c) {
  const tp_system_support *own = &c->support;
  tp_document *d = &s->document;
  tp_text design = {0}, optimistic = {0}, standing = {0};
  char n[TP_NUMBER_SIZE];
  if (!c->has_support) return;
  tp_document_table(d, TP_TABLE_OF_FACTS, 2, 0, "Support for a wanted factor");
  tp_document_word(d, "Factor of safety");
  tp_document_cell(d, "%s", tp_text_significant(n, own->fos, 5));
  tp_text_system_design_support(&design, c);
  add_words(d, "Support", &design);
  if (tp_text_system_standing_support(&standing, c)) {
    add_words(d, "No motion can begin with", &standing);
  }
  if (tp_text_system_optimistic_support(&optimistic, c)) {
    tp_text_add(&optimistic, ", but a motion may begin");
    add_words(d, "Optimistic: forces can hold with", &optimistic);
  }
  add_place(d, s->system, own);
  tp_text_drop(&design);
  tp_text_drop(&optimistic);
  tp_text_drop(&standing);
}
