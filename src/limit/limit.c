/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "limit/extremes.h"
#include "limit/program.h"
#include "limit/prove.h"
#include "limit/search.h"

#include <string.h>

bool tp_limit_answer_init(tp_limit_answer *answer, const tp_cones *cones) {
  memset(answer, 0, sizeof *answer);
  if (!tp_face_init(&answer->face, cones)) return false;
  if (!tp_face_init(&answer->other, cones)) {
    tp_face_clear(&answer->face);
    return false;
  }
  arb_init(answer->sine);
  arb_init(answer->cosine);
  arb_init(answer->degrees);
  for (int k = 0; k < 2; k++) arb_init(answer->forces + k);
  return true;
}

void tp_limit_answer_clear(tp_limit_answer *answer) {
  tp_face_clear(&answer->face);
  tp_face_clear(&answer->other);
  arb_clear(answer->sine);
  arb_clear(answer->cosine);
  arb_clear(answer->degrees);
  for (int k = 0; k < 2; k++) arb_clear(answer->forces + k);
}

static tp_answer judge_basis(tp_limit_answer *answer, const tp_limit_question *q,
                             const tp_program *p, tp_sketch *sketch, const tp_basis *basis) {
  switch (basis->outcome) {
  case TP_SIMPLEX_OPTIMAL:
    return tp_prove_limit(answer, q, sketch, basis, &p->direction, p->near_degrees);
  case TP_SIMPLEX_UNBOUNDED:
    answer->kind = TP_LIMIT_INTERLOCKED;
    return tp_extremes_interlocked(q, sketch);
  case TP_SIMPLEX_INFEASIBLE:
    answer->kind = TP_LIMIT_NOWHERE;
    return tp_extremes_nowhere(q, sketch);
  case TP_SIMPLEX_STUCK:
    break;
  }
  return TP_NO;
}

/* The basis that doubles find is proven or refuted; then the one of the exact program on the
 * midpoints of the data, which costs more and leaves nothing but the width of the data. */
static tp_limit_outcome find(tp_limit_answer *answer, const tp_limit_question *q,
                             const tp_program *p, tp_sketch *sketch) {
  enum { LEAST_BITS = 160 }; /* below, doubling the bits is cheaper */
  const tp_simplex_answer sketched = tp_program_solve(p, sketch);
  tp_basis basis = tp_basis_of(&sketched);
  tp_answer done = judge_basis(answer, q, p, sketch, &basis);
  if (done != TP_YES && q->judge.bits >= LEAST_BITS) {
    if (!tp_basis_exact(&basis, q->cones, &p->direction, &p->target, q->judge.precision)) {
      return TP_LIMIT_FAILED;
    }
    done = judge_basis(answer, q, p, sketch, &basis);
  }
  return done == TP_YES ? TP_LIMIT_PROVEN : TP_LIMIT_OPEN;
}

static tp_limit_outcome find_near(tp_limit_answer *answer, const tp_limit_question *q,
                                  tp_program *p, tp_sketch *sketch) {
  switch (tp_search_near(&p->near_degrees, sketch, q)) {
  case TP_SEARCH_HOLDS_ALWAYS:
    answer->kind = TP_LIMIT_INTERLOCKED;
    return TP_LIMIT_PROVEN;
  case TP_SEARCH_HOLDS_NEVER:
    answer->kind = TP_LIMIT_NOWHERE;
    return TP_LIMIT_PROVEN;
  case TP_SEARCH_TILT:
    break;
  }
  tp_program_set_near(p, q);
  return find(answer, q, p, sketch);
}

tp_limit_outcome tp_limit_find(tp_limit_answer *answer, const tp_limit_question *q) {
  if (q->cones->count == 0) { /* a corner on a corner alone presses on nothing */
    answer->kind = TP_LIMIT_NOWHERE;
    return TP_LIMIT_PROVEN;
  }
  tp_program p;
  tp_sketch sketch;
  if (!tp_program_sketch(&sketch, q)) return TP_LIMIT_OUT_OF_MEMORY;
  tp_program_init(&p);
  tp_limit_outcome outcome = TP_LIMIT_OPEN;
  if (tp_search_is_linear(q)) {
    tp_program_set_linear(&p, q);
    outcome = find(answer, q, &p, &sketch);
  } else {
    outcome = find_near(answer, q, &p, &sketch);
  }
  tp_program_clear(&p);
  tp_sketch_clear(&sketch);
  return outcome;
}
