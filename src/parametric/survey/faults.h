/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What is wrong with a row of a table: all of it; and with many rows alike, once. */

#ifndef TP_SURVEY_FAULTS_H
#define TP_SURVEY_FAULTS_H

#include "output/text.h"
#include "survey/survey.h"
#include "topple_batch.h"

/* "column 'height (m)': 'n/a' is not a number; …" */
typedef struct tp_row_fault {
  size_t column; /* counted from 1; 0: of none */
  char *value;   /* of the cell, which stands before the text; NULL: none */
  char *text;
} tp_row_fault;

/* Begin with {0}. */
struct tp_row_faults {
  long count, room;
  tp_row_fault *items;
};

TP_MUST_USE tp_status tp_row_faults_add(tp_row_faults *faults, size_t column, const char *value,
                                        const char *text, tp_message *message);
void tp_row_faults_clear(tp_row_faults *faults);

/* What reading or solving the scene of a row told, or of its load case (NULL: of none), as a fault
 * with its place in the table, or in the file that the row is over. */
TP_MUST_USE tp_status tp_row_faults_locate(tp_row_faults *faults, const tp_survey *survey,
                                           const tp_scene_text *text, const char *load_case,
                                           tp_message *message);

/* All of the row, with its place: "survey.csv:7:3: block 'B3': column 'width (m)': …; …", to be
 * freed; NULL when memory is exhausted. */
char *tp_row_faults_remark(const tp_row_faults *faults, const tp_survey *survey, size_t row);

/* Fill in the faults of the batch, of `batch->row_count` rows in the order of the table. */
TP_MUST_USE tp_status tp_batch_group_faults(tp_batch *batch, const tp_row_faults *rows,
                                            const tp_survey *survey, tp_message *message);

/* ---- parts of what is said ---------------------------------------------------------------------
 */

/* "survey.csv:7:3: block 'B3': " */
void tp_fault_add_place(tp_text *text, const tp_survey *survey, size_t row, size_t column);

/* "column 'height (m)': 'n/a' is not a number; …" */
void tp_fault_add(tp_text *text, const tp_survey *survey, const tp_row_fault *fault);

/* The text made plain, to be freed; NULL when memory is exhausted. */
char *tp_fault_finish(tp_text *text);

#endif
