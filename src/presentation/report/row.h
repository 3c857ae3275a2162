/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A direction of a solution as a row of a table: the same columns in CSV and in JSON, each number
 * with its bound, empty or null where it is not known. The columns stand in
 * core/terms/results/sweep.csv; here is how one is written. */

#ifndef TP_REPORT_ROW_H
#define TP_REPORT_ROW_H

#include "evaluation/case_numbers.h"
#include "output/json.h"

/* A number of a case, or words, empty where there are none. */
typedef tp_case_state tp_number_of_case(tp_bounded *number, const tp_case *own);
typedef void tp_words_of_case(tp_text *text, const tp_case *own);

void tp_json_of_case(tp_json *json, const char *key, tp_number_of_case *number, const tp_case *own);
void tp_json_text_of_case(tp_json *json, const char *key, tp_words_of_case *words,
                          const tp_case *own);

/* A comma and the field; of a number two, and its bound. Words that are NULL are none. */
void tp_csv_of_case(tp_text *text, tp_number_of_case *number, const tp_case *own);
void tp_csv_text_of_case(tp_text *text, tp_words_of_case *words, const tp_case *own);
void tp_csv_bounded(tp_text *text, bool known, tp_bounded number);
void tp_csv_number(tp_text *text, bool known, double number); /* one that has no bound */
void tp_csv_count(tp_text *text, bool known, size_t count);
void tp_csv_text(tp_text *text, const char *outside); /* from outside; NULL: no field */
void tp_csv_words(tp_text *text, const char *words);

#endif
