/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "random_blocks.h"

#include <math.h>
#include <string.h>

bool same_bytes(const void *one, const void *other, size_t size) {
  return memcmp(one, other, size) == 0;
}

/* Teeth with upright walls below a level top, the walls of the second kind leaning back. */
static void draw_steps(polygon *p, random_numbers *state) {
  const long teeth = 1 + draw_below(state, 20), lean = draw_below(state, 3) - 1;
  const long depth = 1 + draw_below(state, 12), height = 20 + draw_below(state, 400);
  p->count = 0;
  for (long k = 0; k < teeth; k++) {
    polygon_add(p, 20 * k, 0);
    polygon_add(p, 20 * k + 10, 0);
    polygon_add(p, 20 * k + 10 + lean, depth);
    polygon_add(p, 20 * k + 20 + lean, depth);
  }
  polygon_add(p, 20 * teeth, height);
  polygon_add(p, 0, height);
}

/* An underside of edges at 0, 45 and -45 degrees, which ends anywhere on its way. */
static void draw_at_45(polygon *p, random_numbers *state) {
  const long edges = 2 + draw_below(state, 20);
  long y = 0, least = 0;
  p->count = 0;
  for (long k = 0; k <= edges; k++) {
    polygon_add(p, k, y);
    least = y < least ? y : least;
    y += draw_below(state, 3) - 1;
  }
  const long height = edges + 2 + draw_below(state, 60);
  polygon_add(p, edges, height);
  polygon_add(p, 0, height);
}

static void draw_shape(polygon *p, random_numbers *state) {
  const long count = 4 + draw_below(state, draw_once_in(state, 3) ? 120 : 12);
  switch (draw_below(state, 6)) {
  case 0:
    draw_star(p, count, 3e4, 3e4, state);
    break;
  case 1:
    draw_star(p, count, 2e4, 9e4, state);
    break;
  case 2:
    draw_steps(p, state);
    break;
  case 3:
    draw_at_45(p, state);
    break;
  default:
    draw_between_chains(p, count, 1 + draw_below(state, 40), 1 + draw_below(state, 300), state);
    break;
  }
  if (draw_once_in(state, 8)) polygon_shear(p, draw_signed(state, 1), 0);
}

void draw_block(random_block *block, random_numbers *state) {
  static const double scales[] = {1, 1, 1, 0x1p-10, 0x1p-200, 0x1p200};
  polygon *p = &block->whole;
  draw_shape(p, state);
  const double scale = scales[draw_below(state, 6)];
  const double off = draw_once_in(state, 4) ? scale * 0x1p30 * (double)draw_signed(state, 1000) : 0;
  const bool mirror = draw_once_in(state, 2), turn = draw_once_in(state, 2);
  const long first = draw_below(state, p->count);
  for (long k = 0; mirror && k < p->count; k++) p->x[k] = -p->x[k];
  block->counter_clockwise = mirror == turn;
  block->count = (size_t)p->count;
  const polygon drawn = *p;
  for (long k = 0; k < p->count; k++) {
    const long from = (first + (turn ? p->count - k : k)) % p->count;
    p->x[k] = drawn.x[from];
    p->y[k] = drawn.y[from];
    block->xy[2 * k] = (double)p->x[k] * scale + off;
    block->xy[2 * k + 1] = (double)p->y[k] * scale - off;
  }
  if (!draw_once_in(state, 4)) return;
  block->xy[2 * block->count] = block->xy[0];
  block->xy[2 * block->count + 1] = block->xy[1];
  block->count++;
}
