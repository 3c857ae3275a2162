/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Signs of determinants of vectors from the inner point: by doubles with one bound for all; where
 * that does not decide by words, or, where coordinates do not fit into these, by doubles with a
 * bound for each and by whole numbers. The inner point is in no plane of symmetry of the four
 * points that it is a mean of, where it would be level with many a vertex. The triangle whose cone
 * has a point is found by a walk over any side that the point is beyond, from the triangle found
 * last in about that direction. A walk that takes long is followed by a search of all.
 *
 * The bound for all: with u = 2^-53, a coordinate is at most 1 and off by u, the inner point by 5
 * u, a vector from it by 8 u and at most 2, the sum of three of these by 36 u and at most 6. A
 * product of two is off by 36 u, a component of the cross product of two by 80 u and at most 8, its
 * product with the third vector by 6 (80 u) + 8 (36 u) + 48 u, less than 820 u, and the sum of
 * three, with its roundings, by less than 2750 u: less than 2^12 u = 2^-41. */

#include "solid/hull_proof.h"

#include "solid/sides.h"
#include "solid/turns.h"
#include "solid/word_turns.h"

#include <stdlib.h>
#include <string.h>

/* By which the four points are weighed, and their sum: a power of two. */
enum { HULL_WEIGHT = 64 };
static const int hull_weights[4] = {14, 15, 17, 18};

typedef struct proof {
  tp_hull *hull;
  const tp_surface *surface;
  tp_near near[3]; /* o */
  fmpz top[3];     /* o = top / bottom in whole numbers, bottom above 0 */
  fmpz bottom;
  fmpz exact[11]; /* room for three vectors, a sum and a term of it */
  bool has_words;
  int64_t word_top[3]; /* o times HULL_WEIGHT where coordinates fit into words */
} proof;

/* A vector from o: to a vertex, or the sum of those to the corners of a triangle. */
typedef struct aim {
  double at[3];
  const int *vertices;
  int count;
} aim;

void tp_hull_clear(tp_hull *hull) {
  free(hull->corners);
  free(hull->across);
  free(hull->level);
  memset(hull, 0, sizeof *hull);
}

const char *tp_hull_fault_text(tp_hull_fault fault) {
  switch (fault) {
  case TP_HULL_NO_POINT:
    return "a corner is no point of the mesh";
  case TP_HULL_OPEN:
    return "it is not closed";
  case TP_HULL_TURNED:
    return "a facet does not face outwards";
  case TP_HULL_DENTED:
    return "it is not convex at an edge";
  case TP_HULL_WOUND:
    return "it goes round more than once";
  case TP_HULL_BEYOND:
    return "a point of the mesh is outside it";
  default:
    return "it is proven";
  }
}

/* ---- signs -------------------------------------------------------------------------------------
 */

static const double bound_for_all = 0x1p-41;

static aim aim_at(const proof *p, const int *vertices, int count) {
  aim sum = {.vertices = vertices, .count = count};
  for (int n = 0; n < count; n++) {
    const double *at = p->surface->near + 3L * vertices[n];
    for (int k = 0; k < 3; k++) sum.at[k] += at[k] - p->near[k].value;
  }
  return sum;
}

/* The same with a bound for each. */
static void set_near(tp_near vector[3], const proof *p, const aim *to) {
  for (int k = 0; k < 3; k++) {
    vector[k] = (tp_near){0, 0};
    for (int n = 0; n < to->count; n++) {
      const tp_near at = tp_surface_near(p->surface, to->vertices[n], k);
      vector[k] = tp_near_add(vector[k], tp_near_sub(at, p->near[k]));
    }
  }
}

/* The same times a number above 0; of a triangle, vectors to its corners times such numbers. */
static void set_exact(fmpz *vector, const proof *p, const aim *to) {
  const fmpz *weights = p->surface->weights;
  for (int k = 0; k < 3; k++) fmpz_zero(vector + k);
  for (int n = 0; n < to->count; n++) {
    const long vertex = to->vertices[n];
    for (int k = 0; k < 3; k++) {
      fmpz_addmul(vector + k, &p->bottom, p->surface->whole + 3 * vertex + k);
      if (weights == NULL) {
        fmpz_sub(vector + k, vector + k, p->top + k);
      } else {
        fmpz_submul(vector + k, weights + vertex, p->top + k);
      }
    }
  }
}

/* HULL_WEIGHT times the same, of less than TP_TURN_WORD_BITS. */
static void set_words(int64_t vector[3], const proof *p, const aim *to) {
  for (int k = 0; k < 3; k++) {
    vector[k] = 0;
    for (int n = 0; n < to->count; n++) {
      const int64_t at = tp_word_get(p->surface->whole + 3L * to->vertices[n] + k);
      vector[k] += HULL_WEIGHT * at - p->word_top[k];
    }
  }
}

static int word_sign(const proof *p, const aim *a, const aim *b, const aim *c) {
  int64_t one[3], other[3], last[3];
  set_words(one, p, a);
  set_words(other, p, b);
  set_words(last, p, c);
  return tp_word_turn(one, other, last);
}

static int exact_sign(proof *p, const aim *a, const aim *b, const aim *c) {
  fmpz *one = p->exact, *other = p->exact + 3, *last = p->exact + 6, *sum = p->exact + 9;
  fmpz *turn = p->exact + 10;
  set_exact(one, p, a);
  set_exact(other, p, b);
  set_exact(last, p, c);
  fmpz_zero(sum);
  for (int k = 0; k < 3; k++) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    fmpz_mul(turn, one + i, other + j);
    fmpz_submul(turn, one + j, other + i);
    fmpz_addmul(sum, turn, last + k);
  }
  return fmpz_sgn(sum);
}

static int near_sign(const proof *p, const aim *a, const aim *b, const aim *c) {
  tp_near one[3], other[3], last[3], sum = {0, 0};
  set_near(one, p, a);
  set_near(other, p, b);
  set_near(last, p, c);
  for (int k = 0; k < 3; k++) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    const tp_near turn = tp_near_sub(tp_near_mul(one[i], other[j]), tp_near_mul(one[j], other[i]));
    sum = tp_near_add(sum, tp_near_mul(turn, last[k]));
  }
  return tp_near_sign(sum);
}

static double determinant(const double a[3], const double b[3], const double c[3]) {
  return (a[1] * b[2] - a[2] * b[1]) * c[0] + (a[2] * b[0] - a[0] * b[2]) * c[1] +
         (a[0] * b[1] - a[1] * b[0]) * c[2];
}

/* The sign of (a x b) . c: above 0 where c is on the inner side of the plane through o that a side
 * from a to b of a triangle spans. */
static int sign_of(proof *p, const aim *a, const aim *b, const aim *c) {
  const double value = determinant(a->at, b->at, c->at);
  if (fabs(value) > bound_for_all) return value > 0 ? 1 : -1;
  if (p->has_words) return word_sign(p, a, b, c);
  const int sign = near_sign(p, a, b, c);
  return sign != 0 ? sign : exact_sign(p, a, b, c);
}

/* tp_surface_side of a triangle of the hull: above 0 where the vertex is beyond its plane. */
static int plane_side(const proof *p, long triangle, int vertex) {
  const int *corners = p->hull->corners + 3 * triangle;
  const double *near = p->surface->near, *from = near + 3L * corners[0];
  double way[3][3];
  for (int k = 0; k < 3; k++) {
    way[0][k] = near[3L * corners[1] + k] - from[k];
    way[1][k] = near[3L * corners[2] + k] - from[k];
    way[2][k] = near[3L * vertex + k] - from[k];
  }
  const double value = determinant(way[0], way[1], way[2]);
  if (fabs(value) > bound_for_all) return value > 0 ? 1 : -1;
  return tp_surface_side(p->surface, corners, vertex);
}

static int side_sign(proof *p, long triangle, int side, const aim *c) {
  const int *corners = p->hull->corners + 3 * triangle;
  const aim a = aim_at(p, corners + side, 1), b = aim_at(p, corners + (side + 1) % 3, 1);
  return sign_of(p, &a, &b, c);
}

/* ---- a point within ----------------------------------------------------------------------------
 */

static double square(double x) {
  return x * x;
}

/* The square of the length, area or volume that a vertex adds to `count` points. */
static double spread(const tp_surface *s, const int *four, int count, long vertex) {
  double way[3][3], turn[3];
  for (int n = 0; n < count; n++) {
    const long to = n + 1 < count ? four[n + 1] : vertex;
    for (int k = 0; k < 3; k++) way[n][k] = s->near[3 * to + k] - s->near[3L * four[0] + k];
  }
  if (count == 1) return square(way[0][0]) + square(way[0][1]) + square(way[0][2]);
  for (int k = 0; k < 3; k++) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    turn[k] = way[0][i] * way[1][j] - way[0][j] * way[1][i];
  }
  if (count == 2) return square(turn[0]) + square(turn[1]) + square(turn[2]);
  return square(turn[0] * way[2][0] + turn[1] * way[2][1] + turn[2] * way[2][2]);
}

/* Does it certainly add one? */
static bool spans(const tp_surface *s, const int *four, int count, int vertex) {
  fmpz way[3];
  bool differs = false;
  if (count == 2) return !tp_surface_is_straight(s, four[0], four[1], vertex);
  if (count == 3) return tp_surface_side(s, four, vertex) != 0;
  for (int k = 0; k < 3; k++) fmpz_init(way + k);
  tp_surface_way(way, s, four[0], vertex);
  for (int k = 0; k < 3; k++) differs = differs || !fmpz_is_zero(way + k);
  for (int k = 0; k < 3; k++) fmpz_clear(way + k);
  return differs;
}

bool tp_hull_span(int four[4], const tp_surface *surface) {
  four[0] = 0;
  for (int count = 1; count < 4; count++) {
    int best = 0;
    double most = -1;
    for (int v = 0; v < surface->vertex_count; v++) {
      const double size = spread(surface, four, count, v);
      if (size > most) {
        most = size;
        best = v;
      }
    }
    for (int v = 0; v < surface->vertex_count && !spans(surface, four, count, best); v++) best = v;
    if (!spans(surface, four, count, best)) return false;
    four[count] = best;
  }
  return true;
}

/* A mean of four points p / w: with b the product of all w, the sum of p b / w by their weights
 * over HULL_WEIGHT b. */
static void set_centre(proof *p, const int four[4]) {
  const tp_surface *s = p->surface;
  fmpz_one(&p->bottom);
  for (int n = 0; n < 4 && s->weights != NULL; n++) {
    fmpz_mul(&p->bottom, &p->bottom, s->weights + four[n]);
  }
  fmpz_t factor;
  fmpz_init(factor);
  for (int n = 0; n < 4; n++) {
    fmpz_set(factor, &p->bottom);
    if (s->weights != NULL) fmpz_divexact(factor, factor, s->weights + four[n]);
    fmpz_mul_si(factor, factor, hull_weights[n]);
    for (int k = 0; k < 3; k++) fmpz_addmul(p->top + k, factor, s->whole + 3L * four[n] + k);
  }
  fmpz_clear(factor);
  fmpz_mul_ui(&p->bottom, &p->bottom, HULL_WEIGHT);
  for (int k = 0; k < 3; k++) {
    tp_near sum = {0, 0};
    for (int n = 0; n < 4; n++) {
      const tp_near part = {(double)hull_weights[n] / HULL_WEIGHT, 0};
      sum = tp_near_plus(sum, tp_near_mul(part, tp_surface_near(s, four[n], k)));
    }
    p->near[k] = sum;
  }
  p->has_words = tp_surface_has_words(s);
  for (int k = 0; k < 3 && p->has_words; k++) p->word_top[k] = tp_word_get(p->top + k);
}

/* ---- conditions --------------------------------------------------------------------------------
 */

static tp_hull_fault prove_corners(const proof *p) {
  for (long k = 0; k < 3 * p->hull->count; k++) {
    const int corner = p->hull->corners[k];
    if (corner < 0 || corner >= p->surface->vertex_count) return TP_HULL_NO_POINT;
  }
  return TP_HULL_PROVEN;
}

/* The side of a triangle from one vertex to another. */
static long side_from(const tp_hull *hull, int triangle, int from) {
  const int *corners = hull->corners + 3L * triangle;
  return 3L * triangle + (corners[0] == from ? 0 : corners[1] == from ? 1 : 2);
}

static tp_hull_fault prove_closed(proof *p) {
  tp_hull *hull = p->hull;
  tp_sides sides;
  if (!tp_sides_init(&sides, hull->corners, hull->count, p->surface->vertex_count)) {
    tp_sides_clear(&sides);
    return TP_HULL_NO_MEMORY;
  }
  bool closed = hull->count > 0;
  for (int v = 0; closed && v < p->surface->vertex_count; v++) {
    const long past = sides.starts[v + 1];
    for (long k = sides.starts[v]; closed && k < past; k += 2) {
      const tp_side *one = sides.items + k, *other = one + 1;
      closed = k + 1 < past && one->other == other->other && one->other != v &&
               one->is_ahead != other->is_ahead && (k + 2 >= past || other[1].other != one->other);
      if (!closed) break;
      hull->across[side_from(hull, one->triangle, one->is_ahead ? v : one->other)] =
          other->triangle;
      hull->across[side_from(hull, other->triangle, other->is_ahead ? v : other->other)] =
          one->triangle;
    }
  }
  tp_sides_clear(&sides);
  return closed ? TP_HULL_PROVEN : TP_HULL_OPEN;
}

static tp_hull_fault prove_outwards(proof *p) {
  for (long t = 0; t < p->hull->count; t++) {
    const aim last = aim_at(p, p->hull->corners + 3 * t + 2, 1);
    if (side_sign(p, t, 0, &last) <= 0) return TP_HULL_TURNED;
  }
  return TP_HULL_PROVEN;
}

/* Which side of a triangle is towards another. */
static int side_towards(const tp_hull *hull, long triangle, long other) {
  const int *across = hull->across + 3 * triangle;
  return across[0] == other ? 0 : across[1] == other ? 1 : 2;
}

static tp_hull_fault prove_convex(proof *p) {
  const tp_hull *hull = p->hull;
  for (long t = 0; t < hull->count; t++) {
    for (int c = 0; c < 3; c++) {
      const long other = hull->across[3 * t + c];
      if (other < t) continue;
      const int side = side_towards(hull, other, t);
      const int far_corner = hull->corners[3 * other + (side + 2) % 3];
      const int sign = plane_side(p, t, far_corner);
      if (sign > 0) return TP_HULL_DENTED;
      hull->level[3 * t + c] = hull->level[3 * other + side] = sign == 0;
    }
  }
  return TP_HULL_PROVEN;
}

static bool is_in_cone(proof *p, long triangle, const aim *to) {
  for (int c = 0; c < 3; c++) {
    if (side_sign(p, triangle, c, to) < 0) return false;
  }
  return true;
}

static tp_hull_fault prove_once(proof *p) {
  const aim ray = aim_at(p, p->hull->corners, 3);
  for (long t = 1; t < p->hull->count; t++) {
    if (is_in_cone(p, t, &ray)) return TP_HULL_WOUND;
  }
  return TP_HULL_PROVEN;
}

/* The triangle whose cone has a point, from `start` on; below 0: none. */
static long locate(proof *p, const aim *to, long start) {
  const tp_hull *hull = p->hull;
  const long most_steps = 64 + 8 * (long)sqrt((double)hull->count);
  long at = start, before = -1;
  for (long step = 0; step < most_steps; step++) {
    int beyond = -1;
    for (int n = 0; n < 3 && beyond < 0; n++) {
      const int c = (int)((step + n) % 3); /* from another side each time: no walk runs in a ring */
      if (hull->across[3 * at + c] != before && side_sign(p, at, c, to) < 0) beyond = c;
    }
    if (beyond < 0) return at;
    before = at;
    at = hull->across[3 * at + beyond];
  }
  for (long t = 0; t < hull->count; t++) {
    if (is_in_cone(p, t, to)) return t;
  }
  return -1;
}

enum { BINS = 8 }; /* of directions, along each edge of a cube around o */

/* The bin of a direction. */
static int bin_of(const double at[3]) {
  const double sizes[3] = {fabs(at[0]), fabs(at[1]), fabs(at[2])};
  const int axis = sizes[0] > sizes[1]   ? (sizes[0] > sizes[2] ? 0 : 2)
                   : sizes[1] > sizes[2] ? 1
                                         : 2;
  if (!(sizes[axis] > 0)) return 0;
  int bin = 2 * axis + (at[axis] > 0);
  for (int k = 1; k < 3; k++) {
    const int place = (int)((at[(axis + k) % 3] / sizes[axis] + 1) * (BINS / 2.0));
    bin = bin * BINS + (place < BINS ? place : BINS - 1);
  }
  return bin;
}

static tp_hull_fault prove_points(proof *p) {
  const tp_hull *hull = p->hull;
  int found_last[6 * BINS * BINS] = {0};
  bool *is_corner = calloc((size_t)p->surface->vertex_count, sizeof *is_corner);
  if (is_corner == NULL) return TP_HULL_NO_MEMORY;
  for (long k = 0; k < 3 * hull->count; k++) is_corner[hull->corners[k]] = true;
  tp_hull_fault fault = TP_HULL_PROVEN;
  for (int v = 0; fault == TP_HULL_PROVEN && v < p->surface->vertex_count; v++) {
    if (is_corner[v]) continue;
    const aim point = aim_at(p, &v, 1);
    int *last = found_last + bin_of(point.at);
    const long found = locate(p, &point, *last);
    if (found >= 0) *last = (int)found;
    if (found < 0 || plane_side(p, found, v) > 0) {
      fault = TP_HULL_BEYOND;
    }
  }
  free(is_corner);
  return fault;
}

static bool make_room(tp_hull *hull) {
  const size_t count = 3 * (size_t)hull->count + 1;
  hull->across = malloc(count * sizeof *hull->across);
  hull->level = calloc(count, sizeof *hull->level);
  return hull->across != NULL && hull->level != NULL;
}

tp_hull_fault tp_hull_prove(tp_hull *hull, const tp_surface *surface, const int four[4]) {
  proof p = {.hull = hull, .surface = surface};
  if (!make_room(hull)) return TP_HULL_NO_MEMORY;
  for (int k = 0; k < 3; k++) fmpz_init(p.top + k);
  for (int k = 0; k < 11; k++) fmpz_init(p.exact + k);
  fmpz_init(&p.bottom);
  set_centre(&p, four);
  tp_hull_fault fault = prove_corners(&p);
  if (fault == TP_HULL_PROVEN) fault = prove_closed(&p);
  if (fault == TP_HULL_PROVEN) fault = prove_outwards(&p);
  if (fault == TP_HULL_PROVEN) fault = prove_convex(&p);
  if (fault == TP_HULL_PROVEN) fault = prove_once(&p);
  if (fault == TP_HULL_PROVEN) fault = prove_points(&p);
  for (int k = 0; k < 3; k++) fmpz_clear(p.top + k);
  for (int k = 0; k < 11; k++) fmpz_clear(p.exact + k);
  fmpz_clear(&p.bottom);
  return fault;
}
