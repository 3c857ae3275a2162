/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The static limit of a problem (docs/mechanics.md section 6): its contact and its loads put as a
 * question to limit/, and the answer as a result. */

#include "evaluation/friction.h"
#include "evaluation/loaded.h"
#include "evaluation/stages.h"
#include "limit/program.h"
#include "static_limit/limit_asked.h"
#include "static_limit/limit_balance.h"
#include "static_limit/limit_cones.h"
#include "static_limit/limit_friction.h"
#include "static_limit/limit_result.h"
#include "static_limit/limit_serves.h"
#include "strength_reduction/reduction.h"

static bool is_exhausted(const tp_limit_asking *a) {
  const tp_work *work = a->e->work;
  return work != NULL && work->spent > tp_work_allowed(tp_cones_column_count(a->cones));
}

/* A higher rung may tell, if there is one and work is left for it. */
static void leave_open(tp_limit *result, const tp_limit_asking *a) {
  result->too_dear = is_exhausted(a);
  if (!result->too_dear) tp_certainty_leave_open(a->certainty, a->e);
}

/* Under loads that do not turn with the weight a contact at one point holds at single tilts at
 * most, where all moments about it cancel: their sum is a combination of independent functions of
 * the tilt, and not all of them vanish. No strength changes that. */
static bool holds_at_single_tilts(const tp_limit_asking *a) {
  const tp_cones *cones = a->cones;
  if (a->e->loaded == NULL || a->outcome == TP_LIMIT_OUT_OF_MEMORY) return false;
  for (long k = 1; k < cones->count; k++) {
    if (cones->points[k].site != cones->points[0].site) return false;
  }
  tp_trig moment;
  bool vanishes = true;
  tp_trig_init(&moment);
  tp_loaded_moment(&moment, a->e->loaded, a->e, 0);
  for (int k = 0; k < TP_BASIS; k++) {
    vanishes = vanishes && arb_contains_zero(moment.of + k);
  }
  tp_trig_clear(&moment);
  return !vanishes;
}

/* The factor of safety by strength reduction, with the friction at the scene's tilt. */
static void reduce_strength(tp_limit *result, tp_limit_asking *a) {
  const tp_evaluation *e = a->e;
  const tp_quantity *given = &e->problem->scene->tilt_angle_deg;
  result->fos = (tp_fos){.state = TP_FOS_NO_TILT};
  result->fos_mechanism = TP_MECHANISM_UNDECIDED;
  if (!given->given) return;
  if (!e->reduces_strength) {
    result->fos.state = TP_FOS_NOT_ASKED;
    return;
  }
  tp_reduction found;
  arb_t tilt, friction;
  tp_reduction_init(&found);
  arb_init(tilt);
  arb_init(friction);
  arb_set_fmpq(tilt, given->value, e->rung.bits);
  tp_friction_at(friction, e, tilt);
  tp_friction_set_tangent(a->cones->friction, e, friction);
  tp_work_begin(e->work, tp_cones_column_count(a->cones));
  a->outcome = tp_reduction_find(&found, a->question, a->cones, tilt, e->digits);
  if (holds_at_single_tilts(a)) {
    result->fos.state = TP_FOS_UNDEFINED;
  } else if (a->outcome != TP_LIMIT_PROVEN) {
    result->fos.state = TP_FOS_UNDECIDED;
    leave_open(result, a);
  } else if (found.kind == TP_REDUCTION_FACTOR) {
    result->fos = (tp_fos){TP_FOS_NUMBER, tp_result_of(e, found.factor)};
    if (found.has_motion) result->fos_mechanism = tp_limit_mechanism(found.motion);
  } else {
    result->fos.state = found.kind == TP_REDUCTION_NONE ? TP_FOS_UNDEFINED : TP_FOS_NO_OVERTURNING;
  }
  tp_reduction_clear(&found);
  arb_clear(tilt);
  arb_clear(friction);
}

/* Likewise at further tilts. */
static void reduce_at_tilts(const tp_further_tilts *tilts, tp_limit_asking *a) {
  for (size_t k = 0; k < tilts->count && a->outcome != TP_LIMIT_OUT_OF_MEMORY; k++) {
    const tp_further_tilt *at = tilts->items + k;
    tp_limit_question question = *a->question;
    tp_limit_asking own = *a;
    own.e = at->e;
    own.certainty = at->certainty;
    own.question = &question;
    question.work = at->e->work;
    tp_further_begin(at, &(tp_work){0});
    reduce_strength(&at->result->limit, &own);
    tp_further_end(at);
    if (own.outcome == TP_LIMIT_OUT_OF_MEMORY) a->outcome = own.outcome;
  }
}

static void describe(tp_limit *result, tp_direction_ball *angle, const tp_limit_asking *a,
                     tp_direction towards, tp_limit_balance *balance) {
  const tp_evaluation *e = a->e;
  if (holds_at_single_tilts(a)) { /* a search may come upon one of them, or not */
    result->kind = TP_LIMIT_NOWHERE;
    result->mechanism = TP_SLIDES_AND_TOPPLES;
    return;
  }
  if (a->outcome != TP_LIMIT_PROVEN) {
    result->kind = TP_LIMIT_UNDECIDED;
    result->mechanism = TP_MECHANISM_UNDECIDED;
    leave_open(result, a);
    return;
  }
  tp_limit_describe(result, e, a->question, a->answer, towards, a->certainty);
  if (balance != NULL && result->kind == TP_LIMIT_AT_ANGLE) {
    tp_limit_balance_find(balance, e, a->question, a->answer, towards);
  }
  arb_set(angle->sine, a->answer->sine);
  arb_set(angle->cosine, a->answer->cosine);
  arb_set(angle->degrees, a->answer->degrees);
  arb_set(angle->inclination, a->answer->inclination);
  angle->adds = NULL;
  if (a->answer->adds_friction) {
    const tp_cone_point *slips =
        a->cones->points + tp_cones_point_of(a->cones, a->answer->face.columns[0]);
    angle->adds = tp_friction_exact(e, slips->facet);
  }
  angle->exact_direction = e->loaded == NULL && !a->answer->tie;
}

/* What several questions about one contact share. */
typedef struct contact_forces {
  tp_cones cones;
  tp_scaled scaled;
  bool has_scaled; /* not with friction that depends on the load: it changes with every question */
} contact_forces;

/* Tilted on or back; with the factor of safety, there and at further tilts; whether the limit
 * serves for the base as it is otherwise is told there, or not asked; and likewise all forces at
 * it. */
typedef struct variant {
  bool back, with_factor;
  const tp_further_tilts *tilts;
  bool *serves;
  tp_limit_balance *balance;
} variant;

/* False when memory is exhausted. */
static bool share_scaled(contact_forces *c, tp_limit_question *question, const tp_evaluation *e) {
  if (tp_friction_is_load_dependent(e) || c->cones.count == 0) return true;
  if (!c->has_scaled) {
    arb_t friction;
    arb_init(friction);
    tp_friction_at(friction, e, friction);
    tp_friction_set_tangent(c->cones.friction, e, friction);
    arb_clear(friction);
    c->has_scaled = tp_program_scaled(&c->scaled, question);
  }
  question->scaled = c->has_scaled ? &c->scaled : NULL;
  return c->has_scaled;
}

/* What an answer took for zero it tells, but for a tie, which does so itself. */
static void note_zeros(tp_limit_asked *asked, const tp_limit_asking *a, bool is_told) {
  if (asked->took_zero && a->outcome == TP_LIMIT_PROVEN && !is_told) {
    tp_certainty_take_zero(a->certainty, a->e);
  }
  asked->took_zero = false;
}

/* The answer of one question, as far as the rung goes; false when memory is exhausted. */
static bool ask(tp_limit *result, tp_direction_ball *angle, const tp_evaluation *e,
                contact_forces *c, tp_direction towards, variant v, tp_certainty *certainty) {
  tp_limit_answer answer;
  if (!tp_limit_answer_init(&answer, &c->cones)) return false;
  tp_limit_asked asked;
  tp_limit_asked_init(&asked, &c->cones, e, towards, v.back);
  tp_limit_question *question = &asked.question;
  tp_limit_asking a = {e, certainty, &c->cones, question, &answer, TP_LIMIT_OUT_OF_MEMORY, v.back};
  tp_work_begin(e->work, tp_cones_column_count(&c->cones));
  if (share_scaled(c, question, e)) {
    a.outcome = TP_LIMIT_PROVEN;
    tp_limit_meet_friction(result, &a);
    describe(result, angle, &a, towards, v.balance);
    if (v.serves != NULL && a.outcome == TP_LIMIT_PROVEN && !asked.took_zero &&
        !tp_limit_serves(v.serves, e, towards, question, &answer)) {
      a.outcome = TP_LIMIT_OUT_OF_MEMORY;
    }
    note_zeros(&asked, &a, result->tie_bits != 0);
  }
  if (a.outcome != TP_LIMIT_OUT_OF_MEMORY && v.with_factor) {
    reduce_strength(result, &a);
    note_zeros(&asked, &a, false);
    if (v.tilts != NULL) reduce_at_tilts(v.tilts, &a);
  }
  tp_limit_asked_clear(&asked);
  tp_limit_answer_clear(&answer);
  return a.outcome != TP_LIMIT_OUT_OF_MEMORY;
}

static void contact_forces_clear(contact_forces *c) {
  if (c->has_scaled) tp_scaled_clear(&c->scaled);
  tp_cones_clear(&c->cones);
}

static bool find_own(tp_case *result, tp_direction_ball *limit, tp_direction_ball *back,
                     const tp_evaluation *e, const tp_further_tilts *tilts, bool *serves,
                     tp_cones *cones, tp_certainty *certainty) {
  const tp_direction towards = result->towards;
  contact_forces c = {.has_scaled = false};
  if (!tp_limit_cones_init(&c.cones, e, towards, false)) return false;
  result->limit = (tp_limit){.base_beyond_toe = tp_limit_base_beyond_toe(e->problem, towards)};
  result->limit_holds_from = result->limit;
  result->balance = (tp_limit_balance){.known = false};
  const variant forward = {
      .with_factor = true, .tilts = tilts, .serves = serves, .balance = &result->balance};
  const bool done =
      ask(&result->limit, limit, e, &c, towards, forward, certainty) &&
      ask(&result->limit_holds_from, back, e, &c, towards, (variant){.back = true}, certainty);
  if (done && e->loaded == NULL && e->problem->friction.beside_count == 0) {
    *cones = c.cones;
    c.cones = (tp_cones){.count = 0};
  }
  contact_forces_clear(&c);
  return done;
}

/* With a base that ends at the toe where the scene's goes on, or the other way round. */
static bool find_otherwise(tp_case *result, const tp_evaluation *e, tp_certainty *certainty) {
  const tp_direction towards = result->towards;
  contact_forces c = {.has_scaled = false};
  if (!tp_limit_cones_init(&c.cones, e, towards, true)) return false;
  tp_direction_ball other;
  tp_direction_ball_init(&other);
  result->limit_otherwise =
      (tp_limit){.base_beyond_toe = !tp_limit_base_beyond_toe(e->problem, towards)};
  const bool done = ask(&result->limit_otherwise, &other, e, &c, towards, (variant){0}, certainty);
  tp_direction_ball_clear(&other);
  contact_forces_clear(&c);
  return done;
}

/* Of two that tie either may be named first. */
static bool share_mechanism(const tp_limit *a, const tp_limit *b) {
  return a->mechanism == b->mechanism || (a->tie && a->tied_with == b->mechanism) ||
         (b->tie && b->tied_with == a->mechanism);
}

static bool differ(const tp_limit *a, const tp_limit *b, const tp_evaluation *e,
                   tp_certainty *certainty) {
  if (a->kind != b->kind || !share_mechanism(a, b)) return true;
  return a->kind == TP_LIMIT_AT_ANGLE &&
         (tp_result_is_above(e, a->critical_angle_deg, b->critical_angle_deg, certainty) ||
          tp_result_is_above(e, b->critical_angle_deg, a->critical_angle_deg, certainty));
}

/* With a base otherwise that changes nothing. */
static void take_otherwise(tp_case *result) {
  result->limit_otherwise = result->limit;
  result->limit_otherwise.base_beyond_toe = !result->limit.base_beyond_toe;
  result->limit_otherwise.fos = (tp_fos){.state = TP_FOS_NOT_ASKED};
}

/* All but the factor, which is told there already. */
static void share_limits(const tp_further_tilts *tilts, const tp_case *result, bool otherwise) {
  for (size_t k = 0; k < tilts->count; k++) {
    tp_case *at = tilts->items[k].result;
    const tp_limit told = at->limit;
    at->limit = result->limit;
    at->limit.fos = told.fos;
    at->limit.fos_mechanism = told.fos_mechanism;
    at->balance = result->balance;
    at->limit_holds_from = result->limit_holds_from;
    take_otherwise(at);
    if (otherwise) at->limit_otherwise = result->limit_otherwise;
    at->base_matters = result->base_matters;
  }
}

bool tp_evaluate_limit(const tp_evaluation *e, tp_case *result, tp_direction_ball *limit,
                       tp_direction_ball *back, const tp_further_tilts *tilts, tp_cones *cones,
                       tp_certainty *certainty) {
  bool matters = false, serves = false;
  bool done = tp_limit_base_matters(&matters, e->problem, result->towards) &&
              find_own(result, limit, back, e, tilts, matters ? &serves : NULL, cones, certainty);
  const bool otherwise = matters && !serves;
  take_otherwise(result);
  if (done && otherwise) done = find_otherwise(result, e, certainty);
  result->limit_otherwise.fos = (tp_fos){.state = TP_FOS_NOT_ASKED};
  result->base_matters = differ(&result->limit, &result->limit_otherwise, e, certainty);
  share_limits(tilts, result, otherwise);
  return done;
}
