/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A sample as a row: its numbers, and what became of it. */

#ifndef TP_STUDY_ROW_H
#define TP_STUDY_ROW_H

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
  double fos_moments, fos_sliding; /* at the scene's tilt, whether they count or not */
  double pivot_x_m, pivot_y_m;
  double tilt_deg; /* of the scene; NaN: none. Not written, nor read back */
  const char *first, *limit_mechanism, *fos_mechanism; /* in words; of many blocks the second is
                                                          that of their collapse */
  double measures[TP_MEASURES];                        /* as the study lists them; NaN: none */
  int fos_definition; /* tp_fos_definition of the factor that governs; -1: there is none */
  int design; /* tp_design of the factor that a scene of many blocks requires; -1: of none */
  bool open;
  tp_study_teller told_by;
  double seconds;   /* of computing, where it is told by one of both */
  char *why;        /* of an invalid one, owned; else NULL */
  const char *line; /* of one that was read: the text */
} tp_study_row;

/* The number with so many significant digits as a row shows of what is computed. */
enum { TP_ROW_DIGITS = 10 };
double tp_study_rounded(double value);

/* What is computed of a row that way. */
void tp_study_round_row(tp_study_row *row, const tp_study *study);

#endif
