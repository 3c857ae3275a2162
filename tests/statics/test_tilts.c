/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What one solve tells of further tilts is, bit by bit, what a solve of the scene with that tilt
 * tells: of every example and hard case that tilts, from level to nearly upright, under all its
 * loads and laws of friction; and hundreds of tilts are told so. */

#include "stability/tilts.h"
#include "suite.h"
#include "topple.h"

#include <flint/fmpq.h>
#include <glob.h>

enum { TILTS = 5 };
static const long tilt_deg[TILTS] = {0, 13, 27, 41, 76};

static tp_message message;
static long told, asked;
static const char *of;

static void same_number(tp_bounded one, tp_bounded other) {
  ck_assert_msg(one.value == other.value && one.error == other.error, "%s: %.17g, %.17g", of,
                one.value, other.value);
}

static void same_factor(tp_fos one, tp_fos other) {
  ck_assert_msg(one.state == other.state, "%s: %d, %d", of, (int)one.state, (int)other.state);
  if (one.state == TP_FOS_NUMBER) same_number(one.value, other.value);
}

static void same_limit(const tp_limit *one, const tp_limit *other) {
  ck_assert_msg(one->kind == other->kind && one->mechanism == other->mechanism, "%s", of);
  ck_assert_msg(one->fos_mechanism == other->fos_mechanism, "%s", of);
  ck_assert_msg(one->base_beyond_toe == other->base_beyond_toe, "%s", of);
  if (one->kind == TP_LIMIT_AT_ANGLE) {
    same_number(one->critical_angle_deg, other->critical_angle_deg);
  }
  same_factor(one->fos, other->fos);
}

static void same_onset(const tp_onset *one, const tp_onset *other) {
  ck_assert_msg(one->kind == other->kind && one->mechanism == other->mechanism, "%s", of);
  ck_assert_msg(one->below_limit == other->below_limit, "%s", of);
  ck_assert_msg(one->window_count == other->window_count, "%s", of);
  same_number(one->friction_angle_deg, other->friction_angle_deg);
  if (one->kind == TP_ONSET_AT_ANGLE) {
    same_number(one->critical_angle_deg, other->critical_angle_deg);
  }
  for (size_t k = 0; k < one->window_count; k++) {
    const tp_window *a = one->windows + k, *b = other->windows + k;
    ck_assert_msg(a->begins == b->begins && a->to_above == b->to_above, "%s", of);
    if (!a->from_below) same_number(a->from_deg, b->from_deg);
  }
  ck_assert_msg(one->paradox == other->paradox && one->has_motions == other->has_motions, "%s", of);
  ck_assert_msg(one->motion_count == other->motion_count, "%s", of);
  for (size_t k = 0; k < one->motion_count; k++) {
    ck_assert_msg(one->motions[k].mechanism == other->motions[k].mechanism, "%s", of);
    same_number(one->motions[k].angular_g_per_m, other->motions[k].angular_g_per_m);
  }
}

static void same_case(const tp_case *one, const tp_case *other) {
  ck_assert_msg(one->mechanism == other->mechanism && one->first == other->first, "%s", of);
  ck_assert_msg(one->falls_backwards == other->falls_backwards, "%s", of);
  ck_assert_msg(one->has_margin == other->has_margin && one->rolls == other->rolls, "%s", of);
  if (one->has_margin) same_number(one->margin_deg, other->margin_deg);
  ck_assert_msg(one->has_toppling_pivot == other->has_toppling_pivot, "%s", of);
  ck_assert_msg(one->toppling_pivot == other->toppling_pivot, "%s", of);
  for (size_t k = 0; k < one->pivot_count; k++) {
    same_factor(one->pivots[k].fos, other->pivots[k].fos);
  }
  same_factor(one->sliding.fos, other->sliding.fos);
  same_limit(&one->limit, &other->limit);
  same_limit(&one->limit_holds_from, &other->limit_holds_from);
  same_limit(&one->limit_otherwise, &other->limit_otherwise);
  same_onset(&one->onset, &other->onset);
  same_factor(one->governing_fos.fos, other->governing_fos.fos);
  ck_assert_msg(one->governing_fos.factor == other->governing_fos.factor, "%s", of);
  ck_assert_msg(one->governing_fos.complete == other->governing_fos.complete, "%s", of);
  ck_assert_msg(one->load_count == other->load_count, "%s", of);
  for (size_t k = 0; k < one->load_count; k++) {
    same_number(one->loads[k].moment_nm, other->loads[k].moment_nm);
  }
}

static void same_as_alone(const tp_solution *shared, const tp_scene *scene, long tilt) {
  const tp_solve_options options = tp_solve_options_default();
  tp_scene *own = NULL;
  tp_solution *alone = NULL;
  ck_assert_int_eq(
      tp_scene_with(&own, scene, "tilt.angle_deg", tp_exact_of((double)tilt), &message), TP_OK);
  own->base.all_poses = false;
  ck_assert_int_eq(tp_solve(&alone, own, &options, &message), TP_OK);
  ck_assert_msg(alone->case_count == shared->case_count && alone->level == shared->level, "%s", of);
  same_number(alone->tilt_angle_deg, shared->tilt_angle_deg);
  same_number(alone->block.area_m2, shared->block.area_m2);
  ck_assert_int_eq(tp_solution_is_undecided(alone), tp_solution_is_undecided(shared));
  for (size_t k = 0; k < alone->case_count; k++) same_case(shared->cases + k, alone->cases + k);
  tp_solution_free(alone);
  tp_scene_free(own);
}

static void at_tilts(const char *path) {
  const tp_solve_options options = tp_solve_options_default();
  tp_scene *scene = NULL;
  tp_solution *solution = NULL, *solutions[TILTS];
  fmpq degrees[TILTS];
  of = path;
  if (tp_scene_read(&scene, path, &message) != TP_OK) return; /* it is to be refused */
  scene->base.all_poses = false;
  for (int k = 0; k < TILTS; k++) {
    fmpq_init(degrees + k);
    fmpq_set_si(degrees + k, tilt_deg[k], 1);
  }
  tp_tilts tilts = {TILTS, degrees, solutions};
  const bool tilted = scene->tilt_angle_deg.given && scene->frame != TP_FRAME_WORLD;
  if (tp_solve_tilts(&solution, &tilts, scene, &options, &message) == TP_OK) {
    for (int k = 0; k < TILTS; k++) {
      asked += tilted;
      if (solutions[k] == NULL) continue;
      told++;
      same_as_alone(solutions[k], scene, tilt_deg[k]);
      tp_solution_free(solutions[k]);
    }
    tp_solution_free(solution);
  }
  for (int k = 0; k < TILTS; k++) fmpq_clear(degrees + k);
  tp_scene_free(scene);
}

START_TEST(as_alone) {
  glob_t found;
  ck_assert_int_eq(glob(TP_EXAMPLES "/*.yaml", 0, NULL, &found), 0);
  ck_assert_int_eq(glob(TP_EXAMPLES "/studies/block_above_road.yaml", GLOB_APPEND, NULL, &found),
                   0);
  ck_assert_int_eq(glob(TP_HARD "/*.yaml", GLOB_APPEND, NULL, &found), 0);
  for (size_t k = 0; k < found.gl_pathc; k++) at_tilts(found.gl_pathv[k]);
  globfree(&found);
  ck_assert_int_ge(asked, told);
  ck_assert_int_ge(told, 300);
}
END_TEST

SUITE(tilts) {
  Suite *suite = suite_create("tilts");
  TCase *tests = tcase_create("all");
  tcase_set_timeout(tests, 0);
  tcase_add_test(tests, as_alone);
  suite_add_tcase(suite, tests);
  return suite;
}
