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

void tp_search_load_at_degrees(tp_vector *wrench, const tp_limit_question *q, const arb_t degrees) {
  arb_t sine, cosine;
  arb_init(sine);
  arb_init(cosine);
  tp_ball_sin_cos(sine, cosine, degrees, q->judge.bits);
  tp_search_load_at(wrench, q->load, sine, cosine, q->judge.precision);
  arb_clear(sine);
  arb_clear(cosine);
}

void tp_search_excess(tp_trig *excess, const tp_face *face, const tp_limit_question *q) {
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
  tp_roots_find(&roots, excess, q->judge.bits);
  double least = near_enough;
  long nearest = -1;
  for (long k = 0; k < roots.count; k++) {
    const double off = fabs(arf_get_d(arb_midref(roots.degrees + k), ARF_RND_NEAR) - near_degrees);
    if (!roots.rising[k] || off > least) continue;
    least = off;
    nearest = k;
  }
  if (nearest >= 0) {
    arb_set(a->degrees, roots.degrees + nearest);
    tp_ball_sin_cos(a->sine, a->cosine, a->degrees, q->judge.bits);
  }
  const bool certain = roots.certain;
  tp_roots_clear(&roots);
  return nearest >= 0 && certain ? TP_YES : TP_OPEN;
}

tp_answer tp_search_tilt(tp_limit_answer *answer, const tp_face *face, const tp_limit_question *q,
                         double near_degrees) {
  tp_trig excess;
  tp_trig_init(&excess);
  tp_search_excess(&excess, face, q);
  const tp_answer found = tp_search_is_linear(q) ? linear_tilt(answer, &excess, q->judge.bits)
                                                 : nearest_root(answer, &excess, q, near_degrees);
  tp_trig_clear(&excess);
  return found;
}

enum { STEPS = 90 }; /* of the search from level to upright */

/* The loads in the sketch's units, function by function. */
typedef struct loads {
  double of[TP_BASIS][3];
} loads;

/* What the base has to bear: the loads turned round. */
static void set_target(double target[3], const loads *l, double degrees) {
  const double tilt = degrees * (M_PI / 180), cosine = cos(tilt);
  const double basis[TP_BASIS] = {cosine, sin(tilt), 1, 1 / cosine, 1 / (cosine * cosine)};
  for (int row = 0; row < 3; row++) target[row] = 0;
  for (int k = 0; k < TP_BASIS; k++) {
    for (int row = 0; row < 3; row++) {
      if (l->of[k][row] != 0) target[row] -= basis[k] * l->of[k][row]; /* 1 / cos may be infinite */
    }
  }
}

static tp_simplex_answer look(tp_sketch *sketch, const loads *l, double degrees) {
  static const double level[3] = {0, 0, 0};
  double target[3];
  set_target(target, l, degrees);
  return tp_sketch_solve(sketch, level, target);
}

static bool holds(tp_sketch *sketch, const loads *l, double degrees) {
  return look(sketch, l, degrees).outcome == TP_SIMPLEX_OPTIMAL;
}

static double power(const double v[3], const double of[3]) {
  return v[0] * of[0] + v[1] * of[1] + v[2] * of[2];
}

/* What bounded forces hold against the twist. */
static double held_against(const tp_sketch *sketch, const double twist[3]) {
  double held = 0;
  for (long k = 0; k < sketch->count && sketch->most != NULL; k++) {
    const double own = power(twist, sketch->columns[k]);
    if (own < 0 && isfinite(sketch->most[k])) held -= own * sketch->most[k];
  }
  return held;
}

/* From `at`, where the twist beats the base, to the first tilt on the way to `end` where it does
 * not; `end` where it does all the way. */
static double beaten_until(const double twist[3], double held, const loads *l, double at,
                           double end) {
  double target[3];
  set_target(target, l, end);
  if (-power(twist, target) > held) return end;
  double low = at, high = end;
  for (int k = 0; k < 60; k++) {
    const double middle = (low + high) / 2;
    set_target(target, l, middle);
    *(-power(twist, target) > held ? &low : &high) = middle;
  }
  return high;
}

/* A tilt that holds between two that do not: the mechanism in the middle rules out a stretch about
 * it, and what is left on either side is looked at likewise. Where doubles are too short for the
 * scene a mechanism may rule out nothing: `looks` bounds how often it is tried. */
static bool find_between(double *found, tp_sketch *sketch, const loads *l, double low, double high,
                         int *looks) {
  const double middle = (low + high) / 2;
  const tp_simplex_answer answer = look(sketch, l, middle);
  *found = middle;
  if (answer.outcome == TP_SIMPLEX_OPTIMAL) return true;
  if (answer.outcome != TP_SIMPLEX_INFEASIBLE || --*looks <= 0) return false;
  const double held = held_against(sketch, answer.dual);
  const double left = beaten_until(answer.dual, held, l, middle, low);
  const double right = beaten_until(answer.dual, held, l, middle, high);
  return (left > low && find_between(found, sketch, l, low, left, looks)) ||
         (right < high && find_between(found, sketch, l, right, high, looks));
}

/* The last tilt that holds on the way from one that does to one that does not. */
static double halve(tp_sketch *sketch, const loads *l, double held, double fails) {
  double middle = (held + fails) / 2;
  for (; middle != held && middle != fails; middle = (held + fails) / 2) {
    *(holds(sketch, l, middle) ? &held : &fails) = middle;
  }
  return held;
}

/* The first tilt at which the base holds, in steps from level; at a step or between two. */
static tp_search_found find_held(tp_search_tilts *found, tp_sketch *sketch, const loads *l,
                                 double step) {
  enum { MOST_LOOKS = 100 };
  bool open = false;
  for (int k = 0; k <= STEPS; k++) {
    int looks = MOST_LOOKS;
    found->held = k * step;
    found->before = k > 0 ? (k - 1) * step : 0;
    if (holds(sketch, l, found->held)) return TP_SEARCH_TILT;
    if (k > 0 && find_between(&found->held, sketch, l, fmin(found->before, k * step),
                              fmax(found->before, k * step), &looks)) {
      return TP_SEARCH_TILT;
    }
    open = open || looks <= 0;
  }
  return open ? TP_SEARCH_OPEN : TP_SEARCH_HOLDS_NEVER;
}

static void set_loads(loads *l, const tp_sketch *sketch, const tp_limit_question *q) {
  tp_vector term;
  tp_vector_init(&term);
  for (int basis = 0; basis < TP_BASIS; basis++) {
    tp_search_load_term(&term, q->load, basis);
    tp_sketch_wrench(l->of[basis], sketch, &term);
  }
  tp_vector_clear(&term);
}

bool tp_search_pay(const tp_limit_question *q, const tp_sketch *sketch) {
  enum { FEW_BITS = 64 };
  static const double steps = 10; /* some hundred looks in doubles, each a tenth of one in balls */
  return tp_work_spend(q->work, steps, sketch->count, FEW_BITS);
}

/* Where level ground does not hold: of the tilts that do, those nearest to level, on either side.
 */
static tp_search_found find_nearest(tp_search_tilts *tilts, tp_sketch *sketch, const loads *l,
                                    double step) {
  tp_search_tilts below;
  const tp_search_found up = find_held(tilts, sketch, l, step);
  const tp_search_found down = find_held(&below, sketch, l, -step);
  if (up != TP_SEARCH_TILT && down != TP_SEARCH_TILT) return up == TP_SEARCH_OPEN ? up : down;
  if (down == TP_SEARCH_TILT &&
      (up != TP_SEARCH_TILT || -halve(sketch, l, below.held, below.before) <
                                   halve(sketch, l, tilts->held, tilts->before))) {
    *tilts = below;
  }
  return TP_SEARCH_TILT;
}

tp_search_found tp_search_near(tp_search_tilts *tilts, tp_sketch *sketch,
                               const tp_limit_question *q) {
  loads l;
  set_loads(&l, sketch, q);
  const double step = q->range_deg / STEPS;
  *tilts = (tp_search_tilts){.held = 0};
  if (!holds(sketch, &l, 0)) {
    const tp_search_found found = find_nearest(tilts, sketch, &l, step);
    if (found != TP_SEARCH_TILT) return found;
  }
  double held = tilts->held;
  while (held < q->range_deg) {
    const double next = fmin(held + step, q->range_deg);
    if (!holds(sketch, &l, next)) {
      tilts->lets_go = halve(sketch, &l, held, next);
      return TP_SEARCH_TILT;
    }
    held = next;
  }
  return TP_SEARCH_HOLDS_ALWAYS;
}

double tp_search_between(tp_sketch *sketch, const tp_limit_question *q, double held, double fails) {
  loads l;
  set_loads(&l, sketch, q);
  return halve(sketch, &l, held, fails);
}
