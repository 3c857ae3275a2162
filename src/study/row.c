/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "study/row.h"

#include "output/encode.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const char *tp_study_shortest(char out[TP_SHORTEST_SIZE], double value) {
  for (int digits = 15; digits <= 17; digits++) {
    snprintf(out, TP_SHORTEST_SIZE, "%.*g", digits, value);
    if (strtod(out, NULL) == value) break;
  }
  return out;
}

static void add_number(tp_text *text, double value) {
  char out[TP_SHORTEST_SIZE];
  if (isinf(value)) {
    tp_text_add(text, value > 0 ? "inf," : "-inf,");
  } else if (isnan(value)) {
    tp_text_add(text, ",");
  } else {
    tp_text_add(text, "%s,", tp_study_shortest(out, value));
  }
}

void tp_study_write_header(tp_text *text, const tp_study *study) {
  char tilt[TP_SHORTEST_SIZE];
  tp_text_add(text, "sample,");
  for (size_t k = 0; k < study->variable_count; k++) {
    tp_encode_csv(text, study->variables[k].node->key);
    tp_text_add(text, ",");
  }
  tp_text_add(text,
              "outcome,fos,fos_mechanism,fos_definition,first,moments_deg,pivot_x_m,pivot_y_m,"
              "onset_deg,limit_deg,limit_mechanism,");
  for (size_t k = 0; k < study->tilt_count; k++) {
    tp_study_shortest(tilt, study->tilts[k]);
    tp_text_add(text, "outcome_at_%s_deg,fos_at_%s_deg,", tilt, tilt);
  }
  tp_text_add(text, "status,why\n");
}

static const char *definition_name(const tp_study_row *row) {
  return row->fos_definition < 0 ? ""
                                 : tp_fos_definition_name((tp_fos_definition)row->fos_definition);
}

void tp_study_write_row(tp_text *text, const tp_study *study, const tp_study_row *row) {
  const tp_study_outcome own = row->at[0].outcome;
  tp_text_add(text, "%" PRIu64 ",", row->sample);
  for (size_t k = 0; k < study->variable_count; k++) add_number(text, row->values[k]);
  tp_text_add(text, "%s,", tp_study_outcome_name(own));
  add_number(text, row->quantities[TP_STUDY_FOS]);
  tp_text_add(text, "%s,%s,%s,", row->fos_mechanism, definition_name(row), row->first);
  add_number(text, row->quantities[TP_STUDY_MOMENTS_DEG]);
  add_number(text, row->pivot_x_m);
  add_number(text, row->pivot_y_m);
  add_number(text, row->quantities[TP_STUDY_ONSET_DEG]);
  add_number(text, row->quantities[TP_STUDY_LIMIT_DEG]);
  tp_text_add(text, "%s,", row->limit_mechanism);
  for (size_t k = 1; k <= study->tilt_count; k++) {
    tp_text_add(text, "%s,", tp_study_outcome_name(row->at[k].outcome));
    add_number(text, row->at[k].fos);
  }
  tp_text_add(text, "%s,",
              own == TP_STUDY_INVALID ? tp_study_outcome_name(own)
              : row->open             ? "open"
                                      : "certain");
  if (row->why != NULL && own == TP_STUDY_INVALID) tp_encode_csv(text, row->why);
  tp_text_add(text, "\n");
}

void tp_study_write_settings(tp_text *text, const tp_study *study, const double *values) {
  char out[TP_SHORTEST_SIZE];
  for (size_t k = 0; k < study->variable_count; k++) {
    const char *key = study->variables[k].node->key;
    if (k > 0) tp_text_add(text, " ");
    tp_text_append(text, key, strlen(key));
    tp_text_add(text, "=%s", tp_study_shortest(out, values[k]));
  }
}
