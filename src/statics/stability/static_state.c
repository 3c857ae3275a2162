/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A second solve, without the earthquake; of each direction the more severe case stays
 * (verdict/safety.h). */

#include "stability/static_state.h"

#include "common/notes.h"
#include "stability/governing.h"

#include <math.h>

static bool acts(const tp_quantity *share) {
  return share->given && !fmpq_is_zero(share->value);
}

bool tp_static_state_exists(const tp_scene *scene) {
  return acts(&scene->loads.horizontal) || acts(&scene->loads.vertical);
}

bool tp_static_state_counts(const tp_scene *scene) {
  const tp_loads_description *loads = &scene->loads;
  const bool down_dip = tp_scene_lies_in_place(scene)
                            ? loads->direction_given && loads->direction == TP_SEISMIC_DOWN_DIP
                            : true;
  const bool held = loads->anchor_count > 0 || loads->support_count > 0 ||
                    loads->pressure_count > 0 || acts(&loads->water.ice_kpa) ||
                    (tp_water_is_sited(&loads->water) && loads->water.faces != TP_WATER_BEHIND);
  if (!tp_static_state_exists(scene)) return false;
  return held || !down_dip || acts(&loads->vertical) || fmpq_sgn(loads->horizontal.value) < 0;
}

/* ---- a block that its weight alone drives ------------------------------------------------------
 */

/* A facet that dips up-dip as the block lies, its side to the left or to the right down-dip. */
static bool dips_up_dip(const tp_lattice *l, const tp_facet *f, bool left, double tilt_tangent) {
  static const double nearly = 1 - 1e-9;
  fmpz_t run, rise;
  fmpz_init(run);
  fmpz_init(rise);
  fmpz_sub(run, l->x + f->t1, l->x + f->t0);
  fmpz_sub(rise, l->y + f->t1, l->y + f->t0);
  const double over = fmpz_get_d(run), up = left ? fmpz_get_d(rise) : -fmpz_get_d(rise);
  fmpz_clear(run);
  fmpz_clear(rise);
  return !(up >= -tilt_tangent * nearly * over);
}

/* Without an earthquake of k the tilts at which a motion can begin are greater by arctan k, where
 * weights alone act. A margin allows for cohesion. */
static bool may_move_up_dip(const tp_case *shaken, double tilt_deg, double horizontal) {
  static const double margin_deg = 2, degrees = 57.29577951308232;
  const tp_onset *onset = &shaken->onset;
  if (onset->kind == TP_ONSET_NOT_ASKED || onset->window_count == 0) return true;
  const tp_window *lowest = onset->windows;
  if (!lowest->from_below) return onset->window_count > 1;
  return onset->window_count > 2 || lowest->to_above ||
         !(lowest->to_deg.value + atan(horizontal) * degrees + margin_deg < tilt_deg);
}

bool tp_static_state_may_govern(const tp_problem *problem, const tp_solution *solution) {
  const tp_scene *scene = problem->scene;
  if (!tp_static_state_exists(scene) || !solution->has_tilt_angle) return false;
  const double tilt_deg = solution->tilt_angle_deg.value;
  const double tangent = tan(tilt_deg / 57.29577951308232);
  const double horizontal = fmpq_get_d(scene->loads.horizontal.value);
  for (size_t k = 0; k < solution->case_count; k++) {
    const tp_case *own = solution->cases + k;
    if (may_move_up_dip(own, tilt_deg, horizontal)) return true;
    for (long j = 0; j < problem->contact.facet_count; j++) {
      if (dips_up_dip(&problem->lattice, problem->contact.facets + j,
                      own->towards == TP_TOWARDS_LEFT, tangent)) {
        return true;
      }
    }
  }
  return false;
}

/* ---- with and without --------------------------------------------------------------------------
 */

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

/* In place of a case, or, where a block at rest goes the other way, which the whole solution is of,
 * of that. */
static tp_status take(tp_solution **solution, tp_solution **at_rest, size_t k,
                      const tp_scene *scene, tp_message *message) {
  const tp_direction towards = (*at_rest)->cases[k].towards;
  if ((*solution)->cases[k].towards != towards) {
    tp_solution *shaken = *solution;
    *solution = *at_rest;
    *at_rest = shaken;
  } else {
    const tp_case shaken = (*solution)->cases[k];
    (*solution)->cases[k] = (*at_rest)->cases[k];
    (*at_rest)->cases[k] = shaken;
  }
  return note(*solution, scene, towards, message);
}

tp_status tp_static_state_join(tp_solution **solution, const tp_scene *scene,
                               const tp_solve_options *options, tp_static_state_solve *solve,
                               tp_message *message) {
  const size_t count = (*solution)->case_count;
  tp_scene at_rest;
  tp_solution *other = NULL;
  bool any = false;
  for (size_t k = 0; (*solution)->has_tilt_angle && k < count; k++)
    any = any || may_give_way((*solution)->cases + k);
  if (!any) return TP_OK;
  still(&at_rest, scene);
  tp_status status = solve(&other, &at_rest, options, message);
  for (size_t k = 0; status == TP_OK && k < count && k < other->case_count; k++) {
    const tp_case *shaken = (*solution)->cases + k, *resting = other->cases + k;
    const tp_safety of_shaken = tp_case_safety(shaken), of_resting = tp_case_safety(resting);
    if (!may_give_way(shaken) || (count > 1 && shaken->towards != resting->towards)) continue;
    const bool rests = tp_safety_compare(&of_resting, &of_shaken) < 0;
    if (rests) status = take(solution, &other, k, scene, message);
    tp_case_add_state((*solution)->cases + k, rests ? &of_shaken : &of_resting);
  }
  tp_solution_free(other);
  return status;
}
