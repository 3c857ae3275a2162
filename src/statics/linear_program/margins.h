/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Linear inequalities that are to hold with a margin:
 *
 *     maximise  sum over rows that want one of u,  0 <= u <= most,
 *     subject to  A x + u + c <= 0 (u is 0 in all other rows),  E x + e = 0,
 *
 * by a primal-dual interior point method (Mehrotra 1992) on the regularised augmented system, which
 * Eigen factorises. Its iterates tend to the middle of all solutions: where a row has no margin at
 * the end, it has none in any solution. Nothing here is certain. */

#ifndef TP_LINEAR_PROGRAM_MARGINS_H
#define TP_LINEAR_PROGRAM_MARGINS_H

#include "topple_basics.h"

#include <stdbool.h>

/* Rows one after another: `first` has an entry more. Of a row a column may occur several times. */
typedef struct tp_margin_rows {
  long count;
  const long *first, *column;
  const double *entry, *constant;
} tp_margin_rows;

typedef struct tp_margin_program {
  long columns;
  tp_margin_rows rows, equations;
  const bool *wants_margin; /* by row */
  double most;              /* margin */
  double most_work;         /* multiplications of one factorisation; beyond it nothing is sought */
} tp_margin_program;

#ifdef __cplusplus
extern "C" {
#endif

/* `x` by column, `margin` by row; `found`: they are near to a solution. */
TP_MUST_USE bool tp_margins_find(bool *found, double *x, double *margin,
                                 const tp_margin_program *program);

#ifdef __cplusplus
}
#endif

#endif
