/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Rows as lines of CSV, written and read back. A number is the shortest decimal that the double
 * has, `inf` and `-inf` where there is no number since it holds at every or at no tilt, and an
 * empty field where there is none for another reason; so that what is read back is what was
 * written. */

#ifndef TP_STUDY_ROW_CSV_H
#define TP_STUDY_ROW_CSV_H

#include "output/text.h"
#include "study/row.h"

/* The names of the columns, and a row. */
void tp_study_write_header(tp_text *text, const tp_study *study);
void tp_study_write_row(tp_text *text, const tp_study *study, const tp_study_row *row);

/* The numbers of a row as KEY=VALUE, as `topple solve --set` takes them, in front of the scene. */
void tp_study_write_settings(tp_text *text, const tp_study *study, const double *values);

/* Read a line, without its end, into a row whose `values` and `at` have room. False: it is none of
 * this study, or memory is exhausted (`*no_memory`). */
TP_MUST_USE bool tp_study_read_row(tp_study_row *row, bool *no_memory, const tp_study *study,
                                   const char *line);

#endif
