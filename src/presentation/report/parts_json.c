/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* JSON members shared by several reports: factors of safety with words, ties, fractions, points,
 * critical angles. */

#include "report/parts_json.h"

#include "report/words.h"

#include <stdio.h>

/* A factor of safety in words, beside its key. */
static void add_words(tp_json *j, const char *key, const char *words) {
  char key_is[32];
  snprintf(key_is, sizeof key_is, "%s_is", key);
  tp_json_string(j, key_is, words);
}

void tp_json_fos(tp_json *j, const char *key, tp_fos fos) {
  const char *words = tp_text_fos(fos);
  tp_json_known(j, key, fos.state == TP_FOS_NUMBER, fos.value);
  if (words != NULL) add_words(j, key, words);
}

void tp_json_no_fos(tp_json *j, const char *key, const char *words) {
  tp_json_null(j, key);
  add_words(j, key, words);
}

void tp_json_tie(tp_json *j, bool tie, long bits) {
  if (!tie) return;
  char words[64] = "exact";
  if (bits > 0) snprintf(words, sizeof words, "not distinguished by %ld bits", bits);
  tp_json_string(j, "tie_is", words);
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

void tp_json_known(tp_json *j, const char *key, bool known, tp_bounded number) {
  if (known) {
    tp_json_bounded(j, key, number);
  } else {
    tp_json_null(j, key);
  }
}

void tp_json_critical_angle(tp_json *j, const tp_pivot *p) {
  const bool none = p->never || p->always;
  tp_json_known(j, "critical_angle_deg", !none, p->critical_angle_deg);
  if (none) tp_json_string(j, "critical_angle_is", p->never ? "never" : "always");
}
