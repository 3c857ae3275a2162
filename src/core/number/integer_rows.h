/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Gauss and Jordan's elimination on rows of whole numbers, each freed of its common factor at every
 * step. Where rows join neighbours alone, as contacts do blocks, numbers stay far shorter than the
 * minors of the matrix. */

#ifndef TP_NUMBER_INTEGER_ROWS_H
#define TP_NUMBER_INTEGER_ROWS_H

#include <flint/fmpz_mat.h>

void tp_row_free_of_factor(fmpz_mat_t rows, long row);

/* Row `row`, which has an entry in `column`, times what has the sign of row `by`'s there, less what
 * makes that entry zero. */
void tp_row_eliminate(fmpz_mat_t rows, long row, long by, long column);

#endif
