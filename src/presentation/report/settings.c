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

static bool has_column(const tp_setting_columns *columns, const char *key) {
  for (size_t k = 0; k < columns->count; k++) {
    if (strcmp(columns->items[k]->key, key) == 0) return true;
  }
  return false;
}

bool tp_setting_columns_gather(tp_setting_columns *columns, const tp_settings *const *lists,
                               size_t count) {
  size_t room = 1;
  for (size_t k = 0; k < count; k++) room += lists[k]->count;
  *columns = (tp_setting_columns){.items = calloc(room, sizeof *columns->items)};
  for (size_t k = 0; k < count && columns->items != NULL; k++) {
    for (size_t n = 0; n < lists[k]->count; n++) {
      const tp_setting *own = lists[k]->items + n;
      if (!has_column(columns, own->key)) columns->items[columns->count++] = own;
    }
  }
  return columns->items != NULL;
}

void tp_csv_setting_columns_head(tp_text *t, const tp_setting_columns *columns) {
  for (size_t k = 0; k < columns->count; k++) {
    tp_csv_setting_name(t, columns->items[k]->key, columns->items[k]->unit);
    tp_text_add(t, ",");
  }
}

void tp_csv_setting_columns_row(tp_text *t, const tp_setting_columns *columns,
                                const tp_settings *own) {
  for (size_t k = 0; k < columns->count; k++) {
    size_t n = 0;
    while (n < own->count && strcmp(own->items[n].key, columns->items[k]->key) != 0) n++;
    if (n < own->count) tp_csv_setting_value(t, own->items + n);
    tp_text_add(t, ",");
  }
}
