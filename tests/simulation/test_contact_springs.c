/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* When a block on contact springs begins to move: against closed forms of slabs, and for the
 * paper's blocks against the static limit and the onset of motion that the solve proves, which are
 * one number for them; that what stands does not creep; what is refused. */

#include "springs_stage.h"
#include "suite.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A slab slides from the friction angle on, and topples from the one of its diagonal. */
START_TEST(slabs_let_go_at_their_closed_angles) {
  const tp_spring_settings springs = paper_springs();
  body_stage s;
  body_stage_init(&s, SLAB("30", "1", LEVEL), TP_TOWARDS_LEFT);
  ck_assert_int_eq(springs_at(&s.body, 29.999, &springs), TP_RUN_STANDS);
  ck_assert_int_eq(springs_at(&s.body, 30.001, &springs), TP_RUN_MOVES);
  body_stage_clear(&s);
  body_stage_init(&s, SLAB("45", "3", LEVEL), TP_TOWARDS_RIGHT);
  const double diagonal = atan(1.0 / 3) / radians(1);
  ck_assert_int_eq(springs_at(&s.body, diagonal - 0.001, &springs), TP_RUN_STANDS);
  ck_assert_int_eq(springs_at(&s.body, diagonal + 0.001, &springs), TP_RUN_MOVES);
  body_stage_clear(&s);
}
END_TEST

typedef struct paper_block {
  const char *name;
  int a, b, c, count;
  const char *left_end;
} paper_block;

static const paper_block blocks[] = {
    {"A, peak", 15, 94, 5, 3, "peak"},  {"A, valley", 15, 94, 5, 3, "valley"},
    {"B, peak", 14, 135, 5, 3, "peak"}, {"B, valley", 14, 135, 5, 3, "valley"},
    {"C", 20, 158, 7, 4, "valley"},     {"D", 20, 242, 7, 4, "peak"},
    {"E, peak", 30, 120, 5, 3, "peak"}, {"E, valley", 30, 120, 5, 3, "valley"},
    {"F", 30, 118, 5, 2, "valley"},     {"G", 30, 123, 5, 2, "peak"},
};

/* On a base that ends with the block, and on one that goes on by a tooth at both ends. Where limit
 * and onset agree, history does not matter, and the springs can only be off by what they give. */
static void check_block(const paper_block *block, bool goes_on) {
  char text[500];
  snprintf(text, sizeof text,
           "topple: 1\nlength_unit: mm\nblock:\n  teeth: {count: %d, width: %d, height: %d, depth: "
           "%d, left_end: %s}\n  thickness: 20\n  unit_weight_kn_m3: 25.8\nbase: {mated: true, "
           "beyond: {left: %d, right: %d}}\nfriction_angle_deg: 30\ntilt: {towards: left}\n",
           block->count, block->a, block->b, block->c, block->left_end, goes_on ? block->a : 0,
           goes_on ? block->a : 0);
  body_stage s;
  body_stage_init(&s, text, TP_TOWARDS_LEFT);
  const tp_case *own = s.solution->cases;
  const double limit = own->limit.critical_angle_deg.value,
               onset = own->onset.critical_angle_deg.value;
  ck_assert_msg(fabs(limit - onset) < 1e-9, "%s: history matters", block->name);
  const tp_spring_settings springs = paper_springs();
  const double angle = springs_let_go(&s.body, limit - 5, limit + 5, &springs);
  ck_assert_msg(fabs(angle - limit) < 0.05, "%s%s: %.3f, not %.3f", block->name,
                goes_on ? " on a long base" : "", angle, limit);
  body_stage_clear(&s);
}

START_TEST(papers_blocks_let_go_at_their_limit) {
  for (size_t k = 0; k < sizeof blocks / sizeof blocks[0]; k++) {
    check_block(blocks + k, false);
    check_block(blocks + k, true);
  }
}
END_TEST

/* Arcs meet the flat of an ellipse in corners: nothing but the flat bears it. */
START_TEST(ellipse_lets_go_at_its_limit) {
  body_stage s;
  body_stage_init(&s,
                  "topple: 1\nlength_unit: m\nblock: {ellipse: {width: 8, height: 3, flat: 1.8}, "
                  "unit_weight_kn_m3: 26}\nbase: {mated: true, beyond: {left: 2, right: 2}}\n"
                  "friction_angle_deg: 35\ntilt: {towards: left}\n",
                  TP_TOWARDS_LEFT);
  const double limit = s.solution->cases->limit.critical_angle_deg.value;
  const tp_spring_settings springs = paper_springs();
  ck_assert_int_eq(springs_at(&s.body, 0, &springs), TP_RUN_STANDS);
  ck_assert_int_eq(springs_at(&s.body, limit - 0.05, &springs), TP_RUN_STANDS);
  ck_assert_int_eq(springs_at(&s.body, limit + 0.05, &springs), TP_RUN_MOVES);
  body_stage_clear(&s);
}
END_TEST

/* Nothing shakes, but the run may not end before the time that is told as a kink. */
static void no_acceleration(double *horizontal_m_s2, double *vertical_m_s2,
                            const tp_base_motion *motion, double time_s) {
  (void)motion;
  (void)time_s;
  *horizontal_m_s2 = *vertical_m_s2 = 0;
}

static double told_time(const tp_base_motion *motion, double time_s) {
  const double *end = motion->data;
  return time_s < *end ? *end : INFINITY;
}

/* Block E towards its valley at 95 % of the tangent of its limit, where one of its facets has
 * slipped: less than 1e-9 m in 60 s. The run is one tenth as long; peers creep 50 to 2300
 * micrometres a second, which would be 0.3 mm of it. */
START_TEST(block_at_rest_does_not_creep) {
  const double end = 6;
  body_stage s;
  body_stage_init(&s,
                  "topple: 1\nlength_unit: mm\nblock:\n  teeth: {count: 3, width: 30, height: 120, "
                  "depth: 5, left_end: valley}\n  thickness: 20\n  unit_weight_kn_m3: 25.8\n"
                  "friction_angle_deg: 30\ntilt: {towards: left}\n",
                  TP_TOWARDS_LEFT);
  const double limit = radians(s.solution->cases->limit.critical_angle_deg.value);
  const tp_base_motion motion = {&end, no_acceleration, told_time};
  const tp_drive drive = {.angle = atan(0.95 * tan(limit)), .shaking = &motion};
  const tp_spring_settings springs = paper_springs();
  tp_history history = {0};
  const tp_run run = {.body = &s.body,
                      .drive = &drive,
                      .longest_s = end,
                      .moments_every_s = 0.1,
                      .history = &history};
  tp_body_state last;
  tp_message message = {.text = ""};
  ck_assert_int_eq(tp_springs_run(&last, &run, &springs, &message), TP_RUN_STANDS);
  ck_assert_uint_gt(history.moment_count, 50);
  const tp_tilt_moment *first = history.moments + 1,
                       *final = history.moments + history.moment_count - 1;
  ck_assert(first->time_s < 0.2 && final->time_s > 5.8);
  const double moved =
      hypot(final->moved_x_m - first->moved_x_m, final->moved_y_m - first->moved_y_m);
  const double turned = radians(fabs(final->turned_deg - first->turned_deg)) * s.body.extent_m;
  ck_assert_msg(moved + turned < 1e-10, "it crept %g m in %g s", moved + turned, end);
  ck_assert(fabs(final->moved_x_m) > 1e-8); /* it did settle on its springs */
  tp_history_clear(&history);
  body_stage_clear(&s);
}
END_TEST

/* What the facets push with is the weight: the sum of the reactions of block F against statics, at
 * rest. On their springs the facets have turned by some 2e-6. */
START_TEST(reactions_bear_the_weight) {
  body_stage s;
  body_stage_init(&s,
                  "topple: 1\nlength_unit: mm\nblock:\n  teeth: {count: 2, width: 30, height: 118, "
                  "depth: 5, left_end: valley}\n  thickness: 20\n  unit_weight_kn_m3: 25.8\n"
                  "friction_angle_deg: 30\ntilt: {towards: left}\n",
                  TP_TOWARDS_LEFT);
  const double tilt = radians(15), weight = s.body.mass_kg * TP_GRAVITY_M_S2;
  const tp_drive drive = {.angle = tilt};
  const tp_spring_settings springs = paper_springs();
  tp_history history = {0};
  const tp_run run = {.body = &s.body, .drive = &drive, .longest_s = 5, .history = &history};
  tp_body_state last;
  tp_message message = {.text = ""};
  ck_assert_int_eq(tp_springs_run(&last, &run, &springs, &message), TP_RUN_STANDS);
  const double slope = atan2(5, 30); /* facet 1 rises to the right, facet 2 falls */
  double x = 0, y = 0;
  ck_assert_uint_gt(history.reaction_count, 0);
  for (size_t k = 0; k < history.reaction_count; k++) {
    const tp_tilt_reaction *r = history.reactions + k;
    if (r->moment > 0) continue;
    const double up = r->facet == 1 ? slope : -slope;
    ck_assert(r->normal_n >= 0 && fabs(r->shear_n) <= tan(radians(30)) * r->normal_n * (1 + 1e-12));
    x += r->shear_n * cos(up) - r->normal_n * sin(up);
    y += r->shear_n * sin(up) + r->normal_n * cos(up);
  }
  ck_assert_msg(fabs(x - weight * sin(tilt)) < 4e-6 * weight, "along the base: %g", x);
  ck_assert_msg(fabs(y - weight * cos(tilt)) < 4e-6 * weight, "across it: %g", y);
  tp_history_clear(&history);
  body_stage_clear(&s);
}
END_TEST

static void expect_refused(const body_stage *s, tp_spring_settings settings, const char *says) {
  tp_message message = {.text = ""};
  const tp_place place = {"scene.yaml", 7, 3};
  ck_assert_int_eq(tp_springs_check(&settings, &s->body, place, &message), TP_BAD_INPUT);
  ck_assert_msg(strncmp(message.text, "scene.yaml:7:3: ", 16) == 0, "%s", message.text);
  ck_assert_msg(strstr(message.text, says) != NULL, "%s", message.text);
}

START_TEST(settings_out_of_range_are_refused) {
  body_stage s;
  body_stage_init(&s, SLAB("30", "1", LEVEL), TP_TOWARDS_LEFT);
  const tp_spring_settings good = paper_springs();
  tp_message message = {.text = ""};
  ck_assert_int_eq(tp_springs_check(&good, &s.body, (tp_place){0}, &message), TP_OK);
  static const double stiffness[] = {0, -1, NAN, INFINITY};
  for (int k = 0; k < 4; k++) {
    tp_spring_settings bad = good;
    bad.normal_pa_m = stiffness[k];
    expect_refused(&s, bad, "stiffness above zero");
    bad = good;
    bad.shear_pa_m = stiffness[k];
    expect_refused(&s, bad, "stiffness above zero");
  }
  tp_spring_settings bad = good;
  bad.damping = 1;
  expect_refused(&s, bad, "from 0 to below 1, not 1");
  bad = good;
  bad.rounding_m = 0;
  expect_refused(&s, bad, "at most 0.00707 m");
  bad = good;
  bad.time_step_s = 1.001 * tp_springs_stable_step(&good, &s.body);
  expect_refused(&s, bad, "are not stable with these springs");
  bad.time_step_s = 0.999 * tp_springs_stable_step(&good, &s.body);
  ck_assert_int_eq(tp_springs_check(&bad, &s.body, (tp_place){0}, &message), TP_OK);
  body_stage_clear(&s);
}
END_TEST

/* A slab of mass m on two springs of its half width each: the normal mode has omega^2 = k / m, the
 * rocking one k (w / 2)^2 / I; their sum and that of the shear springs bounds the highest. */
START_TEST(stable_step_is_that_of_the_springs_of_a_slab) {
  body_stage s;
  body_stage_init(&s, SLAB("30", "1", LEVEL), TP_TOWARDS_LEFT);
  const tp_spring_settings springs = paper_springs();
  const double k = (1e12 + 1e10) * 1 * 2,
               lever = 0.5; /* of both: stiffness times width times depth */
  const double square = k / s.body.mass_kg + k * 2 * lever * lever / s.body.inertia_kg_m2;
  const double step = tp_springs_stable_step(&springs, &s.body);
  ck_assert_msg(fabs(step * sqrt(square) / 2 - 1) < 1e-12, "%g", step);
  body_stage_clear(&s);
}
END_TEST

SUITE(contact_springs) {
  Suite *suite = suite_create("contact_springs");
  TCase *tests = tcase_create("letting_go");
  tcase_set_timeout(tests, 120);
  tcase_add_test(tests, slabs_let_go_at_their_closed_angles);
  tcase_add_test(tests, papers_blocks_let_go_at_their_limit);
  tcase_add_test(tests, ellipse_lets_go_at_its_limit);
  tcase_add_test(tests, block_at_rest_does_not_creep);
  tcase_add_test(tests, reactions_bear_the_weight);
  tcase_add_test(tests, settings_out_of_range_are_refused);
  tcase_add_test(tests, stable_step_is_that_of_the_springs_of_a_slab);
  suite_add_tcase(suite, tests);
  return suite;
}
