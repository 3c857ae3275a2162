/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Undoes the turns of a problem's world, the last one first. A turn about (x0, y0) takes d = p - p0
 * to (c dx + s dy, c dy - s dx), so that (c dx - s dy, c dy + s dx) / (c² + s²) undoes it, also
 * where c and s are cut off. */

#include "problem/drawn.h"

#include "number/ball.h"

enum { AXIS_BITS = 256 };

/* The turns that the problem's points have gone through, from the last to the first. */
static int turns_of(const tp_turn *turns[2], const tp_problem *problem) {
  const tp_world *world = problem->placement.world;
  int count = 0;
  if (world == NULL) return 0;
  if (world->level) turns[count++] = &world->lay;
  const bool along_first = world->along != NULL || !world->level;
  if (!world->unturned && along_first) turns[count++] = &world->turn;
  return count;
}

bool tp_drawn_is_same(const tp_problem *problem) {
  const tp_turn *turns[2];
  const int count = turns_of(turns, problem);
  bool same = true;
  for (int k = 0; k < count; k++) same = same && fmpq_is_zero(turns[k]->sine);
  return same;
}

void tp_drawn_point(fmpq_t x, fmpq_t y, const tp_problem *problem) {
  const tp_turn *turns[2];
  const int count = turns_of(turns, problem);
  for (int k = 0; k < count; k++) tp_turn_back_point(x, y, turns[k]);
}

static void turn_back_ball(arb_t x, arb_t y, const tp_turn *turn, const fmpq *metres, long bits) {
  fmpq_t number;
  arb_t c, s, from_x, from_y, square, dx, dy;
  arb_struct *const all[] = {c, s, from_x, from_y, square, dx, dy};
  fmpq_init(number);
  for (size_t k = 0; k < sizeof all / sizeof all[0]; k++) arb_init(all[k]);
  arb_set_fmpq(c, turn->cosine, bits);
  arb_set_fmpq(s, turn->sine, bits);
  fmpq_mul(number, turn->x, metres);
  arb_set_fmpq(from_x, number, bits);
  fmpq_mul(number, turn->y, metres);
  arb_set_fmpq(from_y, number, bits);
  fmpq_mul(number, turn->cosine, turn->cosine);
  fmpq_addmul(number, turn->sine, turn->sine);
  arb_set_fmpq(square, number, bits);
  arb_sub(dx, x, from_x, bits);
  arb_sub(dy, y, from_y, bits);
  arb_mul(x, c, dx, bits);
  arb_submul(x, s, dy, bits);
  arb_div(x, x, square, bits);
  arb_add(x, x, from_x, bits);
  arb_mul(y, c, dy, bits);
  arb_addmul(y, s, dx, bits);
  arb_div(y, y, square, bits);
  arb_add(y, y, from_y, bits);
  for (size_t k = 0; k < sizeof all / sizeof all[0]; k++) arb_clear(all[k]);
  fmpq_clear(number);
}

void tp_drawn_ball(arb_t x_m, arb_t y_m, const tp_problem *problem, long bits) {
  const tp_turn *turns[2];
  const int count = turns_of(turns, problem);
  for (int k = 0; k < count; k++) {
    turn_back_ball(x_m, y_m, turns[k], problem->scene->metres_per_unit, bits);
  }
}

void tp_drawn_axis(fmpq_t cosine, fmpq_t sine, const tp_problem *problem) {
  const tp_turn *turns[2];
  const int count = turns_of(turns, problem);
  fmpq_t c, s;
  fmpq_init(c);
  fmpq_init(s);
  fmpq_one(cosine);
  fmpq_zero(sine);
  for (int k = 0; k < count; k++) {
    fmpq_mul(c, cosine, turns[k]->cosine);
    fmpq_submul(c, sine, turns[k]->sine);
    fmpq_mul(s, cosine, turns[k]->sine);
    fmpq_addmul(s, sine, turns[k]->cosine);
    fmpq_swap(cosine, c);
    fmpq_swap(sine, s);
  }
  fmpq_clear(c);
  fmpq_clear(s);
}

void tp_drawn_axis_degrees(arb_t degrees, const tp_problem *problem) {
  fmpq_t cosine, sine;
  arb_t c;
  fmpq_init(cosine);
  fmpq_init(sine);
  arb_init(c);
  tp_drawn_axis(cosine, sine, problem);
  arb_set_fmpq(c, cosine, AXIS_BITS);
  arb_set_fmpq(degrees, sine, AXIS_BITS);
  tp_ball_atan2_degrees(degrees, degrees, c, AXIS_BITS);
  fmpq_clear(cosine);
  fmpq_clear(sine);
  arb_clear(c);
}
