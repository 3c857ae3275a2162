/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What begins to move, and what an impact does: against the solve's modes, which are proven in
 * balls; against closed forms; and on thousands of impacts drawn at random, against what no impact
 * may do. */

#include "body_stage.h"
#include "random_numbers.h"
#include "rigid_contact/impact.h"
#include "rigid_contact/rest.h"
#include "rigid_contact/rigid_contact.h"
#include "suite.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double pi = 3.141592653589793;

static tp_rigid_contact_rest rest_at(const tp_rigid_body *body, double angle_deg) {
  const tp_drive drive = {.angle = angle_deg * pi / 180};
  const tp_run run = {.body = body, .drive = &drive};
  tp_rigid_contact_rest rest;
  ck_assert(tp_rigid_contact_rest_find(&rest, &run));
  return rest;
}

/* ---- the modes of the solve ---- */

/* Over gravity and the extent of the block. */
static double distance(const tp_rigid_contact_motion *own, const tp_motion *proven,
                       double extent_m) {
  const double g = TP_GRAVITY_M_S2;
  return fmax(fmax(fabs(own->x_m_s2 / g - proven->acceleration_x_g.value),
                   fabs(own->y_m_s2 / g - proven->acceleration_y_g.value)),
              fabs(own->turning_rad_s2 / g - proven->angular_g_per_m.value) * extent_m);
}

#define BLOCK_A                                                                                    \
  "topple: 1\nlength_unit: mm\nblock:\n  teeth: {count: 3, width: 15, height: 94, depth: 5, "      \
  "left_end: peak}\n  thickness: 20\n  unit_weight_kn_m3: 25.8\nbase: {mated: true, beyond: "      \
  "{left: 0, right: 0}}\nfriction_angle_deg: 30\n"
#define BLOCK_E                                                                                    \
  "topple: 1\nlength_unit: mm\nblock:\n  teeth: {count: 3, width: 30, height: 120, depth: 5, "     \
  "left_end: valley}\n  thickness: 20\n  unit_weight_kn_m3: 25.8\nbase: {mated: true, beyond: "    \
  "{left: 0, right: 0}}\nfriction_angle_deg: 30\n"
#define BLOCK_F                                                                                    \
  "topple: 1\nlength_unit: mm\nblock:\n  teeth: {count: 2, width: 30, height: 118, depth: 5, "     \
  "left_end: valley}\n  thickness: 20\n  unit_weight_kn_m3: 25.8\nbase: {mated: true, beyond: "    \
  "{left: 0, right: 0}}\nfriction_angle_deg: 30\n"
#define LONG_BASE                                                                                  \
  "topple: 1\nlength_unit: m\nblock:\n  teeth: {count: 3, width: 30, height: 120, depth: 5, "      \
  "left_end: valley}\n  thickness: 20\n  unit_weight_kn_m3: 25.8\nbase: {mated: true, beyond: "    \
  "{left: 60, right: 60}}\nfriction_angle_deg: 30\n"
#define WORN                                                                                       \
  "topple: 1\nlength_unit: mm\nblock:\n  teeth: {count: 3, width: 15, height: 94, depth: 5, "      \
  "left_end: peak}\n  rounded: {corners: [{at: left_end, radius: 3.36}]}\n  thickness: 20\n"       \
  "  unit_weight_kn_m3: 25.8\nbase: {mated: true, beyond: {left: 0, right: 0}}\n"                  \
  "friction_angle_deg: 30\n"
#define SHAKEN                                                                                     \
  "topple: 1\nlength_unit: m\nblock:\n  slab: {width: 2, height: 4}\n  unit_weight_kn_m3: 26\n"    \
  "base: {mated: true, beyond: {left: 2, right: 2}}\nloads: {seismic: {horizontal: 0.15, "         \
  "vertical: 0}}\nfriction_angle_deg: 40\n"
#define WINDOW                                                                                     \
  "topple: 1\nlength_unit: m\nblock:\n  outline: [[0, 1.123], [0.588, 0.901], [1.536, -0.465], "   \
  "[0.967, 4.599], [-0.569, 4.599]]\nbase: {profile: [[0, 1.123], [0.588, 0.901], [1.536, "        \
  "-0.465]]}\nfriction_angle_deg: 61.36\n"

typedef struct tilted {
  const char *text;
  tp_direction towards;
  double angle_deg;
} tilted;

static const tilted scenes[] = {
    {BLOCK_A, TP_TOWARDS_LEFT, 27},   {BLOCK_A, TP_TOWARDS_LEFT, 60},
    {BLOCK_A, TP_TOWARDS_LEFT, 84},   {BLOCK_A, TP_TOWARDS_RIGHT, 25},
    {BLOCK_E, TP_TOWARDS_LEFT, 29},   {BLOCK_E, TP_TOWARDS_LEFT, 50},
    {BLOCK_E, TP_TOWARDS_RIGHT, 40},  {BLOCK_F, TP_TOWARDS_LEFT, 24},
    {BLOCK_F, TP_TOWARDS_RIGHT, 33},  {LONG_BASE, TP_TOWARDS_LEFT, 36},
    {LONG_BASE, TP_TOWARDS_LEFT, 75}, {WORN, TP_TOWARDS_LEFT, 25},
    {WORN, TP_TOWARDS_RIGHT, 30},     {SHAKEN, TP_TOWARDS_LEFT, 25},
    {SHAKEN, TP_TOWARDS_RIGHT, 20},   {SHAKEN, TP_TOWARDS_RIGHT, 45},
    {WINDOW, TP_TOWARDS_LEFT, 21},    {WINDOW, TP_TOWARDS_LEFT, 30},
};
enum { SCENES = sizeof scenes / sizeof *scenes };

/* Each motion that the solve proves, and has no free range, is found, to 1e-12 of gravity. */
START_TEST(motions_from_rest_are_those_of_the_solve) {
  const tilted *own = scenes + _i;
  char text[1000];
  body_stage s;
  snprintf(text, sizeof text, "%stilt: {towards: %s, angle_deg: %.17g}\n", own->text,
           own->towards == TP_TOWARDS_LEFT ? "left" : "right", own->angle_deg);
  body_stage_init(&s, text, own->towards);
  const tp_onset *onset = &s.solution->cases[0].onset;
  const tp_rigid_contact_rest rest = rest_at(&s.body, own->angle_deg);
  ck_assert(onset->has_motions && onset->motion_count > 0);
  size_t fixed = 0;
  for (size_t k = 0; k < onset->motion_count; k++) {
    const tp_motion *proven = onset->motions + k;
    if (!proven->accelerations_fixed) continue;
    double nearest = INFINITY;
    for (int m = 0; m < rest.motion_count; m++) {
      nearest = fmin(nearest, distance(rest.motions + m, proven, s.body.extent_m));
    }
    ck_assert_msg(nearest < 1e-12, "scene %d, motion %zu of %zu: off by %g of %d", _i, k + 1,
                  onset->motion_count, nearest, rest.motion_count);
    fixed++;
  }
  ck_assert(fixed > 0);
  if (fixed == onset->motion_count) ck_assert_int_eq(rest.motion_count, fixed);
  body_stage_clear(&s);
}
END_TEST

/* Where it begins to move, and where nothing can hold it: alpha_s and alpha_w of the solve. */
START_TEST(window_is_that_of_the_solve) {
  const tilted *own = scenes + _i;
  char text[1000];
  body_stage s;
  snprintf(text, sizeof text, "%stilt: {towards: %s}\n", own->text,
           own->towards == TP_TOWARDS_LEFT ? "left" : "right");
  body_stage_init(&s, text, own->towards);
  const tp_case *c = s.solution->cases;
  /* signs are judged to 1e-11 of gravity */
  const double onset = c->onset.critical_angle_deg.value, near = 1e-8;
  ck_assert_int_eq(c->onset.kind, TP_ONSET_AT_ANGLE);
  ck_assert_int_eq(rest_at(&s.body, onset - near).motion_count, 0);
  ck_assert_int_gt(rest_at(&s.body, onset + near).motion_count, 0);
  if (c->limit.kind == TP_LIMIT_AT_ANGLE) {
    /* forces are found within 1e-10 of the loads, which change by a share of the angle of order 1
     */
    const double limit = c->limit.critical_angle_deg.value, far = 1e-7;
    ck_assert(rest_at(&s.body, limit - far).held);
    ck_assert(!rest_at(&s.body, limit + far).held);
  }
  body_stage_clear(&s);
}
END_TEST

/* On a table that tilts slowly from level it begins to move at that tilt. */
START_TEST(table_lets_go_at_the_onset_of_the_solve) {
  const tilted *own = scenes + _i;
  char text[1000];
  body_stage s;
  tp_history h = {0};
  tp_message message = {0};
  snprintf(text, sizeof text, "%stilt: {towards: %s}\n", own->text,
           own->towards == TP_TOWARDS_LEFT ? "left" : "right");
  body_stage_init(&s, text, own->towards);
  const tp_drive drive = {.speed = pi / 180 / 3, .final_angle = 1.5};
  const tp_rigid_contact_settings settings = tp_rigid_contact_settings_default();
  const tp_run run = {
      .body = &s.body, .drive = &drive, .longest_s = 300, .until_collapse = true, .history = &h};
  ck_assert_int_eq(tp_rigid_contact_run(NULL, NULL, &run, &settings, &message), TP_RUN_MOVES);
  const double onset = s.solution->cases[0].onset.critical_angle_deg.value;
  bool let_go = false;
  for (size_t e = 0; e < h.event_count; e++) {
    if (h.events[e].what != TP_EVENT_COLLAPSES) continue;
    ck_assert_msg(fabs(h.events[e].angle_deg - onset) < 1e-8, "begins to move at %.12g, not %.12g",
                  h.events[e].angle_deg, onset);
    let_go = true;
  }
  ck_assert(let_go);
  tp_history_clear(&h);
  body_stage_clear(&s);
}
END_TEST

/* A slab b wide and h high turns about its toe from rest with g r sin(alpha - delta) / (r^2 + k^2),
 * or slips there too, where phi < delta + atan(kappa tan(alpha - delta)) (mechanics.md section 7).
 */
START_TEST(slab_turns_or_slips_as_the_dynamic_border_says) {
  const double b = 1, h = 3, r = hypot(b, h) / 2, k2 = (b * b + h * h) / 12;
  const double delta = atan2(b, h), kappa = k2 / (k2 + r * r), phi = pi / 6;
  const double border = delta + atan(tan(phi - delta) / kappa);
  body_stage s;
  body_stage_init(&s,
                  "topple: 1\nlength_unit: m\nfriction_angle_deg: 30\nblock: {slab: {width: 1, "
                  "height: 3}}\nbase: {mated: true, beyond: {left: 5, right: 5}}\n",
                  TP_TOWARDS_LEFT);
  for (int side = -1; side <= 1; side += 2) {
    const double alpha = border + side * 1e-6;
    const tp_rigid_contact_rest rest = rest_at(&s.body, alpha * 180 / pi);
    ck_assert_int_eq(rest.motion_count, 1);
    const tp_rigid_contact_motion *m = rest.motions;
    const double toe_x = m->x_m_s2 + m->turning_rad_s2 * h / 2; /* the arm is (-b / 2, -h / 2) */
    const double toe_y = m->y_m_s2 - m->turning_rad_s2 * b / 2;
    ck_assert(fabs(toe_y) < 1e-13);
    if (side < 0) {
      const double turning = TP_GRAVITY_M_S2 * r * sin(alpha - delta) / (r * r + k2);
      ck_assert(fabs(m->turning_rad_s2 - turning) < 1e-12 * turning && fabs(toe_x) < 1e-13);
    } else {
      ck_assert(toe_x < -1e-7);
    }
  }
  body_stage_clear(&s);
}
END_TEST

/* ---- stories ---- */

static bool has_event(const tp_history *h, tp_tilt_event_kind kind, long facet) {
  for (size_t k = 0; k < h->event_count; k++) {
    if (h->events[k].what == kind && (facet < 0 || h->events[k].facet == facet)) return true;
  }
  return false;
}

/* On a table that tilts slowly E and F let go at the angles of the solve, slip on the facet that
 * leans down-dip, and end beside their base, fallen over (section 4.5 of the paper). */
START_TEST(blocks_e_and_f_slip_and_then_fall) {
  static const char *const texts[] = {BLOCK_E, BLOCK_F};
  const tp_drive drive = {.speed = pi / 180 / 3, .final_angle = pi / 3};
  for (int k = 0; k < 2; k++) {
    char text[1000];
    body_stage s;
    tp_history h = {0};
    tp_rigid_contact_account account;
    tp_message message = {0};
    const tp_rigid_contact_settings settings = tp_rigid_contact_settings_default();
    snprintf(text, sizeof text, "%stilt: {towards: left}\n", texts[k]);
    body_stage_init(&s, text, TP_TOWARDS_LEFT);
    const tp_run run = {.body = &s.body, .drive = &drive, .longest_s = 200, .history = &h};
    ck_assert_int_eq(tp_rigid_contact_run(NULL, &account, &run, &settings, &message),
                     TP_RUN_LEFT_BASE);
    ck_assert_msg(account.worst_balance < 1e-11, "energy off by %g", account.worst_balance);
    const double onset = s.solution->cases[0].onset.critical_angle_deg.value;
    for (size_t e = 0; e < h.event_count; e++) {
      if (h.events[e].what != TP_EVENT_COLLAPSES) continue;
      ck_assert(fabs(h.events[e].angle_deg - onset) < 1e-8);
    }
    ck_assert(has_event(&h, TP_EVENT_COLLAPSES, -1) && has_event(&h, TP_EVENT_OPENS, -1));
    ck_assert(has_event(&h, TP_EVENT_SLIPS, 1) && has_event(&h, TP_EVENT_SLIPS, 2));
    tp_history_clear(&h);
    body_stage_clear(&s);
  }
}
END_TEST

/* At 95 % of its limit a block does not creep: it is where it was, to the last bit. */
START_TEST(block_at_rest_does_not_creep) {
  body_stage s;
  tp_body_state last;
  tp_message message = {0};
  body_stage_init(&s, BLOCK_A "tilt: {towards: left}\n", TP_TOWARDS_LEFT);
  const double limit = s.solution->cases[0].onset.critical_angle_deg.value * pi / 180;
  const tp_drive drive = {.speed = 0.95 * limit / 60, .final_angle = 0.95 * limit};
  const tp_run run = {.body = &s.body, .drive = &drive, .longest_s = 120};
  const tp_rigid_contact_settings settings = tp_rigid_contact_settings_default();
  ck_assert_int_eq(tp_rigid_contact_run(&last, NULL, &run, &settings, &message), TP_RUN_STANDS);
  ck_assert(last.moved.x == 0 && last.moved.y == 0 && last.turned == 0);
  body_stage_clear(&s);
}
END_TEST

/* ---- impacts ---- */

enum { IMPACTS = 5000, MOST_CONTACTS = 6 };

static double between(random_numbers *numbers, double low, double high) {
  return low + (high - low) * draw_part(numbers);
}

/* A block with up to six contacts in any places, some of which close. */
static void draw_contacts(tp_touching *t, tp_contact_system *system, tp_motion_state *state,
                          random_numbers *numbers) {
  system->inertia[0] = system->inertia[1] = 1;
  system->inertia[2] = between(numbers, 0.05, 0.6);
  for (int e = 0; e < 3; e++) state->speed[e] = between(numbers, -1, 1);
  const long count = 1 + draw_below(numbers, MOST_CONTACTS);
  t->count = 0;
  for (long k = 0; k < count; k++) {
    tp_touching_contact *own = t->items + t->count;
    const double turn = between(numbers, -0.8, 0.8) + pi / 2;
    const double x = between(numbers, -1, 1), y = between(numbers, -1, 0);
    const tp_xy n = {cos(turn), sin(turn)}, at = {n.y, -n.x};
    *own = (tp_touching_contact){.gap = {.across = {n.x, n.y, x * n.y - y * n.x},
                                         .along = {at.x, at.y, x * at.y - y * at.x}},
                                 .friction = between(numbers, 0, 3)};
    own->approach = tp_gap_speed(own->gap.across, state->speed);
    own->slip = tp_gap_speed(own->gap.along, state->speed);
    t->count++;
  }
}

START_TEST(no_impact_gains_energy_or_presses_bodies_into_each_other) {
  tp_touching_contact items[MOST_CONTACTS];
  tp_law_contact law[MOST_CONTACTS];
  long of_law[MOST_CONTACTS];
  tp_touching touching = {.items = items, .law = law, .of_law = of_law, .room = MOST_CONTACTS};
  tp_contact_system system = {0};
  random_numbers numbers = random_numbers_from(18);
  int lowered = 0, bounced = 0;
  for (int k = 0; k < IMPACTS; k++) {
    tp_motion_state state = {0};
    tp_impact impact;
    const double restitution = k % 2 == 0 ? 0 : between(&numbers, 0, 1);
    draw_contacts(&touching, &system, &state, &numbers);
    ck_assert_msg(tp_impact_find(&impact, &touching, &system, &state, restitution),
                  "impact %d has no solution", k);
    const double before = tp_motion_energy(&system, state.speed);
    const double after = tp_motion_energy(&system, impact.speed);
    ck_assert_msg(after <= before * (1 + 1e-11), "impact %d: energy from %g to %g", k, before,
                  after);
    for (long c = 0; c < touching.count; c++) {
      const double leaves = tp_gap_speed(items[c].gap.across, impact.speed);
      ck_assert_msg(leaves > fmax(0, -impact.restitution * items[c].approach) - 1e-9,
                    "impact %d: contact %ld goes in with %g", k, c, leaves);
    }
    /* the change of momentum is a sum of impulses within the cones, by least squares */
    tp_law cones = tp_touching_impact(&touching, &system, &state, 0);
    for (int e = 0; e < 3; e++) cones.free[e] = state.speed[e] - impact.speed[e];
    double factors[2 * MOST_CONTACTS], size = 0;
    for (int e = 0; e < 3; e++) size += fabs(cones.free[e]);
    ck_assert_msg(size < 1e-12 || tp_rest_forces(factors, &cones), "impact %d: no such impulses",
                  k);
    lowered += impact.restitution < restitution;
    bounced += restitution > 0 && impact.restitution == restitution;
  }
  /* both kinds are met */
  ck_assert_int_gt(lowered, IMPACTS / 1000);
  ck_assert_int_gt(bounced, IMPACTS / 4);
}
END_TEST

SUITE(rigid_contact_modes) {
  Suite *suite = suite_create("modes of rigid contact");
  TCase *tests = tcase_create("modes");
  tcase_set_timeout(tests, 300);
  tcase_add_loop_test(tests, motions_from_rest_are_those_of_the_solve, 0, SCENES);
  tcase_add_loop_test(tests, window_is_that_of_the_solve, 0, SCENES);
  tcase_add_loop_test(tests, table_lets_go_at_the_onset_of_the_solve, 0, SCENES);
  tcase_add_test(tests, slab_turns_or_slips_as_the_dynamic_border_says);
  tcase_add_test(tests, blocks_e_and_f_slip_and_then_fall);
  tcase_add_test(tests, block_at_rest_does_not_creep);
  tcase_add_test(tests, no_impact_gains_energy_or_presses_bodies_into_each_other);
  suite_add_tcase(suite, tests);
  return suite;
}
