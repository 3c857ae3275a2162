/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "limit/search.h"

#include "load/roots.h"
#include "number/ball.h"

#include <math.h>

static bool is_homogeneous(const tp_trig *f) {
  return arb_is_zero(f->of + TP_ONE) && arb_is_zero(f->of + TP_SEC) && arb_is_zero(f->of + TP_SEC2);
}

bool tp_search_is_linear(const tp_limit_question *q) {
  return q->cones->allowance_count == 0 && is_homogeneous(&q->load->x) &&
         is_homogeneous(&q->load->y) && is_homogeneous(&q->load->moment);
}

void tp_search_load_term(tp_vector *term, const tp_wrench *load, int basis) {
  arb_set(term->of, load->x.of + basis);
  arb_set(term->of + 1, load->y.of + basis);
  arb_set(term->of + 2, load->moment.of + basis);
}

void tp_search_load_at(tp_vector *wrench, const tp_wrench *load, const arb_t sine,
                       const arb_t cosine, long bits) {
  tp_trig_evaluate(wrench->of, &load->x, sine, cosine, bits);
  tp_trig_evaluate(wrench->of + 1, &load->y, sine, cosine, bits);
  tp_trig_evaluate(wrench->of + 2, &load->moment, sine, cosine, bits);
}

/* v . F - K as a function of the tilt. */
static void set_excess(tp_trig *excess, const tp_face *face, const tp_limit_question *q) {
  tp_vector term;
  tp_vector_init(&term);
  for (int basis = 0; basis < TP_BASIS; basis++) {
    tp_search_load_term(&term, q->load, basis);
    tp_vector_dot(excess->of + basis, &face->twist, &term, q->judge.precision);
  }
  arb_sub(excess->of + TP_ONE, excess->of + TP_ONE, face->held, q->judge.bits);
  tp_vector_clear(&term);
}

/* A cos a + B sin a = 0 with B > 0: the direction (B, -A) of (cosine, sine), exact where A, B are.
 */
static tp_answer linear_tilt(tp_limit_answer *a, const tp_trig *excess, long bits) {
  arb_neg(a->sine, excess->of + TP_COS);
  arb_set(a->cosine, excess->of + TP_SIN);
  tp_ball_atan2_degrees(a->degrees, a->sine, a->cosine, bits);
  return arb_is_positive(a->cosine) ? TP_YES : TP_OPEN;
}

static tp_answer nearest_root(tp_limit_answer *a, const tp_trig *excess, const tp_limit_question *q,
                              double near_degrees) {
  static const double near_enough = 1e-3; /* degrees; what doubles find is far nearer */
  tp_roots roots;
  tp_roots_init(&roots);
  tp_roots_find(&roots, excess, q->range, q->judge.bits);
  double least = near_enough;
  long nearest = -1;
  for (long k = 0; k < roots.count; k++) {
    const double off = fabs(arf_get_d(arb_midref(roots.degrees + k), ARF_RND_NEAR) - near_degrees);
    if (!roots.rising[k] || off > least) continue;
    least = off;
    nearest = k;
  }
  if (nearest >= 0) {
    arb_t turn;
    arb_init(turn);
    arb_set(a->degrees, roots.degrees + nearest);
    arb_div_ui(turn, a->degrees, 180, q->judge.bits);
    arb_sin_cos_pi(a->sine, a->cosine, turn, q->judge.bits);
    arb_clear(turn);
  }
  const bool certain = roots.certain;
  tp_roots_clear(&roots);
  return nearest >= 0 && certain ? TP_YES : TP_OPEN;
}

tp_answer tp_search_tilt(tp_limit_answer *answer, const tp_face *face, const tp_limit_question *q,
                         double near_degrees) {
  tp_trig excess;
  tp_trig_init(&excess);
  set_excess(&excess, face, q);
  const tp_answer found = tp_search_is_linear(q) ? linear_tilt(answer, &excess, q->judge.bits)
                                                 : nearest_root(answer, &excess, q, near_degrees);
  tp_trig_clear(&excess);
  return found;
}

/* The loads in the sketch's units, function by function. */
typedef struct loads {
  double of[TP_BASIS][3];
} loads;

static bool holds(tp_sketch *sketch, const loads *l, double degrees) {
  static const double level[3] = {0, 0, 0};
  const double tilt = degrees * (M_PI / 180), cosine = cos(tilt);
  const double basis[TP_BASIS] = {cosine, sin(tilt), 1, 1 / cosine, 1 / (cosine * cosine)};
  double target[3] = {0, 0, 0};
  for (int k = 0; k < TP_BASIS; k++) {
    for (int row = 0; row < 3; row++) {
      if (l->of[k][row] != 0) target[row] -= basis[k] * l->of[k][row]; /* 1 / cos may be infinite */
    }
  }
  return tp_sketch_solve(sketch, level, target).outcome == TP_SIMPLEX_OPTIMAL;
}

static double halve(tp_sketch *sketch, const loads *l, double low, double high) {
  for (double middle = (low + high) / 2; middle > low && middle < high; middle = (low + high) / 2) {
    if (holds(sketch, l, middle)) {
      low = middle;
    } else {
      high = middle;
    }
  }
  return low;
}

tp_search_found tp_search_near(double *degrees, tp_sketch *sketch, const tp_limit_question *q) {
  enum { STEPS = 90 };
  loads l;
  tp_vector term;
  tp_vector_init(&term);
  for (int basis = 0; basis < TP_BASIS; basis++) {
    tp_search_load_term(&term, q->load, basis);
    tp_sketch_wrench(l.of[basis], sketch, &term);
  }
  tp_vector_clear(&term);
  const double range = arf_get_d(arb_midref(q->range), ARF_RND_DOWN) * (180 / M_PI);
  const double step = range / STEPS;
  int from = 0;
  while (from <= STEPS && !holds(sketch, &l, from * step)) from++;
  if (from <= STEPS) {
    for (int k = from + 1; k <= STEPS; k++) {
      if (holds(sketch, &l, k * step)) continue;
      *degrees = halve(sketch, &l, (k - 1) * step, k * step);
      return TP_SEARCH_TILT;
    }
    return TP_SEARCH_HOLDS_ALWAYS;
  }
  for (int k = 1; k <= STEPS; k++) {
    if (!holds(sketch, &l, -k * step)) continue;
    *degrees = halve(sketch, &l, -k * step, (1 - k) * step);
    return TP_SEARCH_TILT;
  }
  return TP_SEARCH_HOLDS_NEVER;
}
