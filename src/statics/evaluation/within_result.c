/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What was moved where all within a distance touches: roots of exact squares as balls, and the gap
 * left, which is told in doubles. */

#include "evaluation/certainty.h"
#include "evaluation/stages.h"
#include "number/ball.h"

enum { BITS = 128 };

static tp_bounded root_metres(const tp_scene *scene, const fmpq_t square) {
  arb_t root, unit;
  arb_init(root);
  arb_init(unit);
  arb_set_fmpq(root, square, BITS);
  arb_sqrt(root, root, BITS);
  arb_set_fmpq(unit, scene->metres_per_unit, BITS);
  arb_mul(root, root, unit, BITS);
  const tp_bounded result = tp_ball_bounded(root);
  arb_clear(root);
  arb_clear(unit);
  return result;
}

void tp_describe_within(tp_solution *solution, const tp_problem *problem) {
  const tp_snapped *s = problem->placement.snapped;
  if (s == NULL) return;
  const tp_scene *scene = &s->scene;
  arb_t gap, unit;
  fmpq_t within;
  arb_init(gap);
  arb_init(unit);
  fmpq_init(within);
  fmpq_mul(within, scene->base.within.value, scene->metres_per_unit);
  tp_ball_set_bounded(gap, s->gap, s->gap_error);
  arb_set_fmpq(unit, scene->metres_per_unit, BITS);
  arb_mul(gap, gap, unit, BITS);
  solution->within = (tp_within_result){.known = true,
                                        .moved = (size_t)s->snap.moved_count,
                                        .taken = (size_t)s->snap.taken_count,
                                        .within_m = tp_result_rational(within),
                                        .farthest_m = root_metres(scene, s->snap.most),
                                        .gap_left_m = tp_ball_bounded(gap),
                                        .overlap_removed_m = root_metres(scene, s->snap.overlap)};
  arb_clear(gap);
  arb_clear(unit);
  fmpq_clear(within);
}
