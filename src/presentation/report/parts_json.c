/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* JSON members shared by several reports: ties, fractions, points. */

#include "report/parts_json.h"

#include <math.h>
#include <stdio.h>

void tp_json_tie(tp_json *j, const char *key, long bits) {
  char words[64] = "exact";
  if (bits > 0) snprintf(words, sizeof words, "not distinguished by %ld bits", bits);
  tp_json_string(j, key, words);
}

void tp_json_fraction(tp_json *j, const char *key, const tp_fraction *f) {
  tp_json_object(j, key, TP_JSON_LINE);
  tp_json_string(j, "numerator", f->numerator);
  tp_json_string(j, "denominator", f->denominator);
  tp_json_close(j);
}

void tp_json_point(tp_json *j, const char *key, tp_bounded x_m, tp_bounded y_m) {
  tp_json_object(j, key, TP_JSON_LINE);
  tp_json_bounded(j, "x_m", x_m);
  tp_json_bounded(j, "y_m", y_m);
  tp_json_close(j);
}

void tp_json_ends(tp_json *j, const char *key, tp_bounded x0_m, tp_bounded y0_m, tp_bounded x1_m,
                  tp_bounded y1_m) {
  tp_json_array(j, key, TP_JSON_LINE);
  tp_json_point(j, NULL, x0_m, y0_m);
  tp_json_point(j, NULL, x1_m, y1_m);
  tp_json_close(j);
}

void tp_json_known(tp_json *j, const char *key, bool known, tp_bounded number) {
  if (known) {
    tp_json_bounded(j, key, number);
  } else {
    tp_json_null(j, key);
  }
}

void tp_json_range(tp_json *j, const char *key, double least, double most) {
  tp_json_object(j, key, TP_JSON_LINE);
  tp_json_double(j, "least", least);
  tp_json_double(j, "most", most);
  tp_json_close(j);
}

void tp_json_number_or_word(tp_json *j, const char *key, double value) {
  if (isinf(value)) {
    tp_json_string(j, key, value > 0 ? "always" : "never");
  } else {
    tp_json_double(j, key, value);
  }
}

tp_bounded tp_bounded_negated(tp_bounded number) {
  return (tp_bounded){.value = 0 - number.value, .error = number.error};
}
