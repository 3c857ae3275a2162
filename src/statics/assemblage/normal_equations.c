/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Each part's front is put together from the matrix and from what the parts that hang on it left,
 * and leaves what its columns take from the rows behind them. */

#include "assemblage/normal_equations.h"

#include <stdlib.h>
#include <string.h>

enum { SIDE = TP_BLOCK_ROWS, SQUARE = SIDE * SIDE };

/* ---- the matrix --------------------------------------------------------------------------------
 */

static int compare_numbers(const void *first, const void *second) {
  const long a = *(const long *)first, b = *(const long *)second;
  return a < b ? -1 : a > b;
}

/* Which block of a contact comes later in the order. */
static int later_of(const tp_normal_equations *n, const long row[2]) {
  const long *place = n->plan.dissection.place;
  return place[row[0] / SIDE] < place[row[1] / SIDE];
}

static void find_pairs(tp_normal_equations *n) {
  const tp_dissection *d = &n->plan.dissection;
  const tp_force_program *p = n->program;
  for (long k = 0; k < p->assemblage->contact_count; k++) {
    n->pair[k] = -1;
    if (p->first[k] == p->first[k + 1]) continue;
    const long *row = p->columns[p->first[k]].row;
    if (row[0] < 0 || row[1] < 0) continue;
    const int later = later_of(n, row);
    const long first = d->first[row[!later] / SIDE], end = d->first[row[!later] / SIDE + 1];
    const long other = row[later] / SIDE;
    const long *found = bsearch(&other, d->neighbours + first, (size_t)(end - first), sizeof other,
                                compare_numbers);
    n->pair[k] = found - d->neighbours;
  }
}

/* So much of the products of a column's entries, by columns. */
static void add_square(double *square, const tp_near *rows, const tp_near *columns, double d) {
  for (int c = 0; c < SIDE; c++) {
    const double own = d * columns[c].value;
    for (int r = 0; r < SIDE; r++) square[SIDE * c + r] += own * rows[r].value;
  }
}

static void add_column(tp_normal_equations *n, const tp_force_column *c, double d) {
  for (int side = 0; side < 2; side++) {
    if (c->row[side] < 0) continue;
    add_square(n->own_squares + SIDE * c->row[side], c->entry[side], c->entry[side], d);
  }
  if (n->pair[c->contact] < 0) return;
  const int later = later_of(n, c->row);
  add_square(n->pair_squares + SQUARE * n->pair[c->contact], c->entry[later], c->entry[!later], d);
}

/* A little more on the diagonal than rounding takes from it; and one where no column acts. */
static void stiffen(tp_normal_equations *n) {
  static const double share = 1e-14;
  for (long r = 0; r < n->program->rows; r++) {
    double *own = n->own_squares + SIDE * r + r % SIDE;
    *own = *own > 0 ? *own * (1 + share) : 1;
  }
}

static void set_matrix(tp_normal_equations *n, const double *diagonal) {
  const tp_dissection *d = &n->plan.dissection;
  const size_t pairs = (size_t)d->first[d->block_count];
  memset(n->own_squares, 0, (size_t)(SIDE * n->program->rows) * sizeof *n->own_squares);
  memset(n->pair_squares, 0, SQUARE * pairs * sizeof *n->pair_squares);
  for (long k = 0; k < n->program->count; k++) {
    add_column(n, n->program->columns + k, diagonal[k]);
  }
  stiffen(n);
}

/* ---- fronts ------------------------------------------------------------------------------------
 */

/* An entry, by its rows in the front: of its columns, or of what it leaves. */
static double *entry_of(const tp_factor_front *f, double *columns, double *rest, long row,
                        long column) {
  return column < f->own ? columns + column * f->rows + row
                         : rest + (column - f->own) * (f->rows - f->own) + row - f->own;
}

static void set_rows(tp_normal_equations *n, long part) {
  const tp_factor_front *f = n->plan.fronts + part;
  const tp_dissected_part *own = n->plan.dissection.parts + part;
  for (long k = own->first; k < own->end; k++) n->row_of[k] = SIDE * (k - own->first);
  for (long k = 0; k < (f->rows - f->own) / SIDE; k++) {
    n->row_of[n->plan.behind[f->behind + k]] = f->own + SIDE * k;
  }
}

static void put(double *columns, const tp_factor_front *f, long row, long column,
                const double *square) {
  for (int c = 0; c < SIDE; c++) {
    double *to = columns + (column + c) * f->rows + row;
    for (int r = 0; r < SIDE; r++) to[r] = square[SIDE * c + r];
  }
}

static void put_matrix(double *columns, const tp_normal_equations *n, long part) {
  const tp_dissection *d = &n->plan.dissection;
  const tp_factor_front *f = n->plan.fronts + part;
  for (long k = d->parts[part].first; k < d->parts[part].end; k++) {
    const long block = d->order[k];
    put(columns, f, n->row_of[k], n->row_of[k], n->own_squares + SQUARE * block);
    for (long e = d->first[block]; e < d->first[block + 1]; e++) {
      const long place = d->place[d->neighbours[e]];
      if (place > k) {
        put(columns, f, n->row_of[place], n->row_of[k], n->pair_squares + SQUARE * e);
      }
    }
  }
}

/* What a part left, to the front that it hangs on. */
static void add_rest(const tp_normal_equations *n, const tp_factor_front *f, double *columns,
                     double *rest, const tp_factor_front *of, const double *left) {
  const long *behind = n->plan.behind + of->behind, rows = of->rows - of->own;
  for (long c = 0; c < rows; c++) {
    const long column = n->row_of[behind[c / SIDE]] + c % SIDE;
    double *to = entry_of(f, columns, rest, 0, column);
    const double *from = left + c * rows;
    for (long b = c / SIDE; b < rows / SIDE; b++) {
      const long row = n->row_of[behind[b]];
      for (int e = 0; e < SIDE; e++) to[row + e] += from[SIDE * b + e];
    }
  }
}

/* The rests of those that hang on a part are the last on the stack, up to `top`; its own takes
 * their place. */
static bool factorise_part(tp_normal_equations *n, long part, double **top) {
  const tp_factor_plan *plan = &n->plan;
  const tp_factor_front *f = plan->fronts + part;
  double *columns = n->factor + f->columns, *rest = *top, *left = *top;
  const size_t size = (size_t)((f->rows - f->own) * (f->rows - f->own));
  memset(columns, 0, (size_t)(f->rows * f->own) * sizeof *columns);
  memset(rest, 0, size * sizeof *rest);
  set_rows(n, part);
  put_matrix(columns, n, part);
  for (long c = plan->last_child[part]; c >= 0; c = plan->child_before[c]) {
    const tp_factor_front *of = plan->fronts + c;
    left -= (of->rows - of->own) * (of->rows - of->own);
    add_rest(n, f, columns, rest, of, left);
  }
  if (!n->kernel->factorise(columns, f->rows, f->own, rest)) return false;
  memmove(left, rest, size * sizeof *rest);
  *top = left + size;
  return true;
}

bool tp_normal_equations_factorise(tp_normal_equations *n, const double *diagonal) {
  double *top = n->rests;
  set_matrix(n, diagonal);
  for (long k = 0; k < n->plan.dissection.part_count; k++) {
    if (!factorise_part(n, k, &top)) return false;
  }
  return true;
}

/* ---- solutions ---------------------------------------------------------------------------------
 */

static void solve_part(const tp_normal_equations *n, long part) {
  const tp_factor_front *f = n->plan.fronts + part;
  const long *behind = n->plan.behind + f->behind, count = (f->rows - f->own) / SIDE;
  double *own = n->rows + SIDE * n->plan.dissection.parts[part].first;
  memcpy(n->local, own, (size_t)f->own * sizeof *own);
  memset(n->local + f->own, 0, (size_t)(f->rows - f->own) * sizeof *own);
  n->kernel->solve(n->local, n->factor + f->columns, f->rows, f->own);
  memcpy(own, n->local, (size_t)f->own * sizeof *own);
  for (long k = 0; k < count; k++) {
    for (int e = 0; e < SIDE; e++) {
      n->rows[SIDE * behind[k] + e] += n->local[f->own + SIDE * k + e];
    }
  }
}

static void solve_part_back(const tp_normal_equations *n, long part) {
  const tp_factor_front *f = n->plan.fronts + part;
  const long *behind = n->plan.behind + f->behind, count = (f->rows - f->own) / SIDE;
  double *own = n->rows + SIDE * n->plan.dissection.parts[part].first;
  memcpy(n->local, own, (size_t)f->own * sizeof *own);
  for (long k = 0; k < count; k++) {
    memcpy(n->local + f->own + SIDE * k, n->rows + SIDE * behind[k], SIDE * sizeof *own);
  }
  n->kernel->solve_back(n->local, n->factor + f->columns, f->rows, f->own);
  memcpy(own, n->local, (size_t)f->own * sizeof *own);
}

void tp_normal_equations_solve(const tp_normal_equations *n, double *rows) {
  const tp_dissection *d = &n->plan.dissection;
  for (long k = 0; k < d->block_count; k++) {
    memcpy(n->rows + SIDE * k, rows + SIDE * d->order[k], SIDE * sizeof *rows);
  }
  for (long k = 0; k < d->part_count; k++) solve_part(n, k);
  for (long k = d->part_count - 1; k >= 0; k--) solve_part_back(n, k);
  for (long k = 0; k < d->block_count; k++) {
    memcpy(rows + SIDE * d->order[k], n->rows + SIDE * k, SIDE * sizeof *rows);
  }
}

/* ---- memory ------------------------------------------------------------------------------------
 */

static double *numbers(long count) {
  return malloc(((size_t)count + 1) * sizeof(double));
}

tp_status tp_normal_equations_init(tp_normal_equations *n, const tp_force_program *p,
                                   tp_message *message) {
  *n = (tp_normal_equations){.program = p, .kernel = tp_front_kernel_choose(TP_INSTRUCTIONS_BEST)};
  if (!tp_factor_plan_init(&n->plan, p))
    return tp_fail_memory(message, "the forces between blocks");
  const tp_dissection *d = &n->plan.dissection;
  n->own_squares = numbers(SQUARE * d->block_count);
  n->pair_squares = numbers(SQUARE * d->first[d->block_count]);
  n->pair = calloc((size_t)p->assemblage->contact_count + 1, sizeof *n->pair);
  n->factor = numbers(n->plan.entries);
  n->rests = numbers(n->plan.rest_room);
  n->row_of = calloc((size_t)d->block_count + 1, sizeof *n->row_of);
  n->rows = numbers(p->rows);
  n->local = numbers(n->plan.most_rows);
  if (n->own_squares == NULL || n->pair_squares == NULL || n->pair == NULL || n->factor == NULL ||
      n->rests == NULL || n->row_of == NULL || n->rows == NULL || n->local == NULL) {
    return tp_fail_memory(message, "the forces between blocks");
  }
  find_pairs(n);
  return TP_OK;
}

void tp_normal_equations_clear(tp_normal_equations *n) {
  tp_factor_plan_clear(&n->plan);
  free(n->own_squares);
  free(n->pair_squares);
  free(n->pair);
  free(n->factor);
  free(n->rests);
  free(n->row_of);
  free(n->rows);
  free(n->local);
  *n = (tp_normal_equations){.program = NULL};
}
