/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Order of methods for one limit: simplex in doubles, proof of its basis, repair by exact programs
 * of the columns that refute it, then an exact program of all columns; proofs of no limit by
 * extremes.h. */

#include "limit/limit.h"

#include "certificate/extremes.h"
#include "certificate/prove.h"
#include "limit/near.h"
#include "limit/program.h"

#include <stdlib.h>

static tp_answer judge_basis(tp_limit_answer *answer, const tp_limit_question *q,
                             const tp_program *p, tp_scaled *scaled, const tp_basis *basis) {
  switch (basis->outcome) {
  case TP_SIMPLEX_OPTIMAL:
    return tp_prove_limit(answer, q, scaled, basis, &p->direction, 0);
  case TP_SIMPLEX_UNBOUNDED:
    answer->kind = TP_LIMIT_INTERLOCKED;
    return tp_extremes_interlocked(q, scaled, basis);
  case TP_SIMPLEX_INFEASIBLE:
    answer->kind = TP_LIMIT_NOWHERE;
    return tp_extremes_nowhere(q, scaled);
  case TP_SIMPLEX_STUCK:
    break;
  }
  return TP_NO;
}

enum {
  MOST_REPAIRS = 32,
  MOST_COLUMNS = 2 * (3 + MOST_REPAIRS), /* of a basis, and one for each repair */
  WHOLE_PROGRAM = 20000,                 /* columns of which the exact program is tried */
  LEAST_BITS = 160                       /* from which it is: fewer are doubled sooner */
};

/* Columns that an exact program is made of, both edges of each cone. */
typedef struct working_set {
  long count;
  long columns[MOST_COLUMNS];
} working_set;

static void take(working_set *set, const tp_cones *cones, long column) {
  const long first = tp_cones_is_edge(cones, column) ? column - column % 2 : column;
  const long last = tp_cones_is_edge(cones, column) ? first + 1 : column;
  for (long k = first; k <= last; k++) {
    bool known = false;
    for (long at = 0; at < set->count && !known; at++) known = set->columns[at] == k;
    if (!known) set->columns[set->count++] = k;
  }
}

/* Doubles were wrong, and a column says so: the exact program of their basis and that column, then
 * of that and the next column that refutes it. Each looks at all columns once. */
static tp_answer repair(tp_limit_answer *answer, tp_status *status, const tp_limit_question *q,
                        const tp_program *p, tp_scaled *scaled, tp_basis *basis) {
  working_set set = {.count = 0};
  for (int k = 0; k < basis->count; k++) take(&set, q->cones, basis->columns[k]);
  for (int round = 0; round < MOST_REPAIRS && answer->violated >= 0; round++) {
    take(&set, q->cones, answer->violated);
    *status = tp_basis_exact(basis, q->cones, set.columns, set.count, &p->direction, &p->target,
                             q->judge.precision);
    if (*status != TP_OK || basis->outcome != TP_SIMPLEX_OPTIMAL) return TP_OPEN;
    const tp_answer done = judge_basis(answer, q, p, scaled, basis);
    if (done != TP_NO) return done;
  }
  return TP_OPEN;
}

static tp_status whole_basis(tp_basis *basis, const tp_limit_question *q, const tp_program *p) {
  const long count = tp_cones_column_count(q->cones);
  long *columns = calloc((size_t)count + 1, sizeof *columns);
  if (columns == NULL) return TP_OUT_OF_MEMORY;
  for (long k = 0; k < count; k++) columns[k] = k;
  const tp_status status = tp_basis_exact(basis, q->cones, columns, count, &p->direction,
                                          &p->target, q->judge.precision);
  free(columns);
  return status;
}

/* The basis that doubles find is proven, or repaired; where neither does, the exact program of all
 * columns on the midpoints of the data, if they are not too many, leaves nothing but the width of
 * the data. */
static tp_limit_outcome find(tp_limit_answer *answer, const tp_limit_question *q,
                             const tp_program *p, tp_scaled *scaled) {
  tp_basis basis;
  tp_answer done = TP_OPEN;
  tp_status status = TP_OK;
  answer->violated = -1;
  if (!q->without_doubles) {
    const tp_simplex_answer found = tp_program_solve(p, scaled);
    basis = tp_basis_of(&found);
    done = judge_basis(answer, q, p, scaled, &basis);
    if (done == TP_NO) done = repair(answer, &status, q, p, scaled, &basis);
  }
  /* with fewer bits, doubling them is cheaper */
  const bool whole = q->judge.bits >= LEAST_BITS && scaled->count <= WHOLE_PROGRAM;
  if (status == TP_OK && done != TP_YES && (whole || q->without_doubles)) {
    status = whole_basis(&basis, q, p);
    if (status == TP_OK) done = judge_basis(answer, q, p, scaled, &basis);
  }
  if (status != TP_OK) {
    return status == TP_OUT_OF_MEMORY ? TP_LIMIT_OUT_OF_MEMORY : TP_LIMIT_FAILED;
  }
  return done == TP_YES ? TP_LIMIT_PROVEN : TP_LIMIT_OPEN;
}

static bool is_finite(const tp_trig *f) {
  for (int basis = 0; basis < TP_BASIS; basis++) {
    if (!arb_is_finite(f->of + basis)) return false;
  }
  return true;
}

tp_limit_outcome tp_limit_find(tp_limit_answer *answer, const tp_limit_question *q) {
  /* a weight that is not told from none at this precision has no arm */
  if (!is_finite(&q->load->x) || !is_finite(&q->load->y) || !is_finite(&q->load->moment)) {
    return TP_LIMIT_OPEN;
  }
  if (q->cones->count == 0) { /* a corner on a corner alone presses on nothing */
    answer->kind = TP_LIMIT_NOWHERE;
    return TP_LIMIT_PROVEN;
  }
  tp_scaled own, *scaled = q->scaled;
  if (scaled == NULL) {
    if (!tp_program_scaled(&own, q)) return TP_LIMIT_OUT_OF_MEMORY;
    scaled = &own;
  }
  tp_limit_outcome outcome = TP_LIMIT_OPEN;
  if (tp_question_is_linear(q)) {
    tp_program p;
    tp_program_init(&p);
    tp_program_set_linear(&p, q);
    outcome = find(answer, q, &p, scaled);
    tp_program_clear(&p);
  } else {
    outcome = tp_near_find(answer, q, scaled);
  }
  if (scaled->out_of_memory) outcome = TP_LIMIT_OUT_OF_MEMORY;
  if (scaled == &own) tp_scaled_clear(&own);
  return outcome;
}
