/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The upper triangle by columns; its places are found once, and filled by contact. */

#include "assemblage/normal_equations.h"

#include <stdlib.h>
#include <string.h>
#include <suitesparse/cs.h>

/* Of two free blocks that a contact joins. */
typedef struct joined {
  long earlier, later, contact;
} joined;

static int compare_joined(const void *first, const void *second) {
  const joined *a = first, *b = second;
  if (a->later != b->later) return a->later < b->later ? -1 : 1;
  return a->earlier < b->earlier ? -1 : a->earlier > b->earlier;
}

static long contact_count(const tp_force_program *p) {
  return p->count > 0 ? p->columns[p->count - 1].contact + 1 : 0;
}

static long gather(joined *pairs, const tp_force_program *p) {
  long count = 0;
  const long contacts = contact_count(p);
  for (long k = 0; k < contacts; k++) {
    const long *row = p->columns[p->first[k]].row;
    if (row[0] < 0 || row[1] < 0) continue;
    pairs[count++] = (joined){(row[0] < row[1] ? row[0] : row[1]) / 3,
                              (row[0] < row[1] ? row[1] : row[0]) / 3, k};
  }
  qsort(pairs, (size_t)count, sizeof *pairs, compare_joined);
  return count;
}

static bool is_new(const joined *pairs, long k) {
  return k == 0 || compare_joined(pairs + k - 1, pairs + k) != 0;
}

static long different(const joined *pairs, long count) {
  long found = 0;
  for (long k = 0; k < count; k++) found += is_new(pairs, k);
  return found;
}

static void set_rows(cs_dl *m, long *at, long block) {
  for (int e = 0; e < 3; e++) m->i[(*at)++] = 3 * block + e;
}

/* The columns of one block: pairs first … end - 1 have it as the later one. */
static void set_columns(tp_normal_equations *n, long block, const joined *pairs, long first,
                        long end, long *at) {
  cs_dl *m = n->matrix;
  for (int c = 0; c < 3; c++) {
    m->p[3 * block + c] = *at;
    for (long k = first; k < end; k++) {
      if (is_new(pairs, k)) set_rows(m, at, pairs[k].earlier);
      n->pair_place[3 * pairs[k].contact + c] = *at - 3;
    }
    n->own_place[3 * block + c] = *at;
    for (int e = 0; e <= c; e++) m->i[(*at)++] = 3 * block + e;
  }
}

static bool set_pattern(tp_normal_equations *n, joined *pairs) {
  const tp_force_program *p = n->program;
  const long count = gather(pairs, p), blocks = p->rows / 3;
  const long entries = 9 * different(pairs, count) + 6 * blocks;
  cs_dl *m = cs_dl_spalloc(p->rows, p->rows, entries, 1, 0);
  n->matrix = m;
  if (m == NULL) return false;
  long at = 0, pair = 0;
  for (long b = 0; b < blocks; b++) {
    const long first = pair;
    while (pair < count && pairs[pair].later == b) pair++;
    set_columns(n, b, pairs, first, pair, &at);
  }
  m->p[p->rows] = at;
  n->symbolic = cs_dl_schol(1, m);
  return n->symbolic != NULL;
}

tp_status tp_normal_equations_init(tp_normal_equations *n, const tp_force_program *p,
                                   tp_message *message) {
  memset(n, 0, sizeof *n);
  n->program = p;
  const long contacts = contact_count(p);
  joined *pairs = calloc((size_t)contacts + 1, sizeof *pairs);
  n->pair_place = calloc(3 * (size_t)contacts + 1, sizeof *n->pair_place);
  n->own_place = calloc((size_t)p->rows + 1, sizeof *n->own_place);
  n->work = calloc((size_t)p->rows + 1, sizeof *n->work);
  const bool done = pairs != NULL && n->pair_place != NULL && n->own_place != NULL &&
                    n->work != NULL && set_pattern(n, pairs);
  free(pairs);
  return done ? TP_OK : tp_fail_memory(message, "the forces between blocks");
}

void tp_normal_equations_clear(tp_normal_equations *n) {
  cs_dl_spfree(n->matrix);
  cs_dl_sfree(n->symbolic);
  cs_dl_nfree(n->factor);
  free(n->pair_place);
  free(n->own_place);
  free(n->work);
}

/* One column's share: its own blocks' 3 x 3, and that of both. */
static void add_share(tp_normal_equations *n, const tp_force_column *column, double d) {
  double *x = ((cs_dl *)n->matrix)->x;
  for (int k = 0; k < 2; k++) {
    if (column->row[k] < 0) continue;
    for (int c = 0; c < 3; c++) {
      const double own = d * column->entry[k][c].value;
      double *place = x + n->own_place[column->row[k] + c];
      for (int e = 0; e <= c; e++) place[e] += own * column->entry[k][e].value;
    }
  }
  if (column->row[0] < 0 || column->row[1] < 0) return;
  const int later = column->row[0] < column->row[1];
  for (int c = 0; c < 3; c++) {
    const double own = d * column->entry[later][c].value;
    double *place = x + n->pair_place[3 * column->contact + c];
    for (int e = 0; e < 3; e++) place[e] += own * column->entry[!later][e].value;
  }
}

/* A little more on the diagonal than rounding takes from it. */
static void stiffen(tp_normal_equations *n) {
  static const double share = 1e-14;
  double *x = ((cs_dl *)n->matrix)->x;
  for (long r = 0; r < n->program->rows; r++) x[n->own_place[r] + r % 3] *= 1 + share;
}

bool tp_normal_equations_factorise(tp_normal_equations *n, const double *diagonal) {
  cs_dl *m = n->matrix;
  memset(m->x, 0, (size_t)m->p[m->n] * sizeof *m->x);
  for (long k = 0; k < n->program->count; k++) {
    add_share(n, n->program->columns + k, diagonal[k]);
  }
  stiffen(n);
  cs_dl_nfree(n->factor);
  n->factor = cs_dl_chol(m, n->symbolic);
  return n->factor != NULL;
}

void tp_normal_equations_solve(tp_normal_equations *n, double *rows) {
  const cs_dls *symbolic = n->symbolic;
  const cs_dln *factor = n->factor;
  cs_dl_ipvec(symbolic->pinv, rows, n->work, n->program->rows);
  cs_dl_lsolve(factor->L, n->work);
  cs_dl_ltsolve(factor->L, n->work);
  cs_dl_pvec(symbolic->pinv, n->work, rows, n->program->rows);
}
