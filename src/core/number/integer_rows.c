/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* By FLINT's vectors of whole numbers. */

#include "number/integer_rows.h"

#include <flint/fmpz_vec.h>

void tp_row_free_of_factor(fmpz_mat_t rows, long row) {
  fmpz *own = rows->rows[row];
  const long width = fmpz_mat_ncols(rows);
  fmpz_t factor;
  fmpz_init(factor);
  _fmpz_vec_content(factor, own, width);
  if (!fmpz_is_zero(factor) && !fmpz_is_one(factor)) {
    _fmpz_vec_scalar_divexact_fmpz(own, own, width, factor);
  }
  fmpz_clear(factor);
}

void tp_row_eliminate(fmpz_mat_t rows, long row, long by, long column) {
  fmpz *to = rows->rows[row];
  const fmpz *from = rows->rows[by];
  fmpz_t own, pivot, factor;
  fmpz_init(own);
  fmpz_init(pivot);
  fmpz_init(factor);
  fmpz_gcd(factor, to + column, from + column);
  fmpz_divexact(own, to + column, factor);
  fmpz_divexact(pivot, from + column, factor);
  for (long c = 0; c < fmpz_mat_ncols(rows); c++) {
    if (!fmpz_is_zero(to + c)) fmpz_mul(to + c, to + c, pivot);
    if (!fmpz_is_zero(from + c)) fmpz_submul(to + c, from + c, own);
  }
  tp_row_free_of_factor(rows, row);
  fmpz_clear(own);
  fmpz_clear(pivot);
  fmpz_clear(factor);
}
