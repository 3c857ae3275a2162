/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Back-analysis of many blocks. While a factor of safety is looked for in a scene of more than a
 * few of them, its upper bounds are computed alone, without the motions that can begin. At each
 * number found everything is. Where a smaller factor is proven there, the number is moved to where
 * none is, or given up. */

#include "back_analysis/find_system.h"

#include "block_system/governing_case.h"
#include "block_system/system.h"
#include "common/message.h"

#include <math.h>
#include <stdlib.h>

tp_status tp_search_check_system(const tp_search *s) {
  const tp_place place = {s->varied.scene->path, 0, 0};
  if (s->options->least_over != NULL) {
    return tp_refuse(s->message, TP_FAULT_ARGUMENT, place,
                     "the direction of the least force is looked for of one block; of many, "
                     "'support: {block: …, at: [x, y], direction_deg: …, fos: …}' gives the least "
                     "force along a direction");
  }
  switch (s->options->target) {
  case TP_FIND_FOS:
  case TP_FIND_LIMIT_FOS:
  case TP_FIND_GOVERNING_FOS:
  case TP_FIND_LIMIT_ANGLE:
  case TP_FIND_FOS_GOODMAN_BRAY:
  case TP_FIND_ACCELERATION:
    return TP_OK;
  default:
    return tp_refuse(s->message, TP_FAULT_ARGUMENT, place,
                     "%s is of one block on its base; of many blocks there are fos, the factor of "
                     "safety, limit_fos, its upper bound by strength reduction, limit_angle, "
                     "critical_acceleration, and of columns fos_goodman_bray",
                     tp_find_target_name(s->options->target));
  }
}

static void take_factor(tp_sample *at, bool *unbounded, const tp_fos *fos, bool is_least) {
  *unbounded = fos->state == TP_FOS_NUMBER && is_least;
  at->known = fos->state == TP_FOS_NUMBER && !is_least;
  at->result = fos->value;
}

bool tp_find_target_is_governing(tp_find_target target) {
  return target == TP_FIND_FOS || target == TP_FIND_GOVERNING_FOS;
}

/* The factor of safety; where proofs leave it open its upper bound, which is a proven motion or a
 * limit of what forces can hold. */
static void take_governing(tp_sample *at, bool *unbounded, const tp_system_safety *safety) {
  const bool is_number = safety->fos.state == TP_FOS_NUMBER;
  at->is_bound = safety->fos.state == TP_FOS_UNDECIDED;
  at->known = is_number || isfinite(safety->at_most);
  at->result = is_number ? safety->fos.value : (tp_bounded){.value = safety->at_most};
  at->result.digits = NULL;
  *unbounded = isinf(safety->at_most) && !at->is_bound;
}

static void take_from_case(tp_sample *at, bool *unbounded, const tp_system_case *own,
                           tp_find_target target) {
  const tp_goodman_bray *columns = &own->goodman_bray;
  switch (target) {
  case TP_FIND_LIMIT_ANGLE:
    *unbounded = own->limit == TP_SYSTEM_INTERLOCKED;
    at->known = own->limit == TP_SYSTEM_LIMIT_NUMBER;
    at->result = own->critical_angle_deg;
    break;
  case TP_FIND_FOS_GOODMAN_BRAY:
    *unbounded = columns->applies && columns->has_fos && columns->fos_is_least;
    at->known = columns->applies && columns->has_fos && !columns->fos_is_least;
    at->result = (tp_bounded){.value = columns->fos};
    break;
  case TP_FIND_ACCELERATION:
    at->known = own->has_acceleration;
    at->result = own->critical_acceleration_g;
    break;
  default:
    take_factor(at, unbounded, &own->fos, own->fos_is_least);
    break;
  }
  at->result.digits = NULL;
}

/* The least over all directions; not known where one of them is not. */
static void take_from_system(tp_sample *at, bool *unbounded, const tp_block_system *system,
                             tp_find_target target) {
  if (tp_find_target_is_governing(target)) {
    take_governing(at, unbounded, &system->governing_fos);
    return;
  }
  tp_sample least = *at;
  bool all_unbounded = true, all_known = true, any = false;
  for (size_t k = 0; k < system->case_count; k++) {
    tp_sample one = *at;
    bool beyond = false;
    take_from_case(&one, &beyond, system->cases + k, target);
    all_unbounded = all_unbounded && beyond;
    if (beyond) continue;
    all_known = all_known && one.known;
    if (!any || one.result.value < least.result.value) least = one;
    any = true;
  }
  *unbounded = all_unbounded;
  if (any) *at = least;
  at->known = any && all_known;
}

tp_status tp_search_solve_system(tp_block_system **system, tp_search *s, double x,
                                 tp_motions_sought motions) {
  tp_scene *scene = NULL;
  tp_status status = tp_varied_scene(&scene, &s->varied, &x, &s->why);
  if (status == TP_OK) {
    status = tp_block_system_solve(system, scene, &s->varied.options, motions, &s->why);
  }
  tp_scene_free(scene);
  return status;
}

tp_motions_sought tp_search_cheap_motions(const tp_search *s) {
  enum { FEW = 2 };
  const tp_scene *scene = s->varied.scene;
  long free_blocks = 0;
  for (long k = 0; k < scene->many.count; k++) free_blocks += !scene->many.blocks[k].fixed;
  return free_blocks <= FEW ? TP_MOTIONS_ALL : TP_MOTIONS_NONE;
}

tp_status tp_search_take_system(tp_sample *at, bool *unbounded, tp_search *s) {
  tp_block_system *system = NULL;
  const tp_motions_sought motions = tp_find_target_is_governing(s->options->target)
                                        ? tp_search_cheap_motions(s)
                                        : TP_MOTIONS_NONE;
  const tp_status status = tp_search_solve_system(&system, s, at->x, motions);
  if (status == TP_OK) take_from_system(at, unbounded, system, s->options->target);
  tp_block_system_free(system);
  return status;
}
