/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "stability/evaluation.h"

#include "number/ball.h"

#include <math.h>

long tp_evaluation_bits(const tp_evaluation *evaluation) {
  return evaluation->rung.level == TP_LEVEL_EXACT ? ARF_PREC_EXACT : evaluation->rung.bits;
}

bool tp_evaluation_is_last_rung(const tp_evaluation *evaluation) {
  return 4 * evaluation->rung.bits > tp_ladder_most_bits(evaluation->digits);
}

bool tp_evaluation_is_zero_width(const tp_evaluation *e, const arb_t ball, double log2_scale) {
  enum { LEAST_BITS = 160 };
  if (!tp_problem_is_enclosed(e->problem) || e->rung.bits < LEAST_BITS) return false;
  return arb_is_finite(ball) &&
         mag_get_d_log2_approx(arb_radref(ball)) < log2_scale - 0.5 * (double)e->rung.bits;
}

bool tp_evaluation_is_settled(const tp_evaluation *e, const arb_t ball) {
  enum { SETTLING_BITS = 1280 };
  return e->rung.bits >= SETTLING_BITS && tp_evaluation_is_zero_width(e, ball, 0);
}

bool tp_evaluation_is_above(tp_evaluation *e, tp_bounded high, tp_bounded low) {
  static const double least_deg = 1e-6;
  const double apart = high.value - low.value;
  const bool open = fabs(apart - least_deg) <= high.error + low.error;
  if (open && !tp_evaluation_is_last_rung(e)) e->certain = false;
  return apart > least_deg;
}

tp_bounded tp_evaluation_bounded(const tp_evaluation *e, const arb_t ball) {
  tp_bounded result = tp_ball_bounded(ball);
  if (e->decimals != NULL) result.digits = tp_decimals_keep(e->decimals, ball);
  return result;
}

/* With a few digits to spare, so that those asked for round alike over all of the ball. */
static bool is_certain(const tp_evaluation *e, const arb_t ball) {
  enum { SPARE = 3 };
  return tp_ball_certain(ball, e->decimals != NULL ? e->digits + SPARE : e->digits);
}

/* More bits may tell; on the last rung what is finite is given as it is. */
static tp_bounded uncertain(tp_evaluation *evaluation, const arb_t ball) {
  if (tp_evaluation_is_last_rung(evaluation) && arb_is_finite(ball)) {
    evaluation->open_number = true;
  } else {
    evaluation->certain = false;
  }
  return tp_ball_bounded(ball);
}

tp_bounded tp_evaluation_result_scaled(tp_evaluation *evaluation, const arb_t ball,
                                       double log2_scale) {
  const bool zero =
      arb_contains_zero(ball) && tp_evaluation_is_zero_width(evaluation, ball, log2_scale);
  if (!zero && !is_certain(evaluation, ball)) return uncertain(evaluation, ball);
  return tp_evaluation_bounded(evaluation, ball);
}

tp_bounded tp_evaluation_result(tp_evaluation *evaluation, const arb_t ball) {
  return tp_evaluation_result_scaled(evaluation, ball, 0);
}

tp_bounded tp_evaluation_result_within(tp_evaluation *evaluation, const arb_t ball,
                                       double log2_size) {
  const double asked = log2_size - tp_digits_bits(evaluation->digits);
  if (!is_certain(evaluation, ball) &&
      !(arb_is_finite(ball) && tp_mag_log2(arb_radref(ball)) < asked)) {
    return uncertain(evaluation, ball);
  }
  return tp_evaluation_bounded(evaluation, ball);
}

tp_bounded tp_evaluation_rational(const fmpq_t value) {
  arb_t ball;
  arb_init(ball);
  arb_set_fmpq(ball, value, 128);
  const tp_bounded result = tp_ball_bounded(ball);
  arb_clear(ball);
  return result;
}

static tp_bounded coordinate(const tp_lattice *lattice, const fmpz *value,
                             void (*to_metres)(fmpq_t, const tp_lattice *, const fmpz_t)) {
  fmpq_t metres;
  fmpq_init(metres);
  to_metres(metres, lattice, value);
  const tp_bounded result = tp_evaluation_rational(metres);
  fmpq_clear(metres);
  return result;
}

tp_bounded tp_evaluation_x(const tp_problem *problem, long point) {
  return coordinate(&problem->lattice, problem->lattice.x + point, tp_lattice_metres_x);
}

tp_bounded tp_evaluation_y(const tp_problem *problem, long point) {
  return coordinate(&problem->lattice, problem->lattice.y + point, tp_lattice_metres_y);
}

void tp_direction_ball_init(tp_direction_ball *angle) {
  arb_init(angle->sine);
  arb_init(angle->cosine);
  arb_init(angle->degrees);
  arb_init(angle->inclination);
  angle->exact_direction = angle->adds_friction = false;
}

void tp_direction_ball_clear(tp_direction_ball *angle) {
  arb_clear(angle->sine);
  arb_clear(angle->cosine);
  arb_clear(angle->degrees);
  arb_clear(angle->inclination);
}

/* Sign of sin(a - b), which is that of a - b for angles less than half a turn apart. */
static bool cross_sign(const tp_direction_ball *a, const tp_direction_ball *b, int *sign) {
  arb_t cross;
  arb_init(cross);
  arb_mul(cross, a->sine, b->cosine, ARF_PREC_EXACT);
  arb_submul(cross, b->sine, a->cosine, ARF_PREC_EXACT);
  const bool decided = arb_is_exact(cross) || !arb_contains_zero(cross);
  *sign = arf_sgn(arb_midref(cross));
  arb_clear(cross);
  return decided;
}

int tp_evaluation_compare(tp_evaluation *evaluation, const tp_direction_ball *a,
                          const tp_direction_ball *b) {
  if (arb_lt(a->degrees, b->degrees)) return -1;
  if (arb_gt(a->degrees, b->degrees)) return 1;
  int sign = 0;
  evaluation->tie_bits = 0;
  if (arb_is_exact(a->degrees) && arb_is_exact(b->degrees)) return 0;
  if (evaluation->rung.level == TP_LEVEL_EXACT && a->exact_direction && b->exact_direction &&
      cross_sign(a, b, &sign)) {
    return sign;
  }
  if (!tp_evaluation_is_settled(evaluation, a->degrees) ||
      !tp_evaluation_is_settled(evaluation, b->degrees)) {
    evaluation->certain = false;
  }
  evaluation->tie_bits = evaluation->rung.bits;
  return 0;
}
