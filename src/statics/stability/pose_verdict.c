/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Solves the scene with the block in one resting pose, keeps its verdict, and marks the least safe
 * verdict of each direction of tilt. */

#include "stability/pose_verdict.h"

#include "common/message.h"
#include "stability/solution.h"
#include "stability/solve.h"

#include <stdlib.h>

/* Of what belongs to the solution of the pose it keeps nothing. */
static tp_pose_verdict verdict_of(const tp_case *own) {
  tp_pose_verdict verdict = {.towards = own->towards,
                             .mechanism = own->mechanism,
                             .first = own->first,
                             .has_critical_angle = own->has_first_angle,
                             .critical_angle_deg = own->first_angle_deg,
                             .fos = own->governing_fos.fos};
  verdict.critical_angle_deg.digits = verdict.fos.value.digits = NULL;
  return verdict;
}

static tp_status solve(tp_solution *solution, const tp_scene *scene,
                       const tp_solve_options *options, tp_message *message) {
  tp_problem problem;
  tp_status status = tp_problem_init(&problem, scene, options, solution, message);
  if (status != TP_OK) return status;
  status = tp_solve_problem(solution, &problem, options, message);
  tp_problem_clear(&problem);
  return status;
}

tp_status tp_pose_solve(tp_resting_pose *pose, const tp_scene *placed,
                        const tp_solve_options *options, tp_message *message) {
  enum { DIGITS = 9 };
  tp_solve_options own = *options;
  tp_message why;
  own.digits = own.digits < DIGITS ? own.digits : DIGITS;
  own.elements = false;
  own.pivots = TP_PIVOTS_GOVERNING;
  tp_scene scene = *placed; /* borrows all that it holds */
  scene.base.rests = scene.base.all_poses = false;
  tp_solution *solution = tp_solution_new();
  if (solution == NULL) return tp_fail_memory(message, "the resting poses");
  tp_status status = solve(solution, &scene, &own, &why);
  pose->verdict_count = status == TP_OK ? solution->case_count : 0;
  for (size_t k = 0; k < pose->verdict_count; k++) {
    pose->verdicts[k] = verdict_of(solution->cases + k);
  }
  tp_solution_free(solution);
  if (status == TP_BAD_INPUT || status == TP_NO_ANSWER || status == TP_UNDECIDED) status = TP_OK;
  if (status != TP_OK && message != NULL) *message = why;
  return status;
}

/* From the least safe on: it stands at no tilt, begins to move at one, unknown, never. */
typedef enum rank { RANK_NEVER_STANDS, RANK_ANGLE, RANK_UNKNOWN, RANK_NEVER_GOES } rank;

static rank rank_of(const tp_pose_verdict *v) {
  if (v->has_critical_angle) return RANK_ANGLE;
  switch (v->first) {
  case TP_MECHANISM_UNDECIDED:
    return RANK_UNKNOWN;
  case TP_STANDS:
  case TP_INTERLOCKED:
    return RANK_NEVER_GOES;
  default:
    return RANK_NEVER_STANDS;
  }
}

static bool is_less(const tp_pose_verdict *a, const tp_pose_verdict *b) {
  const rank own = rank_of(a), other = rank_of(b);
  if (own != other) return own < other;
  return own == RANK_ANGLE && a->critical_angle_deg.value < b->critical_angle_deg.value;
}

void tp_poses_least(tp_poses_result *poses, size_t case_count) {
  for (size_t c = 0; c < case_count; c++) {
    tp_pose_verdict *least = NULL;
    for (size_t k = 0; k < poses->pose_count; k++) {
      tp_resting_pose *own = poses->poses + k;
      if (c >= own->verdict_count) continue;
      if (least == NULL || is_less(own->verdicts + c, least)) least = own->verdicts + c;
    }
    if (least != NULL) least->least = true;
  }
}
