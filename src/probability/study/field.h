/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The fields of a row, which are the columns of all rows, in their order: the number of the sample,
 * the numbers that vary, what became of it, at the scene's tilt and at those of the study, its
 * status, and why one is invalid. One table for every file that rows are written to. */

#ifndef TP_STUDY_FIELD_H
#define TP_STUDY_FIELD_H

#include "output/text.h"
#include "study/row.h"

typedef enum tp_study_field_kind {
  TP_FIELD_WHOLE,  /* a whole number from 0 on */
  TP_FIELD_NUMBER, /* a double; NaN: there is none */
  TP_FIELD_WORDS,  /* one of some words, of TP_FIELD_WORDS_SIZE at most; may be empty */
  TP_FIELD_TEXT    /* any plain text */
} tp_study_field_kind;

enum { TP_FIELD_WORDS_SIZE = 32 };

/* What a row has in a field, by its kind. */
typedef struct tp_study_value {
  uint64_t whole;
  double number;
  const char *words; /* of a text too; NULL: none */
} tp_study_value;

size_t tp_study_field_count(const tp_study *study);
/* That of the k-th number that varies, or that is measured of the base. */
size_t tp_study_field_of_variable(size_t variable);
size_t tp_study_field_of_measure(const tp_study *study, size_t measure);
tp_study_field_kind tp_study_field_kind_of(const tp_study *study, size_t field);

/* Its name, with the unit of a length in it, as block.slab.height_mm; and the unit, NULL where it
 * has none. */
void tp_study_field_name(tp_text *text, const tp_study *study, size_t field);
const char *tp_study_field_unit(const tp_study *study, size_t field);

/* Where a row has it: one of these; none of them is where why it is invalid. */
typedef struct tp_study_place {
  uint64_t *whole;
  double *number;
  const char **words;
  tp_study_outcome *outcome;
  int *definition, *design; /* tp_fos_definition, tp_design; -1: none */
  bool is_status;
} tp_study_place;

tp_study_place tp_study_field_place(const tp_study *study, tp_study_row *row, size_t field);
tp_study_value tp_study_field_value(const tp_study *study, const tp_study_row *row, size_t field);

#endif
