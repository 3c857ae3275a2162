/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The linear algebra under the motions of many blocks, whose pivots are found from what is kept up
 * to date: null spaces in whole numbers against FLINT's rank and by multiplication, and the basis
 * of forces against a choice that looks at every entry for every pivot. */

#include "contact_modes/basis_proof.h"
#include "contact_modes/null_space.h"
#include "random_numbers.h"
#include "suite.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

/* ---- null space --------------------------------------------------------------------------------
 */

/* Short rows, as of contacts, and some that follow of others. */
static void fill_rows(fmpz_mat_t rows, random_numbers *r) {
  const long count = fmpz_mat_nrows(rows), width = fmpz_mat_ncols(rows);
  for (long k = 0; k < count; k++) {
    for (int n = 0; n < 4; n++) {
      fmpz_set_si(fmpz_mat_entry(rows, k, draw_below(r, width)), draw_below(r, 19) - 9);
    }
    if (k < 2 || draw_below(r, 4) > 0) continue;
    for (long c = 0; c < width; c++) {
      fmpz_add(fmpz_mat_entry(rows, k, c), fmpz_mat_entry(rows, k - 1, c),
               fmpz_mat_entry(rows, k - 2, c));
    }
  }
}

START_TEST(null_spaces) {
  random_numbers r = random_numbers_from((uint64_t)_i);
  const long count = 1 + draw_below(&r, 14), width = 1 + draw_below(&r, 14);
  fmpz_mat_t rows, used, space, product;
  fmpz_mat_init(rows, count, width);
  fill_rows(rows, &r);
  fmpz_mat_init_set(used, rows);
  ck_assert(tp_null_space(space, used));
  ck_assert_int_eq(fmpz_mat_ncols(space), width - fmpz_mat_rank(rows));
  ck_assert_int_eq(fmpz_mat_rank(space), fmpz_mat_ncols(space));
  fmpz_mat_init(product, count, fmpz_mat_ncols(space));
  fmpz_mat_mul(product, rows, space);
  ck_assert(fmpz_mat_is_zero(product));
  fmpz_mat_clear(rows);
  fmpz_mat_clear(used);
  fmpz_mat_clear(space);
  fmpz_mat_clear(product);
}
END_TEST

/* ---- basis -------------------------------------------------------------------------------------
 */

enum { ROWS = 7, COLUMNS = 12 };

/* The entry of a row over its largest one, times the preference of its column, that is the largest
 * of all that are left, again and again. */
static void choose_by_looking(bool chosen[COLUMNS], double entries[ROWS][COLUMNS],
                              const double *preference) {
  bool used[ROWS] = {false};
  memset(chosen, 0, COLUMNS * sizeof *chosen);
  for (int r = 0; r < ROWS; r++) {
    double most = 0;
    for (int c = 0; c < COLUMNS; c++) most = fmax(most, fabs(entries[r][c]));
    for (int c = 0; c < COLUMNS; c++) entries[r][c] /= most;
  }
  for (int k = 0; k < ROWS; k++) {
    int row = -1, column = -1;
    for (int r = 0; r < ROWS; r++) {
      for (int c = 0; c < COLUMNS && !used[r]; c++) {
        if (chosen[c] || fabs(entries[r][c]) < 1e-13) continue;
        if (row >= 0 && fabs(entries[r][c]) * preference[c] <=
                            fabs(entries[row][column]) * preference[column]) {
          continue;
        }
        row = r;
        column = c;
      }
    }
    ck_assert_int_ge(row, 0);
    used[row] = chosen[column] = true;
    for (int r = 0; r < ROWS; r++) {
      const double factor = used[r] ? 0 : entries[r][column] / entries[row][column];
      for (int c = 0; c < COLUMNS; c++) entries[r][c] -= factor * entries[row][c];
    }
  }
}

START_TEST(bases) {
  random_numbers r = random_numbers_from((uint64_t)_i);
  double entries[ROWS][COLUMNS] = {{0}}, preference[COLUMNS];
  bool chosen[COLUMNS];
  arb_mat_t columns, right, factors, product;
  tp_message message = {.text = ""};
  arb_mat_init(columns, ROWS, COLUMNS);
  arb_mat_init(right, ROWS, 1);
  arb_mat_init(factors, COLUMNS, 1);
  arb_mat_init(product, ROWS, 1);
  for (int c = 0; c < COLUMNS; c++) {
    preference[c] = (double)(1 + draw_below(&r, 9));
    for (int k = 0; k < 3; k++) entries[draw_below(&r, ROWS)][c] = (double)(1 + draw_below(&r, 90));
    if (c < ROWS) entries[c][c] = 100; /* so that there is a basis */
    arb_set_si(arb_mat_entry(factors, c, 0), 1 + draw_below(&r, 9));
  }
  for (int k = 0; k < ROWS; k++) {
    arb_set_si(arb_mat_entry(right, k, 0), draw_below(&r, 50));
    for (int c = 0; c < COLUMNS; c++) arb_set_d(arb_mat_entry(columns, k, c), entries[k][c]);
  }
  choose_by_looking(chosen, entries, preference);
  const tp_basis_task task = {columns, right, preference, 128};
  ck_assert_msg(tp_basis_solve(factors, &task, &message) == TP_OK, "%s", message.text);
  arb_mat_mul(product, columns, factors, 128);
  ck_assert(arb_mat_contains(product, right));
  for (int c = 0; c < COLUMNS; c++) { /* what is given stays exact; what is solved has a bound */
    ck_assert_int_eq(arb_is_exact(arb_mat_entry(factors, c, 0)), !chosen[c]);
  }
  arb_mat_clear(columns);
  arb_mat_clear(right);
  arb_mat_clear(factors);
  arb_mat_clear(product);
}
END_TEST

SUITE(mode_algebra) {
  Suite *suite = suite_create("mode_algebra");
  TCase *tests = tcase_create("pivots");
  tcase_add_loop_test(tests, null_spaces, 0, 40);
  tcase_add_loop_test(tests, bases, 0, 20);
  suite_add_tcase(suite, tests);
  return suite;
}
