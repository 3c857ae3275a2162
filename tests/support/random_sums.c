/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "random_sums.h"

/* Three corners: 2 area (1, sum x, sum y, sum x_i x_j over i <= j, likewise y, sum x sum y + sum
 * x_i y_i). */
static void add_triangle(sums *s, const polygon *p, long k) {
  const wide x0 = p->x[0], x1 = p->x[k], x2 = p->x[k + 1];
  const wide y0 = p->y[0], y1 = p->y[k], y2 = p->y[k + 1];
  const wide twice = (x1 - x0) * (y2 - y0) - (x2 - x0) * (y1 - y0);
  const wide x = x0 + x1 + x2, y = y0 + y1 + y2;
  s->of[TP_A2] += twice;
  s->of[TP_X6] += twice * x;
  s->of[TP_Y6] += twice * y;
  s->of[TP_XX12] += twice * (x * x - x0 * x1 - x1 * x2 - x2 * x0);
  s->of[TP_YY12] += twice * (y * y - y0 * y1 - y1 * y2 - y2 * y0);
  s->of[TP_XY24] += twice * (x * y + x0 * y0 + x1 * y1 + x2 * y2);
}

sums polygon_sums(const polygon *p) {
  sums s = {{0}};
  for (long k = 1; k + 1 < p->count; k++) add_triangle(&s, p, k);
  return s;
}

void fmpz_set_wide(fmpz_t integer, wide value) {
  const unsigned __int128 size = value < 0 ? -(unsigned __int128)value : (unsigned __int128)value;
  fmpz_set_uiui(integer, (ulong)(size >> 64), (ulong)size);
  if (value < 0) fmpz_neg(integer, integer);
}

void draw_polygon(polygon *p, random_numbers *state) {
  const long most = draw_once_in(state, 256) ? 500 : draw_once_in(state, 16) ? 60 : 9;
  const long count = 4 + draw_below(state, most - 3);
  const long height = 1L << draw_below(state, 14), step = 1L << draw_below(state, 10);
  if (draw_once_in(state, 4)) {
    draw_star(p, count - 1, (double)(16 * step), (double)height, state);
  } else {
    draw_between_chains(p, count, step, height, state);
  }
  if (draw_once_in(state, 2)) polygon_shear(p, draw_signed(state, 3), 0);
}
