/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The public call that solves a scene of many blocks; with partial factors: each combination of
 * favourable and unfavourable actions is solved as a scene of its own, and the worst governs. One
 * that does not certainly reach what is required is worse than one that does, so that what is met
 * is met in all of them; among equals, as of directions of tilt (block_system/governing_case.h). */

#include "block_system/governing_case.h"
#include "block_system/system.h"
#include "common/host.h"
#include "scene/partial_factors.h"

static bool is_worse(const tp_block_system *one, const tp_block_system *other) {
  const tp_design first = tp_block_system_meets(one, one->required_fos.value);
  const tp_design second = tp_block_system_meets(other, other->required_fos.value);
  if (first == second) {
    return tp_system_case_is_worse(tp_system_most_severe(one), tp_system_most_severe(other));
  }
  return first == TP_DESIGN_NOT_MET || (first == TP_DESIGN_OPEN && second == TP_DESIGN_MET);
}

static tp_status solve_combination(tp_block_system **system, const tp_scene *scene,
                                   unsigned combination, const tp_solve_options *options,
                                   tp_motions_sought motions, tp_message *message) {
  tp_scene factored;
  tp_status status = tp_factored_init(&factored, scene, combination, message);
  if (status != TP_OK) return status;
  status = tp_block_system_solve_as_given(system, &factored, options, motions, message);
  tp_factored_clear(&factored);
  return status;
}

static tp_status solve_combinations(tp_block_system **system, const tp_scene *scene,
                                    const tp_solve_options *options, tp_motions_sought motions,
                                    tp_message *message) {
  tp_block_system *worst = NULL;
  unsigned governing = 0, solved = 0;
  tp_status status = TP_OK;
  for (unsigned k = 0; k < TP_COMBINATIONS && status == TP_OK; k++) {
    tp_block_system *own = NULL;
    if (!tp_combination_differs(scene, k)) continue;
    status = solve_combination(&own, scene, k, options, motions, message);
    if (status != TP_OK) break;
    solved++;
    if (worst == NULL || is_worse(own, worst)) {
      tp_block_system_free(worst);
      worst = own;
      governing = k;
    } else {
      tp_block_system_free(own);
    }
  }
  if (status == TP_OK) {
    worst->partial_factors = tp_factored_text(scene, governing, solved);
    status = tp_factored_note(&worst->notes, scene, worst->partial_factors, message);
  }
  if (status == TP_OK) {
    *system = worst;
  } else {
    tp_block_system_free(worst);
  }
  return status;
}

tp_status tp_block_system_solve(tp_block_system **system, const tp_scene *scene,
                                const tp_solve_options *options, tp_motions_sought motions,
                                tp_message *message) {
  const bool factored = scene->partial_factors != NULL && scene->many.count > 0;
  return factored ? solve_combinations(system, scene, options, motions, message)
                  : tp_block_system_solve_as_given(system, scene, options, motions, message);
}

tp_status tp_solve_block_system(tp_block_system **system, const tp_scene *scene,
                                const tp_solve_options *options, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, system);
  TP_REFUSE_NULL(message, scene);
  TP_REFUSE_NULL(message, options);
  return tp_block_system_solve(system, scene, options, TP_MOTIONS_ALL, message);
}
