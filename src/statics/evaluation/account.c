/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The account of moments by elements about the governing pivot, as Appendix A writes it. */

#include "evaluation/stages.h"

#include "number/ball.h"

typedef struct account {
  const tp_evaluation *evaluation;
  tp_certainty *certainty;
  arb_t sine, cosine;             /* of the tilt */
  arb_t metres;                   /* per sixth of a lattice unit */
  arb_t weight;                   /* per unit of weight2 */
  arb_t stabilising, overturning; /* sums */
} account;

/* Newton per unit of weight2, or the fraction of the block's weight. */
static void set_weight(account *a) {
  const tp_problem *problem = a->evaluation->problem;
  const long bits = a->evaluation->rung.bits;
  if (!problem->scene->block.unit_weight_kn_m3.given) {
    arb_inv(a->weight, a->evaluation->moments.weighted + TP_A2, bits);
    return;
  }
  fmpq_t factor;
  fmpq_init(factor);
  tp_problem_weight_factor(factor, problem);
  arb_set_fmpq(a->weight, factor, bits);
  fmpq_clear(factor);
}

/* Arm of an element in sixths of a lattice unit, then in metres. */
static void set_arm(account *a, arb_t arm, const fmpz_t position6, const fmpz_t pivot, int sign) {
  fmpz_t sixths;
  fmpz_init(sixths);
  fmpz_mul_ui(sixths, pivot, 6);
  fmpz_sub(sixths, position6, sixths);
  if (sign < 0) fmpz_neg(sixths, sixths);
  arb_mul_fmpz(arm, a->metres, sixths, a->evaluation->rung.bits);
  fmpz_clear(sixths);
}

/* The component `weight * function` at an arm, to the side that its sign says. */
static void add_moment(const account *a, arb_t stabilising, arb_t overturning, const arb_t weight,
                       const arb_t function, const arb_t arm, bool positive_stabilises) {
  const long bits = a->evaluation->rung.bits;
  arb_t moment;
  arb_init(moment);
  arb_mul(moment, weight, function, bits);
  arb_mul(moment, moment, arm, bits);
  const bool negative = arf_sgn(arb_midref(moment)) < 0;
  if (negative) arb_neg(moment, moment);
  if (negative != positive_stabilises) {
    arb_add(stabilising, stabilising, moment, bits);
  } else {
    arb_add(overturning, overturning, moment, bits);
  }
  arb_clear(moment);
}

/* Its area and centroid: rational, as all that is on the lattice. */
static void measure_element(const account *a, tp_element *result, const tp_exact_element *element) {
  const tp_problem *problem = a->evaluation->problem;
  const tp_lattice *l = &problem->lattice;
  fmpq_t number, x, y;
  fmpz_t sixths;
  fmpq_init(number);
  fmpq_init(x);
  fmpq_init(y);
  fmpz_init(sixths);
  fmpz_divexact(sixths, &element->weight2, problem->section.density_weights + element->part);
  fmpq_mul(number, l->step_m, l->step_m);
  fmpq_mul_fmpz(number, number, sixths);
  fmpq_div_2exp(number, number, 1);
  result->area_m2 = tp_result_rational(number);
  const fmpz *places[] = {&element->x6, &element->y6};
  const fmpz *origins[] = {l->origin_x, l->origin_y};
  fmpq *const centroid[] = {x, y};
  for (int axis = 0; axis < 2; axis++) {
    fmpz_set(sixths, places[axis]);
    fmpz_addmul_ui(sixths, origins[axis], 6);
    fmpq_mul_fmpz(centroid[axis], l->step_m, sixths);
    fmpz_set_ui(sixths, 6);
    fmpq_div_fmpz(centroid[axis], centroid[axis], sixths);
  }
  tp_result_exact_place(&result->centroid_x_m, &result->centroid_y_m, problem, x, y);
  fmpz_clear(sixths);
  fmpq_clear(number);
  fmpq_clear(x);
  fmpq_clear(y);
}

static void account_element(account *a, tp_element *result, const tp_exact_element *element,
                            long pivot, tp_direction towards) {
  const tp_evaluation *e = a->evaluation;
  const tp_lattice *l = &e->problem->lattice;
  arb_t weight, x, y, stabilising, overturning;
  arb_init(weight);
  arb_init(x);
  arb_init(y);
  arb_init(stabilising);
  arb_init(overturning);
  arb_mul_fmpz(weight, a->weight, &element->weight2, e->rung.bits);
  set_arm(a, x, &element->x6, l->x + pivot, towards == TP_TOWARDS_LEFT ? 1 : -1);
  set_arm(a, y, &element->y6, l->y + pivot, 1);
  add_moment(a, stabilising, overturning, weight, a->cosine, x, true);
  add_moment(a, stabilising, overturning, weight, a->sine, y, false);
  arb_add(a->stabilising, a->stabilising, stabilising, e->rung.bits);
  arb_add(a->overturning, a->overturning, overturning, e->rung.bits);
  *result = (tp_element){.kind = element->kind,
                         .part = element->part,
                         .weight = tp_result(e, weight, a->certainty),
                         .normal_arm_m = tp_result(e, x, a->certainty),
                         .parallel_arm_m = tp_result(e, y, a->certainty),
                         .stabilising = tp_result(e, stabilising, a->certainty),
                         .overturning = tp_result(e, overturning, a->certainty)};
  measure_element(a, result, element);
  arb_clear(weight);
  arb_clear(x);
  arb_clear(y);
  arb_clear(stabilising);
  arb_clear(overturning);
}

/* The tilt of the account: the scene's, or the critical angle, where both sides are equal. */
static void set_tilt(account *a, tp_account *result, const tp_direction_ball *toppling) {
  const tp_evaluation *e = a->evaluation;
  const tp_quantity *tilt = &e->problem->scene->tilt_angle_deg;
  result->at_critical_angle = !tilt->given;
  if (tilt->given) {
    tp_ball_sin_cos_degrees(a->sine, a->cosine, tilt->value, e->rung.bits);
    result->angle_deg = tp_result_rational(tilt->value);
  } else {
    tp_ball_sin_cos(a->sine, a->cosine, toppling->degrees, e->rung.bits);
    result->angle_deg = tp_result(e, toppling->degrees, a->certainty);
  }
}

void tp_evaluate_account(const tp_evaluation *e, tp_case *result, const tp_direction_ball *toppling,
                         tp_certainty *certainty) {
  if (!result->has_toppling_pivot) {
    result->elements.account_count = 0;
    return;
  }
  account a = {.evaluation = e, .certainty = certainty};
  arb_struct *balls[] = {a.sine, a.cosine, a.metres, a.weight, a.stabilising, a.overturning};
  for (size_t k = 0; k < sizeof balls / sizeof balls[0]; k++) arb_init(balls[k]);
  const tp_elements *elements = &e->problem->elements;
  const long pivot = e->problem->contact.points[result->pivots[result->toppling_pivot].index].point;
  set_weight(&a);
  set_tilt(&a, &result->elements, toppling);
  arb_set_fmpq(a.metres, e->problem->lattice.step_m, e->rung.bits);
  arb_div_ui(a.metres, a.metres, 6, e->rung.bits);
  result->elements.account_count = (size_t)elements->count;
  for (long k = 0; k < elements->count; k++) {
    account_element(&a, result->elements.account + k, elements->items + k, pivot, result->towards);
  }
  result->elements.stabilising = tp_result(e, a.stabilising, certainty);
  result->elements.overturning = tp_result(e, a.overturning, certainty);
  for (size_t k = 0; k < sizeof balls / sizeof balls[0]; k++) arb_clear(balls[k]);
}
