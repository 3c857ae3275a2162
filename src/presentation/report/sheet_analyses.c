/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Sobol' indices, reliability and design values of a study's sheet, as tables: what
 * study_analyses.c has as lines for a terminal. */

#include "report/sheet.h"

#include "output/encode.h"
#include "report/study_words.h"

#include <math.h>

static void add_heads(tp_document *d, const char *const *heads, size_t count) {
  for (size_t k = 0; k < count; k++) tp_document_word(d, heads[k]);
}

/* For the critical angle by moments, both limits and the factor; not where none is known. */
static void add_indices(tp_document *d, const tp_study_result *r) {
  static const char *const captions[TP_STUDY_QUANTITIES] = {
      "Sobol' indices, moments",
      "Sobol' indices, onset",
      "Sobol' indices, limit",
      "Sobol' indices, factor",
      "Sobol' indices, factor by Goodman and Bray",
      "Sobol' indices, acceleration",
      "Sobol' indices, support"};
  static const char *const heads[] = {"Key", "First order", "from", "to", "Total", "from", "to"};
  enum { COLUMNS = sizeof heads / sizeof heads[0] };
  for (int q = 0; q < TP_STUDY_QUANTITIES; q++) {
    if (!r->variables[0].sobol_indices[q].known) continue;
    tp_document_table(d, TP_TABLE_OF_COLUMNS, COLUMNS, 0x7e, captions[q]);
    add_heads(d, heads, COLUMNS);
    for (size_t k = 0; k < r->variable_count; k++) {
      const tp_study_index *own = r->variables[k].sobol_indices + q;
      const double numbers[] = {own->first, own->first_low, own->first_high,
                                own->total, own->total_low, own->total_high};
      tp_document_outside_cell(d, r->variables[k].key);
      for (size_t j = 0; j < COLUMNS - 1; j++) tp_document_cell(d, "%.3f", numbers[j]);
    }
  }
}

/* ---- reliability -------------------------------------------------------------------------------
 */

static void add_rare(tp_document *d, const char *label, const tp_study_rare *own) {
  if (!own->asked) return;
  tp_document_word(d, label);
  if (own->known) {
    tp_document_cell(d, "%.3g (%.3g to %.3g), %zu scenes solved", own->probability, own->low,
                     own->high, own->scenes);
  } else {
    tp_text why = {0};
    tp_text_add(&why, "no answer: ");
    tp_encode_plain(&why, own->why);
    tp_document_told_cell(d, why.failed ? "" : why.data);
    d->failed = d->failed || why.failed;
    tp_text_drop(&why);
  }
}

static void add_state(tp_document *d, const tp_study_reliability *own) {
  tp_document_table(d, TP_TABLE_OF_FACTS, 2, 0,
                    tp_study_quantity_is_angle(own->quantity)
                        ? "First-order reliability: angle not above the tilt"
                        : "First-order reliability: factor not above 1");
  tp_document_word(d, "Of");
  tp_document_word(d, tp_study_quantity_words(own->quantity));
  tp_document_word(d, "Search");
  tp_document_told_cell(d, own->state);
  tp_document_word(d, "Scenes solved");
  tp_document_cell(d, "%zu", own->scenes);
  if (own->converged) {
    tp_document_word(d, "Index β");
    tp_document_cell(d, "%.4f", own->beta);
    tp_document_word(d, "Probability");
    tp_document_cell(d, "%.3g", own->probability);
  }
  add_rare(d,
           own->design_point_count > 1 ? "By samples around the design points"
                                       : "By samples around the design point",
           &own->importance);
  add_rare(d, "By subset simulation", &own->subset);
}

/* The design points, the nearest first: a column each. */
static void add_points(tp_document *d, const tp_study_result *r) {
  enum { SHOWN = 4 };
  const tp_study_reliability *own = &r->reliability;
  const size_t points = own->design_point_count > SHOWN ? SHOWN : own->design_point_count;
  const size_t others = points > 1 ? points - 1 : 0;
  double sum = own->probability;
  for (size_t k = 1; k < own->design_point_count; k++) sum += own->design_points[k].probability;
  tp_document_table(d, TP_TABLE_OF_COLUMNS, 3 + others, 0xfe, "Design point and importance");
  static const char *const heads[] = {"Key", "Design point", "Importance"};
  add_heads(d, heads, 3);
  for (size_t k = 1; k <= others; k++) {
    const tp_study_design_point *point = own->design_points + k;
    tp_document_cell(d, "Another, β = %.4f, probability %.3g", point->beta, point->probability);
  }
  for (size_t k = 0; k < r->variable_count; k++) {
    tp_document_outside_cell(d, r->variables[k].key);
    tp_document_cell(d, "%.6g", r->variables[k].design_value);
    tp_document_cell(d, "%.3f", r->variables[k].importance);
    for (size_t j = 1; j <= others; j++) {
      const tp_study_design_point *point = own->design_points + j;
      tp_document_cell(d, "%.6g", k < point->value_count ? point->values[k] : NAN);
    }
  }
  if (own->design_point_count > 1 && own->beta > 0) {
    tp_document_add(d, TP_PASSAGE_CAUTION,
                    "Caution: failure has %zu design points; %.3g to first order, if each is a "
                    "separate failure mode.",
                    own->design_point_count, sum);
  }
}

/* ---- design values -----------------------------------------------------------------------------
 */

static void add_number(tp_document *d, double value) {
  if (isinf(value)) {
    tp_document_word(d, "unbounded");
  } else {
    tp_document_cell(d, "%.6g", value);
  }
}

static void add_then(tp_document *d, const tp_study_design *own) {
  if (isinf(own->quantity_value)) {
    tp_document_word(d, own->quantity_value > 0 ? "always" : "never");
  } else {
    char n[TP_NUMBER_SIZE];
    tp_document_cell(d, tp_study_quantity_is_angle(own->quantity) ? "%s°" : "%s",
                     tp_study_number(n, own->quantity_value, own->quantity));
  }
}

static void add_designs(tp_document *d, const tp_study_result *r) {
  static const char *const heads[] = {
      "Key", "Design value", "from", "to", "in the scene", "Then", "", "Samples above", "Safe end"};
  enum { COLUMNS = sizeof heads / sizeof heads[0] };
  if (r->design_value_count == 0) return;
  tp_document_table(d, TP_TABLE_OF_COLUMNS, COLUMNS, 0xde,
                    "Design values: one number of the scene that stands for all samples");
  add_heads(d, heads, COLUMNS);
  for (size_t k = 0; k < r->design_value_count; k++) {
    const tp_study_design *own = r->design_values + k;
    if (!own->known) continue;
    tp_document_outside_cell(d, r->variables[own->variable].key);
    add_number(d, own->value);
    add_number(d, own->low);
    add_number(d, own->high);
    add_number(d, own->scene_value);
    tp_document_word(d, tp_study_quantity_words(own->quantity));
    add_then(d, own);
    tp_document_cell(d, "%.4g %%", 100 * (1 - own->probability));
    tp_document_word(d, own->low_is_safe ? "lower" : "upper");
  }
  for (size_t k = 0; k < r->design_value_count; k++) {
    const tp_study_design *own = r->design_values + k;
    tp_text why = {0};
    if (own->known) continue;
    tp_encode_plain(&why, r->variables[own->variable].key);
    tp_text_add(&why, ": no solution for %.4g %%: ", 100 * own->probability);
    tp_encode_plain(&why, own->why);
    tp_document_tell(d, TP_PASSAGE_CAUTION, 0, &why);
  }
}

void tp_sheet_add_analyses(tp_document *d, const tp_study_result *r) {
  bool indices = false;
  for (int q = 0; q < TP_STUDY_QUANTITIES; q++) {
    indices = indices || (r->variable_count > 0 && r->variables[0].sobol_indices[q].known);
  }
  if (!indices && !r->reliability.known && r->design_value_count == 0) return;
  tp_document_heading(d, 2, "Sensitivity, reliability and design values");
  if (indices) add_indices(d, r);
  if (r->reliability.known) add_state(d, &r->reliability);
  if (r->reliability.known && r->reliability.converged) add_points(d, r);
  add_designs(d, r);
}
