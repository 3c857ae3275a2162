/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A small linear program in doubles, all entries at hand:
 *
 *     maximise o . x  subject to  T x + slack = b >= 0,  x >= 0,  slack >= 0
 *
 * where the slack of a row that must hold exactly never enters. By the simplex method on the
 * condensed tableau, which begins with x = 0. Nothing here is certain: its answers are to be proven
 * by whoever asks. */

#ifndef TP_CONTACT_MODES_DENSE_PROGRAM_H
#define TP_CONTACT_MODES_DENSE_PROGRAM_H

#include "topple_basics.h"

typedef struct tp_dense_program {
  long rows, columns;
  double *entries;       /* (rows + 2) x (columns + 1): b is the last column; the last two rows are
                            objectives */
  long *basic, *outside; /* variables: those of x, then slacks from `columns` on */
  bool *exact;           /* by row: its slack must be zero in the end */
  bool is_limited; /* objectives are known to have a limit: what seems to have none, by rounding,
                      is passed over */
  bool *barred;    /* by variable: it was */
  double tie; /* by what share numbers may differ, by rounding, of which the first is as good */
  long work;  /* entries changed so far */
} tp_dense_program;

#define TP_DENSE_TIE 1e-9 /* of programs that are to be the same for images of blocks */

enum { TP_DENSE_OBJECTIVES = 2 };

/* With zeros in all entries; false when memory is exhausted. */
TP_MUST_USE bool tp_dense_program_init(tp_dense_program *program, long rows, long columns);
void tp_dense_program_clear(tp_dense_program *program);

/* Row `rows` is the first objective, the one after it the second. */
double *tp_dense_program_entry(tp_dense_program *program, long row, long column);
double *tp_dense_program_right(tp_dense_program *program, long row);

/* Climb the first or the second objective as far as it goes; false: it has no limit, or rounding
 * goes in circles. */
bool tp_dense_program_climb(tp_dense_program *program, int objective);

/* By row: how much an objective would rise with its right-hand side, by a little. */
void tp_dense_program_multipliers(double *of_row, const tp_dense_program *program, int objective);

/* x[columns], none below zero. */
void tp_dense_program_solution(double *x, const tp_dense_program *program);

#endif
