/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A setting as key, formula, value and unit in text, CSV and JSON; a plain decimal is not repeated
 * as its value. */

#include "report/settings.h"

#include "output/encode.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A decimal, with nothing to compute. */
static bool is_plain(const char *text) {
  char *end = NULL;
  (void)strtod(text, &end);
  return end != text && *end == '\0' && text[strspn(text, "+-.0123456789eE")] == '\0';
}

char *tp_text_setting(const tp_setting *setting) {
  tp_text t = {0};
  char *result = NULL, number[TP_NUMBER_SIZE];
  tp_encode_plain(&t, setting->key);
  tp_text_add(&t, " = ");
  tp_encode_plain(&t, setting->formula);
  if (!is_plain(setting->formula)) {
    tp_text_add(&t, " = %s", tp_text_significant(number, setting->value, 12));
  }
  if (setting->unit != NULL) {
    tp_text_add(&t, " ");
    tp_encode_plain(&t, setting->unit);
  }
  return tp_text_finish(&t, &result) == TP_OK ? result : NULL;
}

void tp_csv_setting_name(tp_text *t, const char *key, const char *unit) {
  tp_text name = {0};
  tp_text_add(&name, "%s%s%s", key, unit != NULL ? "_" : "", unit != NULL ? unit : "");
  if (name.data != NULL) tp_encode_csv(t, name.data);
  t->failed = t->failed || name.failed;
  tp_text_drop(&name);
}

void tp_csv_setting_value(tp_text *t, const tp_setting *setting) {
  if (is_plain(setting->formula)) {
    tp_encode_csv(t, setting->formula);
  } else if (!isnan(setting->value.value)) {
    tp_text_add(t, "%.17g", setting->value.value);
  }
}
