/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* In the end each pivot row holds its pivot and columns without one: these are free. How many
 * entries rows and columns have is kept up to date: rows are short, and counting all of them anew
 * for each pivot took most of the time. */

#include "contact_modes/null_space.h"

#include "number/integer_rows.h"

#include <stdlib.h>

typedef struct eliminating {
  fmpz_mat_struct *rows;
  long count, width;
  long *pivot;  /* by row: the column of its pivot; -1: none yet */
  long *row_of; /* by column: the row of which it is the pivot; -1: none */
  long *filled; /* by column: rows with an entry there */
  long *length; /* by row: its entries */
} eliminating;

static fmpz *entry(const eliminating *s, long r, long c) {
  return fmpz_mat_entry(s->rows, r, c);
}

/* `by` 1: the entries of a row are counted in; -1: no longer. */
static void count_row(const eliminating *s, long r, long by) {
  for (long c = 0; c < s->width; c++) {
    if (fmpz_is_zero(entry(s, r, c))) continue;
    s->filled[c] += by;
    s->length[r] += by;
  }
}

/* The shortest row that is left, and in it the column that fills the fewest others. */
static bool find_pivot(long *row, long *column, const eliminating *s) {
  long least = s->width + 1;
  for (long r = 0; r < s->count; r++) {
    if (s->pivot[r] >= 0 || s->length[r] == 0 || s->length[r] >= least) continue;
    least = s->length[r];
    *row = r;
  }
  if (least > s->width) return false;
  long fewest = s->count + 1;
  for (long c = 0; c < s->width; c++) {
    if (fmpz_is_zero(entry(s, *row, c)) || s->filled[c] >= fewest) continue;
    fewest = s->filled[c];
    *column = c;
  }
  return true;
}

static long eliminate_all(const eliminating *s) {
  long rank = 0, row = 0, column = 0;
  for (long r = 0; r < s->count; r++) {
    tp_row_free_of_factor(s->rows, r);
    count_row(s, r, 1);
  }
  for (; find_pivot(&row, &column, s); rank++) {
    s->pivot[row] = column;
    s->row_of[column] = row;
    for (long r = 0; r < s->count; r++) {
      if (r == row || fmpz_is_zero(entry(s, r, column))) continue;
      count_row(s, r, -1);
      tp_row_eliminate(s->rows, r, row, column);
      count_row(s, r, 1);
    }
  }
  return rank;
}

/* One in a free column, times what all pivots divide. */
static void set_vector(fmpz_mat_t space, const eliminating *s, long at, long column) {
  fmpz_t common, part;
  fmpz_init(common);
  fmpz_init(part);
  fmpz_one(common);
  for (long c = 0; c < s->width; c++) {
    const long r = s->row_of[c];
    if (r < 0 || fmpz_is_zero(entry(s, r, column))) continue;
    fmpz_gcd(part, entry(s, r, c), entry(s, r, column));
    fmpz_divexact(part, entry(s, r, c), part);
    fmpz_lcm(common, common, part);
  }
  for (long c = 0; c < s->width; c++) {
    const long r = s->row_of[c];
    if (r < 0 || fmpz_is_zero(entry(s, r, column))) continue;
    fmpz_mul(part, common, entry(s, r, column));
    fmpz_divexact(part, part, entry(s, r, c));
    fmpz_neg(fmpz_mat_entry(space, c, at), part);
  }
  fmpz_set(fmpz_mat_entry(space, column, at), common);
  fmpz_clear(common);
  fmpz_clear(part);
}

bool tp_null_space(fmpz_mat_t space, fmpz_mat_t rows) {
  eliminating s = {.rows = rows, .count = fmpz_mat_nrows(rows), .width = fmpz_mat_ncols(rows)};
  s.pivot = calloc((size_t)s.count + 1, sizeof *s.pivot);
  s.row_of = calloc((size_t)s.width + 1, sizeof *s.row_of);
  s.filled = calloc((size_t)s.width + 1, sizeof *s.filled);
  s.length = calloc((size_t)s.count + 1, sizeof *s.length);
  const bool made = s.pivot != NULL && s.row_of != NULL && s.filled != NULL && s.length != NULL;
  for (long r = 0; r < s.count && made; r++) s.pivot[r] = -1;
  for (long c = 0; c < s.width && made; c++) s.row_of[c] = -1;
  const long rank = made ? eliminate_all(&s) : s.width;
  fmpz_mat_init(space, s.width, s.width - rank);
  long at = 0;
  for (long c = 0; c < s.width && made; c++) {
    if (s.row_of[c] < 0) set_vector(space, &s, at++, c);
  }
  free(s.pivot);
  free(s.row_of);
  free(s.filled);
  free(s.length);
  return made;
}
