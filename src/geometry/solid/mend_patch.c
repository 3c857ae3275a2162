/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* By the least area over chords: the least of the part from i to j is, over k between, that from i
 * to k, that from k to j and the triangle i, k, j. Of equal areas short chords are better. */

#include "solid/mend_patch.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

enum { MOST_CHORDS = 500, LATTICE_BITS = 40 };

typedef struct loop {
  const tp_surface *surface;
  const tp_sides *sides;
  const int *points;
  long count;
  double *costs; /* of the parts from i to j */
  int *splits;
  int *triangles;
  long patched;
} loop;

static const double *at(const loop *l, long k) {
  return l->surface->near + 3L * l->points[k];
}

static double square(const double a[3], const double b[3]) {
  double sum = 0;
  for (int k = 0; k < 3; k++) sum += (a[k] - b[k]) * (a[k] - b[k]);
  return sum;
}

static double area(const double a[3], const double b[3], const double c[3]) {
  double sum = 0;
  for (int k = 0; k < 3; k++) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    const double own = (b[i] - a[i]) * (c[j] - a[j]) - (b[j] - a[j]) * (c[i] - a[i]);
    sum += own * own;
  }
  return sqrt(sum) / 2;
}

/* An edge that the surface has cannot be a chord as well. */
static bool is_taken(const loop *l, long i, long j) {
  long count = 0;
  tp_sides_edge(&count, l->sides, l->points[i], l->points[j]);
  return count > 0;
}

static void find_part(loop *l, long i, long j) {
  static const double shortness = 1e-6;
  const long n = l->count;
  const bool is_chord = !(i == 0 && j == n - 1);
  double least = INFINITY;
  for (long k = i + 1; k < j; k++) {
    const double beside = l->costs[i * n + k] + l->costs[k * n + j];
    if (!(beside < least)) continue;
    const double own = beside + area(at(l, i), at(l, k), at(l, j));
    if (!(own < least)) continue;
    least = own;
    l->splits[i * n + j] = (int)k;
  }
  if (is_chord) least += shortness * square(at(l, i), at(l, j));
  l->costs[i * n + j] = is_chord && is_taken(l, i, j) ? INFINITY : least;
}

static void take_parts(loop *l, long i, long j) {
  if (j - i < 2) return;
  const int k = l->splits[i * l->count + j];
  int *own = l->triangles + 3 * l->patched++;
  own[0] = (int)i;
  own[1] = k;
  own[2] = (int)j;
  take_parts(l, i, k);
  take_parts(l, k, j);
}

static bool patch_by_chords(loop *l) {
  const size_t size = (size_t)(l->count * l->count);
  l->costs = calloc(size, sizeof *l->costs);
  l->splits = calloc(size, sizeof *l->splits);
  const bool done = l->costs != NULL && l->splits != NULL;
  for (long length = 2; done && length < l->count; length++) {
    for (long i = 0; i + length < l->count; i++) find_part(l, i, i + length);
  }
  if (done && isfinite(l->costs[l->count - 1])) take_parts(l, 0, l->count - 1);
  free(l->costs);
  free(l->splits);
  return done;
}

/* ---- in a plane --------------------------------------------------------------------------------
 */

/* Across the plane that the loop goes round most in: the sum of its triangles from one point. */
static void find_normal(double normal[3], const loop *l) {
  for (int k = 0; k < 3; k++) normal[k] = 0;
  for (long n = 1; n + 1 < l->count; n++) {
    const double *a = at(l, 0), *b = at(l, n), *c = at(l, n + 1);
    for (int k = 0; k < 3; k++) {
      const int i = (k + 1) % 3, j = (k + 2) % 3;
      normal[k] += (b[i] - a[i]) * (c[j] - a[j]) - (b[j] - a[j]) * (c[i] - a[i]);
    }
  }
}

/* Two axes of that plane, counter-clockwise about the normal; false: it goes round nothing. */
static bool find_axes(double axes[2][3], const loop *l) {
  double n[3];
  int least = 0;
  find_normal(n, l);
  const double length = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  if (!(length > 0)) return false;
  for (int k = 0; k < 3; k++) {
    n[k] /= length;
    if (fabs(n[k]) < fabs(n[least])) least = k;
  }
  for (int k = 0; k < 3; k++) axes[0][k] = (k == least) - n[least] * n[k];
  const double size =
      sqrt(axes[0][0] * axes[0][0] + axes[0][1] * axes[0][1] + axes[0][2] * axes[0][2]);
  for (int k = 0; k < 3; k++) axes[0][k] /= size;
  for (int k = 0; k < 3; k++) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    axes[1][k] = n[i] * axes[0][j] - n[j] * axes[0][i];
  }
  return true;
}

/* Seen across the plane, rounded to whole numbers, of which the predicates are exact. */
static void project(double *u, double *v, const loop *l, double axes[2][3]) {
  for (long n = 0; n < l->count; n++) {
    double sums[2] = {0};
    for (int k = 0; k < 3; k++) {
      for (int a = 0; a < 2; a++) sums[a] += axes[a][k] * (at(l, n)[k] - at(l, 0)[k]);
    }
    u[n] = nearbyint(ldexp(sums[0], LATTICE_BITS));
    v[n] = nearbyint(ldexp(sums[1], LATTICE_BITS));
  }
}

static void take_triangles(loop *l, const tp_geom_rings *rings) {
  static const int layer[1] = {0};
  tp_geom_triangulation found;
  bool simple = false;
  if (tp_geom_is_simple(&simple, rings, 0) != TP_GEOM_OK || !simple) return;
  if (tp_geom_triangulate(&found, rings, layer) != TP_GEOM_OK) return;
  if (found.count == (size_t)l->count - 2) {
    for (size_t t = 0; t < found.count; t++) {
      int *own = l->triangles + 3 * l->patched++;
      for (int c = 0; c < 3; c++) own[c] = (int)found.triangles[t].corner[c];
    }
  }
  tp_geom_triangulation_clear(&found);
}

static bool patch_in_plane(loop *l) {
  const size_t start[2] = {0, (size_t)l->count};
  double *u = malloc((size_t)l->count * sizeof *u), *v = malloc((size_t)l->count * sizeof *v);
  double axes[2][3];
  const bool done = u != NULL && v != NULL;
  if (done && find_axes(axes, l)) {
    project(u, v, l, axes);
    const tp_geom_rings rings = {.count = 1, .start = start, .u = u, .v = v, .small = true};
    take_triangles(l, &rings);
  }
  free(u);
  free(v);
  return done;
}

bool tp_mend_patch(int *triangles, long *patched, const tp_surface *surface, const tp_sides *sides,
                   const int *points, long count) {
  loop l = {
      .surface = surface, .sides = sides, .points = points, .count = count, .triangles = triangles};
  const bool done = count < 3 || (count <= MOST_CHORDS ? patch_by_chords(&l) : patch_in_plane(&l));
  *patched = l.patched;
  return done;
}
