/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "limit/program.h"

#include "limit/search.h"

#include <math.h>

void tp_program_init(tp_program *p) {
  p->near_degrees = 0;
  tp_vector_init(&p->direction);
  tp_vector_init(&p->target);
}

void tp_program_clear(tp_program *p) {
  tp_vector_clear(&p->direction);
  tp_vector_clear(&p->target);
}

void tp_program_set_linear(tp_program *p, const tp_limit_question *q) {
  tp_search_load_term(&p->direction, q->load, TP_SIN);
  tp_search_load_term(&p->target, q->load, TP_COS);
  tp_vector_neg(&p->target);
}

/* F' by a short step back and forth: it only has to point the right way. */
void tp_program_set_near(tp_program *p, const tp_limit_question *q) {
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

bool tp_program_sketch(tp_sketch *sketch, const tp_limit_question *q) {
  tp_vector size;
  tp_vector_init(&size);
  tp_search_load_term(&size, q->load, TP_COS); /* the weight's */
  const bool done = tp_sketch_init(sketch, q->cones, &size, q->judge.bits);
  tp_vector_clear(&size);
  return done;
}

tp_simplex_answer tp_program_solve(const tp_program *p, tp_sketch *sketch) {
  double direction[3], target[3];
  tp_sketch_wrench(direction, sketch, &p->direction);
  tp_sketch_wrench(target, sketch, &p->target);
  return tp_sketch_solve(sketch, direction, target);
}

static double linear_degrees(tp_sketch *sketch, const tp_limit_question *q) {
  tp_program p;
  tp_program_init(&p);
  tp_program_set_linear(&p, q);
  const tp_simplex_answer found = tp_program_solve(&p, sketch);
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

double tp_program_estimate(tp_sketch *sketch, const tp_limit_question *q) {
  if (tp_search_is_linear(q)) return linear_degrees(sketch, q);
  tp_search_tilts tilts = {.lets_go = 0};
  switch (tp_search_near(&tilts, sketch, q)) {
  case TP_SEARCH_HOLDS_ALWAYS:
    return 90;
  case TP_SEARCH_HOLDS_NEVER:
    return -90;
  case TP_SEARCH_TILT:
  case TP_SEARCH_OPEN: /* level, for want of better */
    break;
  }
  return tilts.lets_go;
}
