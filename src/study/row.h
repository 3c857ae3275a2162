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

typedef struct tp_study_row {
  uint64_t sample;
  double *values;  /* of the variables; the caller's, as `at` is */
  tp_study_at *at; /* the scene's tilt, and those of the study */
  double quantities[TP_STUDY_QUANTITIES];
  double pivot_x_m, pivot_y_m;
  double tilt_deg; /* of the scene; NaN: none. Not written, nor read back */
  const char *first, *limit_mechanism, *fos_mechanism; /* in words */
  double measures[TP_MEASURES];                        /* as the study lists them; NaN: none */
  int fos_definition; /* tp_fos_definition of the factor that governs; -1: there is none */
  bool open;
  char *why;        /* of an invalid one, owned; else NULL */
  const char *line; /* of one that was read: the text */
} tp_study_row;

#endif
