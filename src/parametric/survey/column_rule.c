/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Which columns are of numbers, by the table of keys of scenes, or by the unit of their key. */

#include "scene/unit.h"
#include "scene_varying/slot_table.h"
#include "survey/survey.h"

#include <string.h>

/* Is the key that of the row, a number for each # of that? */
static bool is_of(const char *row, const char *key) {
  while (*row != '\0' && *key != '\0') {
    const size_t digits = strspn(key, "0123456789");
    if (*row == '#' && digits > 0) {
      key += digits;
      row++;
    } else if (*row++ != *key++) {
      return false;
    }
  }
  return *row == *key;
}

void tp_column_take_rule(tp_column *column) {
  static const char parameters[] = "parameters.";
  column->is_number = strncmp(column->key, parameters, strlen(parameters)) == 0 ||
                      tp_key_unit(NULL, column->key) != NULL;
  column->rule = TP_RULE_ANY;
  for (size_t k = 0; k < tp_slot_row_count; k++) {
    if (!is_of(tp_slot_rows[k].key, column->key)) continue;
    column->is_number = true;
    column->rule = tp_slot_rows[k].rule;
  }
}
