/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Threads within a call, and objects that threads hand on to each other: one solves what another
 * one made, a third reports it, a fourth frees it, and some outlive the thread that made them. A
 * program that shares its work out does that with every scene. Every byte must be the same as where
 * one thread does it alone (test_threads.c tells more). */

#include "crowd.h"
#include "sayings.h"
#include "suite.h"
#include "threads_stage.h"

#include <stdlib.h>

/* The sums of a large ring are shared by threads that the call starts. */

/* A roof of more edges than one thread sums. */
static tp_scene *build_long_roof(void) {
  enum { EDGES = 900000 };
  tp_scene *scene = NULL;
  double *xy = calloc(2 * (EDGES + 3), sizeof *xy);
  if (xy == NULL) return NULL;
  xy[2] = EDGES;
  for (int k = 0; k <= EDGES; k++) {
    xy[4 + 2 * k] = EDGES - k;
    xy[5 + 2 * k] = EDGES + k % 2;
  }
  tp_status status = tp_scene_new(&scene, "mm", NULL);
  if (status == TP_OK) status = tp_scene_set_outline(scene, tp_coordinates_of(xy, EDGES + 3), NULL);
  free(xy);
  return built(scene, status);
}

enum { SOLVES = 2 };

static const tp_scene *long_roof;

static void solve_long_roof(crowd *among, int number) {
  (void)among;
  if (number >= SOLVES) return;
  sayings *s = calloc(1, sizeof *s);
  if (s == NULL) return;
  say_solved(s, long_roof, false, 6, false);
  of_thread[number] = s;
}

/* By so many threads that the caller allows. */
static char *solved_by(const tp_scene *scene, size_t threads) {
  char *json = NULL;
  tp_solution *solution = NULL;
  tp_solve_options options = tp_solve_options_default();
  options.threads = threads;
  options.pivots = TP_PIVOTS_GOVERNING;
  ck_assert_int_eq(tp_solve(&solution, scene, &options, NULL), TP_OK);
  same_times(solution);
  ck_assert_int_eq(tp_report_json(&json, solution), TP_OK);
  tp_solution_free(solution);
  return json;
}

START_TEST(threads_within_a_call) {
  sayings alone = {0};
  tp_scene *scene = build_long_roof();
  ck_assert_ptr_nonnull(scene);
  long_roof = scene;
  run_together(solve_long_roof);
  say_solved(&alone, scene, false, 6, false);
  for (int k = 0; k < SOLVES; k++) {
    ck_assert_ptr_nonnull(of_thread[k]);
    expect_same_sayings(&alone, of_thread[k], "a long roof");
    sayings_forget(of_thread[k]);
    free(of_thread[k]);
  }
  char *by_one = solved_by(scene, 1), *by_seven = solved_by(scene, 7);
  char *by_most = solved_by(scene, SIZE_MAX); /* more than serve, as for a sweep or a study */
  ck_assert_str_eq(by_one, by_seven);
  ck_assert_str_eq(by_one, by_most);
  free(by_one);
  free(by_seven);
  free(by_most);
  sayings_forget(&alone);
  tp_scene_free(scene);
}
END_TEST

/* What one thread made, others solve, report and free: one thing at a time has one thread. */

static tp_scene *handed_scene[THREADS];
static tp_solution *handed_solution[THREADS];

static double friction_of(int number) {
  return 20 + 2.5 * number;
}

static void hand_on(crowd *among, int number) {
  const int solved = (number + 1) % THREADS, reported = (number + 2) % THREADS,
            freed = (number + 3) % THREADS;
  handed_scene[number] = build_square(friction_of(number));
  crowd_wait(among);
  handed_solution[solved] = solve_in_thread(handed_scene[solved]);
  crowd_wait(among);
  sayings *s = calloc(1, sizeof *s);
  if (s != NULL && handed_solution[reported] != NULL) say_reports(s, handed_solution[reported]);
  of_thread[reported] = s;
  crowd_wait(among);
  tp_solution_free(handed_solution[freed]);
  tp_scene_free(handed_scene[freed]);
}

START_TEST(handed_on) {
  for (int again = 0; again < 3; again++) {
    run_together(hand_on);
    for (int k = 0; k < THREADS; k++) {
      sayings alone = {0};
      tp_scene *scene = build_square(friction_of(k));
      tp_solution *solution = solve_in_thread(scene);
      ck_assert_ptr_nonnull(solution);
      say_reports(&alone, solution);
      ck_assert_ptr_nonnull(of_thread[k]);
      expect_same_sayings(&alone, of_thread[k], "handed on");
      sayings_forget(of_thread[k]);
      free(of_thread[k]);
      sayings_forget(&alone);
      tp_solution_free(solution);
      tp_scene_free(scene);
    }
  }
}
END_TEST

/* One that ends before the objects that it made. */
static void make_and_end(crowd *among, int number) {
  (void)among;
  handed_scene[number] = build_square(friction_of(number));
  handed_solution[number] = solve_in_thread(handed_scene[number]);
}

static void free_of_others(crowd *among, int number) {
  (void)among;
  tp_scene_free(handed_scene[THREADS - 1 - number]);
  tp_solution_free(handed_solution[THREADS - 1 - number]);
}

START_TEST(outlives_its_thread) {
  run_together(make_and_end);
  for (int k = 0; k < THREADS; k++) {
    sayings of_the_dead = {0}, alone = {0};
    tp_solution *solution = solve_in_thread(handed_scene[k]);
    ck_assert(solution != NULL && handed_solution[k] != NULL);
    say_reports(&alone, solution);
    say_reports(&of_the_dead, handed_solution[k]);
    expect_same_sayings(&alone, &of_the_dead, "of a thread that has ended");
    sayings_forget(&of_the_dead);
    sayings_forget(&alone);
    tp_solution_free(solution);
  }
  run_together(free_of_others);
}
END_TEST

SUITE(threads_handed) {
  Suite *suite = suite_create("threads_handed");
  TCase *tests = tcase_create("threads");
  tcase_set_timeout(tests, 0);
  tcase_add_test(tests, threads_within_a_call);
  tcase_add_test(tests, handed_on);
  tcase_add_test(tests, outlives_its_thread);
  suite_add_tcase(suite, tests);
  return suite;
}
