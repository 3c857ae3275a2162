/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Describes the solution, evaluates it in rising precision (stability/climb.h), and sets the
 * governing factor of safety, and how far it may steepen, for the tilt and all further tilts. */

#include "stability/solve.h"

#include "stability/climb.h"
#include "stability/governing.h"
#include "stability/solution.h"
#include "stability/steepening.h"

/* What follows from the numbers of all stages. */
static void judge(tp_solution *solution, const tp_scene *scene) {
  tp_solution_govern(solution, scene);
  tp_solution_steepen(solution);
}

tp_status tp_solve_problem_tilts(tp_solution *solution, tp_tilts *tilts, const tp_problem *problem,
                                 const tp_solve_options *options, tp_message *message) {
  tp_status status = tp_solution_describe(solution, problem, options, message);
  if (status == TP_OK) status = tp_climb(solution, problem, options, tilts, message);
  if (status != TP_OK) return status;
  judge(solution, problem->scene);
  for (size_t k = 0; tilts != NULL && k < tilts->count; k++) {
    if (tilts->solutions[k] != NULL) judge(tilts->solutions[k], problem->scene);
  }
  return TP_OK;
}

tp_status tp_solve_problem(tp_solution *solution, const tp_problem *problem,
                           const tp_solve_options *options, tp_message *message) {
  return tp_solve_problem_tilts(solution, NULL, problem, options, message);
}
