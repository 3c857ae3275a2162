/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Calls shift, world frame, rest and snapping in the order that the scene asks for, refuses more
 * digits than their poses carry, and notes the time of each. */

#include "problem/placement.h"

#include "problem/effects.h"

static tp_status set_down(tp_rested **rested, const tp_scene *scene,
                          const tp_solve_options *options, tp_solution *solution,
                          tp_message *message) {
  const tp_effect_begin began = tp_effects_begin(solution);
  if (options->digits > TP_RESTED_DIGITS) {
    return tp_refuse(message, TP_FAULT_RANGE, scene->base.rests_place,
                     "of a block that comes to rest numbers are certain to %d digits at most; give "
                     "it where it rests, 'place: as_given', for more",
                     TP_RESTED_DIGITS);
  }
  const tp_status status = tp_rested_init(rested, scene, message);
  if (status != TP_OK) return status;
  return tp_effects_entered(status, message,
                            tp_effects_note(solution, "rest", scene->base.rests_place, "", began));
}

static tp_status snap(tp_snapped **snapped, const tp_scene *scene, tp_solution *solution,
                      tp_message *message) {
  const tp_effect_begin began = tp_effects_begin(solution);
  const tp_status status = tp_snapped_init(snapped, scene, message);
  if (status != TP_OK) return status;
  return tp_effects_entered(
      status, message, tp_effects_note(solution, "within", scene->base.within.place, "", began));
}

static tp_status turn(tp_world **world, const tp_scene *scene, const tp_solve_options *options,
                      tp_solution *solution, tp_message *message) {
  const tp_effect_begin began = tp_effects_begin(solution);
  const bool slope = scene->frame == TP_FRAME_SLOPE;
  if (options->digits > TP_WORLD_DIGITS && !slope) {
    return tp_refuse(message, TP_FAULT_RANGE, scene->frame_place,
                     "where 'frame' is 'world' numbers are certain to %d digits at most; give the "
                     "coordinates along the mean plane, and 'slope', for more",
                     TP_WORLD_DIGITS);
  }
  const tp_status status = tp_world_init(world, scene, message);
  if (status != TP_OK) return status;
  return tp_effects_entered(
      status, message,
      tp_effects_note(solution, slope ? "slope" : "frame", scene->frame_place, "", began));
}

static tp_status shift(tp_jointed **jointed, const tp_scene *scene, tp_solution *solution,
                       tp_message *message) {
  const tp_effect_begin began = tp_effects_begin(solution);
  const tp_status status = tp_jointed_ask(jointed, scene, message);
  if (status != TP_OK) return status;
  return tp_effects_entered(
      status, message, tp_effects_note(solution, "joint", tp_scene_shift_place(scene), "", began));
}

static tp_status smooth(tp_smoothed **smoothed, const tp_scene *scene, tp_solution *solution,
                        tp_message *message) {
  const tp_effect_begin began = tp_effects_begin(solution);
  const tp_place place =
      scene->base.smooth.given ? scene->base.smooth.place : scene->friction_is_place;
  const tp_status status = tp_smoothed_init(smoothed, scene, message);
  if (status != TP_OK) return status;
  return tp_effects_entered(status, message, tp_effects_note(solution, "smooth", place, "", began));
}

tp_status tp_placement_init(tp_placement *placement, const tp_scene **scene,
                            const tp_solve_options *options, tp_solution *solution,
                            tp_message *message) {
  tp_placement *p = placement;
  const bool shifts = tp_scene_is_shifted(*scene), turns = tp_scene_lies_in_place(*scene);
  if (tp_smoothed_is_asked(*scene)) {
    const tp_status status = smooth(&p->smoothed, *scene, solution, message);
    if (status != TP_OK) return status;
    if (p->smoothed != NULL) *scene = &p->smoothed->scene;
  }
  const bool lies_along = shifts || (*scene)->frame == TP_FRAME_SLOPE;
  if (turns && lies_along) {
    const tp_status status = turn(&p->world, *scene, options, solution, message);
    if (status != TP_OK) return status;
    *scene = &p->world->scene;
  }
  if (shifts) {
    const tp_status status = shift(&p->jointed, *scene, solution, message);
    if (status != TP_OK) return status;
    *scene = &p->jointed->scene;
  }
  if ((*scene)->base.rests) {
    const tp_status status = set_down(&p->rested, *scene, options, solution, message);
    if (status != TP_OK) return status;
    *scene = &p->rested->scene;
  }
  if ((*scene)->base.within.given) {
    const tp_status status = snap(&p->snapped, *scene, solution, message);
    if (status != TP_OK) return status;
    *scene = &p->snapped->scene;
  }
  if (turns && !lies_along) {
    const tp_status status = turn(&p->world, *scene, options, solution, message);
    if (status != TP_OK) return status;
    *scene = &p->world->scene;
  }
  if (lies_along && turns && p->world->goes_up_dip) return tp_world_level(p->world, scene, message);
  return TP_OK;
}

void tp_placement_clear(tp_placement *placement) {
  tp_world_free(placement->world);
  tp_snapped_free(placement->snapped);
  tp_rested_free(placement->rested);
  tp_jointed_free(placement->jointed);
  tp_smoothed_free(placement->smoothed);
  *placement = (tp_placement){0};
}
