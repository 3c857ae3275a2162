/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Edges of outline and base in order, arcs and rounded corners with centre and radius, pieces of
 * one arc joined up to half a circle. */

#include "rigid_body/boundary.h"

#include "number/ball.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void tp_boundary_clear(tp_boundary *boundary) {
  free(boundary->edges);
  memset(boundary, 0, sizeof *boundary);
}

/* Room was made for all edges before the first is added. */
static void add(tp_boundary *boundary, tp_edge edge) {
  if (edge.from.x == edge.to.x && edge.from.y == edge.to.y) return;
  boundary->edges[boundary->count++] = edge;
}

/* ---- arcs
 * -------------------------------------------------------------------------------------------- */

static tp_edge arc_of_ball(const tp_local *local, const tp_corner_ball *c, bool inwards) {
  tp_edge edge = {.from = tp_local_point(local, c->before.x, c->before.y),
                  .to = tp_local_point(local, c->after.x, c->after.y),
                  .arc = true,
                  .inwards = inwards,
                  .centre = tp_local_point(local, c->centre.x, c->centre.y)};
  arb_t radius;
  arb_init(radius);
  arb_set(radius, c->radius);
  tp_evaluation_to_metres(radius, &local->e, 1);
  edge.radius = tp_local_nearest(radius);
  arb_clear(radius);
  return edge;
}

static tp_edge arc_of_tip(const tp_local *local, const tp_arc_tip *tip) {
  const tp_problem *problem = local->e.problem;
  tp_corner_ball c;
  tp_corner_ball_init(&c);
  tp_arc_tip_evaluate(&c, tip, &problem->lattice, problem->scene->metres_per_unit,
                      local->e.rung.bits);
  const tp_edge edge = arc_of_ball(local, &c, tip->inwards);
  tp_corner_ball_clear(&c);
  return edge;
}

static tp_edge arc_of_corner(const tp_local *local, const tp_corner *corner) {
  tp_corner_ball c;
  tp_corner_ball_init(&c);
  tp_corner_evaluate(&c, corner, &local->e.problem->lattice, local->e.rung.bits);
  const tp_edge edge = arc_of_ball(local, &c, false);
  tp_corner_ball_clear(&c);
  return edge;
}

/* Is the angle from one end of the first to the other end of the second below half a circle? */
static bool joins(const tp_edge *arc, const tp_edge *next) {
  if (!arc->arc || !next->arc || arc->inwards != next->inwards || arc->to.x != next->from.x ||
      arc->to.y != next->from.y || arc->centre.x != next->centre.x ||
      arc->centre.y != next->centre.y) {
    return false;
  }
  const tp_xy first = tp_xy_minus(arc->from, arc->centre),
              last = tp_xy_minus(next->to, arc->centre);
  const double turn = tp_xy_cross(first, last);
  return next->inwards ? turn < 0 : turn > 0;
}

/* The pieces of an arc become one, as far as that stays below half a circle. */
static void add_arc(tp_boundary *boundary, tp_edge arc) {
  tp_edge *last = boundary->count > 0 ? boundary->edges + boundary->count - 1 : NULL;
  if (last != NULL && joins(last, &arc)) {
    last->to = arc.to;
  } else {
    add(boundary, arc);
  }
}

/* ---- the block
 * --------------------------------------------------------------------------------------------- */

static tp_outline_point end_of(const tp_problem *problem, long vertex, bool after) {
  const tp_corner *corner = tp_corners_at(&problem->corners, vertex);
  return (tp_outline_point){.point = vertex, .cut = corner, .after = after};
}

/* Do the roundings at its two ends leave the edge nothing? */
static bool is_used_up(const tp_problem *problem, long vertex, long next) {
  const tp_corner *start = tp_corners_at(&problem->corners, vertex);
  const tp_corner *end = tp_corners_at(&problem->corners, next);
  return (start != NULL || end != NULL) && tp_tangents_room(start, end, &problem->lattice) == 0;
}

static void add_ring(tp_boundary *boundary, const tp_local *local) {
  const tp_problem *problem = local->e.problem;
  const tp_polyline *ring = problem->section.rings;
  const tp_arc_tips *tips = &problem->section.arc_tips;
  long tip = 0; /* in the order of the ring */
  for (long k = 0; k < ring->count; k++) {
    const long next = k + 1 == ring->count ? 0 : k + 1;
    const tp_corner *corner = tp_corners_at(&problem->corners, k);
    if (corner != NULL) {
      tp_edge arc = arc_of_corner(local, corner);
      arc.number = tp_polyline_number(ring, k);
      add(boundary, arc);
    }
    const bool own = tip < tips->count && tips->items[tip].vertex == k;
    if (own) {
      tp_edge arc = arc_of_tip(local, tips->items + tip++);
      arc.number = tp_polyline_number(ring, k);
      add_arc(boundary, arc);
      continue;
    }
    const bool begins_arc =
        tip < tips->count && tips->items[tip].vertex == next && !tips->items[tip].inwards;
    if (begins_arc || is_used_up(problem, k, next)) continue;
    add(boundary, (tp_edge){.from = tp_local_outline_point(local, end_of(problem, k, true)),
                            .to = tp_local_outline_point(local, end_of(problem, next, false)),
                            .number = tp_polyline_number(ring, k)});
  }
}

static tp_xy turned(tp_xy at, tp_xy about, double cosine, double sine) {
  const double x = at.x - about.x, y = at.y - about.y;
  return (tp_xy){about.x + cosine * x + sine * y, about.y + cosine * y - sine * x};
}

/* About the middle of the flat, as the polygon around the ellipse is turned. */
static void turn_arcs(tp_edge *arcs, long count, tp_xy middle, const tp_ellipse *e) {
  const double cosine = fmpq_get_d(e->cosine), sine = fmpq_get_d(e->sine);
  for (long k = 0; k < count; k++) {
    arcs[k].from = turned(arcs[k].from, middle, cosine, sine);
    arcs[k].to = turned(arcs[k].to, middle, cosine, sine);
    arcs[k].centre = turned(arcs[k].centre, middle, cosine, sine);
  }
}

/* The flat, then round from its right end. The polygon around the ellipse begins there. */
static void add_ellipse(tp_boundary *boundary, const tp_local *local) {
  const tp_problem *problem = local->e.problem;
  const tp_ellipse *e = problem->section.ellipse;
  const double metres = fmpq_get_d(problem->scene->metres_per_unit);
  const tp_xy half = {fmpq_get_d(e->width.value) * metres / 2,
                      fmpq_get_d(e->height.value) * metres / 2};
  fmpq_t share;
  fmpq_init(share);
  fmpq_div(share, e->flat.value, e->width.value);
  const double cut = asin(fmpq_get_d(share)), quarter = acos(0);
  fmpq_clear(share);
  const tp_xy right = tp_local_lattice_point(local, 0);
  const tp_xy left = tp_local_lattice_point(local, problem->lattice.start[1] - 1);
  const tp_xy middle = {(left.x + right.x) / 2, (left.y + right.y) / 2};
  const tp_xy centre = {middle.x, middle.y + half.y * cos(cut)};
  add(boundary, (tp_edge){.from = left, .to = right, .number = 1});
  tp_edge *arcs = boundary->edges + boundary->count;
  const long count = tp_ellipse_arc_count(half);
  tp_ellipse_arcs(arcs, centre, half, cut - quarter, 3 * quarter - cut);
  if (e->cosine != NULL) turn_arcs(arcs, count, middle, e);
  arcs[0].from = right;
  arcs[count - 1].to = left;
  for (long k = 0; k < count; k++) arcs[k].number = 2;
  boundary->count += count;
}

bool tp_boundary_of_block(tp_boundary *boundary, const tp_local *local) {
  const tp_problem *problem = local->e.problem;
  const tp_ellipse *ellipse = problem->section.ellipse;
  /* of an edge at most itself and the arc at its vertex */
  long room = 2 * problem->section.rings[0].count;
  if (ellipse != NULL) {
    const bool circle = fmpq_equal(ellipse->width.value, ellipse->height.value);
    room = 1 + tp_ellipse_arc_count((tp_xy){circle ? 1 : 2, 1});
  }
  *boundary = (tp_boundary){.edges = calloc((size_t)room, sizeof *boundary->edges)};
  if (boundary->edges == NULL) return false;
  if (ellipse != NULL) {
    add_ellipse(boundary, local);
  } else {
    add_ring(boundary, local);
  }
  return true;
}

/* ---- the base
 * ------------------------------------------------------------------------------------------ */

bool tp_boundary_of_base(tp_boundary *boundary, const tp_local *local) {
  const tp_problem *problem = local->e.problem;
  const long *starts = problem->lattice.start + problem->section.ring_count;
  const long start = starts[0], count = starts[1] - start, facets = problem->base.edge_count;
  *boundary = (tp_boundary){.edges = calloc((size_t)count, sizeof *boundary->edges)};
  tp_xy *points = malloc((size_t)count * sizeof *points);
  const bool done = boundary->edges != NULL && points != NULL;
  for (long k = 0; k < count && done; k++) points[k] = tp_local_lattice_point(local, start + k);
  /* the ring runs clockwise: along the profile to the right, and back below it */
  for (long k = count; k > 0 && done; k--) {
    const long edge =
        (k - 1 + facets) % count; /* from the last facet to the first, then the rest */
    add(boundary, (tp_edge){.from = points[(edge + 1) % count],
                            .to = points[edge],
                            .number = edge < facets ? edge + 1 : 0});
  }
  free(points);
  if (!done) tp_boundary_clear(boundary);
  return done;
}

double tp_boundary_reach(const tp_boundary *boundary) {
  double reach = 0;
  for (long k = 0; k < boundary->count; k++) {
    const tp_edge *edge = boundary->edges + k;
    reach = fmax(reach, hypot(edge->from.x, edge->from.y));
    if (!edge->arc || edge->inwards) continue;
    const tp_xy first = tp_xy_minus(edge->from, edge->centre),
                last = tp_xy_minus(edge->to, edge->centre);
    const bool faces =
        tp_xy_cross(first, edge->centre) >= 0 && tp_xy_cross(edge->centre, last) >= 0;
    if (faces) reach = fmax(reach, hypot(edge->centre.x, edge->centre.y) + edge->radius);
  }
  return reach;
}
