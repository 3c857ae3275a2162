/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "motion/accelerations.h"

#include "motion/closed.h"
#include "motion/newton.h"

#include <stdlib.h>
#include <string.h>

enum { OPEN_SIGN = 2, MOST_GENERATORS = 24 };

bool tp_start_init(tp_start *start, const tp_motion_mode *mode) {
  memset(start, 0, sizeof *start);
  tp_vector_init(&start->twist);
  tp_vector_init(&start->acceleration);
  start->force_count = mode->edge_count;
  start->forces = _arb_vec_init(mode->edge_count);
  return true;
}

void tp_start_clear(tp_start *start) {
  tp_vector_clear(&start->twist);
  tp_vector_clear(&start->acceleration);
  _arb_vec_clear(start->forces, start->force_count);
}

/* One mode at work. */
typedef struct starting {
  tp_start *start;
  const tp_motion_question *q;
  const tp_motions *m;
  const tp_motion_mode *mode;
  const tp_vector *loads;
  long count; /* of the generators, rays first */
  tp_vector *items;
  long solutions;
  arb_t least; /* sum of the factors of rays */
} starting;

/* w = f_0 g_0 + f_1 g_1 + f_2 g_2 by Cramer's rule. TP_NO: they span no space. */
static tp_answer solve(arb_ptr factors, const starting *s, const long of[3]) {
  const long bits = s->q->judge.precision;
  const tp_vector *g[3] = {s->items + of[0], s->items + of[1], s->items + of[2]};
  tp_vector cross;
  arb_t whole;
  tp_vector_init(&cross);
  arb_init(whole);
  double scale = 0;
  for (int k = 0; k < 3; k++) scale += tp_vector_log2_size(g[k]);
  tp_vector_cross(&cross, g[1], g[2], bits);
  tp_vector_dot(whole, &cross, g[0], bits);
  const int sign = tp_judge_sign(&s->q->judge, whole, scale);
  for (int k = 0; k < 3 && (sign == 1 || sign == -1); k++) {
    tp_vector_cross(&cross, g[(k + 1) % 3], g[(k + 2) % 3], bits);
    tp_vector_dot(factors + k, &cross, s->loads, bits);
    arb_div(factors + k, factors + k, whole, s->q->judge.bits);
  }
  tp_vector_clear(&cross);
  arb_clear(whole);
  return sign == OPEN_SIGN ? TP_OPEN : sign == 0 ? TP_NO : TP_YES;
}

/* Are none of the factors negative, and all rays at work? */
static tp_answer is_motion(arb_srcptr factors, const starting *s, const long of[3]) {
  int rays = 0;
  for (int k = 0; k < 3; k++) {
    const int sign = tp_judge_sign(&s->q->judge, factors + k, 0);
    if (sign == OPEN_SIGN) return TP_OPEN;
    if (sign < 0) return TP_NO;
    if (of[k] < s->mode->ray_count && sign > 0) rays++;
  }
  return rays == s->mode->ray_count ? TP_YES : TP_NO;
}

static void keep(starting *s, arb_srcptr factors, const long of[3]) {
  const long bits = s->q->judge.bits;
  tp_start *start = s->start;
  arb_t sum;
  arb_init(sum);
  for (int k = 0; k < 3; k++) {
    if (of[k] < s->mode->ray_count) arb_add(sum, sum, factors + k, bits);
  }
  const bool best = s->solutions == 0 || arf_cmp(arb_midref(sum), arb_midref(s->least)) < 0;
  s->solutions++;
  if (best) {
    arb_set(s->least, sum);
    for (int e = 0; e < 3; e++) arb_zero(start->twist.of + e);
    _arb_vec_zero(start->forces, start->force_count);
    for (int k = 0; k < 3; k++) {
      if (of[k] >= s->mode->ray_count) {
        arb_set(start->forces + of[k] - s->mode->ray_count, factors + k);
        continue;
      }
      const tp_vector *twist = &s->m->twists.rays[s->mode->rays[of[k]]].twist;
      for (int e = 0; e < 3; e++) {
        arb_addmul(start->twist.of + e, twist->of + e, factors + k, bits);
      }
    }
  }
  arb_clear(sum);
}

/* Do all forces pass through one place, or have one direction, so that what balances across them
 * fixes the motion of one ray? */
static bool forces_are_alike(const starting *s) {
  const tp_normals *n = &s->m->normals;
  const tp_mode_edge *first = s->mode->edges;
  bool site = true, direction = true;
  for (long k = 1; k < s->mode->edge_count; k++) {
    const tp_mode_edge *own = s->mode->edges + k;
    site = site && n->cones->points[own->point].site == n->cones->points[first->point].site;
    direction = direction && n->family_of[own->point] == n->family_of[first->point] &&
                own->against == first->against;
  }
  return s->mode->ray_count == 1 && (site || direction);
}

static tp_motion_outcome try_all(starting *s) {
  arb_struct *factors = _arb_vec_init(3);
  tp_answer answer = TP_YES;
  long of[3];
  for (of[0] = 0; of[0] < s->count && answer != TP_OPEN; of[0]++) {
    for (of[1] = of[0] + 1; of[1] < s->count && answer != TP_OPEN; of[1]++) {
      for (of[2] = of[1] + 1; of[2] < s->count && answer != TP_OPEN; of[2]++) {
        answer = solve(factors, s, of);
        if (answer == TP_YES) answer = is_motion(factors, s, of);
        if (answer == TP_YES) keep(s, factors, of);
      }
    }
  }
  _arb_vec_clear(factors, 3);
  return answer == TP_OPEN ? TP_MOTION_OPEN : TP_MOTION_PROVEN;
}

/* n . M^-1 e of a contact that slips. */
static tp_motion_outcome look_for_paradox(starting *s) {
  const long bits = s->q->judge.precision;
  const tp_normals *n = &s->m->normals;
  tp_vector edge, normal;
  arb_t press;
  tp_vector_init(&edge);
  tp_vector_init(&normal);
  arb_init(press);
  tp_motion_outcome done = TP_MOTION_PROVEN;
  for (long k = 0; k < s->mode->edge_count && done == TP_MOTION_PROVEN; k++) {
    const tp_mode_edge *own = s->mode->edges + k;
    tp_newton_force(&edge, s->q, n, own);
    tp_vector_neg(&edge);
    tp_newton_normal(&normal, s->q, n, n->normal_of[own->point]);
    tp_vector_dot(press, &normal, &edge, bits);
    const double scale = tp_vector_log2_size(&normal) + tp_vector_log2_size(&edge);
    const int sign = tp_judge_sign(&s->q->judge, press, scale);
    if (sign == OPEN_SIGN) done = TP_MOTION_OPEN;
    if (sign == 1 || sign == OPEN_SIGN) continue;
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
static void start_freely(starting *s) {
  const tp_motion_question *q = s->q;
  const long bits = q->judge.bits;
  tp_vector *a = &s->start->acceleration, *twist = &s->start->twist;
  for (int e = 0; e < 3; e++) arb_set(a->of + e, s->loads->of + e);
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

static void set_acceleration(starting *s) {
  const tp_ray turn = {.twist = s->start->twist, .axis = -1};
  tp_newton_inertia(&s->start->acceleration, s->q, &turn);
  arb_set(s->start->acceleration.of + 2, s->start->twist.of + 2);
}

tp_motion_outcome tp_start_find(tp_start *start, const tp_motion_question *q, const tp_motions *m,
                                const tp_motion_mode *mode, const tp_vector *loads) {
  starting s = {.start = start, .q = q, .m = m, .mode = mode, .loads = loads};
  if (mode->ray_count == 0) {
    start_freely(&s);
    return TP_MOTION_PROVEN;
  }
  s.count = mode->ray_count + mode->edge_count;
  if (s.count > MOST_GENERATORS) return TP_MOTION_TOO_DEAR;
  s.items = calloc((size_t)s.count, sizeof *s.items);
  if (s.items == NULL) return TP_MOTION_OUT_OF_MEMORY;
  arb_init(s.least);
  for (long k = 0; k < s.count; k++) {
    tp_vector_init(s.items + k);
    if (k < mode->ray_count) {
      tp_newton_inertia(s.items + k, q, m->twists.rays + mode->rays[k]);
    } else {
      tp_newton_force(s.items + k, q, &m->normals, mode->edges + k - mode->ray_count);
    }
  }
  tp_motion_outcome done = try_all(&s);
  start->moves = s.solutions > 0;
  start->forces_fixed = s.solutions == 1 && s.count == 3;
  start->fixed = s.solutions == 1 || forces_are_alike(&s);
  if (start->moves) set_acceleration(&s);
  if (done == TP_MOTION_PROVEN && start->moves) done = look_for_paradox(&s);
  for (long k = 0; k < s.count; k++) tp_vector_clear(s.items + k);
  free(s.items);
  arb_clear(s.least);
  return done;
}
