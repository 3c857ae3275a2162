/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a study found besides its samples, on the page of its summary: Sobol' indices, reliability,
 * design values. */

#include "output/encode.h"
#include "report/study_words.h"

#include <math.h>
#include <string.h>

/* For the critical angle by moments, and both limits; not where none is known. */
static void add_indices(tp_text *t, const tp_study_result *r) {
  static const char *const labels[TP_STUDY_QUANTITIES] = {
      "moments", "onset", "limit", "factor", "FoS, G&B", "acceleration", "support"};
  for (int q = 0; q < TP_STUDY_QUANTITIES; q++) {
    if (!r->variables[0].sobol_indices[q].known) continue;
    tp_text_add(t, "\nSobol' indices, %-15s %20s %20s\n", labels[q], "first order", "total");
    for (size_t k = 0; k < r->variable_count; k++) {
      const tp_study_index *own = r->variables[k].sobol_indices + q;
      tp_text_add(t, "  ");
      tp_encode_column(t, r->variables[k].key, TP_STUDY_LABEL);
      tp_text_add(t, " %6.3f %6.3f to %5.3f %6.3f %6.3f to %5.3f\n", own->first, own->first_low,
                  own->first_high, own->total, own->total_low, own->total_high);
    }
  }
}

static void add_rare(tp_text *t, const char *label, const tp_study_rare *own) {
  if (!own->asked) return;
  if (own->known) {
    tp_text_add(t, "  by %s: %.3g (%.3g to %.3g), %zu scenes solved\n", label, own->probability,
                own->low, own->high, own->scenes);
  } else {
    tp_text_add(t, "  by %s: no answer:", label);
    tp_study_add_lines(t, own->why);
    tp_text_add(t, "\n");
  }
}

/* All design points but the nearest, which stands above, with the numbers there; and what all of
 * them come to. */
static void add_ways(tp_text *t, const tp_study_result *r) {
  const tp_study_reliability *own = &r->reliability;
  double sum = own->probability;
  for (size_t k = 1; k < own->design_point_count; k++) {
    const tp_study_design_point *point = own->design_points + k;
    sum += point->probability;
    tp_text_add(t, "  another design point: beta %.4f, probability %.3g, at", point->beta,
                point->probability);
    const double *at = point->values;
    for (size_t i = 0; i < point->value_count; i++) {
      tp_text_add(t, "%s ", i > 0 ? "," : "");
      tp_encode_plain(t, r->variables[i].key);
      tp_text_add(t, " %.6g", at[i]);
    }
    tp_text_add(t, "\n");
  }
  if (own->design_point_count > 1 && own->beta > 0) {
    tp_text_add(t,
                "  caution: failure has %zu design points; %.3g to first order, if each is\n"
                "  a separate failure mode\n",
                own->design_point_count, sum);
  }
}

static void add_reliability(tp_text *t, const tp_study_result *r) {
  const tp_study_reliability *own = &r->reliability;
  if (!own->known) return;
  const tp_study_quantity quantity = own->quantity;
  tp_text_add(t, "\nFirst-order reliability: %s not above %s\n", tp_study_quantity_name(quantity),
              tp_study_quantity_is_angle(quantity) ? "the tilt" : "1");
  tp_text_add(t, "  %s; %zu scenes solved\n", own->state, own->scenes);
  if (own->converged) {
    tp_text_add(t, "  index beta %.4f, probability %.3g\n", own->beta, own->probability);
  }
  add_ways(t, r);
  add_rare(t,
           own->design_point_count > 1 ? "samples around the design points"
                                       : "samples around the design point",
           &own->importance);
  add_rare(t, "subset simulation", &own->subset);
  if (!own->converged) return;
  tp_text_add(t, "  %-*s %14s %11s\n", TP_STUDY_LABEL, "", "design point", "importance");
  for (size_t k = 0; k < r->variable_count; k++) {
    tp_text_add(t, "  ");
    tp_encode_column(t, r->variables[k].key, TP_STUDY_LABEL);
    tp_text_add(t, " %14.6g %11.3f\n", r->variables[k].design_value, r->variables[k].importance);
  }
}

/* "31.2 (30.9 to 31.5)" */
static void add_interval(tp_text *t, double value, double low, double high) {
  tp_text_add(t, "%.6g (", value);
  if (isinf(low)) {
    tp_text_add(t, "unbounded");
  } else {
    tp_text_add(t, "%.6g", low);
  }
  if (isinf(high)) {
    tp_text_add(t, " to unbounded)");
  } else {
    tp_text_add(t, " to %.6g)", high);
  }
}

/* "certain to stand to 26.71°" */
static void add_quantity(tp_text *t, tp_study_quantity quantity, double value) {
  static const char unit[] = " °";
  char number[TP_NUMBER_SIZE];
  const char *words = tp_study_quantity_words(quantity);
  const bool angle = tp_study_quantity_is_angle(quantity);
  const size_t length = strlen(words) - (angle ? sizeof unit - 1 : 0);
  tp_text_add(t, "%.*s ", (int)length, words);
  if (isinf(value)) {
    tp_text_add(t, "%s", value > 0 ? "always" : "never");
  } else {
    tp_text_add(t, "%s%s", tp_study_number(number, value, quantity), angle ? unit + 1 : "");
  }
}

static void add_design(tp_text *t, const tp_study_result *r, const tp_study_design *own) {
  tp_text_add(t, "  ");
  tp_encode_column(t, r->variables[own->variable].key, TP_STUDY_LABEL);
  if (!own->known) {
    tp_text_add(t, " no solution for %.4g %%:", 100 * own->probability);
    tp_study_add_lines(t, own->why);
    tp_text_add(t, "\n");
    return;
  }
  tp_text_add(t, " ");
  add_interval(t, own->value, own->low, own->high);
  tp_text_add(t, ", not %.6g\n    then ", own->scene_value);
  add_quantity(t, own->quantity, own->quantity_value);
  tp_text_add(t, "; %.4g %% of samples are above; safe end: %s\n", 100 * (1 - own->probability),
              own->low_is_safe ? "lower" : "upper");
}

static void add_designs(tp_text *t, const tp_study_result *r) {
  if (r->design_value_count == 0) return;
  tp_text_add(t, "\nDesign values: one number of the scene that stands for all samples\n");
  for (size_t k = 0; k < r->design_value_count; k++) add_design(t, r, r->design_values + k);
}

void tp_study_add_analyses(tp_text *t, const tp_study_result *result) {
  add_indices(t, result);
  add_reliability(t, result);
  add_designs(t, result);
}
