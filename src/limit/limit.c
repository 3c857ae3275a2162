/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "limit/extremes.h"
#include "limit/prove.h"
#include "limit/search.h"

#include <math.h>
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

/* The linear program: sum f c + t direction = target. Where all loads turn with the tilt, F = F_c
 * cos + F_s sin, and t is tan(tilt): direction F_s, target -F_c. Otherwise it is the program at a
 * tilt near the limit, t the way from there: direction F', target -F. */
typedef struct program {
  tp_vector direction, target;
  double near_degrees;
} program;

static void set_linear(program *p, const tp_limit_question *q) {
  tp_search_load_term(&p->direction, q->load, TP_SIN);
  tp_search_load_term(&p->target, q->load, TP_COS);
  tp_vector_neg(&p->target);
}

/* F' by a short step back and forth: it only has to point the right way. */
static void set_near(program *p, const tp_limit_question *q) {
  static const double step = 1e-5; /* degrees */
  const long bits = q->judge.bits;
  tp_vector ends[2];
  arb_t turn, sine, cosine;
  arb_init(turn);
  arb_init(sine);
  arb_init(cosine);
  for (int k = 0; k < 2; k++) {
    tp_vector_init(ends + k);
    arb_set_d(turn, p->near_degrees + (k == 0 ? -step : step));
    arb_div_ui(turn, turn, 180, bits);
    arb_sin_cos_pi(sine, cosine, turn, bits);
    tp_search_load_at(ends + k, q->load, sine, cosine, bits);
  }
  for (int row = 0; row < 3; row++) {
    arb_add(p->target.of + row, ends[0].of + row, ends[1].of + row, bits);
    arb_mul_2exp_si(p->target.of + row, p->target.of + row, -1);
    arb_sub(p->direction.of + row, ends[1].of + row, ends[0].of + row, bits);
    arb_mul_2exp_si(p->direction.of + row, p->direction.of + row, 16);
  }
  tp_vector_neg(&p->target);
  for (int k = 0; k < 2; k++) tp_vector_clear(ends + k);
  arb_clear(turn);
  arb_clear(sine);
  arb_clear(cosine);
}

static tp_simplex_answer solve_sketch(const program *p, tp_sketch *sketch) {
  double direction[3], target[3];
  tp_sketch_wrench(direction, sketch, &p->direction);
  tp_sketch_wrench(target, sketch, &p->target);
  return tp_sketch_solve(sketch, direction, target);
}

static tp_answer judge_basis(tp_limit_answer *answer, const tp_limit_question *q, const program *p,
                             tp_sketch *sketch, const tp_basis *basis) {
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
static tp_limit_outcome find(tp_limit_answer *answer, const tp_limit_question *q, const program *p,
                             tp_sketch *sketch) {
  enum { LEAST_BITS = 160 }; /* below, doubling the bits is cheaper */
  const tp_simplex_answer sketched = solve_sketch(p, sketch);
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

static tp_limit_outcome find_near(tp_limit_answer *answer, const tp_limit_question *q, program *p,
                                  tp_sketch *sketch) {
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
  set_near(p, q);
  return find(answer, q, p, sketch);
}

static bool sketch_init(tp_sketch *sketch, const tp_limit_question *q) {
  tp_vector size;
  tp_vector_init(&size);
  tp_search_load_term(&size, q->load, TP_COS); /* the weight's */
  const bool done = tp_sketch_init(sketch, q->cones, &size, q->judge.bits);
  tp_vector_clear(&size);
  return done;
}

static void program_init(program *p) {
  p->near_degrees = 0;
  tp_vector_init(&p->direction);
  tp_vector_init(&p->target);
}

static void program_clear(program *p) {
  tp_vector_clear(&p->direction);
  tp_vector_clear(&p->target);
}

tp_limit_outcome tp_limit_find(tp_limit_answer *answer, const tp_limit_question *q) {
  if (q->cones->count == 0) { /* a corner on a corner alone presses on nothing */
    answer->kind = TP_LIMIT_NOWHERE;
    return TP_LIMIT_PROVEN;
  }
  program p;
  tp_sketch sketch;
  if (!sketch_init(&sketch, q)) return TP_LIMIT_OUT_OF_MEMORY;
  program_init(&p);
  tp_limit_outcome outcome = TP_LIMIT_OPEN;
  if (tp_search_is_linear(q)) {
    set_linear(&p, q);
    outcome = find(answer, q, &p, &sketch);
  } else {
    outcome = find_near(answer, q, &p, &sketch);
  }
  program_clear(&p);
  tp_sketch_clear(&sketch);
  return outcome;
}

static double estimate_linear(tp_sketch *sketch, const tp_limit_question *q) {
  program p;
  program_init(&p);
  set_linear(&p, q);
  const tp_simplex_answer found = solve_sketch(&p, sketch);
  program_clear(&p);
  switch (found.outcome) {
  case TP_SIMPLEX_UNBOUNDED:
    return 90;
  case TP_SIMPLEX_INFEASIBLE:
    return -90;
  case TP_SIMPLEX_OPTIMAL:
  case TP_SIMPLEX_STUCK:
    break;
  }
  return atan(found.t) * (180 / M_PI);
}

bool tp_limit_estimate(double *degrees, const tp_limit_question *q) {
  tp_sketch sketch;
  if (!sketch_init(&sketch, q)) return false;
  if (tp_search_is_linear(q)) {
    *degrees = estimate_linear(&sketch, q);
  } else {
    const tp_search_found found = tp_search_near(degrees, &sketch, q);
    if (found != TP_SEARCH_TILT) *degrees = found == TP_SEARCH_HOLDS_ALWAYS ? 90 : -90;
  }
  tp_sketch_clear(&sketch);
  return true;
}
