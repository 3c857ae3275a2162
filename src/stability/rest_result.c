/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Where a block that was set down came to rest: exact numbers, and the angle of its turn, whose
 * bound is that of a ball. */

#include "number/ball.h"
#include "stability/certainty.h"
#include "stability/stages.h"

static tp_bounded metres(const tp_rested *r, const fmpq_t length) {
  fmpq_t scaled;
  fmpq_init(scaled);
  fmpq_mul(scaled, length, r->scene.metres_per_unit);
  const tp_bounded result = tp_result_rational(scaled);
  fmpq_clear(scaled);
  return result;
}

void tp_describe_rest(tp_solution *solution, const tp_problem *problem) {
  enum { BITS = 128 };
  const tp_rested *r = problem->rested;
  tp_rest_result *result = &solution->rest;
  if (r == NULL) return;
  const tp_bodies *b = &r->settling.bodies;
  fmpq_t length;
  arb_t x, y;
  fmpq_init(length);
  arb_init(x);
  arb_init(y);
  *result = (tp_rest_result){.known = true,
                             .turns = (size_t)r->settling.turns,
                             .touches = (size_t)r->settling.touches.count,
                             .margin_left_m = metres(r, r->left),
                             .margin_right_m = metres(r, r->right)};
  fmpq_sub(length, &b->centroid.x, &b->own_centroid.x);
  result->moved_x_m = metres(r, length);
  fmpq_sub(length, &b->centroid.y, &b->own_centroid.y);
  result->moved_y_m = metres(r, length);
  arb_set_fmpq(x, b->pose.cosine, BITS);
  arb_set_fmpq(y, b->pose.sine, BITS);
  tp_ball_atan2_degrees(y, y, x, BITS);
  result->turned_deg = tp_ball_bounded(y);
  fmpq_clear(length);
  arb_clear(x);
  arb_clear(y);
}
