/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Distances of corners to edges, in doubles: two outlines that do not cross are nearest in a corner
 * of one of them. */

#include "assemblage/nearest_block.h"

#include "number/between.h"

#include <math.h>

/* From a corner of one outline to all edges of another. */
static double reach_of(const tp_polyline *ring, long corner, const tp_polyline *other) {
  double least = INFINITY;
  for (long k = 0; k < other->count; k++) {
    const long next = k + 1 < other->count ? k + 1 : 0;
    const double x = tp_ratio_apart(ring->x + corner, other->x + k);
    const double y = tp_ratio_apart(ring->y + corner, other->y + k);
    const double dx = tp_ratio_apart(other->x + next, other->x + k);
    const double dy = tp_ratio_apart(other->y + next, other->y + k);
    const double along = fmin(1, fmax(0, (x * dx + y * dy) / (dx * dx + dy * dy)));
    least = fmin(least, hypot(x - along * dx, y - along * dy));
  }
  return least;
}

static double distance_of(const tp_polyline *a, const tp_polyline *b) {
  double least = INFINITY;
  for (long k = 0; k < a->count; k++) least = fmin(least, reach_of(a, k, b));
  for (long k = 0; k < b->count; k++) least = fmin(least, reach_of(b, k, a));
  return least;
}

long tp_nearest_block(double *distance, const tp_given_block *given, long count, long block) {
  long nearest = -1;
  for (long k = 0; k < count; k++) {
    if (k == block) continue;
    const double own = distance_of(given[block].section->rings, given[k].section->rings);
    if (nearest >= 0 && own >= *distance) continue;
    nearest = k;
    *distance = own;
  }
  return nearest;
}

double tp_block_extent(const tp_given_block *block) {
  const tp_polyline *ring = block->section->rings;
  double most = 0;
  for (long k = 1; k < ring->count; k++) {
    most = fmax(most,
                hypot(tp_ratio_apart(ring->x + k, ring->x), tp_ratio_apart(ring->y + k, ring->y)));
  }
  return most;
}
