/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The quasi-static path against closed forms of a slab, Table 3's blocks against what the solve
 * proves, and a block whose collapse depends on what was locked in before. */

#include "body_stage.h"
#include "quasi_static/path.h"
#include "suite.h"

#include <float.h>
#include <glob.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* 1 m wide, 3 m high, 1 m thick; N and Pa/m. */
#define SLAB(friction)                                                                             \
  "topple: 1\nlength_unit: m\nfriction_angle_deg: " #friction                                      \
  "\nblock: {outline: [[0, 0], [1, 0], [1, 3], [0, 3]], unit_weight_kn_m3: 20}\n"
static const double width = 1, height = 3, weight = 60000, stiffness = 1e10, ratio = 0.01;

static double degree;
static tp_message message;

static tp_path_settings slab_settings(void) {
  tp_path_settings settings = tp_path_settings_default();
  settings.normal_pa_m = stiffness;
  settings.shear_pa_m = ratio * stiffness;
  return settings;
}

static tp_path_result follow(const tp_rigid_body *body, const tp_path_settings *settings,
                             tp_history *history) {
  tp_path_result result;
  ck_assert_msg(tp_path_run(&result, body, settings, history, &message) == TP_OK, "%s",
                message.text);
  return result;
}

static void near_to(double value, double expected, double within, const char *what) {
  ck_assert_msg(fabs(value - expected) <= within, "%s: %.15g, not %.15g", what, value, expected);
}

static const tp_tilt_event *event_of(const tp_history *h, tp_tilt_event_kind kind) {
  for (size_t k = 0; k < h->event_count; k++) {
    if (h->events[k].what == kind) return h->events + k;
  }
  ck_abort_msg("no event %d", (int)kind);
}

/* Navier's stress: the joint opens where the resultant leaves the middle third; then it is closed
 * along three times the distance of the resultant from the toe. */
START_TEST(slab_opens_and_turns_as_navier_says) {
  body_stage s;
  tp_history h = {0};
  body_stage_init(&s, SLAB(30), TP_TOWARDS_LEFT);
  const tp_path_settings settings = slab_settings();
  const tp_path_result r = follow(&s.body, &settings, &h);
  const double limit = atan(width / height);
  ck_assert(r.end == TP_RUN_MOVES && r.stood && r.jumps == 0);
  ck_assert(r.stands_to <= limit + 1e-13 && r.collapses_at >= limit);
  ck_assert(r.collapses_at - r.stands_to <= settings.tolerance);
  ck_assert(r.motion.mechanism == TP_TOPPLES && r.motion.turning_m > 0);
  near_to(r.motion.centre.x + s.body.origin.x, 0, 1e-15, "toe");
  near_to(r.closure_m, weight / stiffness, 1e-20, "closure");
  const tp_tilt_event *opens = event_of(&h, TP_EVENT_OPENS);
  near_to(opens->angle_deg, atan(width / (3 * height)) / degree, 2e-6, "it opens");
  ck_assert(opens->x_m == 1 && opens->facet == 1);
  for (size_t k = 0; k < h.moment_count; k++) {
    const tp_tilt_moment *m = h.moments + k;
    const double tilt = m->angle_deg * degree, normal = weight * cos(tilt);
    const double off = height / 2 * tan(tilt), closed = fmin(width, 3 * (width / 2 - off));
    const double turn = closed < width ? 2 * normal / (stiffness * closed * closed)
                                       : 12 * normal * off / (stiffness * pow(width, 3));
    /* what is closed is a difference of widths: rounded, and squared in the turn */
    const double rounded = 2 * 8 * DBL_EPSILON * width / closed;
    near_to(m->turned_deg * degree, turn, (1e-9 + rounded) * turn + 1e-20, "turn");
    near_to(h.reactions[k].normal_n, normal, 1e-8, "normal force");
    near_to(h.reactions[k].shear_n, weight * sin(tilt), 1e-8, "shear force");
  }
  ck_assert_int_gt(h.moment_count, 36);
  tp_history_clear(&h);
  body_stage_clear(&s);
}
END_TEST

START_TEST(slab_slides_at_its_friction_angle) {
  body_stage s;
  body_stage_init(&s, SLAB(10), TP_TOWARDS_RIGHT);
  const tp_path_settings settings = slab_settings();
  const tp_path_result r = follow(&s.body, &settings, NULL);
  ck_assert(r.end == TP_RUN_MOVES && r.motion.mechanism == TP_SLIDES && !r.motion.has_centre);
  near_to(r.motion.direction.x, 1, 1e-9, "down-dip is to the right");
  near_to(r.collapses_at / degree, 10, 1.5e-6, "friction angle");
  ck_assert(r.stands_to <= 10 * degree * (1 + 1e-12));
  body_stage_clear(&s);
}
END_TEST

/* With the closed length l the block has turned by 2 N / (k l^2) about its toe, sheared by
 * T / (k_s l) and sunk by k's closure; its weight acts where that has brought it. No tilt above
 * the largest, over all l, has an equilibrium. */
static double tilt_with_closed(double closed, double normal_stiffness) {
  double tilt = atan(width / height);
  for (int k = 0; k < 200; k++) {
    const double normal = weight * cos(tilt),
                 turn = 2 * normal / (normal_stiffness * closed * closed);
    const double shear = weight * sin(tilt) / (ratio * normal_stiffness * closed);
    const double x = width / 2 - turn * height / 2 - shear,
                 y = height / 2 + turn * width / 2 - turn * closed;
    tilt = atan((x - closed / 3) / y);
  }
  return tilt;
}

static double largest_tilt(double normal_stiffness) {
  double low = 1e-6, high = width;
  for (int k = 0; k < 200; k++) {
    const double a = low + (high - low) / 3, b = high - (high - low) / 3;
    if (tilt_with_closed(a, normal_stiffness) < tilt_with_closed(b, normal_stiffness)) {
      low = a;
    } else {
      high = b;
    }
  }
  return tilt_with_closed(low, normal_stiffness);
}

START_TEST(soft_springs_let_the_slab_fall_sooner) {
  body_stage s;
  body_stage_init(&s, SLAB(30), TP_TOWARDS_LEFT);
  double last = 0;
  for (double k = 1e9; k < 2e15; k *= 1000) {
    tp_path_settings settings = slab_settings();
    settings.normal_pa_m = k;
    settings.shear_pa_m = ratio * k;
    settings.asks_softening = true;
    const tp_path_result r = follow(&s.body, &settings, NULL);
    near_to(r.collapses_at, atan(width / height), 2 * settings.tolerance, "limit of stiff springs");
    ck_assert(r.has_softening);
    near_to(r.collapses_at - r.softening, largest_tilt(k), 3 * settings.tolerance, "soft springs");
    if (last > 0) near_to(last / r.softening, 10, 3, "the cube root of the stiffness");
    last = r.softening;
  }
  body_stage_clear(&s);
}
END_TEST

/* All blocks of the examples for which onset and limit are one, those of Table 3 among them, from
 * level and set down, with two ratios of stiffness. */
static long compare_limit(const char *path, tp_direction towards) {
  static char text[20000];
  FILE *file = fopen(path, "r");
  ck_assert_ptr_nonnull(file);
  text[fread(text, 1, sizeof text - 1, file)] = 0;
  fclose(file);
  body_stage s;
  long compared = 0;
  body_stage_init(&s, text, towards);
  for (size_t c = 0; c < s.solution->case_count; c++) {
    const tp_case *own = s.solution->cases + c;
    if (own->towards != towards || own->onset.kind != TP_ONSET_AT_ANGLE || own->onset.below_limit ||
        own->limit.critical_angle_deg.value <= 0) {
      continue;
    }
    const double limit = own->limit.critical_angle_deg.value * degree;
    for (int k = 0; k < 4; k++) {
      tp_path_settings settings = tp_path_settings_default();
      if (k % 2 == 1) settings.shear_pa_m = settings.normal_pa_m;
      if (k / 2 == 1) settings.from_angle = limit * 0.9;
      const tp_path_result r = follow(&s.body, &settings, NULL);
      ck_assert_msg(r.end == TP_RUN_MOVES, "%s: %d", path, (int)r.end);
      near_to(r.collapses_at, limit, 2 * settings.tolerance, path);
      ck_assert_msg(r.stands_to <= limit + 1e-11, "%s", path);
      ck_assert_msg(r.motion.mechanism == own->limit.mechanism || own->limit.tie, "%s", path);
      compared++;
    }
  }
  body_stage_clear(&s);
  return compared;
}

START_TEST(blocks_of_table_3_collapse_at_their_limit) {
  glob_t found;
  long compared = 0;
  ck_assert_int_eq(glob(TP_EXAMPLES "/block_[a-g]_*.yaml", 0, NULL, &found), 0);
  ck_assert_int_eq(glob(TP_EXAMPLES "/block_[cdfg].yaml", GLOB_APPEND, NULL, &found), 0);
  for (size_t k = 0; k < found.gl_pathc; k++) {
    if (strstr(found.gl_pathv[k], "shifted") != NULL || strstr(found.gl_pathv[k], "_wkt") != NULL) {
      continue; /* of another window; named by a drawing */
    }
    compared += compare_limit(found.gl_pathv[k], TP_TOWARDS_LEFT);
    compared += compare_limit(found.gl_pathv[k], TP_TOWARDS_RIGHT);
  }
  globfree(&found);
  ck_assert_int_ge(compared, 4 * 14);
}
END_TEST

/* The block of docs/mechanics.md section 6a: onset 19.453 degrees, limit 25.091. */
#define BETWEEN                                                                                    \
  "topple: 1\nlength_unit: m\nfriction_angle_deg: 61.36\nblock: {outline: [[0, 1.123], [0.588, "   \
  "0.901], [1.536, -0.465], [0.967, 4.599], [-0.569, 4.599]], unit_weight_kn_m3: 25}\nbase: "      \
  "{profile: [[0, 1.123], [0.588, 0.901], [1.536, -0.465]]}\n"

/* A normal force N at a third of the share c of a facet's length from its beginning, where it is
 * closed, and a shear force T. */
static tp_path_traction locked(double normal, double shear, double length) {
  const double c = 0.02, peak = 2 * normal / (c * length);
  return (tp_path_traction){peak, peak * (1 - 1 / c), shear / (c * length)};
}

/* Forces in balance with the weight at 21 degrees, both less than 90 % of what friction allows: by
 * the three equations of balance, and least in their ratio to it. */
START_TEST(locked_stress_holds_a_block_that_falls_without_it) {
  body_stage s;
  body_stage_init(&s, BETWEEN, TP_TOWARDS_LEFT);
  const double onset = s.solution->cases[0].onset.critical_angle_deg.value,
               limit = s.solution->cases[0].limit.critical_angle_deg.value;
  const tp_path_traction tractions[] = {
      locked(158417.20792173, -257135.42562353, hypot(0.588, 0.222)),
      locked(135467.63476578, 219892.61979452, hypot(0.948, 1.366))};
  double held[2];
  for (int k = 0; k < 2; k++) {
    tp_path_settings settings = tp_path_settings_default();
    if (k == 1) settings.shear_pa_m = settings.normal_pa_m;
    const tp_path_result level = follow(&s.body, &settings, NULL);
    near_to(level.collapses_at / degree, onset, 2e-6, "placed level");
    settings.from_angle = 21 * degree;
    ck_assert(!follow(&s.body, &settings, NULL).stood);
    settings.tractions = tractions;
    const tp_path_result own = follow(&s.body, &settings, NULL);
    ck_assert(own.stood && own.end == TP_RUN_MOVES);
    ck_assert(own.stands_to / degree > 22 && own.collapses_at / degree < limit);
    held[k] = own.collapses_at / degree;
  }
  ck_assert_msg(fabs(held[0] - held[1]) > 0.1, "the ratio of the stiffnesses decides here");
  body_stage_clear(&s);
}
END_TEST

START_TEST(bad_settings_are_refused) {
  static const struct {
    const char *says;
    double normal, shear, from, to, tolerance;
  } bad[] = {{"stiffness of the contact above 0", 0, 1, 0, 1, 1e-8},
             {"stiffness of the contact above 0", 1e12, -1, 0, 1, 1e-8},
             {"stiffness of the contact above 0", 1e12, NAN, 0, 1, 1e-8},
             {"not less, below 90 degrees", 1e12, 1e12, 1, 0.5, 1e-8},
             {"not less, below 90 degrees", 1e12, 1e12, 0, 1.6, 1e-8},
             {"at least 1e-10", 1e12, 1e12, 0, 1, 0},
             {"must be 3.79e+06 Pa/m or more", 1e5, 1e12, 0, 1, 1e-8}};
  body_stage s;
  body_stage_init(&s, SLAB(30), TP_TOWARDS_LEFT);
  for (size_t k = 0; k < sizeof bad / sizeof *bad; k++) {
    tp_path_settings settings = tp_path_settings_default();
    tp_path_result result = {.jumps = 77};
    settings.normal_pa_m = bad[k].normal;
    settings.shear_pa_m = bad[k].shear;
    settings.from_angle = bad[k].from;
    settings.to_angle = bad[k].to;
    settings.tolerance = bad[k].tolerance;
    ck_assert_int_eq(tp_path_run(&result, &s.body, &settings, NULL, &message), TP_BAD_INPUT);
    ck_assert_msg(strstr(message.text, bad[k].says) != NULL, "%s", message.text);
    ck_assert_int_eq(result.jumps, 77);
  }
  tp_path_settings settings = tp_path_settings_default();
  tp_path_result result;
  settings.tractions = &(tp_path_traction){NAN, 1, 1};
  ck_assert_int_eq(tp_path_run(&result, &s.body, &settings, NULL, &message), TP_BAD_INPUT);
  ck_assert_ptr_nonnull(strstr(message.text, "must be finite"));
  body_stage_clear(&s);
}
END_TEST

SUITE(path) {
  degree = acos(-1) / 180;
  Suite *suite = suite_create("path");
  TCase *cases = tcase_create("path");
  tcase_set_timeout(cases, 0);
  tcase_add_test(cases, slab_opens_and_turns_as_navier_says);
  tcase_add_test(cases, slab_slides_at_its_friction_angle);
  tcase_add_test(cases, soft_springs_let_the_slab_fall_sooner);
  tcase_add_test(cases, blocks_of_table_3_collapse_at_their_limit);
  tcase_add_test(cases, locked_stress_holds_a_block_that_falls_without_it);
  tcase_add_test(cases, bad_settings_are_refused);
  suite_add_tcase(suite, cases);
  return suite;
}
