/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What stands in the way of a distance within which all touches: an edge shorter than that; and
 * what gap it leaves, in doubles relative to the profile's first point.
 *
 * With coordinates off by e the height of a point over a line of slope s is off by (2 + 2 |s|) e
 * and its rounding, 8 e (1 + |s|) in all; over an edge that is as good as upright, by its rise. */

#include "base/snap.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

/* ---- edges -------------------------------------------------------------------------------------
 */

static bool is_shorter(fmpq_t square, const tp_polyline *line, long from, long to) {
  fmpq_t own, d;
  fmpq_init(own);
  fmpq_init(d);
  fmpq_sub(d, line->x + to, line->x + from);
  fmpq_mul(own, d, d);
  fmpq_sub(d, line->y + to, line->y + from);
  fmpq_addmul(own, d, d);
  const bool shorter = fmpq_cmp(own, square) < 0;
  if (shorter) fmpq_swap(square, own);
  fmpq_clear(own);
  fmpq_clear(d);
  return shorter;
}

bool tp_snap_short_edge(fmpq_t square, bool *of_base, long *edge, const tp_closeness *near,
                        const fmpq_t within) {
  const tp_polyline *outline = near->section->rings, *ring = &near->base->ring;
  fmpq_t low, high;
  bool found = false;
  fmpq_init(low);
  fmpq_init(high);
  fmpq_mul(square, within, within);
  fmpq_set(low, outline->x);
  fmpq_set(high, outline->x);
  for (long k = 0; k < outline->count; k++) {
    if (fmpq_cmp(outline->x + k, low) < 0) fmpq_set(low, outline->x + k);
    if (fmpq_cmp(outline->x + k, high) > 0) fmpq_set(high, outline->x + k);
    if (!is_shorter(square, outline, k, k + 1 == outline->count ? 0 : k + 1)) continue;
    found = true;
    *of_base = false;
    *edge = k;
  }
  fmpq_sub(low, low, within);
  fmpq_add(high, high, within);
  for (long k = 0; k + 1 < near->points; k++) {
    if (fmpq_cmp(ring->x + k + 1, low) < 0 || fmpq_cmp(ring->x + k, high) > 0) continue;
    if (!is_shorter(square, ring, k, k + 1)) continue;
    found = true;
    *of_base = true;
    *edge = k;
  }
  fmpq_clear(low);
  fmpq_clear(high);
  return found;
}

/* ---- the gap -----------------------------------------------------------------------------------
 */

typedef struct heights {
  long outline, points;
  double *u, *v; /* of the outline, then of the profile */
  double error;  /* of a coordinate */
  double *over;  /* of a point of the profile: the lowest of the block above it, ... */
  double *bound; /* ... and how far that is off */
  double gap, high, low;
} heights;

static void round_line(heights *h, long at, const tp_polyline *line, long count,
                       const tp_polyline *ring) {
  fmpq_t rest;
  fmpq_init(rest);
  for (long k = 0; k < count; k++) {
    fmpq_sub(rest, line->x + k, ring->x);
    h->u[at + k] = fmpq_get_d(rest);
    fmpq_sub(rest, line->y + k, ring->y);
    h->v[at + k] = fmpq_get_d(rest);
    h->error = fmax(h->error, DBL_EPSILON * fmax(fabs(h->u[at + k]), fabs(h->v[at + k])));
  }
  fmpq_clear(rest);
}

/* The line from one point to another at u; of an upright edge its lower end, or its upper one. */
static double line_at(double *bound, const heights *h, long from, long to, double u, bool upper) {
  const double width = h->u[to] - h->u[from], rise = h->v[to] - h->v[from];
  if (!(width > 8 * h->error)) {
    *bound = 8 * h->error + (width > 0 ? fabs(rise) : 0);
    return upper ? fmax(h->v[from], h->v[to]) : fmin(h->v[from], h->v[to]);
  }
  *bound = 8 * h->error * (1 + fabs(rise) / width);
  return h->v[from] + (u - h->u[from]) / width * rise;
}

static void note_gap(heights *h, double gap, double bound) {
  h->gap = fmax(h->gap, gap);
  h->high = fmax(h->high, gap + bound);
  h->low = fmax(h->low, gap - bound);
}

/* The first point of the profile at u or right of it. */
static long first_from(const heights *h, double u) {
  long a = 0, b = h->points;
  while (a < b) {
    const long middle = a + (b - a) / 2;
    if (h->u[h->outline + middle] < u) {
      a = middle + 1;
    } else {
      b = middle;
    }
  }
  return a;
}

/* A vertex of the underside over the profile: its edges both run to the right, or upright. */
static void note_vertex(heights *h, long k) {
  const long last = (k == 0 ? h->outline : k) - 1, next = k + 1 == h->outline ? 0 : k + 1;
  const double u = h->u[k];
  if (h->u[last] > u || h->u[next] < u) return;
  double top = -INFINITY, top_bound = 0;
  long edge = first_from(h, u);
  if (edge > 0) edge--;
  for (; edge + 1 < h->points && h->u[h->outline + edge] <= u; edge++) {
    double bound;
    if (h->u[h->outline + edge + 1] < u) continue;
    const double line = line_at(&bound, h, h->outline + edge, h->outline + edge + 1, u, true);
    if (line > top) {
      top = line;
      top_bound = bound;
    }
  }
  if (!isinf(top)) note_gap(h, h->v[k] - top, top_bound);
}

static void cover_points(heights *h, long k) {
  const long next = k + 1 == h->outline ? 0 : k + 1;
  if (h->u[next] < h->u[k]) return;
  for (long p = first_from(h, h->u[k]); p < h->points && h->u[h->outline + p] <= h->u[next]; p++) {
    double bound;
    const double line = line_at(&bound, h, k, next, h->u[h->outline + p], false);
    if (line < h->over[p]) {
      h->over[p] = line;
      h->bound[p] = bound;
    }
  }
}

static bool heights_init(heights *h, const tp_snap *snap, const tp_closeness *near) {
  *h = (heights){.outline = snap->outline.count, .points = near->points};
  const size_t all = (size_t)(h->outline + h->points);
  h->u = malloc(all * sizeof *h->u);
  h->v = malloc(all * sizeof *h->v);
  h->over = malloc((size_t)h->points * sizeof *h->over);
  h->bound = malloc((size_t)h->points * sizeof *h->bound);
  if (h->u == NULL || h->v == NULL || h->over == NULL || h->bound == NULL) return false;
  round_line(h, 0, &snap->outline, h->outline, &near->base->ring);
  round_line(h, h->outline, &near->base->ring, h->points, &near->base->ring);
  for (long p = 0; p < h->points; p++) h->over[p] = INFINITY;
  return true;
}

bool tp_snap_gap(double *gap, double *error, const tp_snap *snap, const tp_closeness *near) {
  heights h;
  const bool done = heights_init(&h, snap, near);
  if (done) {
    fmpq_t rest;
    fmpq_init(rest);
    fmpq_sub(rest, snap->left, near->base->ring.x);
    const double left = fmpq_get_d(rest) - h.error;
    fmpq_sub(rest, snap->right, near->base->ring.x);
    const double right = fmpq_get_d(rest) + h.error;
    fmpq_clear(rest);
    for (long k = 0; k < h.outline; k++) {
      if (h.u[k] >= left && h.u[k] <= right) note_vertex(&h, k);
      cover_points(&h, k);
    }
    for (long p = 0; p < h.points; p++) {
      const double u = h.u[h.outline + p];
      if (u < left || u > right || isinf(h.over[p])) continue;
      note_gap(&h, h.over[p] - h.v[h.outline + p], h.bound[p]);
    }
    *gap = h.gap;
    *error = fmax(h.high - h.gap, h.gap - h.low);
  }
  free(h.u);
  free(h.v);
  free(h.over);
  free(h.bound);
  return done;
}
