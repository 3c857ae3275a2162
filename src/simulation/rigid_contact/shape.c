/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Corners and faces from the edges of a boundary, with the range of normals of each corner, divided
 * by the extent of the block. */

#include "rigid_contact/shape.h"

#include <math.h>
#include <stdlib.h>

static const double whole_turn = 6.283185307179586;

/* Two edges that meet at less than this are one: no corner (radians). Far above what rounding does
 * to the direction of an edge, far below any corner that is meant. */
static const double least_corner = 1e-9;

static double from_first(tp_normal_range range, double direction) {
  const double d = fmod(direction - range.first, whole_turn);
  return d < 0 ? d + whole_turn : d;
}

double tp_normal_range_margin(tp_normal_range range, double direction) {
  const double d = from_first(range, direction);
  if (d <= range.sweep) return fmin(d, range.sweep - d);
  return fmax(range.sweep - d, d - whole_turn);
}

static tp_xy minus(tp_xy a, tp_xy b) {
  return (tp_xy){a.x - b.x, a.y - b.y};
}

static tp_xy unit(tp_xy a) {
  const double length = hypot(a.x, a.y);
  return (tp_xy){a.x / length, a.y / length};
}

/* The direction in which an edge runs at its begin or its end, the rock on its left: along an arc
 * counter-clockwise about its centre, where it is hollow clockwise. */
static tp_xy course(const tp_edge *edge, bool at_end) {
  if (!edge->arc) return unit(minus(edge->to, edge->from));
  const tp_xy out = unit(minus(at_end ? edge->to : edge->from, edge->centre));
  return edge->inwards ? (tp_xy){out.y, -out.x} : (tp_xy){-out.y, out.x};
}

static tp_normal_range range_of(const tp_edge *edge) {
  const tp_xy a = minus(edge->inwards ? edge->to : edge->from, edge->centre);
  const tp_xy b = minus(edge->inwards ? edge->from : edge->to, edge->centre);
  tp_normal_range range = {.first = atan2(a.y, a.x)};
  range.sweep = from_first(range, atan2(b.y, b.x));
  if (range.sweep == 0) range.sweep = whole_turn;
  return range;
}

static tp_xy over(tp_xy point, double extent) {
  return (tp_xy){point.x / extent, point.y / extent};
}

static void add_edge(tp_contact_shape *shape, const tp_edge *edge, long number, double extent) {
  if (edge->arc && !edge->inwards) {
    shape->corners[shape->corner_count++] = (tp_round_corner){.centre = over(edge->centre, extent),
                                                              .radius = edge->radius / extent,
                                                              .range = range_of(edge),
                                                              .before = number,
                                                              .behind = number};
    return;
  }
  tp_contact_face *face = shape->faces + shape->face_count++;
  *face = (tp_contact_face){.hollow = edge->arc, .edge = number};
  if (edge->arc) {
    face->centre = over(edge->centre, extent);
    face->radius = edge->radius / extent;
    face->range = range_of(edge);
    return;
  }
  face->from = over(edge->from, extent);
  face->along = course(edge, false);
  face->normal = (tp_xy){face->along.y, -face->along.x};
  const tp_xy whole = minus(edge->to, edge->from);
  face->length = hypot(whole.x, whole.y) / extent;
}

static void add_corner(tp_contact_shape *shape, const tp_boundary *boundary, long behind,
                       double extent) {
  const long before = behind > 0 ? behind - 1 : boundary->count - 1;
  const tp_xy in = course(boundary->edges + before, true);
  const tp_xy out = course(boundary->edges + behind, false);
  const double cross = in.x * out.y - in.y * out.x, dot = in.x * out.x + in.y * out.y;
  const double turns = atan2(cross, dot);
  if (turns < least_corner) return;
  shape->corners[shape->corner_count++] =
      (tp_round_corner){.centre = over(boundary->edges[behind].from, extent),
                        .range = {.first = atan2(-in.x, in.y), .sweep = turns},
                        .before = before,
                        .behind = behind};
}

bool tp_contact_shape_init(tp_contact_shape *shape, const tp_boundary *boundary, double extent_m) {
  const size_t count = boundary->count > 0 ? (size_t)boundary->count : 1;
  *shape = (tp_contact_shape){.corners = calloc(2 * count, sizeof *shape->corners),
                              .faces = calloc(count, sizeof *shape->faces)};
  if (shape->corners == NULL || shape->faces == NULL) {
    tp_contact_shape_clear(shape);
    return false;
  }
  for (long k = 0; k < boundary->count; k++) {
    add_corner(shape, boundary, k, extent_m);
    add_edge(shape, boundary->edges + k, k, extent_m);
  }
  return true;
}

void tp_contact_shape_clear(tp_contact_shape *shape) {
  free(shape->corners);
  free(shape->faces);
  *shape = (tp_contact_shape){0};
}
