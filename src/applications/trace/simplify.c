/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Simplification of a traced outline by the Douglas-Peucker algorithm, and the unit moves of its
 * vertices when the outline is shifted outwards. */

#include "trace/refine.h"

#include <math.h>
#include <stdlib.h>

/* From the straight piece between two points. */
static double distance(tp_trace_point p, tp_trace_point a, tp_trace_point b) {
  const double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
  double t = square > 0 ? ((p.x - a.x) * dx + (p.y - a.y) * dy) / square : 0;
  t = fmin(fmax(t, 0), 1);
  return hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

typedef struct stretch {
  long from, to;
} stretch;

/* Marks what stays between two points that do. The stack holds no more stretches than points. */
static void mark(bool *stays, const tp_trace_ring *ring, stretch whole, double tolerance,
                 stretch *stack) {
  long top = 0;
  stack[top++] = whole;
  while (top > 0) {
    const stretch own = stack[--top];
    const tp_trace_point a = ring->points[own.from], b = ring->points[own.to % ring->count];
    long farthest = own.from;
    double most = tolerance;
    for (long k = own.from + 1; k < own.to; k++) {
      const double away = distance(ring->points[k], a, b);
      if (away > most) farthest = k, most = away;
    }
    if (farthest == own.from) continue;
    stays[farthest] = true;
    stack[top++] = (stretch){own.from, farthest};
    stack[top++] = (stretch){farthest, own.to};
  }
}

static long farthest_from(const tp_trace_ring *ring, long from) {
  long best = from;
  double most = 0;
  for (long k = 0; k < ring->count; k++) {
    const double away =
        hypot(ring->points[k].x - ring->points[from].x, ring->points[k].y - ring->points[from].y);
    if (away > most) best = k, most = away;
  }
  return best;
}

/* In room for twice its points: from one of two points far apart, corners of the hull that stay. */
static void simplify(tp_trace_ring *ring, double tolerance, tp_trace_point *copy, bool *stays,
                     stretch *stack) {
  const long count = ring->count, first = farthest_from(ring, 0);
  for (long k = 0; k < count; k++) copy[k] = ring->points[(first + k) % count];
  const tp_trace_ring turned = {count, count, copy};
  const long other = farthest_from(&turned, 0);
  stays[0] = stays[other] = true;
  mark(stays, &turned, (stretch){0, other}, tolerance, stack);
  mark(stays, &turned, (stretch){other, count}, tolerance, stack);
  ring->count = 0;
  for (long k = 0; k < count; k++) {
    if (stays[k]) ring->points[ring->count++] = copy[k];
  }
}

bool tp_trace_simplify(tp_trace_ring *ring, double tolerance) {
  const size_t count = (size_t)ring->count;
  tp_trace_point *copy = calloc(count, sizeof *copy);
  bool *stays = calloc(count + 1, sizeof *stays);
  stretch *stack = calloc(count + 2, sizeof *stack);
  const bool done = copy != NULL && stays != NULL && stack != NULL;
  if (done) simplify(ring, tolerance, copy, stays, stack);
  free(copy);
  free(stays);
  free(stack);
  return done;
}

void tp_trace_moves(tp_trace_point *moves, const tp_trace_ring *ring) {
  const double most = 1.5;
  for (long k = 0; k < ring->count; k++) {
    const tp_trace_point p = ring->points[k > 0 ? k - 1 : ring->count - 1];
    const tp_trace_point q = ring->points[k], r = ring->points[k + 1 < ring->count ? k + 1 : 0];
    const double a = hypot(q.x - p.x, q.y - p.y), b = hypot(r.x - q.x, r.y - q.y);
    /* the outer normals of both edges of a clockwise ring, as it is seen */
    const tp_trace_point m = {(q.y - p.y) / a, (p.x - q.x) / a},
                         n = {(r.y - q.y) / b, (q.x - r.x) / b};
    const double both = 1 + m.x * n.x + m.y * n.y;
    double x = (m.x + n.x) / both, y = (m.y + n.y) / both;
    const double length = hypot(x, y);
    if (!(length <= most)) {
      const double sum = hypot(m.x + n.x, m.y + n.y);
      x = sum > 0 ? most * (m.x + n.x) / sum : 0;
      y = sum > 0 ? most * (m.y + n.y) / sum : 0;
    }
    moves[k] = (tp_trace_point){x, y};
  }
}
