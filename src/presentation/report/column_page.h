/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What Goodman and Bray's method tells of columns in a row, on the page of many blocks. */

#ifndef TP_REPORT_COLUMN_PAGE_H
#define TP_REPORT_COLUMN_PAGE_H

#include "output/language.h"
#include "output/text.h"

/* Its factor, or that there is none. */
void tp_text_goodman_bray_factor(tp_text *text, const tp_goodman_bray *own);

/* By how much more friction it asks for than forces need which act where it is best: the factor by
 * strength reduction over its own. False where one of both is no number. */
bool tp_goodman_bray_cost(double *ratio, const tp_system_case *own);

/* What columns do side by side, counted from the toe up: "sliding 1 to 3, toppling 4 to 13". */
void tp_text_goodman_bray_zones(tp_text *text, const tp_goodman_bray *own,
                                const tp_language *language);

/* Its numbers, the assumption and what it costs, and the columns in a table, names in `width`. */
void tp_text_goodman_bray(tp_text *text, const tp_block_system *system, const tp_system_case *own,
                          int width);

#endif
