/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Pivots, toppling by moments, the toe and sliding by angles of small blocks on small bases,
 * against everything that touches (grid_contact.h) and the centroid in rationals. A pivot is
 * admissible where turning about it presses none of the points that restrain; which facet governs
 * sliding is the rule of docs/mechanics.md section 3, told here of points. The tilt is 45 degrees,
 * whose tangent is 1, so that factors of safety are rational too. */

#include "grid_scene.h"
#include "suite.h"

#include <arb.h>
#include <math.h>

enum { SCENES = 4000, BITS = 200 };

static random_numbers state;

/* Towards the left as it is, towards the right mirrored. */
static long run_of(const grid_restraint *r) {
  return r->along.x;
}

static long rise_of(const grid_restraint *r, tp_direction towards) {
  return towards == TP_TOWARDS_LEFT ? -r->along.y : r->along.y;
}

/* ---- comparisons --------------------------------------------------------------------------------
 */

/* The truth may lie within the error of the number, which is small beside it. */
static void check_ball(const tp_bounded *number, const arb_t truth, const char *what) {
  arb_t apart, error;
  arb_init(apart);
  arb_init(error);
  arb_set_d(apart, number->value);
  arb_sub(apart, apart, truth, BITS);
  arb_abs(apart, apart);
  arb_set_d(error, number->error);
  ck_assert_msg(!arb_gt(apart, error), "%s: %.17g", what, number->value);
  ck_assert_msg(number->error <= 1e-9 * (1 + fabs(number->value)), "%s: wide", what);
  arb_clear(apart);
  arb_clear(error);
}

static void check_rational(const tp_bounded *number, const fmpq_t truth, const char *what) {
  arb_t ball;
  arb_init(ball);
  arb_set_fmpq(ball, truth, BITS);
  check_ball(number, ball, what);
  arb_clear(ball);
}

/* The direction of (x, y) and some whole degrees more. */
static void set_degrees(arb_t degrees, const fmpq_t y, const fmpq_t x, long more) {
  arb_t pi, own;
  arb_init(pi);
  arb_init(own);
  arb_set_fmpq(degrees, y, BITS);
  arb_set_fmpq(own, x, BITS);
  arb_atan2(degrees, degrees, own, BITS);
  arb_const_pi(pi, BITS);
  arb_div(degrees, degrees, pi, BITS);
  arb_mul_ui(degrees, degrees, 180, BITS);
  arb_add_si(degrees, degrees, more, BITS);
  arb_clear(pi);
  arb_clear(own);
}

/* atan2(rise, run) + more degrees, also as a double. */
static double check_inclination(const tp_bounded *number, const grid_restraint *r,
                                tp_direction towards, long more, const char *what) {
  fmpq_t rise, run;
  arb_t truth;
  fmpq_init(rise);
  fmpq_init(run);
  arb_init(truth);
  fmpq_set_si(rise, rise_of(r, towards), 1);
  fmpq_set_si(run, run_of(r), 1);
  set_degrees(truth, rise, run, more);
  check_ball(number, truth, what);
  const double degrees = arf_get_d(arb_midref(truth), ARF_RND_NEAR);
  fmpq_clear(rise);
  fmpq_clear(run);
  arb_clear(truth);
  return degrees;
}

/* ---- toppling -----------------------------------------------------------------------------------
 */

/* A turn towards the left about p moves q by (-(q - p)_y, (q - p)_x), along the normal (-t_y, t_x)
 * by (q - p) . t. */
static bool is_admissible(const grid_scene *s, grid_point p, tp_direction towards) {
  for (long k = 0; k < s->all.count; k++) {
    const grid_restraint *r = s->all.of + k;
    const grid_point to = {p.x + r->along.x, p.y + r->along.y};
    const long lifts = grid_dot(p, r->at, p, to);
    if (towards == TP_TOWARDS_LEFT ? lifts < 0 : lifts > 0) return false;
  }
  return true;
}

static grid_point place_of(const tp_pivot *pivot) {
  return (grid_point){lround(pivot->x_m.value), lround(pivot->y_m.value)};
}

/* Its critical angle, and the factor of safety where it has one: the arms' ratio, over tan 45. */
static void check_moments(const grid_scene *s, const tp_pivot *pivot, tp_direction towards) {
  const grid_point p = place_of(pivot);
  exact_point arm;
  fmpq_t ratio;
  arb_t truth;
  exact_point_init(&arm);
  fmpq_init(ratio);
  arb_init(truth);
  fmpq_set_si(ratio, p.x, 1);
  check_rational(&pivot->x_m, ratio, "x");
  fmpq_sub(&arm.x, &s->centroid.x, ratio);
  if (towards == TP_TOWARDS_RIGHT) fmpq_neg(&arm.x, &arm.x);
  fmpq_set_si(ratio, p.y, 1);
  check_rational(&pivot->y_m, ratio, "y");
  fmpq_sub(&arm.y, &s->centroid.y, ratio);
  set_degrees(truth, &arm.x, &arm.y, 0);
  check_ball(&pivot->critical_angle_deg, truth, "critical angle");
  const bool has_fos = fmpq_sgn(&arm.x) > 0 && fmpq_sgn(&arm.y) > 0;
  if (has_fos) ck_assert_int_eq(pivot->fos.state, TP_FOS_NUMBER);
  if (has_fos) fmpq_div(ratio, &arm.x, &arm.y);
  if (has_fos) check_rational(&pivot->fos.value, ratio, "factor");
  exact_point_clear(&arm);
  fmpq_clear(ratio);
  arb_clear(truth);
}

/* Every point of contact is a candidate, once; the admissible one that topples first governs. */
static void check_pivots(const grid_scene *s, const tp_case *c) {
  ck_assert_uint_eq(c->pivot_count, (size_t)s->touching.count);
  bool any = false;
  double least = INFINITY;
  for (size_t k = 0; k < c->pivot_count; k++) {
    const tp_pivot *pivot = c->pivots + k;
    const grid_point p = place_of(pivot);
    ck_assert(grid_contains(&s->touching, (grid_restraint){p, {0, 0}}));
    for (size_t j = 0; j < k; j++) ck_assert(!grid_same(place_of(c->pivots + j), p));
    ck_assert_int_eq(pivot->admissible, is_admissible(s, p, c->towards));
    check_moments(s, pivot, c->towards);
    any = any || pivot->admissible;
    if (pivot->admissible) least = fmin(least, pivot->critical_angle_deg.value);
  }
  ck_assert_int_eq(c->has_toppling_pivot, any);
  if (!any) return;
  const tp_pivot *governing = c->pivots + c->toppling_pivot;
  ck_assert(governing->admissible);
  ck_assert(governing->critical_angle_deg.value <= least + governing->critical_angle_deg.error);
}

/* ---- sliding ------------------------------------------------------------------------------------
 */

/* The restraint that rises most steeply for a motion down-dip, and whether one stands in the way.
 */
typedef struct steepest {
  const grid_restraint *best;
  bool blocked;
} steepest;

typedef bool (*selection)(const grid_scene *s, const grid_restraint *r, tp_direction towards,
                          const void *context);

static steepest find_steepest(const grid_scene *s, tp_direction towards, selection counts,
                              const void *context) {
  steepest found = {NULL, false};
  for (long k = 0; k < s->all.count; k++) {
    const grid_restraint *r = s->all.of + k, *best = found.best;
    if (!counts(s, r, towards, context)) continue;
    const long run = run_of(r), rise = rise_of(r, towards);
    if (run <= 0) {
      found.blocked = found.blocked || rise > 0;
    } else if (best == NULL || rise * run_of(best) > rise_of(best, towards) * run) {
      found.best = r;
    }
  }
  return found;
}

static bool is_down_dip(const grid_scene *s, const grid_restraint *r, tp_direction towards,
                        const void *context) {
  (void)context;
  const int side = fmpq_cmp_si(&s->centroid.x, r->at.x);
  return towards == TP_TOWARDS_LEFT ? side > 0 : side < 0;
}

static bool is_any(const grid_scene *s, const grid_restraint *r, tp_direction towards,
                   const void *context) {
  (void)s;
  (void)r;
  (void)towards;
  (void)context;
  return true;
}

static bool is_at(const grid_scene *s, const grid_restraint *r, tp_direction towards,
                  const void *context) {
  (void)s;
  (void)towards;
  return grid_same(r->at, *(const grid_point *)context);
}

/* phi + i <= 0, in doubles: of the friction angles here only 0 and 45 degrees can tie, and do so in
 * whole numbers. */
static bool slides_level(const grid_scene *s, const grid_restraint *r, tp_direction towards) {
  const long run = run_of(r), rise = rise_of(r, towards);
  if (s->friction_deg == 0) return rise <= 0;
  if (s->friction_deg == 45) return rise <= -run;
  return atan2((double)rise, (double)run) * 180 / acos(-1) + (double)s->friction_deg <= 0;
}

/* The motion (-run, rise) towards the left, (run, rise) towards the right, against each normal. */
static bool opens(const grid_scene *s, const grid_restraint *best, tp_direction towards) {
  const long run = towards == TP_TOWARDS_LEFT ? -run_of(best) : run_of(best);
  for (long k = 0; k < s->all.count; k++) {
    const grid_point t = s->all.of[k].along;
    if (-run * t.y + rise_of(best, towards) * t.x < 0) return false;
  }
  return true;
}

static void check_sliding(const grid_scene *s, const tp_case *c) {
  const tp_sliding *own = &c->sliding;
  steepest found = find_steepest(s, c->towards, is_down_dip, NULL);
  if (!found.blocked && (found.best == NULL || slides_level(s, found.best, c->towards))) {
    found = find_steepest(s, c->towards, is_any, NULL);
  }
  ck_assert_int_eq(own->known, found.best != NULL || found.blocked);
  bool never = found.blocked;
  if (found.best != NULL) {
    check_inclination(&own->facet_angle_deg, found.best, c->towards, 0, "facet angle");
    never = check_inclination(&own->critical_angle_deg, found.best, c->towards, s->friction_deg,
                              "sliding angle") >= 90 - 1e-9 ||
            never;
    ck_assert_int_eq(own->opens, !found.blocked && opens(s, found.best, c->towards));
  }
  ck_assert_int_eq(own->never, never);
}

/* The toe holds up to phi + i of what rises most steeply from it. */
static void check_toe(const grid_scene *s, const tp_case *c) {
  if (!c->has_toppling_pivot) return;
  const grid_point toe = place_of(c->pivots + c->toppling_pivot);
  const steepest found = find_steepest(s, c->towards, is_at, &toe);
  ck_assert_int_eq(c->toe.known, found.best != NULL || found.blocked);
  ck_assert_int_eq(c->toe.upright, found.blocked);
  if (found.best == NULL || found.blocked) return;
  const double limit =
      check_inclination(&c->toe.limit_angle_deg, found.best, c->towards, s->friction_deg, "toe");
  const double angle = c->pivots[c->toppling_pivot].critical_angle_deg.value;
  if (fabs(angle - limit) > 1e-9) ck_assert_int_eq(c->toe.holds, angle < limit);
}

START_TEST(small_blocks_on_small_bases) {
  state = random_numbers_from(111);
  long governed = 0, blocked = 0, slid = 0;
  for (int round = 0; round < SCENES; round++) {
    static grid_scene s;
    tp_solution *solution = NULL;
    grid_scene_init(&s, &state);
    grid_scene_solve(&solution, &s);
    ck_assert_uint_eq(solution->case_count, 2);
    for (size_t k = 0; k < 2; k++) {
      const tp_case *c = solution->cases + k;
      check_pivots(&s, c);
      check_sliding(&s, c);
      check_toe(&s, c);
      governed += c->has_toppling_pivot;
      blocked += c->sliding.never;
      slid += c->sliding.known && !c->sliding.never;
    }
    tp_solution_free(solution);
    grid_scene_clear(&s);
  }
  ck_assert_int_gt(governed, SCENES);
  ck_assert_int_gt(blocked, SCENES / 5);
  ck_assert_int_gt(slid, SCENES / 5);
}
END_TEST

SUITE(stability) {
  Suite *suite = suite_create("stability");
  TCase *cases = tcase_create("stability");
  tcase_set_timeout(cases, 300);
  tcase_add_test(cases, small_blocks_on_small_bases);
  suite_add_tcase(suite, cases);
  return suite;
}
