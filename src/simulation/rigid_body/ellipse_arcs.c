/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* An ellipse as arcs. Between two of its points with their tangents t0 and t1, v apart, stand two
 * arcs that meet in (p0 + p1 + d (t0 - t1)) / 2 with the same tangent, each tangent to the ellipse
 * at its own end: d is the length from both ends to the corners of their tangents, the positive
 * root of (v - d (t0 + t1))^2 = (2 d)^2. */

#include "rigid_body/boundary.h"

#include <math.h>

enum { PIECES = 256 }; /* of a whole turn; a circle takes one to a quarter */

static long piece_count(tp_xy half_axes) {
  return half_axes.x == half_axes.y ? 4 : PIECES;
}

long tp_ellipse_arc_count(tp_xy half_axes) {
  return 2 * piece_count(half_axes);
}

/* From a point with a unit tangent to another one, the rock on the left. */
static tp_edge tangent_arc(tp_xy from, tp_xy tangent, tp_xy to) {
  const tp_xy normal = tp_xy_left(tangent), chord = tp_xy_minus(to, from);
  const double radius = tp_xy_dot(chord, chord) / (2 * tp_xy_dot(normal, chord));
  return (tp_edge){.from = from,
                   .to = to,
                   .arc = true,
                   .centre = tp_xy_plus(from, radius, normal),
                   .radius = radius};
}

static tp_xy unit_tangent(tp_xy half_axes, double angle) {
  const double x = -half_axes.x * sin(angle), y = half_axes.y * cos(angle), size = hypot(x, y);
  return (tp_xy){x / size, y / size};
}

static tp_xy point_at(tp_xy centre, tp_xy half_axes, double angle) {
  return (tp_xy){centre.x + half_axes.x * cos(angle), centre.y + half_axes.y * sin(angle)};
}

void tp_ellipse_arcs(tp_edge *edges, tp_xy centre, tp_xy half_axes, double first, double last) {
  const long pieces = piece_count(half_axes);
  for (long k = 0; k < pieces; k++) {
    const double a0 = first + (last - first) * (double)k / (double)pieces;
    const double a1 = first + (last - first) * (double)(k + 1) / (double)pieces;
    const tp_xy p0 = point_at(centre, half_axes, a0), p1 = point_at(centre, half_axes, a1);
    const tp_xy t0 = unit_tangent(half_axes, a0), t1 = unit_tangent(half_axes, a1);
    const tp_xy v = tp_xy_minus(p1, p0), apart = tp_xy_minus(t0, t1);
    const double along = tp_xy_dot(v, t0) + tp_xy_dot(v, t1);
    const double d =
        tp_xy_dot(v, v) / (along + sqrt(along * along + tp_xy_dot(apart, apart) * tp_xy_dot(v, v)));
    const tp_xy middle = {(p0.x + p1.x + d * apart.x) / 2, (p0.y + p1.y + d * apart.y) / 2};
    edges[2 * k] = tangent_arc(p0, t0, middle);
    /* the second arc from its own end backwards: its tangent there is the ellipse's too */
    const tp_edge back = tangent_arc(p1, (tp_xy){-t1.x, -t1.y}, middle);
    edges[2 * k + 1] = (tp_edge){
        .from = middle, .to = p1, .arc = true, .centre = back.centre, .radius = -back.radius};
  }
}
