/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* All triangles, but for those that are too far by a sphere about a corner. */

#include "solid/nearest.h"

#include "solid/triangle_distance.h"

#include <math.h>
#include <string.h>

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

static double distance(const tp_surface *s, long triangle, const double point[3]) {
  double corners[3][3], nearest[3];
  for (int c = 0; c < 3; c++) {
    memcpy(corners[c], s->near + 3 * (size_t)s->triangles[3 * triangle + c], sizeof corners[c]);
  }
  return tp_point_triangle_distance(nearest, point, corners);
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
