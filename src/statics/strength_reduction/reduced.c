/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Strength divided by a factor in balls and in the scaled program; margin by the linear program of
 * a push, sides by equilibrium.h and infeasible.h or by the limit found anew. */

#include "strength_reduction/reduced.h"

#include "certificate/equilibrium.h"
#include "certificate/infeasible.h"
#include "limit/program.h"
#include "limit/search.h"

#include <math.h>

static void set_load(tp_reduced *r) {
  tp_vector_init(&r->load);
  tp_question_load_term(&r->load, r->question->load, TP_COS);
  tp_scaled_wrench_near(r->level, &r->reduced, &r->load);
  tp_question_load_at_degrees(&r->load, r->question, r->degrees);
  tp_scaled_wrench(r->target, &r->reduced, &r->load);
  for (int row = 0; row < 3; row++) r->target[row] = -r->target[row];
}

void tp_reduced_init(tp_reduced *r) {
  set_load(r);
  const tp_cones *cones = r->cones;
  arb_init(r->friction);
  arb_set(r->friction, cones->friction);
  r->own_friction = _arb_vec_init(cones->own_count);
  _arb_vec_set(r->own_friction, cones->own_friction, cones->own_count);
  r->bounds = _arb_vec_init(2 * cones->capacity_count);
  for (long k = 0; k < cones->capacity_count; k++) {
    arb_set(r->bounds + 2 * k, cones->capacities[k].shear);
    arb_set(r->bounds + 2 * k + 1, cones->capacities[k].pull);
  }
}

void tp_reduced_clear(tp_reduced *r) {
  tp_cones *cones = r->cones;
  arb_swap(cones->friction, r->friction);
  _arb_vec_swap(cones->own_friction, r->own_friction, cones->own_count);
  _arb_vec_clear(r->own_friction, cones->own_count);
  for (long k = 0; k < cones->capacity_count; k++) {
    arb_swap(cones->capacities[k].shear, r->bounds + 2 * k);
    arb_swap(cones->capacities[k].pull, r->bounds + 2 * k + 1);
  }
  _arb_vec_clear(r->bounds, 2 * cones->capacity_count);
  arb_clear(r->friction);
  tp_vector_clear(&r->load);
}

static void divide_by(const tp_reduced *r, const arf_t factor) {
  tp_cones *cones = r->cones;
  const long bits = r->question->judge.bits;
  arb_t divisor;
  arb_init(divisor);
  arb_set_arf(divisor, factor);
  arb_div(cones->friction, r->friction, divisor, bits);
  for (long k = 0; k < cones->own_count; k++) {
    arb_div(cones->own_friction + k, r->own_friction + k, divisor, bits);
  }
  for (long k = 0; k < cones->capacity_count; k++) {
    arb_div(cones->capacities[k].shear, r->bounds + 2 * k, divisor, bits);
    arb_div(cones->capacities[k].pull, r->bounds + 2 * k + 1, divisor, bits);
  }
  arb_clear(divisor);
}

/* The share of a push from within the cone that the base bears beside the loads, as
 * certificate/equilibrium.h has it. */
double tp_reduced_margin(tp_reduced *r, double log_factor) {
  static const double much = 1e3; /* times the loads: as good as held by any force */
  const long edges = 2 * r->cones->count;
  tp_scaled_divide_strength(&r->reduced, r->given, edges, exp(log_factor));
  double push[3] = {0, 0, 0};
  for (int k = 0; k < TP_PUSH_EDGES; k++) {
    const double *edge = r->reduced.columns[tp_equilibrium_push_edge(r->cones, k)];
    for (int row = 0; row < 3; row++) push[row] += tp_equilibrium_push_weights[k] * edge[row];
  }
  const tp_simplex_answer found = tp_scaled_solve(&r->reduced, push, r->target);
  if (found.outcome == TP_SIMPLEX_OPTIMAL) return fmin(found.t, much);
  return found.outcome == TP_SIMPLEX_UNBOUNDED ? much : -1;
}

static void divide(tp_reduced *r, const arf_t factor) {
  divide_by(r, factor);
  tp_scaled_divide_strength(&r->reduced, r->given, 2 * r->cones->count,
                            arf_get_d(factor, ARF_RND_NEAR));
}

tp_limit_outcome tp_reduced_find(tp_reduced_limit *at, tp_reduced *r, const arf_t factor) {
  tp_limit_answer answer;
  at->kind = TP_LIMIT_UNDECIDED;
  at->has_motion = false;
  if (!tp_limit_answer_init(&answer, r->cones)) return TP_LIMIT_OUT_OF_MEMORY;
  divide(r, factor);
  tp_limit_question question = *r->question;
  question.scaled = &r->reduced;
  question.without_forces = true;
  const tp_limit_outcome outcome = tp_limit_find(&answer, &question);
  if (outcome == TP_LIMIT_PROVEN) at->kind = answer.kind;
  at->has_motion = at->kind == TP_LIMIT_AT_ANGLE;
  arb_indeterminate(at->degrees);
  if (at->has_motion) {
    arb_set(at->degrees, answer.degrees);
    at->motion = tp_face_told_motion(&answer.face, r->cones);
  }
  tp_limit_answer_clear(&answer);
  return outcome;
}

bool tp_reduced_holds_below(const tp_reduced_limit *at, tp_reduced *r) {
  if (at->kind != TP_LIMIT_AT_ANGLE || !tp_question_is_linear(r->question) ||
      arb_is_negative(r->degrees) || !arb_lt(r->degrees, at->degrees)) {
    return false;
  }
  tp_near push[3];
  tp_equilibrium_push_near(push, r->cones, &r->reduced);
  const tp_simplex_answer found = tp_equilibrium_solve_near(&r->reduced, push, r->level);
  return tp_equilibrium_is_told(&found, &r->reduced, push, r->level);
}

/* Where forces span less than all directions: held nowhere, or, where loads turn with the tilt so
 * that it is held between two tilts alone, no longer. */
static tp_limit_outcome infeasible_by_limit(int *side, tp_reduced *r, const arf_t factor) {
  tp_reduced_limit at;
  arb_init(at.degrees);
  const tp_limit_outcome outcome = tp_reduced_find(&at, r, factor);
  const bool before = at.kind == TP_LIMIT_AT_ANGLE && arb_lt(at.degrees, r->degrees);
  if (at.kind == TP_LIMIT_NOWHERE || (before && tp_question_is_linear(r->question))) *side = -1;
  arb_clear(at.degrees);
  return outcome == TP_LIMIT_PROVEN && *side == 0 ? TP_LIMIT_OPEN : outcome;
}

static bool is_held(const tp_limit_question *q, tp_reduced *r, const tp_vector *push) {
  return tp_equilibrium_bears(q, &r->reduced, push, &r->load) == TP_YES;
}

static bool is_lost(tp_reduced_loss *loss, const tp_limit_question *q, tp_reduced *r,
                    const tp_vector *push) {
  tp_face_motion motion = TP_MOTION_TURN;
  const bool lost = tp_infeasible_under(&motion, q, &r->reduced, push, &r->load) == TP_YES;
  if (lost && loss != NULL) *loss = (tp_reduced_loss){true, motion};
  return lost;
}

tp_limit_outcome tp_reduced_side(int *side, tp_reduced_loss *loss, tp_reduced *r,
                                 const arf_t factor, int expected) {
  tp_limit_question strict = *r->question;
  strict.judge.settled = false; /* a proof takes nothing for zero that only is so to so many bits */
  *side = 0;
  if (loss != NULL) loss->known = false;
  divide(r, factor);
  if (expected < 0 && is_lost(loss, &strict, r, NULL)) {
    *side = -1;
    return TP_LIMIT_PROVEN;
  }
  tp_vector push;
  tp_vector_init(&push);
  tp_equilibrium_push(&push, &strict, &r->reduced);
  if (is_held(&strict, r, &push)) {
    *side = 1;
  } else if (is_lost(loss, &strict, r, &push)) {
    *side = -1;
  }
  tp_vector_clear(&push);
  if (r->reduced.out_of_memory) return TP_LIMIT_OUT_OF_MEMORY;
  return *side == 0 ? infeasible_by_limit(side, r, factor) : TP_LIMIT_PROVEN;
}
