/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The basis is chosen in doubles by elimination with the column of the most preference times pivot
 * first. Then one solution in balls, of each part by itself: what exactly nothing acts on stays
 * exactly nothing. */

#include "contact_modes/basis_proof.h"

#include "common/message.h"
#include "contact_modes/enclosed_solve.h"

#include <math.h>
#include <stdlib.h>

typedef struct choosing {
  long rows, count;
  double *entries; /* rows x count, row by row */
  long *chosen;    /* by row */
  bool *taken;     /* by column */
  double *most; /* by row: the largest entry of columns left, times preference; 0: there is none */
  long *best;   /* by row: of which column that is */
} choosing;

static double middle(const arb_mat_struct *m, long r, long c) {
  return arf_get_d(arb_midref(arb_mat_entry(m, r, c)), ARF_RND_NEAR);
}

/* Rows over their largest entry: some blocks weigh next to nothing. */
static void set_entries(choosing *s, const tp_basis_task *t) {
  for (long r = 0; r < s->rows; r++) {
    double *own = s->entries + r * s->count, most = 0;
    for (long c = 0; c < s->count; c++) {
      own[c] = middle(t->columns, r, c);
      most = fmax(most, fabs(own[c]));
    }
    for (long c = 0; c < s->count && most > 0; c++) own[c] /= most;
  }
}

/* The largest entry of a row that is left, times the preference of its column. */
static void find_best(choosing *s, long r, const double *preference) {
  static const double least = 1e-13;
  const double *entries = s->entries + r * s->count;
  s->most[r] = 0;
  for (long c = 0; c < s->count; c++) {
    const double own = fabs(entries[c]);
    if (s->taken[c] || own < least || own * preference[c] <= s->most[r]) continue;
    s->most[r] = own * preference[c];
    s->best[r] = c;
  }
}

/* Of all rows that are left; -1: there is none. */
static long find_pivot(const choosing *s, const bool *used) {
  double most = 0;
  long row = -1;
  for (long r = 0; r < s->rows; r++) {
    if (used[r] || s->most[r] <= most) continue;
    most = s->most[r];
    row = r;
  }
  return row;
}

/* Rows without an entry in the column of a pivot stay as they were, and so does their largest. */
static bool choose(choosing *s, bool *used, const double *preference) {
  for (long r = 0; r < s->rows; r++) find_best(s, r, preference);
  for (long k = 0; k < s->rows; k++) {
    const long row = find_pivot(s, used);
    if (row < 0) return false;
    const long column = s->best[row];
    used[row] = true;
    s->taken[column] = true;
    s->chosen[k] = column;
    const double *own = s->entries + row * s->count;
    for (long r = 0; r < s->rows; r++) {
      double *other = s->entries + r * s->count;
      const double factor = used[r] ? 0 : other[column] / own[column];
      if (factor == 0) continue;
      for (long c = 0; c < s->count; c++) other[c] -= factor * own[c];
      find_best(s, r, preference);
    }
  }
  return true;
}

/* The right-hand side less what the others bear. */
static void set_rest(arb_mat_t rest, const arb_mat_t factors, const tp_basis_task *t,
                     const choosing *s) {
  arb_mat_set(rest, t->right);
  for (long r = 0; r < s->rows; r++) {
    for (long c = 0; c < s->count; c++) {
      if (s->taken[c] || arb_is_zero(arb_mat_entry(t->columns, r, c))) continue;
      arb_submul(arb_mat_entry(rest, r, 0), arb_mat_entry(t->columns, r, c),
                 arb_mat_entry(factors, c, 0), t->bits);
    }
  }
}

/* Rows that columns of the basis join get one number, that of the least. */
static void join_rows(long *part, const tp_basis_task *t, const choosing *s) {
  for (long r = 0; r < s->rows; r++) part[r] = r;
  for (bool changed = true; changed;) {
    changed = false;
    for (long k = 0; k < s->rows; k++) {
      long least = s->rows;
      for (int pass = 0; pass < 2; pass++) {
        for (long r = 0; r < s->rows; r++) {
          if (arb_is_zero(arb_mat_entry(t->columns, r, s->chosen[k]))) continue;
          if (pass == 0 && part[r] < least) least = part[r];
          if (pass == 0 || part[r] == least) continue;
          part[r] = least;
          changed = true;
        }
      }
    }
  }
}

/* The rows of one part, and the columns of the basis in it, as many. Not `made`: memory is
 * exhausted. */
static bool solve_part(bool *made, arb_mat_t factors, const arb_mat_t rest, const tp_basis_task *t,
                       const choosing *s, const long *part, long which, long *rows, long *columns) {
  long row_count = 0, column_count = 0;
  for (long r = 0; r < s->rows; r++) {
    if (part[r] == which) rows[row_count++] = r;
  }
  for (long k = 0; k < s->rows; k++) {
    bool own = false;
    for (long r = 0; r < row_count && !own; r++) {
      own = !arb_is_zero(arb_mat_entry(t->columns, rows[r], s->chosen[k]));
    }
    if (own) columns[column_count++] = s->chosen[k];
  }
  if (row_count != column_count) return false;
  arb_mat_t square, right, own;
  arb_mat_init(square, row_count, row_count);
  arb_mat_init(right, row_count, 1);
  arb_mat_init(own, row_count, 1);
  for (long r = 0; r < row_count; r++) {
    arb_set(arb_mat_entry(right, r, 0), arb_mat_entry(rest, rows[r], 0));
    for (long c = 0; c < row_count; c++) {
      arb_set(arb_mat_entry(square, r, c), arb_mat_entry(t->columns, rows[r], columns[c]));
    }
  }
  bool solved = false;
  *made = tp_enclosed_solve(&solved, own, square, right, t->bits);
  for (long c = 0; c < row_count && solved; c++) {
    arb_set(arb_mat_entry(factors, columns[c], 0), arb_mat_entry(own, c, 0));
  }
  arb_mat_clear(square);
  arb_mat_clear(right);
  arb_mat_clear(own);
  return solved;
}

static tp_status solve(arb_mat_t factors, const tp_basis_task *t, const choosing *s,
                       tp_message *message) {
  long *part = calloc(3 * (size_t)s->rows + 1, sizeof *part);
  if (part == NULL) return tp_fail_memory(message, "a proof");
  arb_mat_t rest;
  arb_mat_init(rest, s->rows, 1);
  set_rest(rest, factors, t, s);
  join_rows(part, t, s);
  bool solved = true, made = true;
  for (long r = 0; r < s->rows && solved; r++) {
    if (part[r] != r) continue;
    solved = solve_part(&made, factors, rest, t, s, part, r, part + s->rows, part + 2 * s->rows);
  }
  arb_mat_clear(rest);
  free(part);
  if (!made) return tp_fail_memory(message, "a proof");
  return solved ? TP_OK : TP_NO_ANSWER;
}

tp_status tp_basis_solve(arb_mat_t factors, const tp_basis_task *t, tp_message *message) {
  const long rows = arb_mat_nrows(t->columns), count = arb_mat_ncols(t->columns);
  choosing s = {.rows = rows,
                .count = count,
                .entries = calloc((size_t)(rows * count) + 1, sizeof *s.entries),
                .chosen = calloc((size_t)rows + 1, sizeof *s.chosen),
                .taken = calloc((size_t)count + 1, sizeof *s.taken),
                .most = calloc((size_t)rows + 1, sizeof *s.most),
                .best = calloc((size_t)rows + 1, sizeof *s.best)};
  bool *used = calloc((size_t)rows + 1, sizeof *used);
  tp_status status = TP_NO_ANSWER;
  if (s.entries == NULL || s.chosen == NULL || s.taken == NULL || s.most == NULL ||
      s.best == NULL || used == NULL) {
    status = tp_fail_memory(message, "a proof");
  } else {
    set_entries(&s, t);
    if (choose(&s, used, t->preference)) status = solve(factors, t, &s, message);
  }
  free(s.entries);
  free(s.chosen);
  free(s.taken);
  free(s.most);
  free(s.best);
  free(used);
  return status;
}
