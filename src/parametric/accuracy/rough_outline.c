/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Outline with a random underside by integers of a linear congruential generator (Knuth), closed by
 * a flat top. */

#include "accuracy/rough_outline.h"

#include <stdint.h>

/* The next of a fixed sequence of numbers from 0 to `below` - 1 (Knuth's linear congruence). */
static long draw(uint64_t *state, long below) {
  *state = *state * 6364136223846793005U + 1442695040888963407U;
  return (long)(*state >> 33) % below;
}

void tp_rough_outline(double *x, double *y, long count) {
  uint64_t state = 2026;
  const long foot = count - 2;
  long along = 0, height = 0;
  for (long k = 0; k < foot; k++) {
    x[k] = (double)along;
    y[k] = k + 1 == foot ? 0 : (double)height;
    along += 60 + draw(&state, 81);
    height += draw(&state, 101) - 50 - height / 64;
  }
  x[foot] = x[foot - 1];
  x[foot + 1] = x[0];
  const long top = 4096 + along / 5 * 2;
  y[foot] = y[foot + 1] = (double)top;
}
