/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Centroid in balls with enough bits for exact cancellation, and points relative to it rounded to
 * doubles. */

#include "rigid_body/local.h"

#include "number/ball.h"

void tp_local_init(tp_local *local, const tp_problem *problem) {
  /* sums of products of four coordinates, and a double's 53 bits behind what cancels */
  enum { DEGREE = 4, SPARE = 128 };
  const tp_solve_options options = tp_solve_options_default();
  const tp_rung rung = {TP_LEVEL_BALL, DEGREE * problem->lattice.bits + SPARE};
  tp_evaluation_init(&local->e, problem, rung, &options);
  const arb_struct *sums = local->e.moments.weighted;
  arb_init(local->x);
  arb_init(local->y);
  arb_div(local->x, sums + TP_X6, sums + TP_A2, rung.bits);
  arb_div(local->y, sums + TP_Y6, sums + TP_A2, rung.bits);
  arb_div_ui(local->x, local->x, 3, rung.bits); /* 6 int x over 2 int 1 */
  arb_div_ui(local->y, local->y, 3, rung.bits);
}

void tp_local_clear(tp_local *local) {
  arb_clear(local->x);
  arb_clear(local->y);
  tp_evaluation_clear(&local->e);
}

double tp_local_nearest(const arb_t ball) {
  return tp_ball_nearest(arb_midref(ball));
}

static double coordinate(const tp_local *local, const arb_t lattice_units, const arb_t centroid) {
  arb_t metres;
  arb_init(metres);
  arb_sub(metres, lattice_units, centroid, local->e.rung.bits);
  tp_evaluation_to_metres(metres, &local->e, 1);
  const double value = tp_local_nearest(metres);
  arb_clear(metres);
  return value;
}

tp_xy tp_local_point(const tp_local *local, const arb_t x, const arb_t y) {
  return (tp_xy){coordinate(local, x, local->x), coordinate(local, y, local->y)};
}

tp_xy tp_local_outline_point(const tp_local *local, tp_outline_point at) {
  arb_t x, y;
  arb_init(x);
  arb_init(y);
  tp_evaluation_point(x, y, &local->e, at);
  const tp_xy point = tp_local_point(local, x, y);
  arb_clear(x);
  arb_clear(y);
  return point;
}

tp_xy tp_local_lattice_point(const tp_local *local, long point) {
  return tp_local_outline_point(local, (tp_outline_point){.point = point});
}
