/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A sample as a row: its numbers, and what became of it; written as a line of CSV and read back. A
 * number is the shortest decimal that the double has, `inf` and `-inf` where there is no number
 * since it holds at every or at no tilt, and an empty field where there is none for another reason;
 * so that what is read back is what was written. */

#ifndef TP_STUDY_ROW_H
#define TP_STUDY_ROW_H

#include "output/text.h"
#include "study/study.h"

/* What becomes of a sample at a tilt. */
typedef struct tp_study_at {
  tp_study_outcome outcome;
  double fos;
} tp_study_at;

/* What told a sample. Of a row that was read it is not known, but can be found again
 * (sample_filter.h). */
typedef enum tp_study_teller {
  TP_TOLD_UNKNOWN,
  TP_TOLD_BY_DOUBLES,
  TP_TOLD_BY_LADDER
} tp_study_teller;

typedef struct tp_study_row {
  uint64_t sample;
  double *values;  /* of the variables; the caller's, as `at` is */
  tp_study_at *at; /* the scene's tilt, and those of the study */
  double quantities[TP_STUDY_QUANTITIES];
  double pivot_x_m, pivot_y_m;
  double tilt_deg; /* of the scene; NaN: none. Not written, nor read back */
  const char *first, *limit_mechanism, *fos_mechanism; /* in words; not read back */
  int fos_definition; /* tp_fos_definition of the factor that governs; -1: there is none */
  bool open;
  tp_study_teller told_by;
  double seconds;   /* of computing, where it is told by one of both */
  char *why;        /* of an invalid one, owned; else NULL */
  const char *line; /* of one that was read: the text */
} tp_study_row;

enum { TP_SHORTEST_SIZE = 32 };

/* The shortest of the decimals of up to 17 digits that name the double. */
const char *tp_study_shortest(char out[TP_SHORTEST_SIZE], double value);

/* The number with so many significant digits as a row shows of what is computed. */
enum { TP_ROW_DIGITS = 10 };
double tp_study_rounded(double value);

/* What is computed of a row that way, all that is told of it. */
void tp_study_round_row(tp_study_row *row, size_t tilts);

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
