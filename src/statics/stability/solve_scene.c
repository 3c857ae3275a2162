/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Public calls that solve a scene: problem, cautions and solution in order, once for each
 * earthquake where there are several, and all resting poses where the scene asks for them. */

#include "block/ring_sums.h"
#include "common/host.h"
#include "common/notes.h"
#include "common/options.h"
#include "evaluation/rough_sole.h"
#include "scene/check_tilt_test.h"
#include "scene_varying/settings.h"
#include "stability/cautions.h"
#include "stability/combinations.h"
#include "stability/earthquakes.h"
#include "stability/front_ground.h"
#include "stability/half_tolerance.h"
#include "stability/poses.h"
#include "stability/solution.h"
#include "stability/solve.h"
#include "stability/static_state.h"

#include <stdlib.h>

TP_OPTIONS_END(tp_solve_options, threads);

void tp_solve_options_init(tp_solve_options *options, size_t size) {
  const tp_solve_options defaults = {.size = sizeof defaults,
                                     .limit = true,
                                     .strength_reduction = true,
                                     .digits = 9,
                                     .level = TP_LEVEL_EXACT,
                                     .pivots = TP_PIVOTS_ALL};
  tp_options_fill(options, size, &defaults);
}

/* Statics that knew nothing of an earthquake would make the block look safer than it is. */
static tp_status note_shaking(tp_notes *notes, const tp_scene *scene, tp_message *message) {
  if (!tp_scene_is_shaken(scene)) return TP_OK;
  return tp_notes_add(
      notes, message, TP_CAUTION, scene->shaking_place,
      "the shaking of the base is not included in these results: 'topple tilt' simulates it");
}

static tp_status fill(tp_solution *solution, tp_tilts *tilts, bool *rest_may_govern,
                      const tp_scene *scene, const tp_solve_options *options, tp_message *message) {
  tp_problem problem;
  tp_status status = tp_scene_notes(&solution->notes, scene, message);
  if (status == TP_OK) status = note_shaking(&solution->notes, scene, message);
  if (status == TP_OK) status = tp_scene_settings(&solution->settings, scene, message);
  if (status == TP_OK) status = tp_problem_init(&problem, scene, options, solution, message);
  if (status != TP_OK) return status;
  status = tp_problem_cautions(&solution->notes, &problem, message);
  if (status == TP_OK) status = tp_solve_problem_tilts(solution, tilts, &problem, options, message);
  if (status == TP_OK) {
    status = tp_rough_sole_cautions(&solution->notes, solution, &problem, message);
  }
  if (status == TP_OK && rest_may_govern != NULL) {
    *rest_may_govern = tp_static_state_may_govern(&problem, solution);
  }
  tp_problem_clear(&problem);
  if (status == TP_OK && scene->base.all_poses) {
    status = tp_poses_find(solution, scene, options, message);
  }
  return status;
}

static void drop_tilts(tp_tilts *tilts) {
  for (size_t k = 0; tilts != NULL && k < tilts->count; k++) {
    tp_solution_free(tilts->solutions[k]);
    tilts->solutions[k] = NULL;
  }
}

/* `*rest_may_govern`, unless NULL: as tp_static_state_may_govern. */
static tp_status solve_one(tp_solution **solution, tp_tilts *tilts, bool *rest_may_govern,
                           const tp_scene *scene, const tp_solve_options *options,
                           tp_message *message) {
  tp_solution *filled = tp_solution_new();
  if (filled == NULL) return tp_fail_memory(message, "the solution");
  const tp_status status = fill(filled, tilts, rest_may_govern, scene, options, message);
  if (status == TP_OK) {
    *solution = filled;
    return TP_OK;
  }
  tp_solution_free(filled);
  drop_tilts(tilts);
  return status;
}

static tp_status solve_alone(tp_solution **solution, const tp_scene *scene,
                             const tp_solve_options *options, tp_message *message) {
  return solve_one(solution, NULL, NULL, scene, options, message);
}

static tp_status solve_combination(tp_solution **solution, const tp_scene *scene,
                                   const tp_solve_options *options, tp_message *message);

/* Under several earthquakes each tilt is solved by itself, and so with partial factors. */
static tp_status solve(tp_solution **solution, tp_tilts *tilts, const tp_scene *scene,
                       const tp_solve_options *options, tp_message *message) {
  bool several = false;
  if (tp_combinations_asked(scene)) {
    return tp_combinations_solve(solution, scene, options, solve_combination, message);
  }
  tp_status status = tp_earthquakes_asked(&several, scene, message);
  if (status != TP_OK) return status;
  bool rests = tp_static_state_counts(scene),
       may_govern = false; /* then each tilt by itself, too */
  status = several
               ? tp_earthquakes_solve(solution, scene, options, solve_alone, message)
               : solve_one(solution, rests ? NULL : tilts, &may_govern, scene, options, message);
  if (status == TP_OK && may_govern && !rests) {
    drop_tilts(tilts);
    rests = true;
  }
  if (status != TP_OK || !rests) return status;
  status = tp_static_state_join(solution, scene, options, solve_alone, message);
  if (status == TP_OK) return TP_OK;
  tp_solution_free(*solution);
  *solution = NULL;
  return status;
}

static tp_status solve_combination(tp_solution **solution, const tp_scene *scene,
                                   const tp_solve_options *options, tp_message *message) {
  return solve(solution, NULL, scene, options, message);
}

tp_status tp_solve_tilts(tp_solution **solution, tp_tilts *tilts, const tp_scene *scene,
                         const tp_solve_options *options, tp_message *message) {
  TP_GUARD_HOST;
  for (size_t k = 0; k < tilts->count; k++) tilts->solutions[k] = NULL;
  return solve(solution, tilts, scene, options, message);
}

tp_status tp_solve_numbers(tp_solution **solution, const tp_scene *scene,
                           const tp_solve_options *options, tp_message *message) {
  return solve(solution, NULL, scene, options, message);
}

tp_status tp_solve(tp_solution **solution, const tp_scene *scene, const tp_solve_options *options,
                   tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, solution);
  TP_REFUSE_NULL(message, scene);
  TP_REFUSE_NULL(message, options);
  tp_solve_options own = tp_solve_options_default();
  TP_TAKE_OPTIONS(message, own, options);
  if (options->digits < 1 || options->digits > TP_DIGITS_MAX) {
    return tp_refuse(message, TP_FAULT_ARGUMENT, (tp_place){0}, "digits must lie between 1 and %d",
                     TP_DIGITS_MAX);
  }
  if ((int)options->level < 0 || (int)options->level >= TP_LEVELS) {
    return tp_refuse(message, TP_FAULT_ARGUMENT, (tp_place){0},
                     "there is no such level of arithmetic");
  }
  if ((int)options->pivots < 0 || options->pivots > TP_PIVOTS_GOVERNING) {
    return tp_refuse(message, TP_FAULT_ARGUMENT, (tp_place){0}, "there is no such list of pivots");
  }
  tp_solution *filled = NULL;
  tp_status status = solve(&filled, NULL, scene, options, message);
  if (status != TP_OK) return status;
  status = tp_half_tolerance_check(filled, scene, options, solve_combination, message);
  if (status == TP_OK) {
    status = tp_front_ground_check(filled, scene, options, solve_combination, message);
  }
  if (status == TP_OK) {
    *solution = filled;
  } else {
    tp_solution_free(filled);
  }
  return status;
}
