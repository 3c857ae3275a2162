/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What is made of the answers of a test over its settings, by levels that are made up: when they
 * agree, from which on, and what is told of all together. */

#include "suite.h"
#include "tilt/converge.h"

#include <math.h>
#include <string.h>

/* A made-up setting: brackets of 0.01 about these answers, its values halving. */
typedef struct made_up {
  tp_converge_level levels[TP_CONVERGE_MOST_LEVELS];
  tp_converge_finding finding;
} made_up;

static made_up make(tp_converge_setting setting, size_t count, size_t own, const double answers[]) {
  made_up m = {.finding = {.setting = setting, .first = 0, .count = count}};
  for (size_t k = 0; k < count; k++) {
    m.levels[k] = (tp_converge_level){.setting = setting,
                                      .value = ldexp(1, -(int)k),
                                      .own = k == own,
                                      .known = true,
                                      .bracket_least = answers[k] - 0.005,
                                      .bracket_most = answers[k] + 0.005};
  }
  return m;
}

static tp_converge_finding judged(made_up m, double asked) {
  tp_converge_judge(&m.finding, m.levels, asked);
  return m.finding;
}

/* Answers of 20, 19, 18.98, 18.97: to 0.05 the second does, and all finer ones. */
START_TEST(holds_refined_or_depends) {
  static const double answers[] = {20, 19, 18.98, 18.97};
  tp_converge_finding f = judged(make(TP_CONVERGE_TIME_STEP, 4, 1, answers), 0.05);
  ck_assert_int_eq(f.verdict, TP_CONVERGE_HOLDS);
  ck_assert(f.has_needed && f.needed == 0.5);
  ck_assert_double_eq_tol(f.spread, 0.04, 1e-12); /* 19.005 to 18.965 */
  f = judged(make(TP_CONVERGE_TIME_STEP, 4, 0, answers), 0.05);
  ck_assert_int_eq(f.verdict, TP_CONVERGE_REFINED);
  ck_assert(f.has_needed && f.needed == 0.5);
  f = judged(make(TP_CONVERGE_TIME_STEP, 4, 0, answers), 2);
  ck_assert_int_eq(f.verdict, TP_CONVERGE_HOLDS);
  ck_assert_double_eq_tol(f.spread, 1.04, 1e-12);
  f = judged(make(TP_CONVERGE_TIME_STEP, 4, 1, answers), 0.015);
  ck_assert_int_eq(f.verdict, TP_CONVERGE_DEPENDS); /* the last two: 18.985 to 18.965 */
  ck_assert(!f.has_needed);
  ck_assert_double_eq_tol(f.spread, 0.02, 1e-12);
}
END_TEST

/* An answer that comes back agrees with none in between: each must with all that are finer. */
START_TEST(what_wanders_does_not_hold) {
  static const double answers[] = {20, 19, 20, 20};
  const tp_converge_finding f = judged(make(TP_CONVERGE_DAMPING, 4, 0, answers), 0.05);
  ck_assert_int_eq(f.verdict, TP_CONVERGE_REFINED);
  ck_assert(f.needed == 0.25);
}
END_TEST

/* A ratio of stiffnesses has no finer values: one that differs is enough. */
START_TEST(ratios_must_all_agree) {
  static const double answers[] = {20, 20, 20.2}, same[] = {20, 20.01, 20};
  ck_assert_int_eq(judged(make(TP_CONVERGE_STIFFNESS_RATIO, 3, 1, answers), 0.05).verdict,
                   TP_CONVERGE_DEPENDS);
  const tp_converge_finding f = judged(make(TP_CONVERGE_STIFFNESS_RATIO, 3, 1, same), 0.05);
  ck_assert_int_eq(f.verdict, TP_CONVERGE_HOLDS);
  ck_assert(!f.has_needed);
}
END_TEST

/* Of brackets whose width is varied only a gap between them counts. */
START_TEST(widths_agree_where_brackets_meet) {
  static const double answers[] = {20, 20.004, 20.004};
  made_up m = make(TP_CONVERGE_TOLERANCE, 3, 1, answers);
  m.levels[0].bracket_least = 15;
  m.levels[0].bracket_most = 25;
  ck_assert_double_eq(judged(m, 0.001).spread, 0);
  ck_assert_int_eq(judged(m, 0.001).verdict, TP_CONVERGE_HOLDS);
  m.levels[2].bracket_least = 20.5;
  m.levels[2].bracket_most = 20.6;
  ck_assert_int_eq(judged(m, 0.001).verdict, TP_CONVERGE_DEPENDS);
  ck_assert_double_eq_tol(judged(m, 0.001).spread, 20.5 - 20.009, 1e-12);
}
END_TEST

START_TEST(what_is_not_known_is_undecided) {
  static const double answers[] = {20, 20, 20};
  made_up m = make(TP_CONVERGE_ROUNDING, 3, 1, answers);
  m.levels[2].known = false;
  ck_assert_int_eq(judged(m, 1).verdict, TP_CONVERGE_OPEN);
  ck_assert(!tp_converge_settled(m.levels, 3, 1));
}
END_TEST

/* Finer levels are run until the last two agree, from the scene's own on, but of what has none. */
START_TEST(finer_levels_are_run_until_two_agree) {
  static const double answers[] = {20, 20, 21, 21};
  const made_up m = make(TP_CONVERGE_STIFFNESS, 4, 1, answers);
  ck_assert(!tp_converge_settled(m.levels, 1, 0.05));
  ck_assert(
      !tp_converge_settled(m.levels, 2, 0.05)); /* these agree, and none is finer than its own */
  ck_assert(!tp_converge_settled(m.levels, 3, 0.05));
  ck_assert(tp_converge_settled(m.levels, 4, 0.05));
  const made_up ratios = make(TP_CONVERGE_STIFFNESS_RATIO, 4, 1, answers);
  ck_assert(!tp_converge_settled(ratios.levels, 4, 0.05));
}
END_TEST

/* All together: its own answer and the finest ones; after a refinement those alone. */
START_TEST(the_answer_over_all_settings) {
  tp_converge_level levels[] = {
      {.setting = TP_CONVERGE_STIFFNESS, .known = true, .bracket_least = 19, .bracket_most = 19.1},
      {.setting = TP_CONVERGE_STIFFNESS,
       .known = true,
       .bracket_least = 19.5,
       .bracket_most = 19.6},
      {.setting = TP_CONVERGE_DAMPING, .known = true, .bracket_least = 19.4, .bracket_most = 19.5},
      {.setting = TP_CONVERGE_DAMPING,
       .known = true,
       .bracket_least = 19.55,
       .bracket_most = 19.65}};
  tp_converge_finding findings[] = {
      {.setting = TP_CONVERGE_STIFFNESS, .verdict = TP_CONVERGE_HOLDS, .first = 0, .count = 2},
      {.setting = TP_CONVERGE_DAMPING, .verdict = TP_CONVERGE_HOLDS, .first = 2, .count = 2}};
  tp_tilt_convergence_case own = {.known = true,
                                  .as_set_least = 18.9,
                                  .as_set_most = 19,
                                  .setting_count = 2,
                                  .settings = findings,
                                  .level_count = 4,
                                  .levels = levels};
  tp_converge_summarise(&own);
  ck_assert(own.converged && own.over_settings_least == 18.9 && own.over_settings_most == 19.65);
  findings[0].verdict = TP_CONVERGE_REFINED;
  tp_converge_summarise(&own);
  ck_assert(own.converged && own.over_settings_least == 19.5 && own.over_settings_most == 19.65);
  findings[1].verdict = TP_CONVERGE_DEPENDS;
  tp_converge_summarise(&own);
  ck_assert(!own.converged);
}
END_TEST

SUITE(tilt_converge) {
  Suite *suite = suite_create("tilt over its settings");
  TCase *tests = tcase_create("tilt over its settings");
  tcase_add_test(tests, holds_refined_or_depends);
  tcase_add_test(tests, what_wanders_does_not_hold);
  tcase_add_test(tests, ratios_must_all_agree);
  tcase_add_test(tests, widths_agree_where_brackets_meet);
  tcase_add_test(tests, what_is_not_known_is_undecided);
  tcase_add_test(tests, finer_levels_are_run_until_two_agree);
  tcase_add_test(tests, the_answer_over_all_settings);
  suite_add_tcase(suite, tests);
  return suite;
}
