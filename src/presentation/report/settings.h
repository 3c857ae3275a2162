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

#endif
