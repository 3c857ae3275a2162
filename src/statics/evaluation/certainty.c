/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Conversion of balls into bounded results, with the tests for the digits asked, for a zero known
 * to half the bits, and for differences of angles (docs/mechanics.md section 10, ties). */

#include "evaluation/certainty.h"

#include "number/ball.h"
#include "problem/drawn.h"

#include <math.h>

void tp_certainty_add(tp_certainty *sum, const tp_certainty *own) {
  sum->open = sum->open || own->open;
  sum->undecided_number = sum->undecided_number || own->undecided_number;
  const bool fewer = sum->zero_bits == 0 || own->zero_bits < sum->zero_bits;
  if (own->zero_bits != 0 && fewer) sum->zero_bits = own->zero_bits;
}

void tp_certainty_take_zero(tp_certainty *certainty, const tp_evaluation *e) {
  tp_certainty_add(certainty, &(tp_certainty){.zero_bits = e->rung.bits});
}

void tp_certainty_leave_open(tp_certainty *certainty, const tp_evaluation *e) {
  if (!tp_evaluation_is_last_rung(e)) certainty->open = true;
}

bool tp_is_zero_width(const tp_evaluation *e, const arb_t ball, double log2_scale) {
  if (!tp_problem_is_enclosed(e->problem) || e->rung.bits < TP_BALL_BITS) return false;
  return arb_is_finite(ball) &&
         mag_get_d_log2_approx(arb_radref(ball)) < log2_scale - 0.5 * (double)e->rung.bits;
}

bool tp_is_settled(const tp_evaluation *e, const arb_t ball) {
  return e->rung.bits >= TP_SETTLING_BITS && tp_is_zero_width(e, ball, 0);
}

bool tp_result_is_above(const tp_evaluation *e, tp_bounded high, tp_bounded low,
                        tp_certainty *certainty) {
  static const double least_deg = 1e-6;
  const double apart = high.value - low.value;
  const bool open = fabs(apart - least_deg) <= high.error + low.error;
  if (open) tp_certainty_leave_open(certainty, e);
  return apart > least_deg;
}

tp_bounded tp_result_of(const tp_evaluation *e, const arb_t ball) {
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
static tp_bounded uncertain(const tp_evaluation *e, const arb_t ball, tp_certainty *certainty) {
  if (tp_evaluation_is_last_rung(e) && arb_is_finite(ball)) {
    certainty->undecided_number = true;
  } else {
    certainty->open = true;
  }
  return tp_ball_bounded(ball);
}

tp_bounded tp_result_scaled(const tp_evaluation *e, const arb_t ball, double log2_scale,
                            tp_certainty *certainty) {
  const bool zero = arb_contains_zero(ball) && tp_is_zero_width(e, ball, log2_scale);
  if (!zero && !is_certain(e, ball)) return uncertain(e, ball, certainty);
  return tp_result_of(e, ball);
}

tp_bounded tp_result(const tp_evaluation *e, const arb_t ball, tp_certainty *certainty) {
  return tp_result_scaled(e, ball, 0, certainty);
}

tp_bounded tp_result_within(const tp_evaluation *e, const arb_t ball, double log2_size,
                            tp_certainty *certainty) {
  const double asked = log2_size - tp_digits_bits(e->digits);
  const bool within = arb_is_finite(ball) && tp_mag_log2(arb_radref(ball)) < asked;
  if (!within && !is_certain(e, ball)) return uncertain(e, ball, certainty);
  return tp_result_of(e, ball);
}

tp_bounded tp_result_metres(const tp_evaluation *e, arb_t value, int degree,
                            tp_certainty *certainty) {
  tp_evaluation_to_metres(value, e, degree);
  return tp_result_scaled(e, value, degree * e->log2_extent, certainty);
}

void tp_result_point(tp_bounded *x_m, tp_bounded *y_m, const tp_evaluation *e, tp_outline_point at,
                     tp_certainty *certainty) {
  if (at.cut == NULL) {
    tp_result_lattice_point(x_m, y_m, e->problem, at.point);
    return;
  }
  const tp_lattice *l = &e->problem->lattice;
  arb_t x, y;
  arb_init(x);
  arb_init(y);
  tp_evaluation_point(x, y, e, at);
  arb_add_fmpz(x, x, l->origin_x, e->rung.bits);
  arb_add_fmpz(y, y, l->origin_y, e->rung.bits);
  if (tp_drawn_is_same(e->problem)) {
    *x_m = tp_result_metres(e, x, 1, certainty);
    *y_m = tp_result_metres(e, y, 1, certainty);
  } else {
    tp_evaluation_to_metres(x, e, 1);
    tp_evaluation_to_metres(y, e, 1);
    tp_result_place(x_m, y_m, e, x, y, e->log2_extent, certainty);
  }
  arb_clear(x);
  arb_clear(y);
}

void tp_result_place(tp_bounded *x_m, tp_bounded *y_m, const tp_evaluation *e, arb_t x, arb_t y,
                     double log2_size, tp_certainty *certainty) {
  tp_drawn_ball(x, y, e->problem, e->rung.bits);
  *x_m = tp_result_within(e, x, log2_size, certainty);
  *y_m = tp_result_within(e, y, log2_size, certainty);
}

enum { BITS_OF_RATIONAL = 128 }; /* more than a double can show */

tp_bounded tp_result_rational(const fmpq_t value) {
  arb_t ball;
  arb_init(ball);
  arb_set_fmpq(ball, value, BITS_OF_RATIONAL);
  const tp_bounded result = tp_ball_bounded(ball);
  arb_clear(ball);
  return result;
}

/* As tp_result_rational, but for the lowest terms. */
static tp_bounded coordinate(const tp_lattice *lattice, const fmpz *value, const fmpz *origin) {
  fmpz_t steps;
  arb_t ball;
  fmpz_init(steps);
  arb_init(ball);
  fmpz_add(steps, value, origin);
  fmpz_mul(steps, steps, fmpq_numref(lattice->step_m));
  arb_fmpz_div_fmpz(ball, steps, fmpq_denref(lattice->step_m), BITS_OF_RATIONAL);
  const tp_bounded result = tp_ball_bounded(ball);
  fmpz_clear(steps);
  arb_clear(ball);
  return result;
}

void tp_result_exact_place(tp_bounded *x_m, tp_bounded *y_m, const tp_problem *problem, fmpq_t x,
                           fmpq_t y) {
  const fmpq *metres = problem->scene->metres_per_unit;
  fmpq_div(x, x, metres);
  fmpq_div(y, y, metres);
  tp_drawn_point(x, y, problem);
  fmpq_mul(x, x, metres);
  fmpq_mul(y, y, metres);
  *x_m = tp_result_rational(x);
  *y_m = tp_result_rational(y);
}

void tp_result_lattice_point(tp_bounded *x_m, tp_bounded *y_m, const tp_problem *problem,
                             long point) {
  const tp_lattice *l = &problem->lattice;
  if (tp_drawn_is_same(problem)) {
    *x_m = coordinate(l, l->x + point, l->origin_x);
    *y_m = coordinate(l, l->y + point, l->origin_y);
    return;
  }
  fmpq_t x, y;
  fmpq_init(x);
  fmpq_init(y);
  tp_lattice_metres_x(x, l, l->x + point);
  tp_lattice_metres_y(y, l, l->y + point);
  tp_result_exact_place(x_m, y_m, problem, x, y);
  fmpq_clear(x);
  fmpq_clear(y);
}
