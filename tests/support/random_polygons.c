/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "random_polygons.h"

#include <math.h>

void polygon_add(polygon *p, long x, long y) {
  p->x[p->count] = x;
  p->y[p->count++] = y;
}

void draw_star(polygon *p, long count, double radius_x, double radius_y, random_numbers *state) {
  p->count = 0;
  for (long k = 0; k < count; k++) {
    const double angle = 2 * acos(-1) * ((double)k + 0.4 * draw_part(state)) / (double)count;
    const double part = 0.3 + 0.7 * draw_part(state);
    polygon_add(p, lround(part * radius_x * cos(angle)), lround(part * radius_y * sin(angle)));
  }
}

void draw_between_chains(polygon *p, long count, long step, long height, random_numbers *state) {
  const long lower = 2 + draw_below(state, count - 3), upper = count - lower;
  long x = 0;
  p->count = 0;
  for (long k = 0; k < lower; k++) {
    polygon_add(p, x, draw_below(state, height + 1));
    x += 1 + draw_below(state, step);
  }
  const long right = p->x[lower - 1];
  x = right;
  for (long k = 0; k + 1 < upper && x > 0; k++) {
    polygon_add(p, x, height + 1 + draw_below(state, height));
    x -= 1 + draw_below(state, 2 * (right / upper) + 1);
  }
  polygon_add(p, 0, height + 1 + draw_below(state, height));
}

void polygon_shear(polygon *p, long along, long up) {
  for (long k = 0; k < p->count; k++) p->x[k] += along * p->y[k];
  for (long k = 0; k < p->count; k++) p->y[k] += up * p->x[k];
}
