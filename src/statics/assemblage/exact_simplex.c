/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The criss-cross method (Terlaky 1985; Fukuda and Terlaky 1997): from any basis, whether its
 * forces and its twists are admissible or not, the first column in a fixed order that is not gives
 * the pivot, and the end comes after finitely many. The load is in the basis always. */

#include "assemblage/exact_simplex.h"

#include "number/integer_rows.h"

#include <flint/fmpq_vec.h>
#include <math.h>
#include <stdlib.h>

/* Columns: the load, the forces, what each bounded one is short of its bound, one a row that tells
 * what the row is a sum of, and the target. Each bounded force has a row of its own after those of
 * the program. */
typedef struct table {
  const tp_exact_program *p;
  long rows, count; /* columns that may be in the basis */
  fmpz_mat_t at;
  long *basic;  /* by row: the column that it tells, with an entry above zero; -1: none */
  long *row_of; /* by column: of which row it is that; -1: of none */
  long *order;  /* of columns: the load, then by their forces */
} table;

static fmpz *entry(const table *t, long row, long column) {
  return fmpz_mat_entry(t->at, row, column);
}

static int sign(const table *t, long row, long column) {
  return fmpz_sgn(entry(t, row, column));
}

static long target(const table *t) {
  return t->count + t->rows;
}

/* ---- table -------------------------------------------------------------------------------------
 */

static void set_entry(table *t, long row, long column, const fmpq *value, const fmpz_t common) {
  fmpz *to = entry(t, row, column);
  fmpz_divexact(to, common, fmpq_denref(value));
  fmpz_mul(to, to, fmpq_numref(value));
}

/* Times the common denominator of all its entries. */
static void set_row(table *t, long row) {
  const tp_exact_program *p = t->p;
  const long rows = p->forces->rows;
  fmpz_t common;
  fmpz_init(common);
  fmpz_lcm(common, fmpq_denref(p->live + row), fmpq_denref(p->target + row));
  for (long k = 0; k < p->forces->count; k++) {
    fmpz_lcm(common, common, fmpq_denref(p->columns + k * rows + row));
  }
  set_entry(t, row, 0, p->live + row, common);
  set_entry(t, row, target(t), p->target + row, common);
  for (long k = 0; k < p->forces->count; k++) {
    set_entry(t, row, 1 + k, p->columns + k * rows + row, common);
  }
  fmpz_set(entry(t, row, t->count + row), common);
  fmpz_clear(common);
}

/* A force and what it is short of its bound. */
static void set_bound(table *t, long row, long column, long rest, const fmpq *most) {
  fmpz_set(entry(t, row, column), fmpq_denref(most));
  fmpz_set(entry(t, row, rest), fmpq_denref(most));
  fmpz_set(entry(t, row, t->count + row), fmpq_denref(most));
  fmpz_set(entry(t, row, target(t)), fmpq_numref(most));
}

typedef struct sized {
  long column;
  double force;
} sized;

static int compare(const void *one, const void *other) {
  const sized *a = one, *b = other;
  if (a->force != b->force) return a->force > b->force ? -1 : 1;
  return a->column < b->column ? -1 : a->column > b->column;
}

static bool set_order(table *t, const double *forces) {
  const tp_exact_program *p = t->p;
  const long own = p->forces->count;
  sized *all = calloc((size_t)t->count + 1, sizeof *all);
  if (all == NULL) return false;
  long rest = 1 + own;
  all[0] = (sized){0, INFINITY};
  for (long k = 0; k < own; k++) {
    all[1 + k] = (sized){1 + k, forces[k]};
    if (p->most[k] == NULL) continue;
    all[rest] = (sized){rest, p->forces->columns[k].most.value - forces[k]};
    rest++;
  }
  qsort(all, (size_t)t->count, sizeof *all, compare);
  for (long k = 0; k < t->count; k++) t->order[k] = all[k].column;
  free(all);
  return true;
}

static bool table_init(table *t, const tp_exact_program *p, const double *forces) {
  const long rows = p->forces->rows, own = p->forces->count;
  long bounded = 0;
  for (long k = 0; k < own; k++) bounded += p->most[k] != NULL;
  *t = (table){.p = p, .rows = rows + bounded, .count = 1 + own + bounded};
  fmpz_mat_init(t->at, t->rows, t->count + t->rows + 1);
  t->basic = calloc((size_t)t->rows + 1, sizeof *t->basic);
  t->row_of = calloc((size_t)t->count + 1, sizeof *t->row_of);
  t->order = calloc((size_t)t->count + 1, sizeof *t->order);
  if (t->basic == NULL || t->row_of == NULL || t->order == NULL) return false;
  for (long r = 0; r < t->rows; r++) t->basic[r] = -1;
  for (long c = 0; c < t->count; c++) t->row_of[c] = -1;
  for (long r = 0; r < rows; r++) set_row(t, r);
  for (long k = 0, at = 0; k < own; k++) {
    if (p->most[k] == NULL) continue;
    set_bound(t, rows + at, 1 + k, 1 + own + at, p->most[k]);
    at++;
  }
  for (long r = 0; r < t->rows; r++) tp_row_free_of_factor(t->at, r);
  return set_order(t, forces);
}

static void table_clear(table *t) {
  fmpz_mat_clear(t->at);
  free(t->basic);
  free(t->row_of);
  free(t->order);
}

/* ---- pivots ------------------------------------------------------------------------------------
 */

static void pivot(table *t, long row, long column) {
  if (sign(t, row, column) < 0) {
    for (long c = 0; c <= target(t); c++) fmpz_neg(entry(t, row, c), entry(t, row, c));
  }
  for (long r = 0; r < t->rows; r++) {
    if (r != row && sign(t, r, column) != 0) tp_row_eliminate(t->at, r, row, column);
  }
  if (t->basic[row] >= 0) t->row_of[t->basic[row]] = -1;
  t->basic[row] = column;
  t->row_of[column] = row;
}

/* As many columns in their order as are independent. */
static void begin(table *t) {
  for (long k = 0; k < t->count; k++) {
    const long column = t->order[k];
    long shortest = -1, least = 0;
    for (long r = 0; r < t->rows; r++) {
      if (t->basic[r] >= 0 || sign(t, r, column) == 0) continue;
      long length = 0;
      for (long c = 0; c <= target(t); c++) length += sign(t, r, c) != 0;
      if (shortest >= 0 && length >= least) continue;
      shortest = r;
      least = length;
    }
    if (shortest >= 0) pivot(t, shortest, column);
  }
}

/* A sum of rows of which no force is part, nor any load. */
static long row_that_lacks_all(const table *t) {
  for (long r = 0; r < t->rows; r++) {
    if (t->basic[r] < 0 && sign(t, r, target(t)) != 0) return r;
  }
  return -1;
}

/* The first column of those that are not in the basis, in whose place of that row a number is below
 * zero; -1: none. */
static long first_below(const table *t, long row) {
  for (long k = 1; k < t->count; k++) {
    const long column = t->order[k];
    if (t->row_of[column] < 0 && sign(t, row, column) < 0) return column;
  }
  return -1;
}

static long first_row_above(const table *t, long column) {
  for (long k = 1; k < t->count; k++) {
    const long row = t->row_of[t->order[k]];
    if (row >= 0 && sign(t, row, column) > 0) return row;
  }
  return -1;
}

typedef enum step {
  STEP_TAKEN,
  STEP_OPTIMAL,
  STEP_INFEASIBLE, /* `row` proves it */
  STEP_OPEN
} step;

static step take_step(table *t, long *row) {
  const long load = t->row_of[0];
  for (long k = 1; k < t->count; k++) {
    const long column = t->order[k], own = t->row_of[column];
    if (own >= 0 && sign(t, own, target(t)) < 0) {
      const long enters = first_below(t, own);
      *row = own;
      if (enters < 0) return STEP_INFEASIBLE;
      pivot(t, own, enters);
      return STEP_TAKEN;
    }
    if (own < 0 && sign(t, load, column) < 0) {
      const long leaves = first_row_above(t, column);
      if (leaves < 0) return STEP_OPEN;
      pivot(t, leaves, column);
      return STEP_TAKEN;
    }
  }
  return STEP_OPTIMAL;
}

/* ---- answer ------------------------------------------------------------------------------------
 */

/* What a row is a sum of, over a number. */
static void take_multipliers(tp_exact_answer *answer, const table *t, long row, const fmpz_t over) {
  for (long r = 0; r < t->p->forces->rows; r++) {
    fmpq_set_fmpz_frac(answer->multipliers + r, entry(t, row, t->count + r), over);
  }
}

static void take_limit(tp_exact_answer *answer, const table *t) {
  answer->outcome = TP_EXACT_LIMIT;
  for (long c = 0; c <= t->p->forces->count; c++) {
    const long row = t->row_of[c];
    fmpq *to = c == 0 ? &answer->load : answer->factors + c - 1;
    if (row >= 0) fmpq_set_fmpz_frac(to, entry(t, row, target(t)), entry(t, row, c));
  }
  take_multipliers(answer, t, t->row_of[0], entry(t, t->row_of[0], 0));
}

static void take_never(tp_exact_answer *answer, const table *t, long row) {
  fmpz_t over;
  fmpz_init(over);
  fmpz_set_si(over, -sign(t, row, target(t)));
  answer->outcome = TP_EXACT_NEVER;
  take_multipliers(answer, t, row, over);
  fmpz_clear(over);
}

static void solve(tp_exact_answer *answer, table *t) {
  enum { MOST = 1000 }; /* pivots; some ten are usual */
  begin(t);
  if (t->row_of[0] < 0) return;
  long row = row_that_lacks_all(t);
  if (row >= 0) {
    take_never(answer, t, row);
    return;
  }
  step last = STEP_TAKEN;
  for (long k = 0; k < MOST && last == STEP_TAKEN; k++) last = take_step(t, &row);
  if (last == STEP_OPTIMAL) take_limit(answer, t);
  if (last == STEP_INFEASIBLE) take_never(answer, t, row);
}

void tp_exact_answer_clear(tp_exact_answer *answer, const tp_exact_program *p) {
  fmpq_clear(&answer->load);
  _fmpq_vec_clear(answer->factors, p->forces->count);
  _fmpq_vec_clear(answer->multipliers, p->forces->rows);
}

tp_status tp_exact_simplex(tp_exact_answer *answer, const tp_exact_program *p, const double *forces,
                           tp_message *message) {
  *answer = (tp_exact_answer){.outcome = TP_EXACT_OPEN,
                              .factors = _fmpq_vec_init(p->forces->count),
                              .multipliers = _fmpq_vec_init(p->forces->rows)};
  fmpq_init(&answer->load);
  table t;
  const bool made = table_init(&t, p, forces);
  if (made) solve(answer, &t);
  table_clear(&t);
  if (made) return TP_OK;
  tp_exact_answer_clear(answer, p);
  return tp_fail_memory(message, "the forces between blocks");
}
