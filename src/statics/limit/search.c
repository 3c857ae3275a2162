/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Search for the first tilt from level that the base does not hold, by linear programs in doubles
 * (docs/mechanics.md section 6): the twist of a program that fails rules out a stretch of tilts,
 * what lies between held and failing tilts is bisected.
 *
 * Tilts are halved, not interpolated between (number/root.h): whether the base holds is a yes or a
 * no, and sixty values of a mechanism's excess cost less than one program. */

#include "limit/search.h"

#include "number/ball.h"

#include <math.h>

enum { STEPS = 90 }; /* of the search from level to upright */

/* The loads in the scaled program's units, function by function. */
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

static tp_simplex_answer sample(tp_scaled *scaled, const loads *l, double degrees) {
  static const double level[3] = {0, 0, 0};
  double target[3];
  set_target(target, l, degrees);
  return tp_scaled_solve(scaled, level, target);
}

static bool holds(tp_scaled *scaled, const loads *l, double degrees) {
  return sample(scaled, l, degrees).outcome == TP_SIMPLEX_OPTIMAL;
}

static double power(const double v[3], const double of[3]) {
  return v[0] * of[0] + v[1] * of[1] + v[2] * of[2];
}

/* What bounded forces hold against the twist. */
static double held_against(const tp_scaled *scaled, const double twist[3]) {
  double held = 0;
  for (long k = 0; k < scaled->count && scaled->most != NULL; k++) {
    const double own = power(twist, scaled->columns[k]);
    if (own < 0 && isfinite(scaled->most[k])) held -= own * scaled->most[k];
  }
  return held;
}

/* From `at`, where the twist proves that nothing holds, to the first tilt on the way to `end` where
 * it does not; `end` where it does all the way. */
static double infeasible_until(const double twist[3], double held, const loads *l, double at,
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

/* A tilt that holds between two that do not: the mechanism in the middle rules out an interval
 * about it, and what is left on either side is sampled likewise. Where doubles are too short for
 * the scene a mechanism may rule out nothing: `samples` bounds how often it is tried. */
static bool find_between(double *found, tp_scaled *scaled, const loads *l, double low, double high,
                         int *samples) {
  const double middle = (low + high) / 2;
  const tp_simplex_answer answer = sample(scaled, l, middle);
  *found = middle;
  if (answer.outcome == TP_SIMPLEX_OPTIMAL) return true;
  if (answer.outcome != TP_SIMPLEX_INFEASIBLE || --*samples <= 0) return false;
  const double held = held_against(scaled, answer.dual);
  const double left = infeasible_until(answer.dual, held, l, middle, low);
  const double right = infeasible_until(answer.dual, held, l, middle, high);
  return (left > low && find_between(found, scaled, l, low, left, samples)) ||
         (right < high && find_between(found, scaled, l, right, high, samples));
}

/* The last tilt that holds on the way from one that does to one that does not. */
static double halve(tp_scaled *scaled, const loads *l, double held, double fails) {
  double middle = (held + fails) / 2;
  for (; middle != held && middle != fails; middle = (held + fails) / 2) {
    *(holds(scaled, l, middle) ? &held : &fails) = middle;
  }
  return held;
}

/* The first tilt at which the base holds, in steps from level; at a step or between two. */
static tp_search_found find_held(tp_search_tilts *found, tp_scaled *scaled, const loads *l,
                                 double step) {
  enum { MOST_SAMPLES = 100 };
  bool open = false;
  for (int k = 0; k <= STEPS; k++) {
    int samples = MOST_SAMPLES;
    found->held = k * step;
    found->before = k > 0 ? (k - 1) * step : 0;
    if (holds(scaled, l, found->held)) return TP_SEARCH_TILT;
    if (k > 0 && find_between(&found->held, scaled, l, fmin(found->before, k * step),
                              fmax(found->before, k * step), &samples)) {
      return TP_SEARCH_TILT;
    }
    open = open || samples <= 0;
  }
  return open ? TP_SEARCH_OPEN : TP_SEARCH_HOLDS_NEVER;
}

static void set_loads(loads *l, const tp_scaled *scaled, const tp_limit_question *q) {
  tp_vector term;
  tp_vector_init(&term);
  for (int basis = 0; basis < TP_BASIS; basis++) {
    tp_question_load_term(&term, q->load, basis);
    tp_scaled_wrench(l->of[basis], scaled, &term);
  }
  tp_vector_clear(&term);
}

bool tp_search_pay(const tp_limit_question *q, const tp_scaled *scaled) {
  enum { FEW_BITS = 64 };
  static const double steps =
      10; /* some hundred samples in doubles, each a tenth of one in balls */
  return tp_work_spend(q->work, steps, scaled->count, FEW_BITS);
}

/* Where level ground does not hold: of the tilts that do, those nearest to level, on either side.
 */
static tp_search_found find_nearest(tp_search_tilts *tilts, tp_scaled *scaled, const loads *l,
                                    double step) {
  tp_search_tilts below;
  const tp_search_found up = find_held(tilts, scaled, l, step);
  const tp_search_found down = find_held(&below, scaled, l, -step);
  if (up != TP_SEARCH_TILT && down != TP_SEARCH_TILT) return up == TP_SEARCH_OPEN ? up : down;
  if (down == TP_SEARCH_TILT &&
      (up != TP_SEARCH_TILT || -halve(scaled, l, below.held, below.before) <
                                   halve(scaled, l, tilts->held, tilts->before))) {
    *tilts = below;
  }
  return TP_SEARCH_TILT;
}

tp_search_found tp_search_near(tp_search_tilts *tilts, tp_scaled *scaled,
                               const tp_limit_question *q) {
  loads l;
  set_loads(&l, scaled, q);
  const double step = q->range_deg / STEPS;
  *tilts = (tp_search_tilts){.held = 0};
  if (!holds(scaled, &l, 0)) {
    const tp_search_found found = find_nearest(tilts, scaled, &l, step);
    if (found != TP_SEARCH_TILT) return found;
  }
  double held = tilts->held;
  while (held < q->range_deg) {
    const double next = fmin(held + step, q->range_deg);
    if (!holds(scaled, &l, next)) {
      tilts->fails = halve(scaled, &l, held, next);
      return TP_SEARCH_TILT;
    }
    held = next;
  }
  return TP_SEARCH_HOLDS_ALWAYS;
}

double tp_search_between(tp_scaled *scaled, const tp_limit_question *q, double held, double fails) {
  loads l;
  set_loads(&l, scaled, q);
  return halve(scaled, &l, held, fails);
}
