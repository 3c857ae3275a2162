/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Fields of a row in CSV and in JSON. */

#include "report/row.h"

#include "output/encode.h"
#include "report/parts_json.h"

void tp_json_of_case(tp_json *j, const char *key, tp_number_of_case *number, const tp_case *c) {
  tp_bounded value = {0};
  const bool known = number(&value, c) == TP_CASE_NUMBER;
  tp_json_known(j, key, known, value);
}

void tp_json_text_of_case(tp_json *j, const char *key, tp_words_of_case *words, const tp_case *c) {
  tp_text text = {0};
  words(&text, c);
  tp_json_string(j, key, text.data);
  j->text.failed = j->text.failed || text.failed;
  tp_text_drop(&text);
}

void tp_csv_of_case(tp_text *t, tp_number_of_case *number, const tp_case *c) {
  tp_bounded value = {0};
  const bool known = number(&value, c) == TP_CASE_NUMBER;
  tp_csv_bounded(t, known, value);
}

void tp_csv_text_of_case(tp_text *t, tp_words_of_case *words, const tp_case *c) {
  tp_text_add(t, ",");
  words(t, c);
}

void tp_csv_bounded(tp_text *t, bool known, tp_bounded number) {
  if (known) {
    tp_text_add(t, ",%.17g,%.17g", number.value, number.error);
  } else {
    tp_text_add(t, ",,");
  }
}

void tp_csv_number(tp_text *t, bool known, double number) {
  tp_text_add(t, ",");
  if (known) tp_text_add(t, "%.17g", number);
}

void tp_csv_count(tp_text *t, bool known, size_t count) {
  tp_text_add(t, ",");
  if (known) tp_text_add(t, "%zu", count);
}

void tp_csv_text(tp_text *t, const char *outside) {
  tp_text_add(t, ",");
  if (outside != NULL) tp_encode_csv(t, outside);
}

void tp_csv_words(tp_text *t, const char *words) {
  tp_text_add(t, ",%s", words != NULL ? words : "");
}
