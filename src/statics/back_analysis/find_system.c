/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Back-analysis of many blocks. While a number is looked for only limits and factors are computed,
 * without the motions that can begin; with each number that is found all of it, as limit analysis
 * alone does not say that the blocks stand. */

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
                     "%s is of one block on its base; of many blocks there are fos, by strength "
                     "reduction, governing_fos, the lesser of that and the factor on what drives, "
                     "limit_angle, critical_acceleration, and of columns fos_goodman_bray",
                     tp_find_target_name(s->options->target));
  }
}

static void take_factor(tp_sample *at, bool *unbounded, const tp_fos *fos, bool is_least) {
  *unbounded = fos->state == TP_FOS_NUMBER && is_least;
  at->known = fos->state == TP_FOS_NUMBER && !is_least;
  at->result = fos->value;
}

/* The one that governs; where proofs leave it open its upper bound, which is a proven motion or a
 * limit of what forces can hold. */
static void take_governing(tp_sample *at, bool *unbounded, const tp_system_safety *safety) {
  *unbounded = isinf(safety->at_most);
  at->known = safety->fos.state == TP_FOS_NUMBER || isfinite(safety->at_most);
  at->result = safety->fos.state == TP_FOS_NUMBER ? safety->fos.value
                                                  : (tp_bounded){.value = safety->at_most};
}

static void take_from_case(tp_sample *at, bool *unbounded, const tp_system_case *own,
                           tp_find_target target) {
  const tp_goodman_bray *columns = &own->goodman_bray;
  switch (target) {
  case TP_FIND_GOVERNING_FOS:
    take_governing(at, unbounded, &own->governing_fos);
    break;
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

tp_status tp_search_take_system(tp_sample *at, bool *unbounded, tp_search *s) {
  tp_scene *scene = NULL;
  tp_block_system *system = NULL;
  tp_status status = tp_varied_scene(&scene, &s->varied, &at->x, &s->why);
  if (status == TP_OK) {
    const tp_motions_sought motions = s->options->target == TP_FIND_GOVERNING_FOS
                                          ? tp_block_system_cheap_motions(scene)
                                          : TP_MOTIONS_NONE;
    status = tp_block_system_solve(&system, scene, &s->varied.options, motions, &s->why);
  }
  if (status == TP_OK) take_from_system(at, unbounded, system, s->options->target);
  tp_block_system_free(system);
  tp_scene_free(scene);
  return status;
}

static void tell_system(tp_found_blocks *blocks, const tp_system_case *own) {
  const tp_goodman_bray *columns = &own->goodman_bray;
  *blocks = (tp_found_blocks){.verdict = tp_system_case_worst_verdict(own),
                              .has_standing_fos = own->has_standing_fos,
                              .standing_fos = own->standing_fos,
                              .has_moving_fos =
                                  own->has_moving_fos && !(own->fos.state == TP_FOS_NUMBER &&
                                                           own->moving_fos >= own->fos.value.value),
                              .moving_fos = own->moving_fos,
                              .has_fos_goodman_bray = columns->applies && columns->has_fos,
                              .fos_goodman_bray = columns->fos};
}

void tp_search_tell_blocks(tp_search *s) {
  tp_found *found = s->found;
  found->blocks = calloc(found->count, sizeof *found->blocks);
  if (found->blocks == NULL) {
    s->status = tp_fail_memory(s->message, "the solutions");
    return;
  }
  s->varied.options.strength_reduction = true;
  for (size_t k = 0; k < found->count && s->status == TP_OK; k++) {
    tp_scene *scene = NULL;
    tp_block_system *system = NULL;
    found->blocks[k].verdict = TP_SYSTEM_UNDECIDED;
    tp_status status = tp_varied_scene(&scene, &s->varied, &found->solutions[k].value, &s->why);
    if (status == TP_OK) {
      status = tp_solve_block_system(&system, scene, &s->varied.options, &s->why);
    }
    if (status == TP_OK) tell_system(found->blocks + k, tp_system_governing(system));
    if (status == TP_OUT_OF_MEMORY || status == TP_SYSTEM_FAILED) {
      s->status = tp_fail(s->message, status, (tp_place){0}, "%s", s->why.text);
    }
    tp_block_system_free(system);
    tp_scene_free(scene);
  }
}
