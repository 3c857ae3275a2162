/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Pairs of triangles whose boxes meet; then a flood over edges that meet no triangle of the other
 * surface. */

#include "ground/depth.h"

#include <stdlib.h>
#include <string.h>

/* One of both surfaces, of which some lies beyond the other. */
typedef struct half {
  const tp_relief *relief;
  bool *is_blocked; /* of each edge: it meets the other surface, */
  int *enters;      /* and so often more enters it than it leaves it */
  bool *is_beyond;  /* of each vertex */
  int *waiting;     /* vertices whose edges were not looked at yet */
  long waiting_count;
} half;

typedef struct search {
  half halves[2]; /* the rock, the ground */
  tp_ground_depth *depth;
  tp_whole ways[7]; /* corners from the rock's first, then an axis */
  tp_whole sides[2];
  fmpz n[6];
} search;

/* ---- triangles that cross ----------------------------------------------------------------------
 */

static bool is_parted(int signs[3], const tp_relief *r, long triangle, const tp_relief *other,
                      long of) {
  int before = 0, behind = 0;
  for (int k = 0; k < 3; k++) {
    signs[k] = tp_relief_side(r, triangle, other, other->surface.triangles[3 * of + k]);
    before += signs[k] > 0;
    behind += signs[k] < 0;
  }
  return before == 0 || behind == 0;
}

/* How far they overlap along the axis ways[6], times its length, into n[0]. */
static void overlap(search *s) {
  fmpz *low = s->n + 1, *high = s->n + 3; /* of both */
  for (int k = 0; k < 6; k++) {
    tp_whole_dot(s->n + 5, s->ways + k, s->ways + 6);
    const int of = k / 3;
    if (k % 3 == 0 || fmpz_cmp(s->n + 5, low + of) < 0) fmpz_set(low + of, s->n + 5);
    if (k % 3 == 0 || fmpz_cmp(s->n + 5, high + of) > 0) fmpz_set(high + of, s->n + 5);
  }
  fmpz_sub(s->n, high, low + 1);
  fmpz_sub(s->n + 5, high + 1, low);
  if (fmpz_cmp(s->n + 5, s->n) < 0) fmpz_set(s->n, s->n + 5);
}

/* Along the axis of a number: across either triangle, or across a side of each; zeros: none. */
static void set_axis(search *s, int number) {
  const tp_whole *rock = s->ways, *ground = s->ways + 3;
  const tp_whole *one = number == 1 ? ground : rock, *other = number == 0 ? rock : ground;
  const int a = number < 2 ? 0 : (number - 2) / 3, b = number < 2 ? 1 : (number - 2) % 3;
  tp_whole_sub(s->sides, one[(a + 1) % 3].at, one[a].at);
  tp_whole_sub(s->sides + 1, other[(b + 1) % 3].at, other[b].at);
  tp_whole_cross(s->ways + 6, s->sides, s->sides + 1);
}

static double over_length(search *s) {
  slong top = 0, bottom = 0;
  tp_whole_dot(s->n + 5, s->ways + 6, s->ways + 6);
  const double h = fmpz_get_d_2exp(&top, s->n), q = fmpz_get_d_2exp(&bottom, s->n + 5);
  const slong odd = bottom % 2;
  return ldexp(h / sqrt(ldexp(q, (int)odd)),
               (int)(top - (bottom - odd) / 2 - s->halves[0].relief->surface.exponent));
}

static void cross_depth(search *s, long rock, long ground) {
  const tp_relief *r = s->halves[0].relief, *g = s->halves[1].relief;
  const int *a = r->surface.triangles + 3 * rock, *b = g->surface.triangles + 3 * ground;
  for (int k = 0; k < 3; k++) {
    tp_whole_sub(s->ways + k, tp_relief_point(r, a[k]), tp_relief_point(r, a[0]));
    tp_whole_sub(s->ways + 3 + k, tp_relief_point(g, b[k]), tp_relief_point(r, a[0]));
  }
  double least = INFINITY;
  for (int k = 0; k < 11; k++) {
    set_axis(s, k);
    if (tp_whole_is_zero(s->ways + 6)) continue;
    overlap(s);
    if (fmpz_sgn(s->n) <= 0) return;
    least = fmin(least, over_length(s));
  }
  if (least > s->depth->most) *s->depth = (tp_ground_depth){least, rock, ground};
}

/* ---- edges that meet the other surface ---------------------------------------------------------
 */

/* The sign of the volume of four corners. */
static int volume(search *s, const fmpz *p, const fmpz *q, const fmpz *a, const fmpz *b) {
  tp_whole *v = s->ways;
  tp_whole_sub(v, q, p);
  tp_whole_sub(v + 1, a, p);
  tp_whole_sub(v + 2, b, p);
  tp_whole_cross(v + 3, v, v + 1);
  tp_whole_dot(s->n, v + 3, v + 2);
  return fmpz_sgn(s->n);
}

/* How the line through both ends passes a triangle: -1 beside it; 0 within; else by a corner or a
 * side of it, whose sides are bits. */
static int passes(search *s, const tp_relief *r, const tp_relief_edge *e, const tp_relief *other,
                  long triangle) {
  const int *t = other->surface.triangles + 3 * triangle;
  int before = 0, behind = 0, sides = 0;
  for (int k = 0; k < 3; k++) {
    const int sign = volume(s, tp_relief_point(r, e->from), tp_relief_point(r, e->to),
                            tp_relief_point(other, t[k]), tp_relief_point(other, t[(k + 1) % 3]));
    before += sign > 0;
    behind += sign < 0;
    if (sign == 0) sides |= 1 << k;
  }
  return before > 0 && behind > 0 ? -1 : sides;
}

/* Is one end not behind a triangle, and the other behind it? */
static bool goes_in(const tp_relief *other, long triangle, const tp_relief *r, int from, int to) {
  return tp_relief_side(other, triangle, r, from) >= 0 &&
         tp_relief_side(other, triangle, r, to) < 0;
}

/* Does its surface end at a vertex? */
static bool is_rim(const tp_relief *r, int vertex) {
  for (long k = 3 * r->starts[vertex]; k < 3 * r->starts[vertex + 1]; k++) {
    const tp_relief_edge *e = r->edges + r->edge_of[3L * r->at[k / 3] + k % 3];
    if (e->triangles[1] < 0 && (e->from == vertex || e->to == vertex)) return true;
  }
  return false;
}

/* From front to back where it passes a triangle, or for all triangles where that is by a side or a
 * corner, which is told at the first of them; by the rim it does not. */
static bool goes_in_by(const tp_relief *other, long triangle, int sides, const tp_relief *r,
                       int from, int to) {
  const int *t = other->surface.triangles + 3 * triangle;
  if (sides == 0) return goes_in(other, triangle, r, from, to);
  for (int k = 0; k < 3; k++) {
    const tp_relief_edge *own = other->edges + other->edge_of[3 * triangle + k];
    if (sides != 1 << k) continue;
    return own->triangles[0] == triangle && own->triangles[1] >= 0 &&
           goes_in(other, triangle, r, from, to) && goes_in(other, own->triangles[1], r, from, to);
  }
  for (int k = 0; k < 3; k++) {
    const int vertex = t[(k + 1) % 3];
    if (sides != (1 << k | 1 << (k + 1) % 3)) continue;
    if (other->at[other->starts[vertex]] != triangle || is_rim(other, vertex)) return false;
    for (long n = other->starts[vertex]; n < other->starts[vertex + 1]; n++) {
      if (!goes_in(other, other->at[n], r, from, to)) return false;
    }
    return true;
  }
  return false;
}

static void put(half *h, int vertex) {
  if (h->is_beyond[vertex]) return;
  h->is_beyond[vertex] = true;
  h->waiting[h->waiting_count++] = vertex;
}

/* The sides that are of this triangle first; signs are those of its corners. */
static void meet(search *s, int own, long triangle, long other, const int signs[3]) {
  half *h = s->halves + own;
  const tp_relief *r = h->relief, *of = s->halves[1 - own].relief;
  for (int k = 0; k < 3; k++) {
    const int number = r->edge_of[3 * triangle + k];
    const tp_relief_edge *e = r->edges + number;
    const int a = signs[k], b = signs[(k + 1) % 3];
    if (e->triangles[0] != triangle || a * b > 0) continue;
    const int sides = passes(s, r, e, of, other);
    if (sides < 0) continue;
    h->is_blocked[number] = true;
    h->enters[number] += goes_in_by(of, other, sides, r, e->from, e->to);
    h->enters[number] -= goes_in_by(of, other, sides, r, e->to, e->from);
  }
}

static bool look(void *of, long rock, long ground) {
  search *s = of;
  const tp_relief *r = s->halves[0].relief, *g = s->halves[1].relief;
  int rock_signs[3], ground_signs[3];
  const bool rock_parted = is_parted(rock_signs, g, ground, r, rock);
  const bool ground_parted = is_parted(ground_signs, r, rock, g, ground);
  meet(s, 0, rock, ground, rock_signs);
  meet(s, 1, ground, rock, ground_signs);
  if (!rock_parted && !ground_parted) cross_depth(s, rock, ground);
  return true;
}

/* ---- corners beyond ----------------------------------------------------------------------------
 */

static void spread(half *h, int vertex) {
  const tp_relief *r = h->relief;
  for (long k = r->starts[vertex]; k < r->starts[vertex + 1]; k++) {
    for (int c = 0; c < 3; c++) {
      const int number = r->edge_of[3L * r->at[k] + c];
      const tp_relief_edge *e = r->edges + number;
      if (h->is_blocked[number] || (e->from != vertex && e->to != vertex)) continue;
      put(h, e->from == vertex ? e->to : e->from);
    }
  }
}

static void measure(search *s, int own, int vertex) {
  const tp_relief *r = s->halves[own].relief, *other = s->halves[1 - own].relief;
  long triangle = 0;
  const double depth =
      tp_triangle_tree_point(&triangle, &other->tree, r->surface.near + 3L * vertex);
  if (depth <= s->depth->most) return;
  const long first = r->at[r->starts[vertex]];
  *s->depth = (tp_ground_depth){depth, own == 0 ? first : triangle, own == 0 ? triangle : first};
}

/* An end is beyond where an edge enters once more than it leaves. */
static void flood(search *s, int own) {
  half *h = s->halves + own;
  for (long k = 0; k < h->relief->edge_count; k++) {
    const tp_relief_edge *e = h->relief->edges + k;
    if (h->enters[k] != 0) put(h, h->enters[k] > 0 ? e->to : e->from);
  }
  while (h->waiting_count > 0) spread(h, h->waiting[--h->waiting_count]);
  for (int v = 0; v < h->relief->surface.vertex_count; v++) {
    if (h->is_beyond[v]) measure(s, own, v);
  }
}

static bool half_init(half *h, const tp_relief *relief) {
  const size_t vertices = (size_t)relief->surface.vertex_count;
  h->relief = relief;
  h->is_blocked = calloc((size_t)relief->edge_count, sizeof *h->is_blocked);
  h->enters = calloc((size_t)relief->edge_count, sizeof *h->enters);
  h->is_beyond = calloc(vertices, sizeof *h->is_beyond);
  h->waiting = malloc(vertices * sizeof *h->waiting);
  return h->is_blocked != NULL && h->enters != NULL && h->is_beyond != NULL && h->waiting != NULL;
}

static void half_clear(half *h) {
  free(h->is_blocked);
  free(h->enters);
  free(h->is_beyond);
  free(h->waiting);
}

bool tp_ground_depth_find(tp_ground_depth *depth, const tp_relief *rock, const tp_relief *ground) {
  search s = {.depth = depth};
  *depth = (tp_ground_depth){.most = 0};
  for (int k = 0; k < 7; k++) tp_whole_init(s.ways + k);
  for (int k = 0; k < 2; k++) tp_whole_init(s.sides + k);
  for (int k = 0; k < 6; k++) fmpz_init(s.n + k);
  const bool rock_done = half_init(s.halves, rock);
  const bool done = half_init(s.halves + 1, ground) && rock_done &&
                    tp_triangle_tree_pairs(&rock->tree, &ground->tree, 0, look, &s);
  for (int k = 0; k < 2 && done; k++) flood(&s, k);
  for (int k = 0; k < 7; k++) tp_whole_clear(s.ways + k);
  for (int k = 0; k < 2; k++) tp_whole_clear(s.sides + k);
  for (int k = 0; k < 6; k++) fmpz_clear(s.n + k);
  half_clear(s.halves);
  half_clear(s.halves + 1);
  return done;
}
