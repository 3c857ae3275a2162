/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What was set in the scene before it was solved. */

#ifndef TP_REPORT_SETTINGS_H
#define TP_REPORT_SETTINGS_H

#include "output/json.h"

/* "b = 2*a = 80 mm": the number where the formula is more than one. To be freed; NULL when memory
 * is exhausted. */
char *tp_text_setting(const tp_setting *setting);

/* As a column of CSV: its key, with the unit where there is one to say, block.slab.width_mm; and
 * the number as it was written, of another formula the double nearest to its value. */
void tp_csv_setting_name(tp_text *text, const char *key, const char *unit);
void tp_csv_setting_value(tp_text *text, const tp_setting *setting);

/* The settings that come first under their keys in several lists; to be cleared by free(items).
 * False when memory is exhausted. */
typedef struct tp_setting_columns {
  size_t count;
  const tp_setting **items;
} tp_setting_columns;

TP_MUST_USE bool tp_setting_columns_gather(tp_setting_columns *columns,
                                           const tp_settings *const *lists, size_t count);
/* Each with a comma behind it: the head, and of a row each number that was set, or an empty field.
 */
void tp_csv_setting_columns_head(tp_text *text, const tp_setting_columns *columns);
void tp_csv_setting_columns_row(tp_text *text, const tp_setting_columns *columns,
                                const tp_settings *own);

#endif
