/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Eight threads in the library at the same time.
 *
 * Whoever sweeps a number solves in threads, and a result that depended on what other threads do
 * would be found by nobody. Here threads read, build, solve, find, derive, verify, measure and draw
 * different scenes at once; and solve and report one scene that none of them changes. Every byte
 * must be the same as where one thread does it alone, which it does after the others, so that what
 * is made at a first use is made among them. Built with ThreadSanitizer (./check --sanitize
 * threads) it also tells of memory that two threads use without an order, whether or not a byte
 * came out wrong. */

#define _GNU_SOURCE
#include "crowd.h"
#include "sayings.h"
#include "suite.h"
#include "threads_stage.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#define EXAMPLE(name) TP_EXAMPLES "/" name
#define HARD(name) TP_HARD "/" name

enum { FOLDER = 64 };

static const char *folder;

/* Files of a thread lie in a folder of its own. */
static const char *make_folder(char own[FOLDER], int number) {
  snprintf(own, FOLDER, "%s/%d", folder, number);
  mkdir(own, 0700);
  return own;
}

/* Different scenes: part k is said by thread k, and under ./check --long by thread k + 1 after its
 * own. */

enum { MOST_TURNS = 2, MOST_PARTS = 64 };
static sayings *said[MOST_TURNS][MOST_PARTS];

static int turns(void) {
  return (int)rounds(1, MOST_TURNS);
}

static void say_parts(crowd *among, int number) {
  char own[FOLDER];
  (void)among;
  make_folder(own, number);
  for (int turn = 0; turn < turns(); turn++) {
    for (size_t k = (size_t)(number + turn) % THREADS; k < all_sayings_count; k += THREADS) {
      sayings *s = calloc(1, sizeof *s);
      if (s == NULL) return;
      s->folder = own;
      all_sayings[k].say(s);
      said[turn][k] = s;
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
    for (int turn = 0; turn < turns(); turn++) {
      ck_assert_ptr_nonnull(said[turn][k]);
      expect_same_sayings(&alone, said[turn][k], all_sayings[k].name);
      sayings_forget(said[turn][k]);
      free(said[turn][k]);
    }
    sayings_forget(&alone);
  }
}
END_TEST

/* One scene for all: solved, derived, drawn and varied by every thread, and one solution reported.
 * A scene that is varied shares its long chains of points with the others. */

static const char *const shared_scenes[] = {
    HARD("far_with_every_load.yaml"), EXAMPLE("block_e_valley.yaml"), NULL, /* built in memory */
    /* and under ./check --long */
    EXAMPLE("block_a_worn.yaml"), EXAMPLE("block_bonded.yaml"), EXAMPLE("vault.yaml"),
    EXAMPLE("boulder.yaml"), EXAMPLE("two_density_block.yaml"), HARD("limit_parallel_cones.yaml"),
    HARD("friction_that_leaps.yaml")};
enum { SHARED_SCENES = sizeof shared_scenes / sizeof shared_scenes[0] };

static const tp_scene *shared_scene;
static const tp_solution *shared_solution;

static void say_shared(sayings *s) {
  tp_message message = {.text = ""};
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
  tp_message message = {.text = ""};
  tp_scene *scene = NULL;
  char own[FOLDER];
  if (path == NULL) scene = build_square(33.3);
  if (path != NULL) (void)!tp_scene_read(&scene, path, &message);
  ck_assert_msg(scene != NULL, "%s", message.text);
  tp_solution *solution = solve_in_thread(scene);
  ck_assert_ptr_nonnull(solution);
  shared_scene = scene;
  shared_solution = solution;
  run_together(share);
  sayings alone = {.folder = make_folder(own, THREADS)};
  say_shared(&alone);
  ck_assert_uint_gt(alone.count, 25);
  for (int k = 0; k < THREADS; k++) {
    ck_assert_ptr_nonnull(of_thread[k]);
    expect_same_sayings(&alone, of_thread[k], path != NULL ? path : "a scene in memory");
    sayings_forget(of_thread[k]);
    free(of_thread[k]);
  }
  sayings_forget(&alone);
  tp_solution_free(solution);
  tp_scene_free(scene);
}
END_TEST

SUITE(threads) {
  folder = scratch_folder();
  Suite *suite = suite_create("threads");
  TCase *tests = tcase_create("threads");
  tcase_set_timeout(tests, 0);
  tcase_add_test(tests, different_scenes);
  tcase_add_loop_test(tests, one_scene, 0, (int)rounds(3, SHARED_SCENES));
  suite_add_tcase(suite, tests);
  return suite;
}
