/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A direction of a solution as a row of a table: the same columns in CSV and in JSON, each number
 * with its bound, empty or null where it is not known. */

#ifndef TP_REPORT_ROW_H
#define TP_REPORT_ROW_H

#include "output/json.h"

/* What `topple solve --csv` tells; and what `topple sweep` tells besides: what happens first, and
 * the governing pivot. */
typedef enum tp_row_columns { TP_ROW_VERDICT, TP_ROW_PIVOT } tp_row_columns;

/* In CSV: the names of the columns, and what stands in them, a comma before each. `own` NULL: as
 * many empty fields. */
void tp_row_names(tp_text *text, tp_row_columns columns);
void tp_row_fields(tp_text *text, tp_row_columns columns, const tp_solution *solution,
                   const tp_case *own);

/* As members of an object. */
void tp_row_members(tp_json *json, tp_row_columns columns, const tp_solution *solution,
                    const tp_case *own);

#endif
