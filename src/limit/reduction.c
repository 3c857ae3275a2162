/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "limit/reduction.h"

#include "limit/program.h"

#include <math.h>

/* Factors looked at: beyond these, strength does not matter. */
static const double least_factor = 1e-6, most_factor = 1e6;

/* The strength as given, to be divided. */
typedef struct reduction {
  const tp_limit_question *question;
  tp_cones *cones;
  arb_t friction; /* as given */
  arb_ptr bounds; /* shear and pull of each allowance, as given */
  const tp_sketch *given;
  tp_sketch reduced;
  double degrees;
} reduction;

static void reduction_init(reduction *r) {
  const tp_cones *cones = r->cones;
  arb_init(r->friction);
  arb_set(r->friction, cones->friction);
  r->bounds = _arb_vec_init(2 * cones->allowance_count);
  for (long k = 0; k < cones->allowance_count; k++) {
    arb_set(r->bounds + 2 * k, cones->allowances[k].shear);
    arb_set(r->bounds + 2 * k + 1, cones->allowances[k].pull);
  }
}

static void reduction_clear(reduction *r) {
  _arb_vec_clear(r->bounds, 2 * r->cones->allowance_count);
  arb_clear(r->friction);
}

static void divide_by(const reduction *r, double factor) {
  tp_cones *cones = r->cones;
  const long bits = r->question->judge.bits;
  arb_t divisor;
  arb_init(divisor);
  arb_set_d(divisor, factor);
  arb_div(cones->friction, r->friction, divisor, bits);
  for (long k = 0; k < cones->allowance_count; k++) {
    arb_div(cones->allowances[k].shear, r->bounds + 2 * k, divisor, bits);
    arb_div(cones->allowances[k].pull, r->bounds + 2 * k + 1, divisor, bits);
  }
  arb_clear(divisor);
}

static void restore(const reduction *r) {
  tp_cones *cones = r->cones;
  arb_set(cones->friction, r->friction);
  for (long k = 0; k < cones->allowance_count; k++) {
    arb_set(cones->allowances[k].shear, r->bounds + 2 * k);
    arb_set(cones->allowances[k].pull, r->bounds + 2 * k + 1);
  }
}

/* Limit less tilt in doubles, by the logarithm of the factor: it falls. */
static double margin(reduction *r, double log_factor) {
  tp_sketch_divide_strength(&r->reduced, r->given, 2 * r->cones->count, exp(log_factor));
  return tp_program_estimate(&r->reduced, r->question) - r->degrees;
}

/* A zero of the margin between two logarithms by regula falsi, the end that stays halved
 * (Illinois), and by halving where that is slow. */
static double solve(reduction *r, double low, double high, double at_low, double at_high) {
  enum { MOST_STEPS = 200 };
  int kept = 0;
  for (int step = 0; step < MOST_STEPS && high - low > 4e-16 * fmax(1, fabs(low)); step++) {
    const bool halves = step % 4 == 3;
    double middle =
        halves ? low + (high - low) / 2 : low + (high - low) * (at_low / (at_low - at_high));
    if (!(middle > low && middle < high)) middle = low + (high - low) / 2;
    if (!(middle > low && middle < high)) break;
    const double own = margin(r, middle);
    if (own == 0) return middle;
    if (own > 0) {
      low = middle;
      at_low = own;
      if (kept > 0) at_high /= 2;
      kept = 1;
    } else {
      high = middle;
      at_high = own;
      if (kept < 0) at_low /= 2;
      kept = -1;
    }
  }
  return low + (high - low) / 2;
}

/* Proven: 1 where the block holds beyond the tilt at this factor, -1 where not up to it, 0 open. */
static tp_limit_outcome prove_side(int *side, reduction *r, double factor, const arb_t degrees) {
  tp_limit_answer answer;
  if (!tp_limit_answer_init(&answer, r->cones)) return TP_LIMIT_OUT_OF_MEMORY;
  divide_by(r, factor);
  tp_sketch_divide_strength(&r->reduced, r->given, 2 * r->cones->count, factor);
  tp_limit_question question = *r->question;
  question.sketch = &r->reduced;
  const tp_limit_outcome outcome = tp_limit_find(&answer, &question);
  *side = 0;
  if (outcome == TP_LIMIT_PROVEN) {
    if (answer.kind == TP_LIMIT_INTERLOCKED) *side = 1;
    if (answer.kind == TP_LIMIT_NOWHERE) *side = -1;
    if (answer.kind == TP_LIMIT_AT_ANGLE && arb_gt(answer.degrees, degrees)) *side = 1;
    if (answer.kind == TP_LIMIT_AT_ANGLE && arb_lt(answer.degrees, degrees)) *side = -1;
  }
  tp_limit_answer_clear(&answer);
  return outcome;
}

/* Widen about the estimate until both sides are proven: from what doubles tell apart to what is
 * asked for, or a little more. */
static tp_limit_outcome enclose(arb_t factor, reduction *r, double estimate, const arb_t degrees,
                                int digits) {
  enum { NARROWEST = 13 }; /* 10^-13 */
  const int widest = digits + 1 < NARROWEST - 1 ? digits + 1 : NARROWEST - 1;
  for (int place = NARROWEST; place >= widest; place--) {
    const double width = pow(10, -place);
    int low = 0, high = 0;
    tp_limit_outcome outcome = prove_side(&low, r, estimate * (1 - width), degrees);
    if (outcome == TP_LIMIT_PROVEN) {
      outcome = prove_side(&high, r, estimate * (1 + width), degrees);
    }
    if (outcome == TP_LIMIT_OUT_OF_MEMORY || outcome == TP_LIMIT_FAILED) return outcome;
    if (low <= 0 || high >= 0) continue;
    arb_set_d(factor, estimate);
    mag_set_d(arb_radref(factor), 1.001 * width * estimate); /* the rounded ends lie within */
    return TP_LIMIT_PROVEN;
  }
  return TP_LIMIT_OPEN;
}

static tp_limit_outcome find(tp_reduction_kind *kind, arb_t factor, reduction *r,
                             const arb_t degrees, int digits) {
  const double low = log(least_factor), high = log(most_factor);
  const double at_low = margin(r, low), at_high = margin(r, high);
  if (at_low > 0 && at_high < 0) {
    *kind = TP_REDUCTION_FACTOR;
    return enclose(factor, r, exp(solve(r, low, high, at_low, at_high)), degrees, digits);
  }
  *kind = at_low > 0 ? TP_REDUCTION_UNBOUNDED : TP_REDUCTION_NONE;
  int side = 0;
  const tp_limit_outcome outcome =
      prove_side(&side, r, at_low > 0 ? most_factor : least_factor, degrees);
  if (outcome != TP_LIMIT_PROVEN) return outcome;
  return side == (at_low > 0 ? 1 : -1) ? TP_LIMIT_PROVEN : TP_LIMIT_OPEN;
}

tp_limit_outcome tp_reduction_find(tp_reduction_kind *kind, arb_t factor,
                                   const tp_limit_question *question, tp_cones *cones,
                                   const arb_t degrees, int digits) {
  reduction r = {.question = question,
                 .cones = cones,
                 .degrees = arf_get_d(arb_midref(degrees), ARF_RND_NEAR)};
  tp_sketch own;
  if (question->sketch == NULL && !tp_program_sketch(&own, question)) {
    return TP_LIMIT_OUT_OF_MEMORY;
  }
  r.given = question->sketch != NULL ? question->sketch : &own;
  tp_limit_outcome outcome = TP_LIMIT_OUT_OF_MEMORY;
  if (tp_sketch_copy(&r.reduced, r.given)) {
    reduction_init(&r);
    outcome = find(kind, factor, &r, degrees, digits);
    restore(&r);
    reduction_clear(&r);
    tp_sketch_clear(&r.reduced);
  }
  if (r.given == &own) tp_sketch_clear(&own);
  return outcome;
}
