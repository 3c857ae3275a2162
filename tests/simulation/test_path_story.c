/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The way of blocks E and F to their failure, which section 4.5 of the paper tells: which facets
 * open, where the stress goes, which of them slips. The states on the way are compared with those
 * of a joint cut into thousands of strips, each with a normal and a shear spring of its own. */

#include "body_stage.h"
#include "quasi_static/path.h"
#include "suite.h"

#include <math.h>
#include <string.h>

#define TOOTHED(count, height)                                                                     \
  "topple: 1\nlength_unit: mm\nfriction_angle_deg: 30\nblock:\n  teeth: {count: " #count           \
  ", width: 30, height: " #height                                                                  \
  ", depth: 5, left_end: valley}\n  thickness: 20\n  unit_weight_kn_m3: 25.8\nbase: {mated: "      \
  "true, beyond: {left: 0, right: 0}}\ntilt: {towards: left}\n"
#define BLOCK_E TOOTHED(3, 120)
#define BLOCK_F TOOTHED(2, 118)

enum { STRIPS = 2000 };
static const double normal_stiffness = 1e12, shear_stiffness = 1e10, thickness = 0.02;

/* A strip's force acts at its middle: along a closed length of a tenth of the facet moments are off
 * by the square of a strip over that, and by the angle of an event, 2e-8. */
static const double off = 1e-5;

static double degree;

/* Facets of these blocks from left to right: teeth of 30 by 5 mm that begin in a valley. */
static tp_xy corner(int k) {
  return (tp_xy){0.03 * k, k % 2 == 0 ? 0 : 0.005};
}

/* Forces on the block of the strips of one facet that have not opened, at a small displacement
 * x, y, turn of its centroid, stuck; and what they add to the balance. */
typedef struct strips {
  double normal, shear, closure[2]; /* at the two ends */
} strips;

/* How much of a strip is closed, and its mean closure there; at its two edges it is `a` and `b`. */
static double closed_share(double a, double b, double *closure) {
  *closure = 0;
  if (a <= 0 && b <= 0) return 0;
  *closure = (fmax(a, 0) + fmax(b, 0)) / 2;
  return a >= 0 && b >= 0 ? 1 : fmax(a, b) / fabs(a - b);
}

static strips press(int facet, tp_xy centroid, const double u[3], double force[3]) {
  const tp_xy from = corner(facet), to = corner(facet + 1);
  const double dx = to.x - from.x, dy = to.y - from.y, length = hypot(dx, dy);
  const double tx = dx / length, ty = dy / length, area = length / STRIPS * thickness;
  strips sum = {0};
  double before = 0, closure;
  for (int k = 0; k <= STRIPS; k++) {
    const double share = (double)k / STRIPS, middle = (k - 0.5) / STRIPS;
    const double at_x = from.x + share * dx - centroid.x, at_y = from.y + share * dy - centroid.y;
    const double moved_x = u[0] - u[2] * at_y, moved_y = u[1] + u[2] * at_x;
    const double now = ty * moved_x - tx * moved_y, along = tx * moved_x + ty * moved_y;
    if (k == 0) sum.closure[0] = now;
    const double closed = closed_share(before, now, &closure);
    before = sum.closure[1] = now;
    if (k == 0) continue;
    const double x = from.x + middle * dx - centroid.x, y = from.y + middle * dy - centroid.y;
    const double normal = normal_stiffness * area * closure * closed;
    const double shear = -shear_stiffness * area * along * closed;
    const double fx = -ty * normal + tx * shear, fy = tx * normal + ty * shear;
    sum.normal += normal;
    sum.shear += shear;
    force[0] += fx;
    force[1] += fy;
    force[2] += x * fy - y * fx;
  }
  return sum;
}

static void balance(double force[3], const tp_rigid_body *body, double tilt, const double u[3]) {
  const double weight = body->mass_kg * TP_GRAVITY_M_S2;
  force[0] = -weight * sin(tilt);
  force[1] = -weight * cos(tilt);
  force[2] = 0;
  for (int facet = 0; facet < 2; facet++) press(facet, body->origin, u, force);
}

/* Cramer's rule for the step that differences of the balance propose. */
static double determinant(double m[3][3]) {
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
         m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

/* The displacement on the two facets on the left, none of which has slipped. */
static void settle(double u[3], const tp_rigid_body *body, double tilt) {
  static const double step[] = {1e-11, 1e-11, 2e-10};
  const double weight = body->mass_kg * TP_GRAVITY_M_S2;
  u[0] = u[2] = 0;
  u[1] = -weight / (normal_stiffness * thickness * 0.06);
  for (int round = 0; round < 60; round++) {
    double force[3], m[3][3], other[3];
    balance(force, body, tilt, u);
    if (fabs(force[0]) + fabs(force[1]) + fabs(force[2]) / 0.05 < 1e-9 * weight) return;
    for (int k = 0; k < 3; k++) {
      double moved[] = {u[0], u[1], u[2]};
      moved[k] += step[k];
      balance(other, body, tilt, moved);
      for (int i = 0; i < 3; i++) m[i][k] = (force[i] - other[i]) / step[k];
    }
    const double all = determinant(m);
    for (int k = 0; k < 3; k++) {
      double own[3][3];
      memcpy(own, m, sizeof own);
      for (int i = 0; i < 3; i++) own[i][k] = force[i];
      u[k] += determinant(own) / all;
    }
  }
  ck_abort_msg("the strips find no balance at %g degrees", tilt / degree);
}

static void near_to(double value, double expected, double within, const char *what) {
  ck_assert_msg(fabs(value - expected) <= within, "%s: %.9g, not %.9g", what, value, expected);
}

typedef struct told {
  tp_tilt_event_kind kind;
  long facet;
  double x_mm; /* where, to 1.5 mm */
} told;

static void compare_story(const tp_history *h, const told *story, size_t count) {
  ck_assert_int_eq(h->event_count, count);
  for (size_t k = 0; k < count; k++) {
    const tp_tilt_event *own = h->events + k;
    ck_assert_msg(own->what == story[k].kind && own->facet == story[k].facet,
                  "event %zu: %d at %ld", k, (int)own->what, own->facet);
    if (own->facet > 0) near_to(own->x_m * 1000, story[k].x_mm, 1.5, "where");
    ck_assert(k == 0 || own->angle_deg >= own[-1].angle_deg);
  }
}

/* Reactions at each moment from one tilt to another, where two facets bear and none has slipped. */
static void compare_reactions(const tp_history *h, const tp_rigid_body *body, double from_deg,
                              double to_deg) {
  long compared = 0;
  for (size_t k = 0; k < h->reaction_count; k++) {
    const tp_tilt_reaction *own = h->reactions + k;
    const double tilt_deg = h->moments[own->moment].angle_deg;
    if (own->facet != 1 || tilt_deg < from_deg || tilt_deg > to_deg || own->moment % 3 != 0)
      continue;
    double u[3], force[3] = {0};
    settle(u, body, tilt_deg * degree);
    for (int facet = 0; facet < 2; facet++) {
      const strips s = press(facet, body->origin, u, force);
      near_to(own[facet].normal_n, s.normal, off * s.normal, "normal force of strips");
      near_to(own[facet].shear_n, s.shear, off * s.normal, "shear force of strips");
    }
    compared++;
  }
  ck_assert_int_gt(compared, 3);
}

/* An end of a facet opens where the closure of its strips is 0. */
static void compare_opening(const tp_history *h, const tp_rigid_body *body, size_t event) {
  const tp_tilt_event *own = h->events + event;
  double u[3], force[3] = {0};
  settle(u, body, own->angle_deg * degree);
  const strips s = press((int)own->facet - 1, body->origin, u, force);
  const bool right = own->x_m > 0.015 + 0.03 * (double)(own->facet - 1);
  near_to(s.closure[right], 0, 1e-5 * fabs(s.closure[!right]), "closure of strips");
}

static void compare_slip(const tp_history *h, const tp_rigid_body *body, size_t event) {
  const tp_tilt_event *own = h->events + event;
  double u[3], force[3] = {0};
  settle(u, body, own->angle_deg * degree);
  const strips s = press((int)own->facet - 1, body->origin, u, force);
  near_to(s.shear / s.normal, tan(30 * degree), off, "friction mobilized in strips");
}

static tp_path_result follow(const body_stage *s, tp_history *history) {
  tp_message message;
  tp_path_result result;
  const tp_path_settings settings = tp_path_settings_default();
  ck_assert_msg(tp_path_run(&result, &s->body, &settings, history, &message) == TP_OK, "%s",
                message.text);
  return result;
}

/* "After some tilting there is no contact on the right": facet 3 has opened at 7.4 degrees. "Most
 * of the stress is in the intermediate sub-element" up to some 14.5 degrees: its reaction is the
 * largest at 13. "It is slowly transferred to the left one", until the intermediate one slips, at
 * 27.5 degrees as in the paper's simulation. */
START_TEST(block_e_is_left_to_two_facets_and_slips_on_the_middle_one) {
  static const told story[] = {{TP_EVENT_OPENS, 3, 90}, {TP_EVENT_SLIPS, 3, 65},
                               {TP_EVENT_OPENS, 3, 60}, {TP_EVENT_OPENS, 1, 30},
                               {TP_EVENT_OPENS, 2, 60}, {TP_EVENT_SLIPS, 2, 31},
                               {TP_EVENT_SLIPS, 1, 1},  {TP_EVENT_COLLAPSES, 0, 0}};
  body_stage s;
  tp_history h = {0};
  body_stage_init(&s, BLOCK_E, TP_TOWARDS_LEFT);
  const tp_path_result r = follow(&s, &h);
  compare_story(&h, story, sizeof story / sizeof *story);
  compare_reactions(&h, &s.body, 7.5, 27.4);
  compare_opening(&h, &s.body, 3);
  compare_opening(&h, &s.body, 4);
  compare_slip(&h, &s.body, 5);
  near_to(h.events[5].angle_deg, 27.5, 0.05, "the paper's numerical angle");
  double most = 0, most_at = 0, least = 1e9, least_at = 0;
  for (size_t k = 0; k < h.reaction_count; k++) {
    const tp_tilt_reaction *own = h.reactions + k;
    const double at = h.moments[own->moment].angle_deg;
    if (own->facet == 2 && own->normal_n > most) most = own->normal_n, most_at = at;
    if (own->facet == 1 && own->normal_n < least) least = own->normal_n, least_at = at;
  }
  near_to(most_at, 13.5, 1, "most in the middle");
  near_to(least_at, 14.5, 1, "least on the left");
  ck_assert(r.motion.mechanism == TP_SLIDES_AND_TOPPLES && r.jumps == 0);
  tp_history_clear(&h);
  body_stage_clear(&s);
}
END_TEST

/* Of F the right facet's load goes to the left one from some 7 degrees on; it slips long before the
 * block can move, since the left one still holds. */
START_TEST(block_f_slips_on_the_right_first) {
  static const told story[] = {{TP_EVENT_OPENS, 1, 30},
                               {TP_EVENT_OPENS, 2, 60},
                               {TP_EVENT_SLIPS, 2, 31},
                               {TP_EVENT_SLIPS, 1, 1},
                               {TP_EVENT_COLLAPSES, 0, 0}};
  body_stage s;
  tp_history h = {0};
  body_stage_init(&s, BLOCK_F, TP_TOWARDS_LEFT);
  const tp_path_result r = follow(&s, &h);
  compare_story(&h, story, sizeof story / sizeof *story);
  compare_reactions(&h, &s.body, 0, 19);
  for (size_t k = 0; k < 2; k++) compare_opening(&h, &s.body, k);
  compare_slip(&h, &s.body, 2);
  ck_assert(r.motion.mechanism == TP_SLIDES_AND_TOPPLES);
  ck_assert(r.stands_to / degree - h.events[2].angle_deg > 4);
  tp_history_clear(&h);
  body_stage_clear(&s);
}
END_TEST

SUITE(path_story) {
  degree = acos(-1) / 180;
  Suite *suite = suite_create("path story");
  TCase *cases = tcase_create("path story");
  tcase_set_timeout(cases, 0);
  tcase_add_test(cases, block_e_is_left_to_two_facets_and_slips_on_the_middle_one);
  tcase_add_test(cases, block_f_slips_on_the_right_first);
  suite_add_tcase(suite, cases);
  return suite;
}
