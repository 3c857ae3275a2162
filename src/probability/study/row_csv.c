/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Walks the fields of study/field.h, writing whole numbers, shortest decimals or quoted words. */

#include "study/row_csv.h"

#include "number/shortest.h"
#include "output/encode.h"
#include "study/field.h"

#include <inttypes.h>
#include <math.h>
#include <string.h>

static void add_number(tp_text *text, double value) {
  char out[TP_SHORTEST_SIZE];
  if (isinf(value)) {
    tp_text_add(text, value > 0 ? "inf" : "-inf");
  } else if (!isnan(value)) {
    tp_text_add(text, "%s", tp_shortest(out, value));
  }
}

/* A key may need quotes. */
static void add_name(tp_text *text, const tp_study *study, size_t field) {
  tp_text name = {0};
  tp_study_field_name(&name, study, field);
  if (name.data != NULL) tp_encode_csv(text, name.data);
  text->failed = text->failed || name.failed;
  tp_text_drop(&name);
}

void tp_study_write_header(tp_text *text, const tp_study *study) {
  const size_t count = tp_study_field_count(study);
  for (size_t k = 0; k < count; k++) {
    add_name(text, study, k);
    tp_text_add(text, k + 1 < count ? "," : "\n");
  }
}

void tp_study_write_row(tp_text *text, const tp_study *study, const tp_study_row *row) {
  const size_t count = tp_study_field_count(study);
  for (size_t k = 0; k < count; k++) {
    const tp_study_value own = tp_study_field_value(study, row, k);
    switch (tp_study_field_kind_of(study, k)) {
    case TP_FIELD_WHOLE:
      tp_text_add(text, "%" PRIu64, own.whole);
      break;
    case TP_FIELD_NUMBER:
      add_number(text, own.number);
      break;
    case TP_FIELD_WORDS:
      tp_text_append(text, own.words, strlen(own.words));
      break;
    case TP_FIELD_TEXT:
      if (own.words != NULL) tp_encode_csv(text, own.words);
      break;
    }
    tp_text_append(text, k + 1 < count ? "," : "\n", 1);
  }
}

void tp_study_write_settings(tp_text *text, const tp_study *study, const double *values) {
  char out[TP_SHORTEST_SIZE];
  for (size_t k = 0; k < study->variable_count; k++) {
    const char *key = study->variables[k].node->key;
    if (k > 0) tp_text_add(text, " ");
    tp_text_append(text, key, strlen(key));
    tp_text_add(text, "=%s", tp_shortest(out, values[k]));
  }
}
