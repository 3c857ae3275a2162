/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Sides by the common perpendicular of their lines, cut to both of them; corners by their foot in
 * the triangle, else by its sides. */

#include "solid/triangle_distance.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

static double dot(const double a[3], const double b[3]) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void sub(double way[3], const double to[3], const double from[3]) {
  for (int k = 0; k < 3; k++) way[k] = to[k] - from[k];
}

static void cross(double product[3], const double a[3], const double b[3]) {
  for (int k = 0; k < 3; k++) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    product[k] = a[i] * b[j] - a[j] * b[i];
  }
}

static double apart(const double a[3], const double b[3]) {
  double way[3];
  sub(way, a, b);
  return sqrt(dot(way, way));
}

static double within(double share) {
  return fmin(1, fmax(0, share));
}

static double point_side(double nearest[3], const double p[3], const double a[3],
                         const double b[3]) {
  double way[3], own[3];
  sub(way, b, a);
  sub(own, p, a);
  const double square = dot(way, way), share = square > 0 ? within(dot(own, way) / square) : 0;
  for (int k = 0; k < 3; k++) nearest[k] = a[k] + share * way[k];
  return apart(p, nearest);
}

double tp_point_triangle_distance(double nearest[3], const double p[3], double t[3][3]) {
  double b[3], c[3], n[3], own[3], across[3], foot[3], least = INFINITY;
  sub(b, t[1], t[0]);
  sub(c, t[2], t[0]);
  cross(n, b, c);
  sub(own, p, t[0]);
  const double height = dot(own, n) / dot(n, n);
  bool is_inside = true;
  for (int k = 0; k < 3; k++) {
    double way[3], from[3];
    sub(way, t[(k + 1) % 3], t[k]);
    sub(from, p, t[k]);
    cross(across, way, from);
    is_inside = is_inside && dot(across, n) >= 0;
  }
  if (is_inside) {
    for (int k = 0; k < 3; k++) nearest[k] = p[k] - height * n[k];
    return apart(p, nearest);
  }
  for (int k = 0; k < 3; k++) {
    const double side = point_side(foot, p, t[k], t[(k + 1) % 3]);
    if (side >= least) continue;
    least = side;
    memcpy(nearest, foot, sizeof foot);
  }
  return least;
}

/* Between two segments. */
static double side_side(double points[2][3], const double a[2][3], const double b[2][3]) {
  double u[3], v[3], w[3];
  sub(u, a[1], a[0]);
  sub(v, b[1], b[0]);
  sub(w, a[0], b[0]);
  const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), uw = dot(u, w), vw = dot(v, w);
  const double area = uu * vv - uv * uv;
  const double s = area > 0 ? within((uv * vw - vv * uw) / area) : 0;
  for (int k = 0; k < 3; k++) points[0][k] = a[0][k] + s * u[k];
  point_side(points[1], points[0], b[0], b[1]);
  return point_side(points[0], points[1], a[0], a[1]);
}

static void keep(double *least, double points[2][3], double own, const double p[3],
                 const double q[3]) {
  if (own >= *least) return;
  *least = own;
  memcpy(points[0], p, 3 * sizeof *p);
  memcpy(points[1], q, 3 * sizeof *q);
}

double tp_triangle_distance(double points[2][3], double one[3][3], double other[3][3]) {
  double least = INFINITY, foot[3], own[2][3];
  for (int k = 0; k < 3; k++) {
    keep(&least, points, tp_point_triangle_distance(foot, one[k], other), one[k], foot);
    const double back = tp_point_triangle_distance(foot, other[k], one);
    keep(&least, points, back, foot, other[k]);
  }
  for (int k = 0; k < 9; k++) {
    const int i = k / 3, j = k % 3;
    double a[2][3], b[2][3];
    memcpy(a[0], one[i], sizeof a[0]);
    memcpy(a[1], one[(i + 1) % 3], sizeof a[1]);
    memcpy(b[0], other[j], sizeof b[0]);
    memcpy(b[1], other[(j + 1) % 3], sizeof b[1]);
    const double distance = side_side(own, a, b);
    keep(&least, points, distance, own[0], own[1]);
  }
  return least;
}
