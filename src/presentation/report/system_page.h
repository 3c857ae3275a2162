/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Parts of the page of many blocks. */

#ifndef TP_REPORT_SYSTEM_PAGE_H
#define TP_REPORT_SYSTEM_PAGE_H

#include "output/text.h"

/* The rows of a table on a page; more stand in JSON, which a line says. */
enum { TP_SYSTEM_ROWS = 60 };
void tp_text_more_rows(tp_text *text, size_t rows);

/* The label of a number, in a column; the name of a block, in `width`. */
void tp_text_system_label(tp_text *text, const char *label);
void tp_text_system_name(tp_text *text, const char *name, int width);

/* The support that a case is asked for, and its loads in a table, names in `width`: nothing where
 * there are none. */
void tp_text_system_support(tp_text *text, const tp_block_system *system, const tp_system_case *of);
void tp_text_system_loads(tp_text *text, const tp_block_system *system, const tp_system_case *of,
                          int width);

/* Does water press in some of its contacts? */
bool tp_system_case_is_wet(const tp_system_case *of);

#endif
