/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Similarity from pixels to scene lengths by a scale of known length, level by a plumb line, and
 * the vertices of the outline nearest to the clicked ends of the contact. */

#include "trace/trace.h"

#include <math.h>

void tp_trace_place(tp_trace *trace, const tp_trace_options *options) {
  const tp_trace_point a = options->scale[0], b = options->scale[1];
  trace->per_pixel = options->length / hypot(b.x - a.x, b.y - a.y);
  trace->down = (tp_trace_point){0, 1};
  trace->origin = (tp_trace_point){0, 0};
  if (options->plumb_given) {
    const tp_trace_point p = options->plumb[0], q = options->plumb[1];
    const double length = hypot(q.x - p.x, q.y - p.y), sign = q.y >= p.y ? 1 : -1;
    trace->down = (tp_trace_point){sign * (q.x - p.x) / length, sign * (q.y - p.y) / length};
  }
  tp_trace_point least = {INFINITY, INFINITY};
  for (long k = 0; k < trace->ring.count; k++) {
    const tp_trace_point own = tp_trace_to_scene(trace, trace->ring.points[k]);
    least.x = fmin(least.x, own.x);
    least.y = fmin(least.y, own.y);
  }
  trace->origin = least;
}

tp_trace_point tp_trace_to_scene(const tp_trace *trace, tp_trace_point pixel) {
  const tp_trace_point d = trace->down;
  return (tp_trace_point){trace->per_pixel * (pixel.x * d.y - pixel.y * d.x) - trace->origin.x,
                          -trace->per_pixel * (pixel.x * d.x + pixel.y * d.y) - trace->origin.y};
}

/* The point of the ring nearest to one of the picture. */
static long nearest(const tp_trace *trace, tp_trace_point to, double *distance) {
  long best = 0;
  *distance = INFINITY;
  for (long k = 0; k < trace->ring.count; k++) {
    const tp_trace_point p = trace->ring.points[k];
    const double own = hypot(p.x - to.x, p.y - to.y);
    if (own >= *distance) continue;
    *distance = own;
    best = k;
  }
  return best;
}

/* From a point of the picture to the line of the ring. */
static double miss(const tp_trace *trace, tp_trace_point from) {
  double least = INFINITY;
  for (long k = 0; k < trace->ring.count; k++) {
    const tp_trace_point p = trace->ring.points[k],
                         q = trace->ring.points[(k + 1) % trace->ring.count];
    const double x = q.x - p.x, y = q.y - p.y, square = x * x + y * y;
    const double along = square > 0 ? ((from.x - p.x) * x + (from.y - p.y) * y) / square : 0;
    const double share = fmin(fmax(along, 0), 1);
    least = fmin(least, hypot(p.x + share * x - from.x, p.y + share * y - from.y));
  }
  return least;
}

bool tp_trace_find_between(tp_trace *trace, const tp_trace_options *options) {
  if (!options->between_given) return true;
  const tp_trace_point a = options->between[0], b = options->between[1];
  const bool first_is_left = tp_trace_to_scene(trace, a).x <= tp_trace_to_scene(trace, b).x;
  double left = 0, right = 0;
  trace->between[0] = nearest(trace, first_is_left ? a : b, &left);
  trace->between[1] = nearest(trace, first_is_left ? b : a, &right);
  trace->between_px = fmax(left, right);
  trace->missed_px = fmax(miss(trace, a), miss(trace, b));
  return trace->between[0] != trace->between[1];
}
