/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A dense part of a sparse Cholesky factor, the front of one part of a dissection: the columns of
 * its own rows, and what these take from the rows behind them. All columns run downwards in memory;
 * what is above the diagonal is neither given nor of use. Counts are multiples of three. */

#ifndef TP_ASSEMBLAGE_FRONT_H
#define TP_ASSEMBLAGE_FRONT_H

#include "common/instructions.h"

typedef struct tp_front_kernel {
  /* `columns`, rows x own, become those of the factor; `rest`, (rows - own) square, loses what they
   * take from it. False where a pivot is not above zero. */
  bool (*factorise)(double *columns, long rows, long own, double *rest);
  /* In place, of `rows` numbers: L v = b for the first ones, taken from those behind them; and
   * L^T v = b of the first ones, those behind them being known. */
  void (*solve)(double *v, const double *columns, long rows, long own);
  void (*solve_back)(double *v, const double *columns, long rows, long own);
} tp_front_kernel;

/* Of instructions that are present; all give the same bits. */
const tp_front_kernel *tp_front_kernel_choose(tp_instructions instructions);

#endif
