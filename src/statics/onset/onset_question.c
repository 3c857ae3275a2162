/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Contact cones, centroid, radius of gyration and loads of a case in the lengths of a question of
 * motion/question.h: whole numbers of the lattice for the weight alone. */

#include "onset/onset_question.h"

#include "evaluation/loaded_exact.h"
#include "static_limit/limit_asked.h"
#include "static_limit/limit_cones.h"

#include <string.h>

/* Of the weight: lengths times 3 A2 make the centroid (X6, Y6) and the square of the radius of
 * gyration 3/2 A2 (XX12 + YY12) - X6^2 - Y6^2. */
static void set_inertia(tp_motion_question *q, const tp_evaluation *e, tp_direction towards) {
  const arb_struct *sums = e->moments.weighted;
  const long bits = tp_evaluation_bits(e);
  arb_mul_ui(q->scale, sums + TP_A2, 3, bits);
  arb_set(q->x, sums + TP_X6);
  arb_set(q->y, sums + TP_Y6);
  tp_ball_mirror(q->x, towards);
  arb_add(q->gyration, sums + TP_XX12, sums + TP_YY12, bits);
  arb_mul(q->gyration, q->gyration, q->scale, bits);
  arb_mul_2exp_si(q->gyration, q->gyration, -1);
  arb_submul(q->gyration, q->x, q->x, bits);
  arb_submul(q->gyration, q->y, q->y, bits);
}

/* Weight and inertia act at the centroid. */
bool tp_onset_load_is_central(const tp_load *load) {
  return load->kind == TP_LOAD_WEIGHT || load->kind == TP_LOAD_SEISMIC;
}

/* Of the others. False: there are none. */
static bool add_others(tp_wrench *sum, const tp_evaluation *e) {
  const long bits = e->rung.bits;
  bool any = false;
  for (long k = 0; k < e->loaded->count; k++) {
    const tp_load *own = e->loaded->items + k;
    if (tp_onset_load_is_central(own)) continue;
    any = true;
    tp_trig_add(&sum->x, &own->wrench.x, bits);
    tp_trig_add(&sum->y, &own->wrench.y, bits);
    tp_trig_add(&sum->moment, &own->wrench.moment, bits);
  }
  return any;
}

/* The moment of all loads about the centroid, N m, in the question's lengths: without those that
 * act there, of which rounding would leave a moment that is not zero. */
static void set_moment(tp_motion_question *q, const tp_evaluation *e, const tp_wrench *others,
                       tp_direction towards) {
  const long bits = e->rung.bits;
  arb_t x, y, factor;
  arb_init(x);
  arb_init(y);
  arb_init(factor);
  arb_div(x, q->x, q->scale, bits);
  arb_div(y, q->y, q->scale, bits);
  tp_ball_mirror(x, towards);
  tp_loaded_metres(x, y, e);
  tp_ball_mirror(x, towards);
  tp_wrench_moment(&q->load.moment, others, x, y, bits);
  arb_set_fmpq(factor, e->problem->lattice.step_m, bits);
  arb_div(factor, q->scale, factor, bits);
  for (int basis = 0; basis < TP_BASIS; basis++) {
    arb_mul(q->load.moment.of + basis, q->load.moment.of + basis, factor, bits);
  }
  arb_clear(x);
  arb_clear(y);
  arb_clear(factor);
}

/* Does none of the other loads have a moment about the centroid, exactly? Asked where balls do not
 * exclude it. */
static bool others_are_central(const tp_motion_question *q, const tp_evaluation *e) {
  for (int basis = 0; basis < TP_BASIS; basis++) {
    if (!arb_contains_zero(q->load.moment.of + basis)) return false;
  }
  for (long k = 0; k < e->loaded->count; k++) {
    const tp_load *own = e->loaded->items + k;
    if (!tp_onset_load_is_central(own) && !tp_loaded_is_central(own, e->loaded, e)) return false;
  }
  return true;
}

void tp_onset_question_load(tp_motion_question *q, const tp_evaluation *e, tp_direction towards,
                            const tp_wrench *all, const tp_wrench *others) {
  tp_wrench_clear(&q->load);
  tp_wrench_init(&q->load);
  tp_trig_add(&q->load.x, &all->x, e->rung.bits);
  tp_trig_add(&q->load.y, &all->y, e->rung.bits);
  q->through_centroid = others == NULL;
  if (others != NULL) set_moment(q, e, others, towards);
  if (others == NULL || !others_are_central(q, e)) return;
  for (int basis = 0; basis < TP_BASIS; basis++) arb_zero(q->load.moment.of + basis);
  q->through_centroid = true;
}

static void set_load(tp_motion_question *q, const tp_evaluation *e, tp_direction towards) {
  if (e->loaded == NULL) {
    q->through_centroid = true;
    arb_set_si(q->load.x.of + TP_SIN, -1);
    arb_set_si(q->load.y.of + TP_COS, -1);
    return;
  }
  tp_wrench others;
  tp_wrench_init(&others);
  const bool any = add_others(&others, e);
  tp_onset_question_load(q, e, towards, &e->loaded->sum, any ? &others : NULL);
  tp_wrench_clear(&others);
}

bool tp_onset_has_strength(const tp_evaluation *e) {
  const tp_loads_description *loads = &e->problem->scene->loads;
  return e->loaded != NULL &&
         !(fmpq_is_zero(loads->cohesion_kpa.value) && fmpq_is_zero(loads->bond_kpa.value));
}

/* In whole numbers, with friction alone. */
static bool find_cones(tp_cones *cones, const tp_evaluation *e, tp_direction towards,
                       tp_cones *known) {
  if (known != NULL && known->count > 0) {
    *cones = *known;
    *known = (tp_cones){.count = 0};
    return true;
  }
  tp_evaluation bare = *e;
  bare.loaded = NULL;
  return tp_limit_cones_init_beside(cones, &bare, towards);
}

bool tp_onset_asked_init(tp_onset_asked *asked, const tp_evaluation *e, tp_direction towards,
                         tp_cones *known) {
  memset(asked, 0, sizeof *asked);
  tp_motion_question *q = &asked->question;
  if (!find_cones(&asked->cones, e, towards, known)) return false;
  const bool strong = tp_onset_has_strength(e);
  if (strong && !tp_limit_cones_init_beside(&asked->strong, e, towards)) {
    tp_cones_clear(&asked->cones);
    return false;
  }
  tp_motion_question_init(q, &asked->cones);
  if (strong) q->strong = &asked->strong;
  set_inertia(q, e, towards);
  set_load(q, e, towards);
  q->judge = tp_limit_asked_judge(e);
  q->judge.took_zero = &asked->took_zero;
  q->work = e->work;
  return true;
}

void tp_onset_asked_clear(tp_onset_asked *asked) {
  tp_motion_question_clear(&asked->question);
  tp_cones_clear(&asked->cones);
  tp_cones_clear(&asked->strong);
}
