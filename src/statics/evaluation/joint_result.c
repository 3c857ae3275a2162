/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* How open a joint is whose block was shifted along its base and came to rest (base/aperture.h). */

#include "base/aperture.h"
#include "evaluation/certainty.h"
#include "evaluation/stages.h"
#include "number/ball.h"

enum { BITS = 128 };

static tp_bounded metres(const tp_scene *scene, const fmpq_t length) {
  fmpq_t scaled;
  fmpq_init(scaled);
  fmpq_mul(scaled, length, scene->metres_per_unit);
  const tp_bounded result = tp_result_rational(scaled);
  fmpq_clear(scaled);
  return result;
}

static tp_bounded ball_metres(const tp_scene *scene, const arb_t length) {
  arb_t scaled;
  arb_init(scaled);
  arb_set_fmpq(scaled, scene->metres_per_unit, BITS);
  arb_mul(scaled, scaled, length, BITS);
  const tp_bounded result = tp_ball_bounded(scaled);
  arb_clear(scaled);
  return result;
}

/* Normal to the mean plane, also where the block was laid level as it lies on that. */
static void measure(tp_aperture *a, const tp_problem *problem) {
  const tp_sole *sole = &problem->placement.jointed->sole;
  const fmpq *closure = problem->scene->base.closure.value;
  const tp_scene *along = problem->placement.world != NULL ? problem->placement.world->along : NULL;
  if (along != NULL) {
    const tp_polyline *profile = &along->base.profile;
    tp_aperture_measure(a, &along->block.outline, sole->first, sole->count, profile, profile->count,
                        closure, BITS);
  } else {
    tp_aperture_measure(a, problem->section.rings, sole->first, sole->count, &problem->base.ring,
                        problem->base.edge_count + 1, closure, BITS);
  }
}

void tp_describe_joint(tp_solution *solution, const tp_problem *problem) {
  const tp_jointed *j = problem->placement.jointed;
  if (j == NULL) return;
  const tp_scene *scene = problem->scene;
  const tp_base_description *base = &scene->base;
  tp_joint_result *result = &solution->joint;
  tp_aperture a;
  tp_aperture_init(&a);
  measure(&a, problem);
  *result = (tp_joint_result){.known = true,
                              .shift_m = metres(scene, j->shift),
                              .above_base_m = ball_metres(scene, a.covered),
                              .largest_gap_m = metres(scene, a.largest),
                              .has_closure = base->closure.given,
                              .closure_m = metres(scene, base->closure.value)};
  /* Of the two that are divided by neither is zero: it rests on what it has above the base. */
  arb_div(a.area, a.area, a.covered, BITS);
  arb_div(a.matched, a.matched, a.length, BITS);
  result->mean_gap_m = ball_metres(scene, a.area);
  result->matching = tp_ball_bounded(a.matched);
  result->has_matching_sought = j->sought;
  result->matching_sought = tp_result_rational(base->matching.value);
  result->shift_before_m = metres(scene, j->before);
  result->matching_before = j->before_matching;
  tp_aperture_clear(&a);
}
