/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Sides of the plane first, as whole numbers s = bottom (up . p) - top; edges whose ends lie on
 * different sides meet it in (s_a b - s_b a) / (s_a - s_b), once for all triangles that have them;
 * then triangles, each clipped from corner to corner. */

#include "solid/cut.h"

#include <stdlib.h>

enum { CLIPPED = 4 };

/* ---- points of the section ---------------------------------------------------------------------
 */

/* An edge that crosses the plane. */
typedef struct crossing {
  int low, high; /* vertices of the surface */
  int place;     /* of the point in what is cut off; -1: not yet */
} crossing;

typedef struct cutter {
  const tp_surface *surface;
  tp_cut_plane *plane;
  fmpz *sides; /* of each vertex */
  int *places; /* of each vertex in what is cut off; -1: not yet */
  crossing *crossings;
  long crossing_count;
  tp_surface *cut;
} cutter;

static int side_of(const cutter *c, int vertex) {
  return fmpz_sgn(c->sides + vertex);
}

static int compare_crossings(const void *one, const void *other) {
  const crossing *a = one, *b = other;
  if (a->low != b->low) return a->low < b->low ? -1 : 1;
  return (a->high > b->high) - (a->high < b->high);
}

static crossing crossing_of(int a, int b) {
  return (crossing){a < b ? a : b, a < b ? b : a, -1};
}

/* Of all triangles, each edge once. */
static bool find_crossings(cutter *c) {
  const tp_surface *s = c->surface;
  long count = 0;
  for (int pass = 0; pass < 2; pass++) {
    count = 0;
    for (long k = 0; k < 3 * s->triangle_count; k++) {
      const int a = s->triangles[k], b = s->triangles[k % 3 == 2 ? k - 2 : k + 1];
      if (side_of(c, a) * side_of(c, b) >= 0) continue;
      if (pass == 1) c->crossings[count] = crossing_of(a, b);
      count++;
    }
    if (pass == 1) break;
    c->crossings = malloc(((size_t)count + 1) * sizeof *c->crossings);
    if (c->crossings == NULL) return false;
  }
  qsort(c->crossings, (size_t)count, sizeof *c->crossings, compare_crossings);
  for (long k = 0; k < count; k++) {
    const crossing *last = c->crossings + c->crossing_count - 1;
    if (k > 0 && compare_crossings(last, c->crossings + k) == 0) continue;
    c->crossings[c->crossing_count++] = c->crossings[k];
  }
  return true;
}

/* Where an edge meets the plane, in whole numbers of the surface, and what these are divided by. */
static void set_crossing(fmpz *point, fmpz_t weight, const cutter *c, const crossing *edge) {
  const fmpz *low = c->surface->whole + 3L * edge->low, *high = c->surface->whole + 3L * edge->high;
  const fmpz *side = c->sides + edge->low, *other = c->sides + edge->high;
  fmpz_sub(weight, side, other);
  const bool turned = fmpz_sgn(weight) < 0;
  for (int k = 0; k < 3; k++) {
    fmpz_mul(point + k, side, high + k);
    fmpz_submul(point + k, other, low + k);
    if (turned) fmpz_neg(point + k, point + k);
  }
  fmpz_abs(weight, weight);
}

/* A vertex on the plane, else the first crossing. */
static void choose_origin(cutter *c) {
  tp_cut_plane *plane = c->plane;
  if (!fmpz_is_zero(plane->weight)) return;
  fmpz_one(plane->weight);
  for (int v = 0; v < c->surface->vertex_count; v++) {
    if (side_of(c, v) != 0) continue;
    for (int k = 0; k < 3; k++) fmpz_set(plane->origin + k, c->surface->whole + 3L * v + k);
    return;
  }
  if (c->crossing_count > 0) set_crossing(plane->origin, plane->weight, c, c->crossings);
}

/* ---- what is cut off ---------------------------------------------------------------------------
 */

/* The next point: (weight0 whole / weight - origin), both over their common divisor. */
static int add_point(cutter *c, const fmpz *whole, const fmpz_t weight, int source) {
  tp_surface *cut = c->cut;
  const int place = (int)cut->vertex_count++;
  fmpz *own = cut->whole + 3L * place, *divisor = cut->weights + place;
  fmpz_t common;
  fmpz_init_set(common, weight);
  for (int k = 0; k < 3; k++) {
    fmpz_mul(own + k, whole + k, c->plane->weight);
    fmpz_submul(own + k, c->plane->origin + k, weight);
    fmpz_gcd(common, common, own + k);
  }
  for (int k = 0; k < 3; k++) fmpz_divexact(own + k, own + k, common);
  fmpz_divexact(divisor, weight, common);
  fmpz_clear(common);
  cut->sources[place] = source;
  return place;
}

static int place_of_vertex(cutter *c, int vertex) {
  static const fmpz one = 1;
  if (c->places[vertex] < 0) {
    c->places[vertex] =
        add_point(c, c->surface->whole + 3L * vertex, &one, c->surface->sources[vertex]);
  }
  return c->places[vertex];
}

static int place_of_crossing(cutter *c, int a, int b) {
  const crossing asked = crossing_of(a, b);
  crossing *own = bsearch(&asked, c->crossings, (size_t)c->crossing_count, sizeof *c->crossings,
                          compare_crossings);
  if (own->place < 0) {
    fmpz point[3];
    fmpz_t weight;
    fmpz_init(weight);
    for (int k = 0; k < 3; k++) fmpz_init(point + k);
    set_crossing(point, weight, c, own);
    own->place = add_point(c, point, weight, -1);
    for (int k = 0; k < 3; k++) fmpz_clear(point + k);
    fmpz_clear(weight);
  }
  return own->place;
}

/* What of a triangle lies above, as up to four corners. */
static int clip(int corners[CLIPPED], cutter *c, const int *triangle) {
  int count = 0;
  for (int k = 0; k < 3; k++) {
    const int a = triangle[k], b = triangle[(k + 1) % 3];
    if (side_of(c, a) >= 0) corners[count++] = place_of_vertex(c, a);
    if (side_of(c, a) * side_of(c, b) < 0) corners[count++] = place_of_crossing(c, a, b);
  }
  return count;
}

static bool is_above(const cutter *c, const int *triangle) {
  for (int k = 0; k < 3; k++) {
    if (side_of(c, triangle[k]) > 0) return true;
  }
  return false;
}

static void clip_all(cutter *c) {
  for (long t = 0; t < c->surface->triangle_count; t++) {
    const int *triangle = c->surface->triangles + 3 * t;
    int corners[CLIPPED];
    if (!is_above(c, triangle)) continue;
    const int count = clip(corners, c, triangle);
    for (int k = 2; k < count; k++) {
      int *own = c->cut->triangles + 3 * c->cut->triangle_count;
      own[0] = corners[0];
      own[1] = corners[k - 1];
      own[2] = corners[k];
      c->cut->faces[c->cut->triangle_count++] = c->surface->faces[t];
    }
  }
}

/* Of the first surface the size of its farthest point: what is inside of it is no farther. */
static void choose_exponent(cutter *c) {
  const tp_surface *cut = c->cut;
  if (c->plane->exponent > 0) return;
  c->plane->exponent = 1;
  for (long k = 0; k < 3 * cut->vertex_count; k++) {
    const long bits = (long)fmpz_bits(cut->whole + k) - (long)fmpz_bits(cut->weights + k / 3) + 1;
    if (bits > c->plane->exponent) c->plane->exponent = bits;
  }
}

static void set_near(cutter *c) {
  tp_surface *cut = c->cut;
  fmpq_t at;
  fmpq_init(at);
  choose_exponent(c);
  cut->exponent = c->plane->exponent;
  for (long k = 0; k < 3 * cut->vertex_count; k++) {
    fmpq_set_fmpz_frac(at, cut->whole + k, cut->weights + k / 3);
    fmpq_div_2exp(at, at, (ulong)cut->exponent);
    cut->near[k] = tp_surface_nearest(at);
  }
  fmpq_clear(at);
}

/* ---- all ---------------------------------------------------------------------------------------
 */

/* Room for all: a triangle makes two at most, and its edges three points. */
static bool make_room(cutter *c) {
  const tp_surface *s = c->surface;
  tp_surface *cut = c->cut;
  const size_t triangles = 2 * (size_t)s->triangle_count;
  const size_t points = (size_t)s->vertex_count + (size_t)c->crossing_count;
  cut->sources = malloc(points * sizeof *cut->sources);
  cut->whole = calloc(3 * points, sizeof *cut->whole);
  cut->weights = calloc(points, sizeof *cut->weights);
  cut->near = malloc(3 * points * sizeof *cut->near);
  cut->triangles = malloc(3 * triangles * sizeof *cut->triangles);
  cut->faces = malloc(triangles * sizeof *cut->faces);
  return cut->sources != NULL && cut->whole != NULL && cut->weights != NULL && cut->near != NULL &&
         cut->triangles != NULL && cut->faces != NULL;
}

static void set_lattice(const cutter *c) {
  tp_surface *cut = c->cut;
  const tp_surface *s = c->surface;
  fmpz_mul(cut->divisor, s->divisor, c->plane->weight);
  for (int k = 0; k < 3; k++) {
    fmpz_mul(cut->origin[k], s->origin[k], c->plane->weight);
    fmpz_add(cut->origin[k], cut->origin[k], c->plane->origin + k);
  }
}

static bool find_sides(cutter *c) {
  const tp_surface *s = c->surface;
  c->sides = calloc((size_t)s->vertex_count, sizeof *c->sides);
  c->places = malloc((size_t)s->vertex_count * sizeof *c->places);
  if (c->sides == NULL || c->places == NULL) return false;
  for (long v = 0; v < s->vertex_count; v++) {
    tp_cut_height(c->sides + v, c->plane, s->whole + 3 * v);
    fmpz_mul(c->sides + v, c->sides + v, c->plane->bottom);
    fmpz_sub(c->sides + v, c->sides + v, c->plane->top);
    c->places[v] = -1;
  }
  return true;
}

static bool cut_all(cutter *c) {
  if (!find_sides(c) || !find_crossings(c)) return false;
  choose_origin(c);
  if (!make_room(c)) return false;
  set_lattice(c);
  clip_all(c);
  set_near(c);
  return true;
}

tp_status tp_cut_above(tp_surface *cut, const tp_surface *surface, tp_cut_plane *plane,
                       tp_message *message) {
  cutter c = {.surface = surface, .plane = plane, .cut = cut};
  *cut = (tp_surface){.mesh = surface->mesh, .split = surface->split};
  fmpz_init(cut->divisor);
  for (int k = 0; k < 3; k++) fmpz_init(cut->origin[k]);
  const bool done = cut_all(&c);
  for (long v = 0; c.sides != NULL && v < surface->vertex_count; v++) fmpz_clear(c.sides + v);
  free(c.sides);
  free(c.places);
  free(c.crossings);
  if (done) return TP_OK;
  tp_surface_clear(cut);
  return tp_fail_memory(message, "a solid that a plane cuts");
}
