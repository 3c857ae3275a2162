/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A rotation by an exact direction, divided by the square of its length. */

#include "load/lie.h"

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
