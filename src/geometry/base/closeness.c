/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Pairs of vertices and edges within a distance, found by binary search along the profile in
 * doubles with a bound, and the exact foot of a vertex on an edge with the square of its
 * distance. */

#include "base/closeness.h"

#include <arb.h>
#include <float.h>
#include <math.h>

static double u_of(const tp_closeness *n, long point) {
  return n->lattice->u[point] * n->scale_u;
}

static double v_of(const tp_closeness *n, long point) {
  return n->lattice->v[point] * n->scale_v;
}

/* Scene lengths in the unit, 2^exponent steps of the lattice: by the height of the base's ring,
 * which is never 0. */
static double unit_of(const tp_closeness *n, long exponent) {
  const tp_polyline *ring = &n->base->ring;
  const long last = ring->count - 1;
  fmpq_t unit;
  fmpz_t steps;
  fmpq_init(unit);
  fmpz_init(steps);
  fmpq_sub(unit, ring->y, ring->y + last);
  fmpz_sub(steps, n->lattice->y + n->ring, n->lattice->y + n->ring + last);
  fmpq_div_fmpz(unit, unit, steps);
  fmpq_mul_2exp(unit, unit, (ulong)exponent);
  const double result = fmpq_get_d(unit);
  fmpq_clear(unit);
  fmpz_clear(steps);
  return result;
}

/* Each coordinate is off by 2^-53 of the largest, a difference of two by four times that. With the
 * share t of the edge in [0, 1] the distance |r - t e| takes up the errors of r, of e, and of t,
 * which is some two of these over |e|: 2^-49 of the largest covers them and the rounding. */
void tp_closeness_init(tp_closeness *near, const tp_section *section, const tp_base *base,
                       const tp_lattice *l) {
  const long exponent = l->exponent_u > l->exponent_v ? l->exponent_u : l->exponent_v;
  *near = (tp_closeness){.section = section,
                         .base = base,
                         .lattice = l,
                         .ring = l->start[section->ring_count],
                         .points = base->edge_count + 1,
                         .scale_u = ldexp(1, (int)(l->exponent_u - exponent)),
                         .scale_v = ldexp(1, (int)(l->exponent_v - exponent))};
  near->unit = unit_of(near, exponent);
  double largest = 0, low_u = INFINITY, low_v = INFINITY, high_u = -INFINITY, high_v = -INFINITY;
  for (long k = 0; k < l->start[1]; k++) {
    const double u = u_of(near, k), v = v_of(near, k);
    low_u = fmin(low_u, u);
    high_u = fmax(high_u, u);
    low_v = fmin(low_v, v);
    high_v = fmax(high_v, v);
    largest = fmax(largest, fmax(fabs(u), fabs(v)));
  }
  near->size = fmax(high_u - low_u, high_v - low_v);
  for (long k = near->ring; k < near->ring + near->points; k++) {
    largest = fmax(largest, fmax(fabs(u_of(near, k)), fabs(v_of(near, k))));
  }
  near->error = 8 * DBL_EPSILON * largest;
}

/* ---- pairs -------------------------------------------------------------------------------------
 */

/* The first point of the profile at `low` or right of it. */
static long first_from(const tp_closeness *n, double low) {
  long a = 0, b = n->points;
  while (a < b) {
    const long middle = a + (b - a) / 2;
    if (u_of(n, n->ring + middle) < low) {
      a = middle + 1;
    } else {
      b = middle;
    }
  }
  return a;
}

static double distance(const tp_closeness *n, long point, long from, long to) {
  const double eu = u_of(n, to) - u_of(n, from), ev = v_of(n, to) - v_of(n, from);
  const double ru = u_of(n, point) - u_of(n, from), rv = v_of(n, point) - v_of(n, from);
  const double square = eu * eu + ev * ev;
  const double share = square > 0 ? fmin(1, fmax(0, (ru * eu + rv * ev) / square)) : 0;
  return hypot(ru - share * eu, rv - share * ev);
}

static long next_of_outline(const tp_closeness *n, long vertex) {
  return vertex + 1 == n->lattice->start[1] ? 0 : vertex + 1;
}

static double edge_length(const tp_closeness *n, long from, long to) {
  return hypot(u_of(n, to) - u_of(n, from), v_of(n, to) - v_of(n, from));
}

double tp_closeness_shorter_edge(const tp_closeness *n, bool of_base, long k) {
  const long outline = n->lattice->start[1];
  if (!of_base) {
    return fmin(edge_length(n, k, next_of_outline(n, k)),
                edge_length(n, (k == 0 ? outline : k) - 1, k));
  }
  double length = INFINITY;
  if (k > 0) length = fmin(length, edge_length(n, n->ring + k - 1, n->ring + k));
  if (k + 1 < n->points) length = fmin(length, edge_length(n, n->ring + k, n->ring + k + 1));
  return length;
}

static bool visit_vertices(const tp_closeness *n, const tp_closeness_reach *r,
                           tp_closeness_visitor visitor, void *context) {
  for (long k = 0; k < n->lattice->start[1]; k++) {
    const double own =
        r->share_of_edge > 0 ? r->share_of_edge * tp_closeness_shorter_edge(n, false, k) : INFINITY;
    const double reach = fmin(r->within, own) + n->error;
    const double u = u_of(n, k), across = r->upright ? n->error : reach;
    long edge = first_from(n, u - across);
    if (edge > 0) edge--;
    for (; edge + 1 < n->points && u_of(n, n->ring + edge) <= u + across; edge++) {
      const double d = distance(n, k, n->ring + edge, n->ring + edge + 1);
      if (d <= reach && !visitor(context, &(tp_closeness_pair){false, k, edge}, d)) return false;
    }
  }
  return true;
}

static bool visit_points(const tp_closeness *n, const tp_closeness_reach *r,
                         tp_closeness_visitor visitor, void *context) {
  for (long k = 0; k < n->lattice->start[1]; k++) {
    const long next = next_of_outline(n, k);
    if (u_of(n, next) < u_of(n, k)) continue;
    const double own = r->share_of_edge > 0 ? edge_length(n, k, next) : INFINITY;
    const double reach = fmin(r->within, own) + n->error, across = r->upright ? n->error : reach;
    const double low = fmin(v_of(n, k), v_of(n, next)), high = fmax(v_of(n, k), v_of(n, next));
    const double last = u_of(n, next) + across;
    for (long p = first_from(n, u_of(n, k) - across); p < n->points && u_of(n, n->ring + p) <= last;
         p++) {
      const double v = v_of(n, n->ring + p);
      if (v < low - reach || v > high + reach) continue;
      const double d = distance(n, n->ring + p, k, next);
      if (d <= reach && !visitor(context, &(tp_closeness_pair){true, p, k}, d)) return false;
    }
  }
  return true;
}

bool tp_closeness_visit(const tp_closeness *near, const tp_closeness_reach *reach,
                        tp_closeness_visitor visitor, void *context) {
  return visit_vertices(near, reach, visitor, context) &&
         visit_points(near, reach, visitor, context);
}

/* ---- exactly -----------------------------------------------------------------------------------
 */

/* With r from the edge's first point to the vertex and e along the edge: t = r . e / e . e, cut to
 * [0, 1], and |r - t e|^2. */
void tp_closeness_foot(fmpq_t share, fmpq_t square, int *side, const tp_closeness *near,
                       const tp_closeness_pair *pair) {
  const tp_polyline *outline = near->section->rings, *ring = &near->base->ring;
  const tp_polyline *own = pair->of_base ? ring : outline, *other = pair->of_base ? outline : ring;
  const long next = pair->of_base ? next_of_outline(near, pair->edge) : pair->edge + 1;
  fmpq_t ex, ey, rx, ry, work;
  fmpq_init(ex);
  fmpq_init(ey);
  fmpq_init(rx);
  fmpq_init(ry);
  fmpq_init(work);
  fmpq_sub(ex, other->x + next, other->x + pair->edge);
  fmpq_sub(ey, other->y + next, other->y + pair->edge);
  fmpq_sub(rx, own->x + pair->vertex, other->x + pair->edge);
  fmpq_sub(ry, own->y + pair->vertex, other->y + pair->edge);
  fmpq_mul(work, ex, ry);
  fmpq_submul(work, ey, rx);
  *side = fmpq_sgn(work);
  fmpq_mul(share, rx, ex);
  fmpq_addmul(share, ry, ey);
  fmpq_mul(work, ex, ex);
  fmpq_addmul(work, ey, ey);
  if (fmpq_sgn(share) <= 0) {
    fmpq_zero(share);
  } else if (fmpq_cmp(share, work) >= 0) {
    fmpq_one(share);
  } else {
    fmpq_div(share, share, work);
  }
  fmpq_submul(rx, share, ex);
  fmpq_submul(ry, share, ey);
  fmpq_mul(square, rx, rx);
  fmpq_addmul(square, ry, ry);
  fmpq_clear(ex);
  fmpq_clear(ey);
  fmpq_clear(rx);
  fmpq_clear(ry);
  fmpq_clear(work);
}

double tp_closeness_root(const fmpq_t square) {
  enum { BITS = 64 };
  arb_t root;
  arb_init(root);
  arb_set_fmpq(root, square, BITS);
  arb_sqrt(root, root, BITS);
  const double result = arf_get_d(arb_midref(root), ARF_RND_NEAR);
  arb_clear(root);
  return result;
}
