/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Estimate in doubles, or proof at a given precision, of one limit for the comparison of topple
 * accuracy. */

#include "stability/limit_price.h"

#include "limit/program.h"
#include "stability/friction.h"
#include "stability/limit_asked.h"
#include "stability/limit_cones.h"

static tp_status estimate(arb_t degrees, bool *found, const tp_limit_question *question) {
  tp_scaled scaled;
  if (!tp_program_scaled(&scaled, question)) return TP_OUT_OF_MEMORY;
  const double own = tp_program_estimate(&scaled, question);
  tp_scaled_clear(&scaled);
  *found = own > -90 && own < 90;
  arb_set_d(degrees, own);
  return TP_OK;
}

static tp_status prove(arb_t degrees, bool *found, const tp_limit_question *question) {
  tp_limit_answer answer;
  if (!tp_limit_answer_init(&answer, question->cones)) return TP_OUT_OF_MEMORY;
  const tp_limit_outcome outcome = tp_limit_find(&answer, question);
  *found = outcome == TP_LIMIT_PROVEN && answer.kind == TP_LIMIT_AT_ANGLE;
  arb_set(degrees, answer.degrees);
  tp_limit_answer_clear(&answer);
  if (outcome == TP_LIMIT_OUT_OF_MEMORY) return TP_OUT_OF_MEMORY;
  return outcome == TP_LIMIT_FAILED ? TP_DEPENDENCY_FAILED : TP_OK;
}

tp_status tp_evaluate_limit_at_price(arb_t degrees, bool *found, const tp_evaluation *e,
                                     tp_direction towards, tp_limit_price price) {
  *found = false;
  if (tp_friction_is_load_dependent(e)) return TP_OK;
  tp_cones cones;
  if (!tp_limit_cones_init(&cones, e, towards, false)) return TP_OUT_OF_MEMORY;
  tp_limit_asked asked;
  tp_limit_asked_init(&asked, &cones, e, towards, false);
  arb_t friction;
  arb_init(friction);
  tp_friction_at(friction, e, friction);
  tp_friction_tangent(cones.friction, friction, e->rung.bits);
  arb_clear(friction);
  asked.question.without_doubles = price == TP_LIMIT_EXACTLY;
  const tp_status status = price == TP_LIMIT_IN_DOUBLES ? estimate(degrees, found, &asked.question)
                                                        : prove(degrees, found, &asked.question);
  tp_limit_asked_clear(&asked);
  tp_cones_clear(&cones);
  return status;
}
