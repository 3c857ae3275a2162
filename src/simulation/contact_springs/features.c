/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Edges and arcs of a boundary turned into straight pieces, discs at convex corners and hollows,
 * with the tangent points and slacks at their ends. */

#include "contact_springs/features.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The sine by which a disc may lean over beside a straight piece that it ends: contacts of a facet
 * lean by elastic lengths over its own, far less. */
static const double slack_beside_straight = 0.1;

/* A boundary that turns by less than this in a vertex goes on smoothly there: the arcs of a curve
 * do, but for the rounding of their ends. */
static const double smooth_turn = 1e-9;

void tp_features_clear(tp_features *features) {
  free(features->items);
  memset(features, 0, sizeof *features);
}

bool tp_feature_reaches(const tp_feature *f, tp_xy direction, double slack) {
  return tp_xy_cross(f->first, direction) >= -slack && tp_xy_cross(direction, f->last) >= -slack &&
         tp_xy_dot(f->first, direction) + tp_xy_dot(f->last, direction) > 0;
}

bool tp_feature_reaches_beside(const tp_feature *f, tp_xy direction) {
  return tp_xy_cross(f->first, direction) >= -f->slack_first &&
         tp_xy_cross(direction, f->last) >= -f->slack_last &&
         tp_xy_dot(f->first, direction) + tp_xy_dot(f->last, direction) > 0;
}

static tp_xy scaled(tp_xy v, double by) {
  return (tp_xy){v.x * by, v.y * by};
}

static tp_xy towards(tp_xy from, tp_xy to) {
  const tp_xy v = tp_xy_minus(to, from);
  return scaled(v, 1 / hypot(v.x, v.y));
}

/* The direction of a boundary at the beginning of an edge, or at its end. */
static tp_xy direction_at(const tp_edge *edge, bool end) {
  if (!edge->arc) return towards(edge->from, edge->to);
  const tp_xy radial = towards(edge->centre, end ? edge->to : edge->from);
  const tp_xy left = tp_xy_left(radial);
  return edge->inwards ? scaled(left, -1) : left;
}

/* A concave corner that turns by less than this sine is passed from edge to edge. */
static const double least_notch = 0.01;

/* How a vertex turns, and what rounding takes of the edges at it. */
typedef struct corner {
  tp_xy in, out; /* directions of the boundary before and behind it */
  bool convex;
  double radius, taken; /* taken: of both edges, from the vertex to the tangent points */
  double added;         /* to both, of a notch: a disc of the radius is clear of the one there */
} corner;

static double edge_length(const tp_edge *edge) {
  const tp_xy v = tp_xy_minus(edge->to, edge->from);
  return hypot(v.x, v.y);
}

/* A quarter of the shorter edge stays the most that a rounding takes. */
static corner corner_between(const tp_edge *before, const tp_edge *after, double radius) {
  enum { LEAST_SHARE = 4 };
  corner c = {.in = direction_at(before, true), .out = direction_at(after, false)};
  const double sine = tp_xy_cross(c.in, c.out), cosine = tp_xy_dot(c.in, c.out);
  c.convex = sine > smooth_turn || (cosine < 0 && sine > 0);
  if (!c.convex) {
    enum { CLEAR_RADII = 4 };
    const double size = cosine < 0 ? 1 : -sine;
    c.added = size > least_notch ? CLEAR_RADII * radius / size : 0;
    return c;
  }
  const double half_tangent = sine / (1 + cosine); /* of half the turn */
  const double most = fmin(edge_length(before), edge_length(after)) / LEAST_SHARE;
  c.taken = fmin(radius * half_tangent, most);
  c.radius = c.taken / half_tangent;
  return c;
}

/* A quarter turn to the right: out of the rock. */
static tp_xy outwards(tp_xy direction) {
  return (tp_xy){direction.y, -direction.x};
}

static tp_feature straight(const tp_edge *edge, const corner *begin, const corner *end) {
  const tp_xy tangent = towards(edge->from, edge->to);
  const double first = begin->convex ? begin->taken : 0, last = end->convex ? end->taken : 0;
  return (tp_feature){.kind = TP_FEATURE_STRAIGHT,
                      .from = tp_xy_plus(edge->from, first, tangent),
                      .tangent = tangent,
                      .normal = outwards(tangent),
                      .length = edge_length(edge) - first - last,
                      .before = begin->added,
                      .behind = end->added,
                      .facet = edge->number};
}

/* Where it goes on smoothly as a straight piece it may lean over that, as the disc of a corner. */
static tp_feature arc(const tp_edge *edge, bool straight_before, bool straight_after) {
  const tp_xy first = towards(edge->centre, edge->from), last = towards(edge->centre, edge->to);
  return (tp_feature){.kind = edge->inwards ? TP_FEATURE_HOLLOW : TP_FEATURE_DISC,
                      .centre = edge->centre,
                      .radius = edge->radius,
                      .first = edge->inwards ? last : first,
                      .last = edge->inwards ? first : last,
                      .slack_first = straight_before ? slack_beside_straight : 0,
                      .slack_last = straight_after ? slack_beside_straight : 0,
                      .facet = edge->number};
}

static tp_feature rounded(const tp_edge *before, const tp_edge *after, const corner *c) {
  const tp_xy tangent_point = tp_xy_plus(before->to, -c->taken, c->in);
  return (tp_feature){.kind = TP_FEATURE_DISC,
                      .centre = tp_xy_plus(tangent_point, -c->radius, outwards(c->in)),
                      .radius = c->radius,
                      .first = outwards(c->in),
                      .last = outwards(c->out),
                      .slack_first = before->arc ? 0 : slack_beside_straight,
                      .slack_last = after->arc ? 0 : slack_beside_straight,
                      /* at an end of the base that of its profile's, not the end face's */
                      .facet = before->number != 0 ? before->number : after->number};
}

bool tp_features_init(tp_features *features, const tp_boundary *boundary, double radius_m,
                      const double *friction) {
  const long count = boundary->count;
  const size_t room = 2 * (size_t)count;
  *features = (tp_features){.items = calloc(room, sizeof *features->items)};
  if (features->items == NULL) return false;
  for (long k = 0; k < count; k++) {
    const tp_edge *before = boundary->edges + (k + count - 1) % count, *edge = boundary->edges + k;
    const tp_edge *after = boundary->edges + (k + 1) % count;
    const corner begin = corner_between(before, edge, radius_m);
    const corner end = corner_between(edge, after, radius_m);
    tp_feature own = edge->arc
                         ? arc(edge, !before->arc && !begin.convex, !after->arc && !end.convex)
                         : straight(edge, &begin, &end);
    own.friction = friction != NULL ? friction[k] : 0;
    features->items[features->count++] = own;
    if (!end.convex) continue;
    own = rounded(edge, after, &end);
    if (friction != NULL) own.friction = fmin(friction[k], friction[(k + 1) % count]);
    features->items[features->count++] = own;
  }
  return true;
}
