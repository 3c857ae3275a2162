/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Direction and target of the linear program at level or at a tilt, the derivative F' by central
 * difference, and an estimate of the limit in doubles. */

#include "limit/program.h"

#include "limit/search.h"
#include "linear_program/precise.h"

#include <math.h>

void tp_program_init(tp_program *p) {
  tp_vector_init(&p->direction);
  tp_vector_init(&p->target);
}

void tp_program_clear(tp_program *p) {
  tp_vector_clear(&p->direction);
  tp_vector_clear(&p->target);
}

void tp_program_set_linear(tp_program *p, const tp_limit_question *q) {
  tp_question_load_term(&p->direction, q->load, TP_SIN);
  tp_question_load_term(&p->target, q->load, TP_COS);
  tp_vector_neg(&p->target);
}

/* F' a degree, by a step of 2^STEP degrees back and forth: it only has to point the right way. */
enum { STEP = -17 };

void tp_program_set_near(tp_program *p, const tp_limit_question *q, const arb_t near) {
  const long bits = q->judge.bits;
  tp_vector *const parts[3] = {&p->target, &p->direction, &p->direction};
  tp_vector load;
  arb_t at;
  tp_vector_init(&load);
  arb_init(at);
  for (int k = 0; k < 3; k++) {
    arb_one(at);
    arb_mul_2exp_si(at, at, STEP);
    arb_mul_si(at, at, k == 0 ? 0 : k == 1 ? -1 : 1, bits);
    arb_add(at, near, at, bits);
    tp_question_load_at_degrees(&load, q, at);
    for (int row = 0; row < 3; row++) {
      if (k == 2) {
        arb_sub(parts[k]->of + row, load.of + row, parts[k]->of + row, bits);
        arb_mul_2exp_si(parts[k]->of + row, parts[k]->of + row, -STEP - 1);
      } else {
        arb_set(parts[k]->of + row, load.of + row);
      }
    }
  }
  tp_vector_neg(&p->target);
  tp_vector_clear(&load);
  arb_clear(at);
}

bool tp_program_scaled(tp_scaled *scaled, const tp_limit_question *q) {
  tp_vector size;
  tp_vector_init(&size);
  tp_question_load_term(&size, q->load, TP_COS); /* the weight's */
  const bool done = tp_scaled_init(scaled, q->cones, &size, q->judge.bits);
  tp_vector_clear(&size);
  return done;
}

tp_simplex_answer tp_program_solve(const tp_program *p, tp_scaled *scaled) {
  double direction[3], target[3];
  tp_scaled_wrench(direction, scaled, &p->direction);
  tp_scaled_wrench(target, scaled, &p->target);
  return tp_scaled_solve(scaled, direction, target);
}

tp_simplex_answer tp_program_solve_precisely(const tp_program *p, tp_scaled *scaled,
                                             const tp_limit_question *q) {
  return tp_precise_solve(scaled, q->cones, &p->direction, &p->target, q->work, q->judge.bits);
}

static double linear_degrees(tp_scaled *scaled, const tp_limit_question *q) {
  tp_program p;
  tp_program_init(&p);
  tp_program_set_linear(&p, q);
  const tp_simplex_answer found = tp_program_solve(&p, scaled);
  tp_program_clear(&p);
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

double tp_program_estimate(tp_scaled *scaled, const tp_limit_question *q) {
  if (tp_question_is_linear(q)) return linear_degrees(scaled, q);
  tp_search_tilts tilts = {.fails = 0};
  (void)tp_search_pay(q, scaled); /* its callers try but so many times */
  switch (tp_search_near(&tilts, scaled, q)) {
  case TP_SEARCH_HOLDS_ALWAYS:
    return 90;
  case TP_SEARCH_HOLDS_NEVER:
    return -90;
  case TP_SEARCH_TILT:
  case TP_SEARCH_OPEN: /* level, for want of better */
    break;
  }
  return tilts.fails;
}
