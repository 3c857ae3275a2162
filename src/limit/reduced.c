/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "limit/reduced.h"

#include "limit/program.h"

#include <math.h>

void tp_reduced_init(tp_reduced *r) {
  const tp_cones *cones = r->cones;
  arb_init(r->friction);
  arb_set(r->friction, cones->friction);
  r->bounds = _arb_vec_init(2 * cones->allowance_count);
  for (long k = 0; k < cones->allowance_count; k++) {
    arb_set(r->bounds + 2 * k, cones->allowances[k].shear);
    arb_set(r->bounds + 2 * k + 1, cones->allowances[k].pull);
  }
}

void tp_reduced_clear(tp_reduced *r) {
  tp_cones *cones = r->cones;
  arb_swap(cones->friction, r->friction);
  for (long k = 0; k < cones->allowance_count; k++) {
    arb_swap(cones->allowances[k].shear, r->bounds + 2 * k);
    arb_swap(cones->allowances[k].pull, r->bounds + 2 * k + 1);
  }
  _arb_vec_clear(r->bounds, 2 * cones->allowance_count);
  arb_clear(r->friction);
}

static void divide_by(const tp_reduced *r, const arf_t factor) {
  tp_cones *cones = r->cones;
  const long bits = r->question->judge.bits;
  arb_t divisor;
  arb_init(divisor);
  arb_set_arf(divisor, factor);
  arb_div(cones->friction, r->friction, divisor, bits);
  for (long k = 0; k < cones->allowance_count; k++) {
    arb_div(cones->allowances[k].shear, r->bounds + 2 * k, divisor, bits);
    arb_div(cones->allowances[k].pull, r->bounds + 2 * k + 1, divisor, bits);
  }
  arb_clear(divisor);
}

double tp_reduced_margin(tp_reduced *r, double log_factor) {
  const double upright = 90, beyond = 180;
  tp_sketch_divide_strength(&r->reduced, r->given, 2 * r->cones->count, exp(log_factor));
  const double limit = tp_program_estimate(&r->reduced, r->question);
  return (limit < upright ? limit : beyond) - r->degrees;
}

tp_limit_outcome tp_reduced_find(tp_reduced_limit *at, tp_reduced *r, const arf_t factor,
                                 const arb_t degrees) {
  tp_limit_answer answer;
  if (!tp_limit_answer_init(&answer, r->cones)) return TP_LIMIT_OUT_OF_MEMORY;
  divide_by(r, factor);
  tp_sketch_divide_strength(&r->reduced, r->given, 2 * r->cones->count,
                            arf_get_d(factor, ARF_RND_NEAR));
  tp_limit_question question = *r->question;
  question.sketch = &r->reduced;
  const tp_limit_outcome outcome = tp_limit_find(&answer, &question);
  at->side = 0;
  at->has_motion = false;
  arb_indeterminate(at->degrees);
  if (outcome == TP_LIMIT_PROVEN) {
    if (answer.kind == TP_LIMIT_INTERLOCKED) at->side = 1;
    if (answer.kind == TP_LIMIT_NOWHERE) at->side = -1;
    if (answer.kind == TP_LIMIT_AT_ANGLE) {
      arb_set(at->degrees, answer.degrees);
      at->has_motion = true;
      at->motion = answer.face.motion;
      if (arb_gt(answer.degrees, degrees)) at->side = 1;
      if (arb_lt(answer.degrees, degrees)) at->side = -1;
    }
  }
  tp_limit_answer_clear(&answer);
  return outcome;
}

tp_limit_outcome tp_reduced_side(int *side, tp_reduced *r, const arf_t factor,
                                 const arb_t degrees) {
  tp_reduced_limit at = {.side = 0};
  arb_init(at.degrees);
  const tp_limit_outcome outcome = tp_reduced_find(&at, r, factor, degrees);
  *side = at.side;
  arb_clear(at.degrees);
  return outcome;
}
