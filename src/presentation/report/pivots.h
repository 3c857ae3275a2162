/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The candidate pivots of a case, in text and in JSON. */

#ifndef TP_REPORT_PIVOTS_H
#define TP_REPORT_PIVOTS_H

#include "output/json.h"
#include "report/page.h"

/* The table of pivots, numbered as in figures. */
void tp_page_add_pivots(tp_page *page, const tp_case *own);

/* Does a table have a row for a pivot of the list? The admissible ones, and of the others as many
 * as fit, those nearest to the toe. */
bool tp_pivot_has_row(const tp_case *own, size_t pivot);

/* How it turns about the pivot: "governs", "free" or "blocked". */
const char *tp_text_turning(const tp_case *own, size_t pivot);

#endif
