/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The critical angle of a block by the general path: a scene of its outline, prepared exactly and
 * solved up the ladder. */

#include "batch/turning.h"

#include "batch/block_scene.h"
#include "stability/solution.h"
#include "stability/solve.h"

#include <math.h>
#include <stdlib.h>

/* The vertex of the outline as given in which the contact point lies. */
static long vertex_at(const tp_problem *problem, size_t contact_point) {
  const tp_lattice *lattice = &problem->lattice;
  const long point = problem->contact.points[contact_point].point;
  for (long k = lattice->start[0]; k < lattice->start[1]; k++) {
    if (tp_lattice_same_point(lattice, k, point)) {
      return tp_polyline_number(problem->section.rings, k - lattice->start[0]) - 1;
    }
  }
  return -1;
}

static tp_status read_off(tp_block_turning *turning, const tp_solution *solution,
                          const tp_problem *problem) {
  const tp_case *own = solution->cases;
  if (!own->has_toppling_pivot) return TP_NO_ANSWER;
  const tp_bounded angle = own->pivots[own->toppling_pivot].critical_angle_deg;
  *turning =
      (tp_block_turning){.angle_deg = angle.value,
                         .error_deg = angle.error,
                         .pivot = vertex_at(problem, own->pivots[own->toppling_pivot].index)};
  return tp_solution_is_undecided(solution) ? TP_UNDECIDED : TP_OK;
}

static tp_status solve(tp_block_turning *turning, const tp_scene *scene, tp_solution *solution,
                       tp_message *message) {
  tp_solve_options options = tp_solve_options_default();
  options.limit = false;
  options.strength_reduction = false;
  options.pivots = TP_PIVOTS_GOVERNING;
  tp_problem problem;
  tp_status status = tp_problem_init(&problem, scene, &options, solution, message);
  if (status != TP_OK) return status;
  status = tp_solve_problem(solution, &problem, &options, message);
  if (status == TP_OK) status = read_off(turning, solution, &problem);
  tp_problem_clear(&problem);
  return status;
}

tp_status tp_turning_solve(tp_block_turning *turning, tp_vertices vertices, tp_direction towards,
                           tp_message *message) {
  *turning = (tp_block_turning){.angle_deg = NAN, .error_deg = NAN, .pivot = -1};
  tp_scene *scene = NULL;
  tp_status status = tp_block_scene_new(&scene, vertices, towards, message);
  if (status != TP_OK) return status;
  tp_solution *solution = tp_solution_new();
  if (solution == NULL) {
    status = tp_fail_memory(message, "the solution");
  } else {
    status = solve(turning, scene, solution, message);
  }
  tp_solution_free(solution);
  tp_scene_free(scene);
  return status;
}
