/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A second solve, without the earthquake; of each direction the more severe case stays
 * (verdict/safety.h). */

#include "stability/static_state.h"

#include "common/notes.h"
#include "stability/governing.h"

static bool acts(const tp_quantity *share) {
  return share->given && !fmpq_is_zero(share->value);
}

bool tp_static_state_counts(const tp_scene *scene) {
  const tp_loads_description *loads = &scene->loads;
  const bool down_dip = tp_scene_lies_in_place(scene)
                            ? loads->direction_given && loads->direction == TP_SEISMIC_DOWN_DIP
                            : true;
  const bool held = loads->anchor_count > 0 || loads->support_count > 0 ||
                    loads->pressure_count > 0 || acts(&loads->water.ice_kpa);
  if (!acts(&loads->horizontal) && !acts(&loads->vertical)) return false;
  return held || !down_dip || acts(&loads->vertical) || fmpq_sgn(loads->horizontal.value) < 0;
}

/* The scene without its earthquake, sharing all else. */
static void still(tp_scene *at_rest, const tp_scene *scene) {
  *at_rest = *scene;
  fmpq_init(at_rest->loads.horizontal.value); /* zeros, which own nothing */
  fmpq_init(at_rest->loads.vertical.value);
  at_rest->loads.horizontal.given = at_rest->loads.vertical.given = false;
  at_rest->loads.direction_given = false;
}

/* A case in which a motion can begin fails already. */
static bool may_give_way(const tp_case *shaken) {
  return tp_case_safety(shaken).verdict >= TP_VERDICT_OPEN;
}

static tp_status note(tp_solution *solution, const tp_scene *scene, tp_direction towards,
                      tp_message *message) {
  return tp_notes_add(
      &solution->notes, message, TP_CAUTION, scene->loads.seismic_place,
      "towards the %s the state without the earthquake governs: it is the less safe "
      "one, and the results are those without the earthquake",
      towards == TP_TOWARDS_LEFT ? "left" : "right");
}

tp_status tp_static_state_join(tp_solution *solution, const tp_scene *scene,
                               const tp_solve_options *options, tp_static_state_solve *solve,
                               tp_message *message) {
  tp_scene at_rest;
  tp_solution *other = NULL;
  bool any = false;
  for (size_t k = 0; solution->has_tilt_angle && k < solution->case_count; k++)
    any = any || may_give_way(solution->cases + k);
  if (!any) return TP_OK;
  still(&at_rest, scene);
  tp_status status = solve(&other, &at_rest, options, message);
  for (size_t k = 0; status == TP_OK && k < solution->case_count && k < other->case_count; k++) {
    const tp_safety shaken = tp_case_safety(solution->cases + k);
    const tp_safety resting = tp_case_safety(other->cases + k);
    if (!may_give_way(solution->cases + k) ||
        solution->cases[k].towards != other->cases[k].towards ||
        tp_safety_compare(&resting, &shaken) >= 0) {
      continue;
    }
    const tp_case governs = other->cases[k];
    other->cases[k] = solution->cases[k];
    solution->cases[k] = governs;
    status = note(solution, scene, governs.towards, message);
  }
  tp_solution_free(other);
  return status;
}
