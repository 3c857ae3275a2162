/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Solutions of Newton's and Coulomb's laws for one mode under given loads (docs/mechanics.md
 * section 6a): sums of three generators where there are several (motion/starting.h), closed forms
 * for free flight and for turning about one point; Painleve's paradox is looked for at each contact
 * that slips. */

#include "motion/accelerations.h"

#include "motion/closed.h"
#include "motion/newton.h"
#include "motion/starting.h"

#include <stdlib.h>
#include <string.h>

/* Threes of generators with each free force at either bound: 24^3 / 6 * 2^4, some 32000 programs of
 * three rows. */
enum { MOST_GENERATORS = 24, MOST_FREE = 4 };

/* Do all forces pass through one point, or have one direction, so that what balances across them
 * fixes the motion of one ray? */
static bool forces_are_alike(const tp_starting *s) {
  const tp_normals *n = &s->m->normals;
  const tp_cone_edge *first = s->mode->edges;
  const tp_cone_point *points = n->cones->points;
  bool site = true, direction = true;
  for (long k = 1; k < s->mode->edge_count; k++) {
    const tp_cone_edge *own = s->mode->edges + k;
    site = site && points[own->point].site == points[first->point].site;
    direction = direction && n->family_of[own->point] == n->family_of[first->point] &&
                tp_cones_own(n->cones, own->point) == tp_cones_own(n->cones, first->point) &&
                own->against == first->against;
  }
  return s->mode->ray_count == 1 && (site || direction);
}

/* Does it turn about a point through which all forces pass, those of lines that stick included? */
static bool turns_about_all(const tp_starting *s) {
  const tp_cone_point *points = s->m->normals.cones->points;
  const long site = s->m->twists.rays[s->mode->rays[0]].site;
  bool all = s->strength != NULL && s->mode->ray_count == 1 && site >= 0 &&
             s->strength->pull_count == 0 && s->mode->edge_count > 0;
  for (long k = 0; k < s->mode->edge_count && all; k++) {
    all = points[s->mode->edges[k].point].site == site;
  }
  for (long k = 0; k < s->free_count && all; k++) {
    all = points[s->strength->sticks[k]].site == site;
  }
  return all;
}

/* Then what turns it is the moment of the loads about that point, and the sum of all forces there
 * is what is left. */
static tp_motion_outcome turn(tp_starting *s) {
  const long bits = s->q->judge.bits;
  const tp_motion_question *q = s->q;
  const long point = s->mode->edges[0].point;
  tp_vector about;
  arb_t x, y, moment, inertia;
  tp_vector_init(&about);
  arb_init(x);
  arb_init(y);
  arb_init(moment);
  arb_init(inertia);
  const arb_struct at_x = tp_cones_x(q->cones, point), at_y = tp_cones_y(q->cones, point);
  tp_newton_arms(x, y, q, &at_x, &at_y, bits);
  tp_ball_turn(about.of, x, y, bits);
  tp_vector_dot(moment, &about, &s->loads, bits);
  tp_vector_dot(inertia, &about, s->items, bits);
  const int sign = tp_vector_judge(&q->judge, moment, &about, &s->loads);
  arb_div(moment, moment, inertia, bits);
  const tp_vector *twist = &s->m->twists.rays[s->mode->rays[0]].twist;
  for (int e = 0; e < 3; e++) {
    arb_mul(s->start->twist.of + e, twist->of + e, moment, bits);
    arb_mul(s->start->sum.of + e, s->items->of + e, moment, bits);
    arb_sub(s->start->sum.of + e, s->start->sum.of + e, s->loads.of + e, bits);
  }
  s->solutions = sign != 0 && arb_is_positive(moment) ? 1 : 0;
  s->start->one_point = s->solutions > 0;
  tp_vector_clear(&about);
  arb_clear(x);
  arb_clear(y);
  arb_clear(moment);
  arb_clear(inertia);
  return sign == TP_OPEN_SIGN ? TP_MOTION_OPEN : TP_MOTION_PROVEN;
}

/* n . M^-1 e of a contact that slips. */
static tp_motion_outcome look_for_paradox(tp_starting *s) {
  const long bits = s->q->judge.precision;
  const tp_normals *n = &s->m->normals;
  tp_vector edge, normal;
  arb_t press;
  tp_vector_init(&edge);
  tp_vector_init(&normal);
  arb_init(press);
  tp_motion_outcome done = TP_MOTION_PROVEN;
  for (long k = 0; k < s->mode->edge_count && done == TP_MOTION_PROVEN; k++) {
    const tp_cone_edge *own = s->mode->edges + k;
    tp_newton_force(&edge, s->q, n, own);
    tp_vector_neg(&edge);
    tp_newton_normal(&normal, s->q, n, n->normal_of[own->point]);
    tp_vector_dot(press, &normal, &edge, bits);
    const int sign = tp_vector_judge(&s->q->judge, press, &normal, &edge);
    if (sign == TP_OPEN_SIGN) done = TP_MOTION_OPEN;
    if (sign == 1 || sign == TP_OPEN_SIGN) continue;
    int slip = 0;
    for (int r = 0; r < s->mode->ray_count && slip == 0; r++) {
      slip = tp_closed_slip(n, own->point, s->m->twists.rays + s->mode->rays[r]);
    }
    s->start->paradox = s->start->paradox || slip != 0;
  }
  tp_vector_clear(&edge);
  tp_vector_clear(&normal);
  arb_clear(press);
  return done;
}

/* The block alone: a = (w_x, w_y, w_m / k^2); as a twist about the origin of the cones. */
static void start_freely(tp_starting *s) {
  const tp_motion_question *q = s->q;
  const long bits = q->judge.bits;
  tp_vector *a = &s->start->acceleration, *twist = &s->start->twist;
  for (int e = 0; e < 3; e++) arb_set(a->of + e, s->loads.of + e);
  arb_div(a->of + 2, a->of + 2, q->gyration, bits);
  arb_set(twist->of + 2, a->of + 2);
  arb_mul(twist->of, a->of + 2, q->y, bits);
  arb_add(twist->of, twist->of, a->of, bits);
  arb_div(twist->of, twist->of, q->scale, bits);
  arb_mul(twist->of + 1, a->of + 2, q->x, bits);
  arb_sub(twist->of + 1, a->of + 1, twist->of + 1, bits);
  arb_div(twist->of + 1, twist->of + 1, q->scale, bits);
  s->start->moves = s->start->fixed = s->start->forces_fixed = true;
}

static void set_acceleration(tp_starting *s) {
  const tp_ray turn = {.twist = s->start->twist, .axis = -1};
  tp_newton_inertia(&s->start->acceleration, s->q, &turn);
  arb_set(s->start->acceleration.of + 2, s->start->twist.of + 2);
}

static void set_generators(tp_starting *s) {
  const tp_motion_mode *mode = s->mode;
  const long pulls = s->strength != NULL ? s->strength->pull_count : 0;
  for (long k = 0; k < s->count + s->free_count; k++) {
    tp_vector *own = s->items + k;
    tp_vector_init(own);
    const long edge = k - mode->ray_count, pull = edge - mode->edge_count;
    if (edge < 0) {
      tp_newton_inertia(own, s->q, s->m->twists.rays + mode->rays[k]);
    } else if (pull < 0) {
      tp_newton_force(own, s->q, &s->m->normals, mode->edges + edge);
    } else {
      const tp_vector *from =
          pull < pulls ? s->strength->pulls + pull : s->strength->free + pull - pulls;
      for (int e = 0; e < 3; e++) arb_set(own->of + e, from->of + e);
    }
  }
}

/* Do bonds pull on a slide by no more than all of them, where it needs the least of them? */
static tp_motion_outcome bound_pulls(tp_starting *s) {
  const long pulls = s->strength != NULL ? s->strength->pull_count : 0;
  if (pulls == 0 || s->solutions == 0) return TP_MOTION_PROVEN;
  arb_t left;
  arb_init(left);
  for (long k = 0; k < pulls; k++) {
    tp_strength_add_pull(left, s->start->forces + s->mode->edge_count + k, s->q,
                         s->strength->pulled[k]);
  }
  arb_sub(left, s->strength->most_pull, left, s->q->judge.bits);
  const int sign = tp_judge_sign(&s->q->judge, left, 0);
  arb_clear(left);
  if (sign < 0) s->solutions = 0;
  return sign == TP_OPEN_SIGN ? TP_MOTION_OPEN : TP_MOTION_PROVEN;
}

static tp_motion_outcome start_touching(tp_starting *s) {
  tp_start *start = s->start;
  const long pulls = s->strength != NULL ? s->strength->pull_count : 0;
  s->count = s->mode->ray_count + s->mode->edge_count + pulls;
  s->free_count = s->strength != NULL ? s->strength->free_count : 0;
  s->greatest = pulls > 0;
  if (s->count > MOST_GENERATORS || s->free_count > MOST_FREE) return TP_MOTION_TOO_DEAR;
  s->items = calloc((size_t)(s->count + s->free_count), sizeof *s->items);
  if (s->items == NULL) return TP_MOTION_OUT_OF_MEMORY;
  set_generators(s);
  tp_motion_outcome done = turns_about_all(s) ? turn(s) : tp_starting_try(s);
  if (done == TP_MOTION_PROVEN) done = bound_pulls(s);
  const bool alone = s->solutions == 1 && s->free_count == 0;
  start->moves = s->solutions > 0;
  start->forces_fixed = (alone && s->count == 3) || (s->greatest && start->moves);
  start->greatest = s->greatest;
  start->fixed =
      start->one_point || (alone && pulls == 0) || (s->strength == NULL && forces_are_alike(s));
  if (start->moves) set_acceleration(s);
  if (done == TP_MOTION_PROVEN && start->moves) done = look_for_paradox(s);
  for (long k = 0; k < s->count + s->free_count; k++) tp_vector_clear(s->items + k);
  free(s->items);
  return done;
}

tp_motion_outcome tp_start_find(tp_start *start, const tp_motion_question *q, const tp_motions *m,
                                const tp_motion_mode *mode, const tp_vector *loads,
                                const tp_strength *strength) {
  tp_starting s = {.start = start, .q = q, .m = m, .mode = mode, .strength = strength};
  tp_vector_init(&s.loads);
  tp_vector_init(&s.rest);
  arb_init(s.best);
  for (int e = 0; e < 3; e++) {
    arb_set(s.loads.of + e, loads->of + e);
    if (strength == NULL) continue;
    arb_add(s.loads.of + e, s.loads.of + e, strength->fixed.of + e, q->judge.bits);
  }
  tp_motion_outcome done = TP_MOTION_PROVEN;
  if (mode->ray_count == 0) {
    start_freely(&s);
  } else {
    done = start_touching(&s);
  }
  tp_vector_clear(&s.loads);
  tp_vector_clear(&s.rest);
  arb_clear(s.best);
  return done;
}
