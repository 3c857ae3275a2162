/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* On an edge by the sign of a product, in the outline by the crossings of a ray. */

#include "load/outline.h"

static bool between(const fmpq *value, const fmpq *a, const fmpq *b) {
  return (fmpq_cmp(a, value) <= 0 && fmpq_cmp(value, b) <= 0) ||
         (fmpq_cmp(b, value) <= 0 && fmpq_cmp(value, a) <= 0);
}

bool tp_loads_on_edge(const tp_polyline *ring, long k, const fmpq *x, const fmpq *y) {
  const long next = k + 1 == ring->count ? 0 : k + 1;
  const fmpq *x0 = ring->x + k, *y0 = ring->y + k, *x1 = ring->x + next, *y1 = ring->y + next;
  return tp_points_turn(x0, y0, x1, y1, x, y) == 0 && between(x, x0, x1) && between(y, y0, y1);
}

/* By crossings of a ray to the right. */
bool tp_loads_in_outline(const tp_polyline *ring, const fmpq *x, const fmpq *y) {
  bool inside = false;
  for (long k = 0; k < ring->count; k++) {
    const long next = k + 1 == ring->count ? 0 : k + 1;
    if (tp_loads_on_edge(ring, k, x, y)) return true;
    const bool above = fmpq_cmp(ring->y + k, y) > 0, next_above = fmpq_cmp(ring->y + next, y) > 0;
    if (above == next_above) continue;
    const int side = tp_points_turn(ring->x + k, ring->y + k, ring->x + next, ring->y + next, x, y);
    if ((side > 0) == next_above) inside = !inside;
  }
  return inside;
}
