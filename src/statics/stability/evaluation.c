/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Moments, weight and points of a problem at one precision; integers of moderate size are summed
 * exactly, which is cheaper than in balls. */

#include "stability/evaluation.h"

#include "number/ball.h"

#include <float.h>
#include <math.h>

static double log2_extent(const tp_lattice *l) {
  const double step_m = fmpq_get_d(l->step_m);
  return (double)l->bits + log2(step_m > 0 ? step_m : DBL_MIN);
}

static void set_metres(tp_evaluation *e) {
  for (int k = 0; k < TP_METRES; k++) arb_init(e->metres + k);
  arb_set_fmpq(e->metres, e->problem->lattice.step_m, e->rung.bits);
  for (int k = 1; k < TP_METRES; k++) {
    arb_pow_ui(e->metres + k, e->metres, (ulong)k + 1, e->rung.bits);
  }
}

void tp_evaluation_init(tp_evaluation *e, const tp_problem *problem, tp_rung rung,
                        const tp_solve_options *options) {
  *e = (tp_evaluation){.problem = problem,
                       .rung = rung,
                       .digits = options->digits,
                       .reduces_strength = options->strength_reduction,
                       .tells_ranges = options->motion_ranges,
                       .pivots = options->pivots,
                       .log2_extent = log2_extent(&problem->lattice)};
  arb_init(e->weight_per_area_pa);
  arb_init(e->friction_tangent);
  arb_init(e->tilt_sine);
  arb_init(e->tilt_cosine);
  set_metres(e);
  const tp_quantity *tilt = &problem->scene->tilt_angle_deg;
  if (tilt->given) tp_ball_sin_cos_degrees(e->tilt_sine, e->tilt_cosine, tilt->value, rung.bits);
  tp_moments_init(&e->moments);
  tp_evaluate_moments(&e->moments, problem, rung);
}

void tp_evaluation_clear(tp_evaluation *e) {
  arb_clear(e->weight_per_area_pa);
  arb_clear(e->friction_tangent);
  arb_clear(e->tilt_sine);
  arb_clear(e->tilt_cosine);
  for (int k = 0; k < TP_METRES; k++) arb_clear(e->metres + k);
  tp_moments_clear(&e->moments);
}

long tp_evaluation_bits(const tp_evaluation *e) {
  return e->rung.level == TP_LEVEL_EXACT ? ARF_PREC_EXACT : e->rung.bits;
}

bool tp_evaluation_is_last_rung(const tp_evaluation *e) {
  return 4 * e->rung.bits > tp_ladder_most_bits(e->digits);
}

/* Integers up to about this size are summed faster exactly than in balls (measured: 90 against 290
 * ns a vertex at 40 bits, even at 300). */
enum { EXACT_IS_CHEAPER = 256 };

void tp_evaluate_moments(tp_moments *moments, const tp_problem *problem, tp_rung rung) {
  const fmpq *metres_per_unit = problem->scene->metres_per_unit;
  if (rung.level == TP_LEVEL_BALL && problem->lattice.bits <= EXACT_IS_CHEAPER) {
    rung.level = TP_LEVEL_EXACT;
  }
  tp_moments_evaluate(moments, &problem->section, &problem->lattice, metres_per_unit, rung,
                      TP_SUM_COUNT);
  if (problem->section.arc_tips.count > 0) {
    tp_arcs_take_off(moments, &problem->section, &problem->lattice, metres_per_unit, rung.bits);
  }
  if (problem->corners.count > 0) {
    tp_corners_take_off(moments, &problem->corners, &problem->section, &problem->lattice,
                        rung.bits);
  }
}

void tp_evaluation_point(arb_t x, arb_t y, const tp_evaluation *e, tp_outline_point at) {
  const tp_lattice *l = &e->problem->lattice;
  if (at.cut == NULL) {
    arb_set_fmpz(x, l->x + at.point);
    arb_set_fmpz(y, l->y + at.point);
    return;
  }
  tp_corner_ball c;
  tp_corner_ball_init(&c);
  tp_corner_evaluate(&c, at.cut, l, e->rung.bits);
  arb_set(x, at.after ? c.after.x : c.before.x);
  arb_set(y, at.after ? c.after.y : c.before.y);
  tp_corner_ball_clear(&c);
}

void tp_evaluation_axis(arb_t x, arb_t y, const tp_evaluation *e, long k) {
  tp_evaluation_point(x, y, e, tp_contact_on_outline(e->problem->contact.points + k));
}

void tp_evaluation_facet(arb_t dx, arb_t dy, const tp_evaluation *e, const tp_facet *facet) {
  arb_t x, y;
  arb_init(x);
  arb_init(y);
  tp_evaluation_point(x, y, e, tp_facet_begin(facet));
  tp_evaluation_point(dx, dy, e, tp_facet_end(facet));
  arb_sub(dx, dx, x, e->rung.bits);
  arb_sub(dy, dy, y, e->rung.bits);
  arb_clear(x);
  arb_clear(y);
}

void tp_evaluation_to_metres(arb_t value, const tp_evaluation *e, int degree) {
  arb_mul(value, value, e->metres + degree - 1, e->rung.bits);
}

void tp_evaluation_weight(arb_t newton, const tp_evaluation *e) {
  fmpq_t factor;
  fmpq_init(factor);
  tp_problem_weight_factor(factor, e->problem);
  arb_mul_fmpz(newton, e->moments.weighted + TP_A2, fmpq_numref(factor), e->rung.bits);
  arb_div_fmpz(newton, newton, fmpq_denref(factor), e->rung.bits);
  fmpq_clear(factor);
}
