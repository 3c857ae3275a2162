/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Rows of a table that make the same scene but for its title: a list of bare names over one
 * template is thousands of times the same block. */

#ifndef TP_SURVEY_SAME_ROWS_H
#define TP_SURVEY_SAME_ROWS_H

#include "survey/survey.h"

/* Rows by number, from 0: that behind the head. */
typedef struct tp_same_rows {
  size_t *first;     /* by row: the first that is the same, itself where none before is */
  size_t *different; /* those that are the first, in their order */
  size_t *same;      /* the others */
  size_t different_count, same_count;
} tp_same_rows;

/* Of all rows of the survey; false when memory is exhausted. */
TP_MUST_USE bool tp_same_rows_find(tp_same_rows *rows, const tp_survey *survey);
void tp_same_rows_clear(tp_same_rows *rows);

#endif
