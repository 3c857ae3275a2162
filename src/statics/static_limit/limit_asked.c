/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Loads of a case as the wrench of a limit question: the weight in whole numbers of the lattice, or
 * the sum of all loads in balls, with sines reversed for motion up-dip (docs/mechanics.md section
 * 6). */

#include "static_limit/limit_asked.h"

#include "evaluation/loaded.h"
#include "number/ball.h"

/* The weight alone, on the lattice, times three over its half: F = 3 A2 (-sin, -cos), its moment
 * with (X6, Y6) = 3 A2 times the centroid. */
static void set_weight(tp_wrench *load, const tp_evaluation *e, tp_direction towards) {
  const arb_struct *sums = e->moments.weighted;
  const long bits = tp_evaluation_bits(e);
  arb_mul_si(load->x.of + TP_SIN, sums + TP_A2, -3, bits);
  arb_set(load->y.of + TP_COS, load->x.of + TP_SIN);
  arb_neg(load->moment.of + TP_COS, sums + TP_X6);
  tp_ball_mirror(load->moment.of + TP_COS, towards);
  arb_set(load->moment.of + TP_SIN, sums + TP_Y6);
}

/* The loads as functions of the tilt turned back: sines change their sign. */
static void turn_back(tp_wrench *load) {
  tp_trig *parts[] = {&load->x, &load->y, &load->moment};
  for (int k = 0; k < 3; k++) arb_neg(parts[k]->of + TP_SIN, parts[k]->of + TP_SIN);
}

/* From here on, what half the bits do not tell from zero is zero: a tie of mechanisms then is one.
 * That half is more than the digits asked for. */
static bool is_settled(const tp_evaluation *e) {
  enum { SPARE = 32 };
  const tp_problem *problem = e->problem;
  const bool enclosed =
      tp_problem_is_enclosed(problem) && !problem->loaded; /* loads are rationals */
  return e->rung.bits >= (enclosed ? TP_BALL_BITS : TP_SETTLING_BITS) &&
         (double)e->rung.bits >= 2 * (tp_digits_bits(e->digits) + SPARE);
}

tp_judge tp_limit_asked_judge(const tp_evaluation *e) {
  return (tp_judge){.bits = e->rung.bits,
                    .precision = e->loaded == NULL ? tp_evaluation_bits(e) : e->rung.bits,
                    .settled = is_settled(e)};
}

void tp_limit_asked_init(tp_limit_asked *asked, const tp_cones *cones, const tp_evaluation *e,
                         tp_direction towards, bool back) {
  tp_wrench *load = &asked->load;
  tp_wrench_init(load);
  if (e->loaded == NULL) {
    set_weight(load, e, towards);
  } else {
    tp_loaded_local_sum(load, e->loaded, e);
  }
  if (back) turn_back(load);
  asked->question = (tp_limit_question){.cones = cones,
                                        .load = load,
                                        .range_deg = e->loaded == NULL ? 0 : e->loaded->range_deg,
                                        .work = e->work,
                                        .judge = tp_limit_asked_judge(e)};
  asked->took_zero = false;
  asked->question.judge.took_zero = &asked->took_zero;
}

void tp_limit_asked_clear(tp_limit_asked *asked) {
  tp_wrench_clear(&asked->load);
}
