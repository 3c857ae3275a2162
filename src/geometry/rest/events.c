/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The event nearest to the middle of an interval of shifts, by binary search of the profile for
 * every vertex of the block and for the centroid. */

#include "rest/events.h"

/* The point of the profile, which runs from right to left, that is the last at or right of x; -1
 * where all lie left of it. */
static long last_from(const tp_bodies *b, const fmpq_t x) {
  long low = -1, high = b->profile_count - 1;
  while (low < high) {
    const long middle = low + (high - low + 1) / 2;
    if (fmpq_cmp(b->base.x + middle, x) >= 0) {
      low = middle;
    } else {
      high = middle - 1;
    }
  }
  return low;
}

typedef struct nearest {
  const tp_bodies *bodies;
  fmpq_t low, middle, high, x, distance, least;
  bool found;
} nearest;

/* Take the shift that brings own_x over a point of the profile, if it is nearer to the middle. */
static void take(fmpq_t event, nearest *n, const fmpq_t own_x, long point) {
  if (point < 0 || point >= n->bodies->profile_count) return;
  fmpq_sub(n->x, n->bodies->base.x + point, own_x);
  if (fmpq_cmp(n->x, n->low) <= 0 || fmpq_cmp(n->x, n->high) >= 0) return;
  fmpq_sub(n->distance, n->x, n->middle);
  fmpq_abs(n->distance, n->distance);
  if (n->found && fmpq_cmp(n->distance, n->least) >= 0) return;
  n->found = true;
  fmpq_swap(n->least, n->distance);
  fmpq_set(event, n->x);
}

/* Of the points of the profile the two next to where own_x lies in the middle of the interval. */
static void look(fmpq_t event, nearest *n, const fmpq_t own_x) {
  fmpq_add(n->x, own_x, n->middle);
  const long right = last_from(n->bodies, n->x);
  take(event, n, own_x, right);
  take(event, n, own_x, right + 1);
}

bool tp_event_within(fmpq_t event, const tp_bodies *bodies, const fmpq_t low, const fmpq_t high) {
  nearest n = {.bodies = bodies};
  fmpq *const all[] = {n.low, n.middle, n.high, n.x, n.distance, n.least};
  const size_t count = sizeof all / sizeof all[0];
  for (size_t k = 0; k < count; k++) fmpq_init(all[k]);
  fmpq_set(n.low, low);
  fmpq_set(n.high, high);
  fmpq_add(n.middle, low, high);
  fmpq_div_2exp(n.middle, n.middle, 1);
  look(event, &n, &bodies->own_centroid.x);
  for (long k = 0; k < bodies->own.count; k++) look(event, &n, bodies->own.x + k);
  for (size_t k = 0; k < count; k++) fmpq_clear(all[k]);
  return n.found;
}
