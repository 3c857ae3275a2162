/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A linear program of three rows in double arithmetic:
 *
 *     maximise t subject to  sum_k f_k column_k + t direction = target,  0 <= f_k <= most_k.
 *
 * With a direction of zeros any solution will do. The bounded simplex method with the basis inverse
 * at hand (3 x 3), the column of the most negative reduced cost entering, or where that is bounded
 * every bounded one that gains, in turn; a handful of passes over the columns. Nothing here is
 * certain: the answer is a basis that a certificate then judges. Columns are best scaled to size
 * one. */

#ifndef TP_LINEAR_PROGRAM_SIMPLEX_H
#define TP_LINEAR_PROGRAM_SIMPLEX_H

#include <stdbool.h>

typedef struct tp_simplex_program {
  long count;
  const double (*columns)[3];
  const double *most; /* NULL: no column is bounded; INFINITY: this one is not */
  double direction[3], target[3];
} tp_simplex_program;

typedef enum tp_simplex_outcome {
  TP_SIMPLEX_OPTIMAL,
  TP_SIMPLEX_UNBOUNDED,
  TP_SIMPLEX_INFEASIBLE,
  TP_SIMPLEX_STUCK /* too many steps: rounding goes in circles */
} tp_simplex_outcome;

enum { TP_SIMPLEX_T = -1, TP_SIMPLEX_NONE = -2 };

/* The basis: a column, TP_SIMPLEX_T, or TP_SIMPLEX_NONE for a row that nothing is needed for. The
 * dual: the twist (v_x, v_y, omega) with dual . column >= 0 for every column below its bound. Where
 * infeasible it separates: dual . target < 0. */
typedef struct tp_simplex_answer {
  tp_simplex_outcome outcome;
  double t;
  long basis[3];
  double values[3], dual[3];
} tp_simplex_answer;

/* `at_most` has room for a flag a column, where there are bounds: set for those at their bound. As
 * given they are where the search starts: those of a program much like this one save most of it. */
tp_simplex_answer tp_simplex_solve(const tp_simplex_program *program, bool *at_most);

#endif
