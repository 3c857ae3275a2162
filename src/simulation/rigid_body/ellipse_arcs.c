/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* An ellipse as arcs. Between two of its points with their tangents t0 and t1, v apart, stand two
 * arcs that meet in the centre of the circle inscribed in the triangle of chord and tangents. With
 * a and b the tangents of half the angles from t0 to v and from v to t1 it lies over the share
 * b / (a + b) of the chord, higher than that by a b / (a + b) of its length. Each arc is tangent to
 * the ellipse at its own end and parallel to v where they meet: it turns by one of these angles, so
 * both turn as the ellipse does and stay within the triangle, however slender that is.
 *
 * Arcs that leave the tangents at the same distance from their corner turn back where these are of
 * very different lengths: an ellipse of 12500 to 1 was off by 3/4 of its width. */

#include "rigid_body/boundary.h"

#include <math.h>

enum { PIECES = 256 }; /* of a whole turn; a circle takes one to a quarter */

static long piece_count(tp_xy half_axes) {
  return half_axes.x == half_axes.y ? 4 : PIECES;
}

long tp_ellipse_arc_count(tp_xy half_axes) {
  return 2 * piece_count(half_axes);
}

/* With a tangent of half its turn below this an arc rises over its chord by less than the rounding
 * of its radius: it stands as a straight edge. */
static const double least_turn = 0x1p-26;

/* From a point to another one, the rock on the left. Its unit tangent in `end`, one of them, and
 * the chord are apart by the angle whose tangent is `turn`. */
static tp_edge tangent_arc(tp_xy from, tp_xy to, tp_xy end, tp_xy tangent, double turn) {
  const tp_xy chord = tp_xy_minus(to, from);
  const double radius = hypot(chord.x, chord.y) * hypot(1, turn) / (2 * turn);
  return (tp_edge){.from = from,
                   .to = to,
                   .arc = true,
                   .centre = tp_xy_plus(end, radius, tp_xy_left(tangent)),
                   .radius = radius};
}

static tp_edge straight_edge(tp_xy from, tp_xy to) {
  return (tp_edge){.from = from, .to = to};
}

/* The tangent of half the angle from one direction to another, of less than half a circle. */
static double half_angle(tp_xy from, tp_xy to) {
  const double lengths = hypot(from.x, from.y) * hypot(to.x, to.y);
  return tp_xy_cross(from, to) / (lengths + tp_xy_dot(from, to));
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
    const double from = first + (last - first) * (double)k / (double)pieces;
    const double to = first + (last - first) * (double)(k + 1) / (double)pieces;
    const tp_xy p0 = point_at(centre, half_axes, from), p1 = point_at(centre, half_axes, to);
    const tp_xy t0 = unit_tangent(half_axes, from), t1 = unit_tangent(half_axes, to);
    const tp_xy v = tp_xy_minus(p1, p0);
    const double a = half_angle(t0, v), b = half_angle(v, t1);
    const bool turns = a >= least_turn && b >= least_turn;
    const double share = turns ? b / (a + b) : 0.5, height = turns ? a * share : 0;
    const tp_xy middle = tp_xy_plus(tp_xy_plus(p0, share, v), -height, tp_xy_left(v));
    edges[2 * k] = turns ? tangent_arc(p0, middle, p0, t0, a) : straight_edge(p0, middle);
    edges[2 * k + 1] = turns ? tangent_arc(middle, p1, p1, t1, b) : straight_edge(middle, p1);
  }
}
