/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Eight threads in the library at the same time.
 *
 * Whoever sweeps a number solves in threads, and a result that depended on what other threads do
 * would be found by nobody. Here threads read, build, solve, find, derive, verify, measure and draw
 * different scenes at once; solve and report one scene that none of them changes; and hand scenes
 * and solutions on to each other. Every byte must be the same as where one thread does it alone,
 * which it does after the others, so that what is made at a first use is made among them. Built
 * with ThreadSanitizer (./check --sanitize threads) it also tells of memory that two threads use
 * without an order, whether or not a byte came out wrong. */

#define _GNU_SOURCE
#include "crowd.h"
#include "runner.h"
#include "sayings.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#define EXAMPLE(name) TP_EXAMPLES "/" name
#define HARD(name) TP_HARD "/" name

enum { FOLDER = 64 };

static char folder[] = "/tmp/topple-threads-XXXXXX";

/* Files of a thread lie in a folder of its own. */
static const char *make_folder(char own[FOLDER], int number) {
  snprintf(own, FOLDER, "%s/%d", folder, number);
  mkdir(own, 0700);
  return own;
}

static void expect_same(const sayings *alone, const sayings *among, const char *what) {
  ck_assert_msg(alone->count == among->count, "%s: %zu texts, alone %zu", what, among->count,
                alone->count);
  for (size_t k = 0; k < alone->count; k++) {
    const char *one = alone->texts[k], *other = among->texts[k];
    ck_assert(one != NULL && other != NULL);
    size_t same = 0;
    while (one[same] != '\0' && one[same] == other[same]) same++;
    ck_assert_msg(one[same] == other[same], "%s, text %zu:\n%.120s\nand alone\n%.120s", what, k,
                  other + same, one + same);
  }
}

/* Scenes in memory, which threads make too: NULL where one cannot be made. */

static tp_scene *built(tp_scene *scene, tp_status status) {
  if (status == TP_OK) return scene;
  tp_scene_free(scene);
  return NULL;
}

static tp_scene *build_square(double friction_angle_deg) {
  static const double square[] = {0, 0, 4, 0, 4, 6, 0, 6};
  tp_scene *scene = NULL;
  tp_status status = tp_scene_new(&scene, "m", NULL);
  if (status == TP_OK) status = tp_scene_set_outline(scene, tp_coordinates_of(square, 4), NULL);
  if (status == TP_OK) status = tp_scene_set_unit_weight_kn_m3(scene, tp_exact_of(25), NULL);
  if (status == TP_OK) {
    status = tp_scene_set_friction_angle_deg(scene, tp_exact_of(friction_angle_deg), NULL);
  }
  if (status == TP_OK) status = tp_scene_set_bond_kpa(scene, tp_exact_text("1.1"), NULL);
  if (status == TP_OK) status = tp_scene_set_tilt_angle_deg(scene, tp_exact_of(12.5), NULL);
  return built(scene, status);
}

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

static tp_solution *solve(const tp_scene *scene) {
  tp_solution *solution = NULL;
  const tp_solve_options options = tp_solve_options_default();
  if (scene != NULL) (void)!tp_solve(&solution, scene, &options, NULL);
  if (solution != NULL) same_times(solution);
  return solution;
}

/* Different scenes: part k is said by thread k, and by thread k + 1 after its own. */

enum { ROUNDS = 2, MOST_PARTS = 64 };
static sayings *said[ROUNDS][MOST_PARTS];

static void say_parts(crowd *among, int number) {
  char own[FOLDER];
  (void)among;
  make_folder(own, number);
  for (int round = 0; round < ROUNDS; round++) {
    for (size_t k = (size_t)(number + round) % THREADS; k < all_sayings_count; k += THREADS) {
      sayings *s = calloc(1, sizeof *s);
      if (s == NULL) return;
      s->folder = own;
      all_sayings[k].say(s);
      said[round][k] = s;
    }
  }
}

START_TEST(different_scenes) {
  char own[FOLDER];
  ck_assert_uint_le(all_sayings_count, MOST_PARTS);
  run_together(say_parts);
  make_folder(own, THREADS);
  for (size_t k = 0; k < all_sayings_count; k++) {
    sayings alone = {.folder = own};
    all_sayings[k].say(&alone);
    for (int round = 0; round < ROUNDS; round++) {
      ck_assert_ptr_nonnull(said[round][k]);
      expect_same(&alone, said[round][k], all_sayings[k].name);
      sayings_forget(said[round][k]);
      free(said[round][k]);
    }
    sayings_forget(&alone);
  }
}
END_TEST

/* One scene for all: solved, derived, drawn and varied by every thread, and one solution reported.
 * A scene that is varied shares its long chains of points with the others. */

static const char *const shared_scenes[] = {
    EXAMPLE("block_e_valley.yaml"),    EXAMPLE("block_a_worn.yaml"),
    EXAMPLE("block_bonded.yaml"),      EXAMPLE("vault.yaml"),
    EXAMPLE("boulder.yaml"),           EXAMPLE("two_density_block.yaml"),
    HARD("limit_parallel_cones.yaml"), HARD("far_with_every_load.yaml"),
    HARD("friction_that_leaps.yaml"),  NULL}; /* built in memory */

static const tp_scene *shared_scene;
static const tp_solution *shared_solution;
static sayings *of_thread[THREADS + 1];

static void say_shared(sayings *s) {
  tp_message message = {""};
  tp_derivation *derivation = NULL;
  tp_derive_options options = tp_derive_options_default();
  options.elements = options.limit = true;
  say_solved(s, shared_scene, false, 9, true);
  say_solved(s, shared_scene, true, 30, false);
  note_status(s, tp_derive(&derivation, shared_scene, &options, &message), &message);
  if (derivation != NULL && tp_report_derivation(next_saying(s), derivation) != TP_OK) s->count--;
  tp_derivation_free(derivation);
  for (int k = 0; k < 2; k++) {
    tp_scene *varied = NULL;
    const tp_exact angle_deg = tp_exact_of(31.5 + k);
    note_status(s, tp_scene_with(&varied, shared_scene, "friction_angle_deg", angle_deg, &message),
                &message);
    if (varied != NULL) say_solved(s, varied, false, 9, false);
    tp_scene_free(varied);
  }
  say_reports(s, shared_solution);
}

static void share(crowd *among, int number) {
  char own[FOLDER];
  (void)among;
  sayings *s = calloc(1, sizeof *s);
  if (s == NULL) return;
  s->folder = make_folder(own, number);
  say_shared(s);
  of_thread[number] = s;
}

START_TEST(one_scene) {
  const char *path = shared_scenes[_i];
  tp_message message = {""};
  tp_scene *scene = NULL;
  char own[FOLDER];
  if (path == NULL) scene = build_square(33.3);
  if (path != NULL) (void)!tp_scene_read(&scene, path, &message);
  ck_assert_msg(scene != NULL, "%s", message.text);
  tp_solution *solution = solve(scene);
  ck_assert_ptr_nonnull(solution);
  shared_scene = scene;
  shared_solution = solution;
  run_together(share);
  sayings alone = {.folder = make_folder(own, THREADS)};
  say_shared(&alone);
  ck_assert_uint_gt(alone.count, 25);
  for (int k = 0; k < THREADS; k++) {
    ck_assert_ptr_nonnull(of_thread[k]);
    expect_same(&alone, of_thread[k], path != NULL ? path : "a scene in memory");
    sayings_forget(of_thread[k]);
    free(of_thread[k]);
  }
  sayings_forget(&alone);
  tp_solution_free(solution);
  tp_scene_free(scene);
}
END_TEST

/* The sums of a large ring are shared by threads that the call starts. */

enum { SOLVES = 2 };

static void solve_long_roof(crowd *among, int number) {
  (void)among;
  if (number >= SOLVES) return;
  sayings *s = calloc(1, sizeof *s);
  if (s == NULL) return;
  say_solved(s, shared_scene, false, 6, false);
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
  shared_scene = scene;
  run_together(solve_long_roof);
  say_solved(&alone, scene, false, 6, false);
  for (int k = 0; k < SOLVES; k++) {
    ck_assert_ptr_nonnull(of_thread[k]);
    expect_same(&alone, of_thread[k], "a long roof");
    sayings_forget(of_thread[k]);
    free(of_thread[k]);
  }
  char *by_one = solved_by(scene, 1), *by_seven = solved_by(scene, 7);
  ck_assert_str_eq(by_one, by_seven);
  free(by_one);
  free(by_seven);
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
  handed_solution[solved] = solve(handed_scene[solved]);
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
      tp_solution *solution = solve(scene);
      ck_assert_ptr_nonnull(solution);
      say_reports(&alone, solution);
      ck_assert_ptr_nonnull(of_thread[k]);
      expect_same(&alone, of_thread[k], "handed on");
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
  handed_solution[number] = solve(handed_scene[number]);
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
    tp_solution *solution = solve(handed_scene[k]);
    ck_assert(solution != NULL && handed_solution[k] != NULL);
    say_reports(&alone, solution);
    say_reports(&of_the_dead, handed_solution[k]);
    expect_same(&alone, &of_the_dead, "of a thread that has ended");
    sayings_forget(&of_the_dead);
    sayings_forget(&alone);
    tp_solution_free(solution);
  }
  run_together(free_of_others);
}
END_TEST

int main(void) {
  if (mkdtemp(folder) == NULL) return 1;
  Suite *suite = suite_create("threads");
  TCase *tests = tcase_create("threads");
  tcase_set_timeout(tests, 0);
  tcase_add_test(tests, different_scenes);
  tcase_add_loop_test(tests, one_scene, 0, sizeof shared_scenes / sizeof shared_scenes[0]);
  tcase_add_test(tests, threads_within_a_call);
  tcase_add_test(tests, handed_on);
  tcase_add_test(tests, outlives_its_thread);
  suite_add_tcase(suite, tests);
  const int failed = run_suite(suite);
  char command[64];
  snprintf(command, sizeof command, "rm -r '%s'", folder);
  return system(command) == 0 ? failed : 1;
}
