/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A ray from the point along x is inside where it meets an odd number of triangles. Seen along it,
 * the point lies in a triangle where all three sides turn the same way about it. Where a side
 * passes through it, the point is taken as moved by an infinitely small e along y and e^2 along z
 * (simulation of simplicity, Edelsbrunner and Mücke 1990), so that no ray meets an edge or a
 * corner, or grazes a triangle.
 *
 * Three times the corners less three times the point are whole numbers. */

#include "solid/inside.h"

typedef struct ray {
  const tp_surface *surface;
  double near[3]; /* the point, */
  fmpz whole[3];  /* and three times it */
  fmpz corners[9], r[3];
} ray;

/* ---- what doubles rule out --------------------------------------------------------------------
 */

/* Coordinates are at most 1 in size, and off by a rounding; the mean of three by four. */
static const double slack = 8 * DBL_EPSILON;

/* Behind the point, or beside the ray. */
static bool is_apart(const ray *x, const int *corners) {
  const double *near = x->surface->near;
  for (int k = 0; k < 3; k++) {
    const double a = near[3L * corners[0] + k], b = near[3L * corners[1] + k];
    const double c = near[3L * corners[2] + k];
    if (fmax(fmax(a, b), c) < x->near[k] - slack) return true;
    if (k > 0 && fmin(fmin(a, b), c) > x->near[k] + slack) return true;
  }
  return false;
}

/* ---- exactly ----------------------------------------------------------------------------------
 */

/* The side from one corner to another, seen along x: 1 where it turns to the left about the point,
 * -1 to the right; 0 where both corners are one. */
static int turn(ray *x, const fmpz *from, const fmpz *to) {
  fmpz_mul(x->r, from + 1, to + 2);
  fmpz_submul(x->r, from + 2, to + 1);
  const int sign = fmpz_sgn(x->r), along_z = fmpz_cmp(from + 2, to + 2);
  if (sign != 0) return sign;
  if (along_z != 0) return along_z > 0 ? 1 : -1;
  const int along_y = fmpz_cmp(to + 1, from + 1);
  return (along_y > 0) - (along_y < 0);
}

/* The sign of a . (b x c). */
static int volume_sign(ray *x, const fmpz *a, const fmpz *b, const fmpz *c) {
  fmpz_zero(x->r);
  for (int k = 0; k < 3; k++) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    fmpz_mul(x->r + 1, b + i, c + j);
    fmpz_submul(x->r + 1, b + j, c + i);
    fmpz_addmul(x->r, a + k, x->r + 1);
  }
  return fmpz_sgn(x->r);
}

static bool meets(ray *x, const int *corners) {
  if (is_apart(x, corners)) return false;
  const fmpz *a = x->corners, *b = a + 3, *c = a + 6;
  for (int k = 0; k < 9; k++) {
    fmpz_mul_ui(x->corners + k, x->surface->whole + 3L * corners[k / 3] + k % 3, 3);
    fmpz_sub(x->corners + k, x->corners + k, x->whole + k % 3);
  }
  const int side = turn(x, a, b);
  if (side == 0 || turn(x, b, c) != side || turn(x, c, a) != side) return false;
  return volume_sign(x, a, b, c) == side;
}

bool tp_surface_has_inside(const tp_surface *surface, const tp_surface *other, long triangle) {
  const int *own = other->triangles + 3 * triangle;
  ray x = {.surface = surface};
  bool inside = false;
  for (int k = 0; k < 9; k++) fmpz_init(x.corners + k);
  for (int k = 0; k < 3; k++) {
    fmpz_init(x.r + k);
    fmpz_init(x.whole + k);
    for (int c = 0; c < 3; c++) {
      x.near[k] += other->near[3L * own[c] + k];
      fmpz_add(x.whole + k, x.whole + k, other->whole + 3L * own[c] + k);
    }
    x.near[k] /= 3;
  }
  for (long t = 0; t < surface->triangle_count; t++) {
    if (meets(&x, surface->triangles + 3 * t)) inside = !inside;
  }
  for (int k = 0; k < 9; k++) fmpz_clear(x.corners + k);
  for (int k = 0; k < 3; k++) {
    fmpz_clear(x.r + k);
    fmpz_clear(x.whole + k);
  }
  return inside;
}
