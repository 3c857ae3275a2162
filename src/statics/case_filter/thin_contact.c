/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A force e = (e_x, e_y, m) with e_y > 0 as the point (e_x, m) / e_y of a plane: sums of forces are
 * what lies in the convex hull of their points.
 *
 * The normals n of contact points lie there at (-t_y, x t_x + y t_y) / t_x, both of a facet above
 * one another. Motions that open all have n . r >= 0, so that each edge of the hull is a motion
 * that keeps the two points at its ends, and no other point closes.
 *
 * The weight lies at (tan(tilt), 0). What friction bears at the limits either way is the two points
 * between which the hull of all edges of cones ends on that axis. Of those on each side of it the
 * one is taken that together with the other crosses the axis farthest, in turn, until both stay:
 * then all others lie on one side of their line. */

#include "case_filter/thin_contact.h"

static bool add(tp_thin_contact *thin, int *place, int point) {
  int k = 0;
  while (k < thin->count && thin->points[k] != point) k++;
  if (k == TP_PLAN_POINTS) return false;
  thin->points[k] = point;
  if (k == thin->count) thin->count++;
  if (place != NULL) *place = k;
  return true;
}

/* ---- what bears the weight ---------------------------------------------------------------------
 */

enum { EDGES = 2 * TP_REST_POINTS };

/* The edges on one side of the axis, the point of each. */
typedef struct edges {
  int count, point[EDGES];
  double along[EDGES], moment[EDGES];
} edges;

static bool set_edges(edges sides[2], const tp_contact_rest *all, double friction) {
  sides[0].count = sides[1].count = 0;
  for (int k = 0; k < 2 * all->count; k++) {
    const int point = k / 2;
    const double f = k % 2 == 0 ? friction : -friction;
    const double up = all->tx[point] + f * all->ty[point];
    const double along = (f * all->tx[point] - all->ty[point]) / up;
    const double moment = all->x[point] - all->y[point] * along;
    edges *own = sides + (moment >= 0 ? 0 : 1);
    if (!(up > 0)) return false;
    own->point[own->count] = point;
    own->along[own->count] = along;
    own->moment[own->count++] = moment;
  }
  return sides[0].count > 0 && sides[1].count > 0;
}

/* That which crosses the axis farthest together with one on the other side: which has (at - along)
 * / moment, by how much it goes farther for each unit of moment, the largest. */
static int farthest(const edges *own, double way, double at, double moment) {
  int best = 0;
  for (int k = 1; k < own->count; k++) {
    const double one = way * (own->along[k] - at) * fabs(own->moment[best] - moment);
    const double held = way * (own->along[best] - at) * fabs(own->moment[k] - moment);
    if (one > held) best = k;
  }
  return best;
}

static bool add_limit(tp_thin_contact *thin, const edges sides[2], double way) {
  enum { STEPS = 16 };
  int of[2] = {0, 0};
  for (int k = 1; k < sides[0].count; k++) {
    if (way * sides[0].along[k] > way * sides[0].along[of[0]]) of[0] = k;
  }
  bool stay = false;
  for (int step = 1; step < STEPS && !stay; step++) {
    const int own = step % 2, other = 1 - own;
    const int next =
        farthest(sides + own, way, sides[other].along[of[other]], sides[other].moment[of[other]]);
    stay = step > 1 && next == of[own];
    of[own] = next;
  }
  return add(thin, NULL, sides[0].point[of[0]]) && add(thin, NULL, sides[1].point[of[1]]);
}

/* ---- what closes -------------------------------------------------------------------------------
 */

/* Facets as points of the plane: their normals' slope, and the moments of both ends. */
typedef struct normals {
  int count;
  double slope[TP_REST_FACETS];
  double moment[2][TP_REST_FACETS]; /* the lower, the upper */
  int point[2][TP_REST_FACETS];
} normals;

static void set_normals(normals *own, const tp_contact_rest *all) {
  own->count = all->count / 2;
  for (int k = 0; k < own->count; k++) {
    const double slope = all->ty[2 * k] / all->tx[2 * k];
    own->slope[k] = -slope;
    const double first = all->x[2 * k] + slope * all->y[2 * k];
    const double last = all->x[2 * k + 1] + slope * all->y[2 * k + 1];
    const int lower = first < last ? 0 : 1;
    own->moment[lower][k] = first;
    own->point[lower][k] = 2 * k;
    own->moment[1 - lower][k] = last;
    own->point[1 - lower][k] = 2 * k + 1;
  }
}

/* The hull from its leftmost facet to its rightmost along its lower side, or back along its upper.
 */
static bool add_side(tp_thin_contact *thin, const normals *n, int upper) {
  const double way = upper != 0 ? -1 : 1;
  int at = 0;
  for (int k = 1; k < n->count; k++) {
    const double less = way * (n->slope[k] - n->slope[at]);
    const bool outer = way * (n->moment[upper][k] - n->moment[upper][at]) < 0;
    if (less < 0 || (less == 0 && outer)) at = k;
  }
  while (at >= 0) {
    if (thin->ring_count == TP_PLAN_POINTS) return false;
    if (!add(thin, thin->ring + thin->ring_count, n->point[upper][at])) return false;
    thin->ring_count++;
    int next = -1;
    double dx = 0, dy = 0;
    for (int k = 0; k < n->count; k++) {
      const double x = n->slope[k] - n->slope[at], y = n->moment[upper][k] - n->moment[upper][at];
      if (way * x <= 0 || (next >= 0 && dx * y - dy * x >= 0)) continue;
      next = k;
      dx = x;
      dy = y;
    }
    at = next;
  }
  return true;
}

/* ---- what may slide ----------------------------------------------------------------------------
 */

/* Rises towards down-dip are the slopes of normals. */
static bool add_facets(tp_thin_contact *thin, const tp_contact_rest *all, const normals *n,
                       bool first_is_down_dip) {
  int steepest[2] = {-1, -1}; /* of those down-dip of the centroid, of all */
  for (int k = 0; k < n->count; k++) {
    const bool reaches = all->x[2 * k + (first_is_down_dip ? 0 : 1)] < 0;
    for (int own = reaches ? 0 : 1; own < 2; own++) {
      if (steepest[own] < 0 || n->slope[k] > n->slope[steepest[own]]) steepest[own] = k;
    }
  }
  for (int own = 0; own < 2; own++) {
    if (steepest[own] < 0 || (own == 1 && steepest[1] == steepest[0])) continue;
    thin->facets[thin->facet_count++] = steepest[own];
    if (!add(thin, NULL, 2 * steepest[own]) || !add(thin, NULL, 2 * steepest[own] + 1))
      return false;
  }
  return true;
}

bool tp_thin_contact_find(tp_thin_contact *thin, const tp_contact_rest *all, double friction,
                          int point, bool first_is_down_dip) {
  edges sides[2];
  normals n;
  *thin = (tp_thin_contact){.count = 0};
  set_normals(&n, all);
  return n.count > 0 && set_edges(sides, all, friction) && add_limit(thin, sides, 1) &&
         add_limit(thin, sides, -1) && add_side(thin, &n, 0) && add_side(thin, &n, 1) &&
         add_facets(thin, all, &n, first_is_down_dip) && add(thin, NULL, point);
}
