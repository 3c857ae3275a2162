/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What is asked of scenes in which numbers are others: back-analysis and maps of a scene in memory
 * are those of the file that says the same, formulas are of the numbers that it has now, and
 * threads vary one scene each for itself. */

#include "varied_scene.h"

#include <pthread.h>
#include <stdio.h>
#include <string.h>

static char *found(const tp_scene *scene, const char *key, tp_find_target target, double value) {
  tp_find_options options = tp_find_options_default();
  tp_found *own = NULL;
  tp_solution *solution = NULL;
  const tp_solve_options solve_options = tp_solve_options_default();
  char *json = NULL;
  options.key = key;
  options.target = target;
  options.value = value;
  options.has_low = true;
  options.low = 0.5;
  DO(tp_find(&own, scene, &options, &message));
  ck_assert_uint_eq(own->count, 1);
  DO(tp_solve(&solution, scene, &solve_options, &message));
  DO(tp_report_found_json(&json, own, solution));
  char *effects = strstr(json, "\"effects\""), *rest = strstr(json, "\"find\"");
  ck_assert(effects != NULL && rest != NULL && effects < rest); /* with their times */
  memmove(effects, rest, strlen(rest) + 1);
  tp_found_free(own);
  tp_solution_free(solution);
  return json;
}

static char *map(const tp_scene *scene, const char *key, tp_chart_range range) {
  tp_chart_map_options options = tp_chart_map_options_default();
  tp_chart *chart = NULL;
  char *json = NULL;
  options.scene = scene;
  options.x = (tp_chart_axis){key, range};
  DO(tp_chart_map(&chart, &options, &message));
  DO(tp_report_chart_json(&json, chart));
  tp_chart_free(chart);
  return json;
}

START_TEST(found_and_drawn) {
  tp_scene *built = slab(3);
  tp_scene *file = read_text(HEAD "block: {outline: [[0, 0], [3, 0], [3, 6], [0, 6]]}\n" REST);
  static const struct {
    const char *key;
    tp_find_target target;
    double value;
  } wanted[] = {{"block.outline.3.2", TP_FIND_CRITICAL_ANGLE, 25},
                {"block.outline.2.1", TP_FIND_FOS, 2},
                {"friction_angle_deg", TP_FIND_LIMIT_ANGLE, 20},
                {"friction_angle_deg", TP_FIND_SLIDING_FOS, 3},
                {"tilt.angle_deg", TP_FIND_FOS, 2}};
  for (size_t k = 0; k < sizeof wanted / sizeof wanted[0]; k++) {
    expect_equal(found(built, wanted[k].key, wanted[k].target, wanted[k].value),
                 found(file, wanted[k].key, wanted[k].target, wanted[k].value));
  }
  expect_equal(map(built, "block.outline.3.2", (tp_chart_range){2, 12}),
               map(file, "block.outline.3.2", (tp_chart_range){2, 12}));
  expect_equal(map(built, "friction_angle_deg", (tp_chart_range){10, 50}),
               map(file, "friction_angle_deg", (tp_chart_range){10, 50}));
  tp_find_options options = tp_find_options_default();
  tp_found *none = NULL;
  options.key = "friction_angle_deg"; /* moments do not depend on it */
  options.value = 20;
  char why[2][sizeof message.text];
  ck_assert_int_eq(tp_find(&none, built, &options, &message), TP_NO_ANSWER);
  snprintf(why[0], sizeof why[0], "%s", strstr(message.text, "critical_angle"));
  ck_assert_int_eq(tp_find(&none, file, &options, &message), TP_NO_ANSWER);
  snprintf(why[1], sizeof why[1], "%s", strstr(message.text, "critical_angle"));
  ck_assert_str_eq(why[0], why[1]);
  tp_scene_free(built);
  tp_scene_free(file);
}
END_TEST

/* Formulas are of the numbers that the scene has now. */
START_TEST(derived) {
  static const char *const keys[] = {"block.slab.width", "b"};
  const tp_exact values[] = {T("7/2"), T("9")};
  tp_scene *scenes[2] = {NULL}, *file = read_text(HEAD "parameters: {a: 3, b: 2*a}\nblock: {slab: "
                                                       "{width: a, height: b}}\n" REST);
  char *texts[2] = {NULL};
  DO(tp_scene_with_numbers(scenes, file, keys, values, 2, &message));
  scenes[1] =
      read_text(HEAD "parameters: {a: 3, b: 9}\nblock: {slab: {width: 7/2, height: b}}\n" REST);
  const tp_derive_options options = tp_derive_options_default();
  for (int k = 0; k < 2; k++) {
    tp_derivation *derivation = NULL;
    DO(tp_derive(&derivation, scenes[k], &options, &message));
    DO(tp_report_derivation_json(&texts[k], derivation));
    tp_derivation_free(derivation);
    tp_scene_free(scenes[k]);
  }
  expect_equal(texts[0], texts[1]);
  tp_scene_free(file);
}
END_TEST

enum { THREADS = 8, TIMES = 20 };

typedef struct task {
  const tp_scene *scene;
  const char *key;
  double from;
  double angles[TIMES];
  bool done;
} task;

static void *sweep(void *context) {
  task *own = context;
  own->done = true;
  for (int k = 0; k < TIMES && own->done; k++) {
    tp_scene *varied = NULL;
    tp_solution *solution = NULL;
    tp_message why;
    const tp_solve_options options = tp_solve_options_default();
    own->done =
        tp_scene_with(&varied, own->scene, own->key, E(own->from + k / 8.0), &why) == TP_OK &&
        tp_solve(&solution, varied, &options, &why) == TP_OK;
    if (own->done) own->angles[k] = solution->cases[0].limit.critical_angle_deg.value;
    tp_solution_free(solution);
    tp_scene_free(varied);
  }
  return NULL;
}

/* Each has its own numbers of one scene, and what it finds is what it finds alone. */
static void expect_threads(const tp_scene *scene, const char *key) {
  task tasks[THREADS], alone;
  pthread_t threads[THREADS];
  for (int k = 0; k < THREADS; k++) {
    tasks[k] = (task){.scene = scene, .key = key, .from = 2 + k};
    ck_assert_int_eq(pthread_create(threads + k, NULL, sweep, tasks + k), 0);
  }
  for (int k = 0; k < THREADS; k++) ck_assert_int_eq(pthread_join(threads[k], NULL), 0);
  for (int k = 0; k < THREADS; k++) {
    alone = (task){.scene = scene, .key = key, .from = 2 + k};
    sweep(&alone);
    ck_assert(alone.done && tasks[k].done);
    ck_assert_mem_eq(alone.angles, tasks[k].angles, sizeof alone.angles);
  }
}

START_TEST(threads) {
  tp_scene *built = slab(3);
  tp_scene *file = read_text(HEAD PARAMETERS("3", "2*a", "1/a") RING REST);
  expect_threads(built, "block.outline.3.2");
  expect_threads(built, "friction_angle_deg");
  expect_threads(file, "a");
  expect_threads(file, "friction_angle_deg");
  tp_scene_free(built);
  tp_scene_free(file);
}
END_TEST

SUITE(vary_found) {
  Suite *suite = suite_create("vary_found");
  TCase *tests = tcase_create("scenes");
  tcase_set_timeout(tests, 0);
  tcase_add_test(tests, found_and_drawn);
  tcase_add_test(tests, derived);
  tcase_add_test(tests, threads);
  suite_add_tcase(suite, tests);
  return suite;
}
