/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Where a block that was set down came to rest: exact numbers, and the angle of its turn, whose
 * bound is that of a ball. */

#include "evaluation/rest_result.h"

#include "evaluation/certainty.h"
#include "evaluation/stages.h"
#include "number/ball.h"

tp_bounded tp_rest_metres(const tp_rested *r, const fmpq_t length) {
  fmpq_t scaled;
  fmpq_init(scaled);
  fmpq_mul(scaled, length, r->scene.metres_per_unit);
  const tp_bounded result = tp_result_rational(scaled);
  fmpq_clear(scaled);
  return result;
}

tp_bounded tp_rest_turned_deg(const tp_rested *r) {
  enum { BITS = 128 };
  arb_t x, y;
  arb_init(x);
  arb_init(y);
  arb_set_fmpq(x, r->settling.bodies.pose.cosine, BITS);
  arb_set_fmpq(y, r->settling.bodies.pose.sine, BITS);
  tp_ball_atan2_degrees(y, y, x, BITS);
  const tp_bounded turned = tp_ball_bounded(y);
  arb_clear(x);
  arb_clear(y);
  return turned;
}

tp_rest_result tp_rest_result_of(const tp_rested *r) {
  const tp_bodies *b = &r->settling.bodies;
  fmpq_t length;
  fmpq_init(length);
  tp_rest_result result = {.known = true,
                           .turns = (size_t)r->settling.turns,
                           .contacts = (size_t)r->settling.touches.count,
                           .turned_deg = tp_rest_turned_deg(r),
                           .margin_left_m = tp_rest_metres(r, r->left),
                           .margin_right_m = tp_rest_metres(r, r->right)};
  fmpq_sub(length, &b->centroid.x, &b->own_centroid.x);
  result.moved_x_m = tp_rest_metres(r, length);
  fmpq_sub(length, &b->centroid.y, &b->own_centroid.y);
  result.moved_y_m = tp_rest_metres(r, length);
  fmpq_clear(length);
  return result;
}

void tp_describe_rest(tp_solution *solution, const tp_problem *problem) {
  if (problem->placement.rested != NULL)
    solution->rest = tp_rest_result_of(problem->placement.rested);
}
