/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "stability/onset_question.h"

#include "stability/limit_asked.h"
#include "stability/limit_cones.h"
#include "stability/loaded.h"

/* Of the weight: lengths times 3 A2 make the centroid (X6, Y6) and the square of the radius of
 * gyration 3/2 A2 (XX12 + YY12) - X6^2 - Y6^2. */
static void set_inertia(tp_motion_question *q, const tp_evaluation *e, bool mirrored) {
  const arb_struct *sums = e->moments.weighted;
  const long bits = tp_evaluation_bits(e);
  arb_mul_ui(q->scale, sums + TP_A2, 3, bits);
  arb_set(q->x, sums + TP_X6);
  arb_set(q->y, sums + TP_Y6);
  if (mirrored) arb_neg(q->x, q->x);
  arb_add(q->gyration, sums + TP_XX12, sums + TP_YY12, bits);
  arb_mul(q->gyration, q->gyration, q->scale, bits);
  arb_mul_2exp_si(q->gyration, q->gyration, -1);
  arb_submul(q->gyration, q->x, q->x, bits);
  arb_submul(q->gyration, q->y, q->y, bits);
}

/* The moment of all loads about the centroid, N m, in the question's lengths. */
static void set_moment(tp_motion_question *q, const tp_evaluation *e, bool mirrored) {
  const long bits = e->rung.bits;
  const tp_wrench *sum = &e->loaded->sum;
  arb_t x, y, factor;
  arb_init(x);
  arb_init(y);
  arb_init(factor);
  arb_div(x, q->x, q->scale, bits);
  arb_div(y, q->y, q->scale, bits);
  if (mirrored) arb_neg(x, x);
  tp_loaded_metres(x, y, e);
  if (mirrored) arb_neg(x, x);
  tp_wrench_moment(&q->load.moment, sum, x, y, bits);
  arb_set_fmpq(factor, e->problem->lattice.step_m, bits);
  arb_div(factor, q->scale, factor, bits);
  for (int basis = 0; basis < TP_BASIS; basis++) {
    arb_mul(q->load.moment.of + basis, q->load.moment.of + basis, factor, bits);
  }
  arb_clear(x);
  arb_clear(y);
  arb_clear(factor);
}

static void set_load(tp_motion_question *q, const tp_evaluation *e, bool mirrored) {
  q->weight_alone = e->loaded == NULL;
  if (q->weight_alone) {
    arb_set_si(q->load.x.of + TP_SIN, -1);
    arb_set_si(q->load.y.of + TP_COS, -1);
    return;
  }
  tp_trig_add(&q->load.x, &e->loaded->sum.x, e->rung.bits);
  tp_trig_add(&q->load.y, &e->loaded->sum.y, e->rung.bits);
  set_moment(q, e, mirrored);
}

bool tp_onset_question_init(tp_motion_question *q, tp_cones *cones, const tp_evaluation *e,
                            tp_direction towards) {
  tp_evaluation bare = *e; /* whole numbers, and friction alone */
  bare.loaded = NULL;
  if (!tp_limit_cones_init(cones, &bare, towards, false)) return false;
  tp_motion_question_init(q, cones);
  set_inertia(q, e, towards == TP_TOWARDS_RIGHT);
  set_load(q, e, towards == TP_TOWARDS_RIGHT);
  q->judge = tp_limit_asked_judge(e);
  q->work = e->work;
  return true;
}

void tp_onset_question_clear(tp_motion_question *q, tp_cones *cones) {
  tp_motion_question_clear(q);
  tp_cones_clear(cones);
}
