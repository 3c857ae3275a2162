/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The distance from a triangle: the foot within it, or else the nearest of its sides. */

#include "solid/nearest.h"

#include <math.h>

static void take(double way[3], const tp_surface *s, int to, const double from[3]) {
  for (int k = 0; k < 3; k++) way[k] = s->near[3 * to + k] - from[k];
}

static double dot(const double a[3], const double b[3]) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void cross(double product[3], const double a[3], const double b[3]) {
  for (int k = 0; k < 3; k++) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    product[k] = a[i] * b[j] - a[j] * b[i];
  }
}

/* Across a triangle, outwards. */
static void set_normal(double normal[3], const tp_surface *s, long triangle) {
  const int *corners = s->triangles + 3 * triangle;
  const double *first = s->near + 3 * (size_t)corners[0];
  double b[3], c[3];
  take(b, s, corners[1], first);
  take(c, s, corners[2], first);
  cross(normal, b, c);
  const double length = sqrt(dot(normal, normal));
  for (int k = 0; k < 3; k++) normal[k] /= length;
}

/* From a side, and whether the point lies to its left within the plane of the triangle. */
static double from_side(bool *left, const double a[3], const double b[3], const double normal[3]) {
  double way[3], across[3], foot[3];
  for (int k = 0; k < 3; k++) way[k] = b[k] - a[k];
  cross(across, a, b); /* of the point as the origin */
  *left = dot(across, normal) >= 0;
  const double share = fmin(1, fmax(0, -dot(a, way) / dot(way, way)));
  for (int k = 0; k < 3; k++) foot[k] = a[k] + share * way[k];
  return sqrt(dot(foot, foot));
}

static double distance(const tp_surface *s, long triangle, const double point[3]) {
  const int *corners = s->triangles + 3 * triangle;
  double ways[3][3], normal[3], least = INFINITY;
  bool within = true, left = true;
  set_normal(normal, s, triangle);
  for (int k = 0; k < 3; k++) take(ways[k], s, corners[k], point);
  for (int k = 0; k < 3; k++) {
    least = fmin(least, from_side(&left, ways[k], ways[(k + 1) % 3], normal));
    within = within && left;
  }
  return within ? fabs(dot(ways[0], normal)) : least;
}

/* Farther than the sphere about a corner that holds the triangle: need not be looked at. */
static bool is_far(const tp_surface *s, long triangle, const double point[3], double least) {
  const int *corners = s->triangles + 3 * triangle;
  const double *first = s->near + 3 * (size_t)corners[0];
  double way[3], b[3], c[3];
  take(way, s, corners[0], point);
  take(b, s, corners[1], first);
  take(c, s, corners[2], first);
  return sqrt(dot(way, way)) - sqrt(fmax(dot(b, b), dot(c, c))) > least;
}

tp_nearest_triangle tp_surface_nearest_triangle(const tp_surface *surface, const double point[3]) {
  static const double same = 1e-9, turned = 1e-6; /* of the size of the surface; of a cosine */
  tp_nearest_triangle nearest = {.distance = INFINITY};
  for (long k = 0; k < surface->triangle_count; k++) {
    if (is_far(surface, k, point, nearest.distance + same)) continue;
    const double own = distance(surface, k, point);
    if (own > nearest.distance + same) continue;
    double a[3], b[3];
    if (own < nearest.distance - same) {
      nearest = (tp_nearest_triangle){k, own, false};
      continue;
    }
    set_normal(a, surface, nearest.triangle);
    set_normal(b, surface, k);
    nearest.is_edge = nearest.is_edge || dot(a, b) < 1 - turned;
  }
  return nearest;
}

void tp_surface_inward(fmpz inward[3], const tp_surface *surface, long triangle) {
  const int *corners = surface->triangles + 3 * triangle;
  const fmpz *a = surface->whole + 3 * (size_t)corners[0];
  fmpz b[3], c[3];
  for (int k = 0; k < 3; k++) {
    fmpz_init(b + k);
    fmpz_init(c + k);
    fmpz_sub(b + k, surface->whole + 3 * (size_t)corners[1] + k, a + k);
    fmpz_sub(c + k, surface->whole + 3 * (size_t)corners[2] + k, a + k);
  }
  for (int k = 0; k < 3; k++) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    fmpz_mul(inward + k, b + j, c + i);
    fmpz_submul(inward + k, b + i, c + j);
  }
  for (int k = 0; k < 3; k++) {
    fmpz_clear(b + k);
    fmpz_clear(c + k);
  }
}
