/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A rotation by an exact direction, divided by the square of its length. */

#include "load/lie.h"

#include "number/ball.h"
#include "plane/direction.h"

void tp_lie_init(tp_lie *lie) {
  fmpq *const all[] = {lie->up_x, lie->up_y, lie->square, lie->x, lie->y};
  for (int k = 0; k < 5; k++) fmpq_init(all[k]);
  fmpq_one(lie->up_y);
  fmpq_one(lie->square);
}

void tp_lie_clear(tp_lie *lie) {
  fmpq *const all[] = {lie->up_x, lie->up_y, lie->square, lie->x, lie->y};
  for (int k = 0; k < 5; k++) fmpq_clear(all[k]);
}

/* Up is (sin a, cos a) where the left is lowered, and mirrored to the right. */
void tp_lie_tilt(tp_lie *lie, const fmpq_t degrees, bool left) {
  arb_t sine, cosine;
  arb_init(sine);
  arb_init(cosine);
  tp_ball_sin_cos_degrees(sine, cosine, degrees, TP_DIRECTION_BITS);
  arf_get_fmpq(lie->up_x, arb_midref(sine));
  arf_get_fmpq(lie->up_y, arb_midref(cosine));
  if (!left) fmpq_neg(lie->up_x, lie->up_x);
  arb_clear(sine);
  arb_clear(cosine);
}

void tp_lie_measure(tp_lie *lie) {
  fmpq_mul(lie->square, lie->up_x, lie->up_x);
  fmpq_addmul(lie->square, lie->up_y, lie->up_y);
}

void tp_lie_of(fmpq_t across, fmpq_t up, const tp_lie *lie, const fmpq_t x, const fmpq_t y) {
  fmpq_t dx, dy, a, u;
  fmpq *const all[] = {dx, dy, a, u};
  for (int k = 0; k < 4; k++) fmpq_init(all[k]);
  fmpq_sub(dx, x, lie->x);
  fmpq_sub(dy, y, lie->y);
  fmpq_mul(a, lie->up_y, dx);
  fmpq_submul(a, lie->up_x, dy);
  fmpq_mul(u, lie->up_x, dx);
  fmpq_addmul(u, lie->up_y, dy);
  fmpq_div(a, a, lie->square);
  fmpq_div(u, u, lie->square);
  fmpq_add(across, a, lie->x);
  fmpq_add(up, u, lie->y);
  for (int k = 0; k < 4; k++) fmpq_clear(all[k]);
}
