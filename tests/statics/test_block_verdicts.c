/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The verdicts of many blocks are what tp_solve tells of each alone, by any number of threads. */

#include "drawn_blocks.h"
#include "suite.h"

#include <math.h>
#include <string.h>

static tp_message message;

enum { SOLVED = 60 };

typedef struct verdicts {
  tp_mechanism mechanism[SOLVED], first[SOLVED];
  double angle[SOLVED], error[SOLVED], critical[SOLVED], limit[SOLVED], onset[SOLVED], fos[SOLVED];
  tp_limit_kind limit_kind[SOLVED];
  tp_onset_kind onset_kind[SOLVED];
  tp_status status[SOLVED];
  tp_blocks_summary summary;
} verdicts;

static double friction[SOLVED], tilt[SOLVED];

static void solve(verdicts *v, const tp_outlines *outlines, size_t threads) {
  tp_blocks_options options = tp_blocks_options_default();
  options.threads = threads;
  options.towards = TP_TOWARDS_RIGHT;
  memset(v, 0, sizeof *v);
  const tp_verdict_columns columns = {.mechanism = v->mechanism,
                                      .first = v->first,
                                      .first_angle_deg = v->angle,
                                      .first_error_deg = v->error,
                                      .critical_angle_deg = v->critical,
                                      .limit_kind = v->limit_kind,
                                      .limit_angle_deg = v->limit,
                                      .onset_kind = v->onset_kind,
                                      .onset_angle_deg = v->onset,
                                      .fos = v->fos,
                                      .status = v->status};
  ck_assert_int_eq(tp_blocks_solve(&columns, &v->summary, outlines, tp_numbers_each(friction),
                                   tp_numbers_each(tilt), &options, &message),
                   TP_OK);
}

static void claim_same(double own, bool given, tp_bounded number) {
  ck_assert_int_eq(isnan(own), !given);
  if (given) ck_assert_double_eq(own, number.value);
}

/* As tp_solve tells of each alone. */
static void claim_verdict(const verdicts *v, size_t k) {
  tp_scene *scene = NULL;
  tp_solution *solution = NULL;
  const tp_coordinates own =
      tp_coordinates_of(all_xy + 2 * first_of[k], first_of[k + 1] - first_of[k]);
  tp_status status = tp_scene_new(&scene, "km", &message);
  if (status == TP_OK) status = tp_scene_set_outline(scene, own, &message);
  if (status == TP_OK) status = tp_scene_set_tilt_towards(scene, false, true, &message);
  if (status == TP_OK && !isnan(friction[k])) {
    status = tp_scene_set_friction_angle_deg(scene, tp_exact_of(friction[k]), &message);
  }
  if (status == TP_OK && !isnan(tilt[k])) {
    status = tp_scene_set_tilt_angle_deg(scene, tp_exact_of(tilt[k]), &message);
  }
  const tp_solve_options options = tp_solve_options_default();
  if (status == TP_OK) status = tp_solve(&solution, scene, &options, &message);
  tp_scene_free(scene);
  if (status == TP_OK && tp_solution_is_undecided(solution)) status = TP_UNDECIDED;
  ck_assert_int_eq(status, v->status[k]);
  if (status == TP_BAD_INPUT) ck_assert_int_eq(v->mechanism[k], TP_MECHANISM_UNDECIDED);
  if (solution == NULL) return;
  const tp_case *one = solution->cases;
  ck_assert_int_eq(v->mechanism[k], one->mechanism);
  ck_assert_int_eq(v->first[k], one->first);
  ck_assert_int_eq(v->limit_kind[k], one->limit.kind);
  ck_assert_int_eq(v->onset_kind[k], one->onset.kind);
  claim_same(v->angle[k], one->has_first_angle, one->first_angle_deg);
  claim_same(v->error[k], one->has_first_angle, (tp_bounded){one->first_angle_deg.error, 0, NULL});
  claim_same(v->critical[k], one->has_toppling_pivot,
             one->has_toppling_pivot ? one->pivots[one->toppling_pivot].critical_angle_deg
                                     : (tp_bounded){0});
  claim_same(v->limit[k], one->limit.kind == TP_LIMIT_AT_ANGLE, one->limit.critical_angle_deg);
  claim_same(v->onset[k], one->onset.kind == TP_ONSET_AT_ANGLE, one->onset.critical_angle_deg);
  claim_same(v->fos[k], one->governing_fos.fos.state == TP_FOS_NUMBER,
             one->governing_fos.fos.value);
  tp_solution_free(solution);
}

START_TEST(verdicts_of_many) {
  static verdicts first, other;
  tp_outlines outlines = draw_blocks();
  outlines.count = SOLVED;
  for (size_t k = 0; k < SOLVED; k++) {
    friction[k] = k % 5 == 0 ? NAN : 20 + (double)(k % 30);
    tilt[k] = k % 7 == 0 ? NAN : (double)(k % 40);
  }
  friction[10] = 91; /* an angle of friction that is none */
  solve(&first, &outlines, 1);
  ck_assert_int_eq(first.status[10], TP_BAD_INPUT);
  for (size_t k = 0; k < SOLVED; k++) claim_verdict(&first, k);
  solve(&other, &outlines, 7);
  ck_assert(same_bytes(&first, &other, sizeof first));
  const size_t all = first.summary.done + first.summary.bad + first.summary.undecided;
  ck_assert_uint_eq(all, SOLVED);
}
END_TEST

SUITE(block_verdicts) {
  Suite *suite = suite_create("block_verdicts");
  TCase *tests = tcase_create("blocks");
  tcase_set_timeout(tests, 0);
  tcase_add_test(tests, verdicts_of_many);
  suite_add_tcase(suite, tests);
  return suite;
}
