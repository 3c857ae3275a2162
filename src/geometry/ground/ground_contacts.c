/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Pairs of triangles whose boxes are within the band are looked at once for each corner and edge
 * that is the first triangle's; doubles with bounds leave most of them out. With the plane through
 * a with the normal n, a point p has h = n . (p - a), is h / |n| over it with the foot
 * p - n h / n^2, and lies over the triangle where it turns left, seen along n, about all sides.
 * Lines p + s u of the rock and q + t v of the ground have, with c = u x v and w = q - p, the
 * common perpendicular from s = (w x v) . c / c^2 to t = (w x u) . c / c^2. */

#include "ground/ground_contacts.h"

#include "common/grow.h"

#include <stdlib.h>

enum { VECTORS = 8, NUMBERS = 4 };

typedef struct finder {
  tp_ground_contacts *contacts;
  const tp_relief *rock, *ground;
  fmpz_t band_top, band_bottom; /* squares of the band's */
  double near_band;             /* a little more than it, as the surfaces' doubles */
  tp_whole v[VECTORS];
  fmpz n[NUMBERS];
} finder;

static double distance(const finder *f, const fmpz_t height, const fmpz_t square) {
  slong top = 0, bottom = 0;
  const double h = fmpz_get_d_2exp(&top, height), s = fmpz_get_d_2exp(&bottom, square);
  const slong odd = bottom % 2;
  return ldexp(h / sqrt(ldexp(s, (int)odd)),
               (int)(top - (bottom - odd) / 2 - f->rock->surface.exponent));
}

/* |height| / |normal| <= band? */
static bool is_within(const finder *f, const fmpz_t height, const fmpz_t square) {
  fmpz_t one, other;
  fmpz_init(one);
  fmpz_init(other);
  fmpz_mul(one, height, height);
  fmpz_mul(one, one, f->band_bottom);
  fmpz_mul(other, square, f->band_top);
  const bool within = fmpz_cmp(one, other) <= 0;
  fmpz_clear(one);
  fmpz_clear(other);
  return within;
}

/* ---- a contact ---------------------------------------------------------------------------------
 */

static void make_primitive(tp_whole *normal) {
  fmpz_t common;
  fmpz_init(common);
  fmpz_gcd(common, normal->at, normal->at + 1);
  fmpz_gcd(common, common, normal->at + 2);
  for (int k = 0; k < 3; k++) fmpz_divexact(normal->at + k, normal->at + k, common);
  fmpz_clear(common);
}

/* At point + way top / bottom. */
static bool add(finder *f, const fmpz *point, const tp_whole *way, const fmpz_t top,
                const fmpz_t bottom, const tp_whole *normal, double gap) {
  tp_ground_contact *own = tp_ground_contacts_next(f->contacts);
  if (own == NULL) return false;
  for (int k = 0; k < 3; k++) {
    fmpz_set(own->normal.at + k, normal->at + k);
    fmpz_mul(fmpq_numref(own->at + k), way->at + k, top);
    fmpz_addmul(fmpq_numref(own->at + k), point + k, bottom);
    fmpz_set(fmpq_denref(own->at + k), bottom);
    fmpq_canonicalise(own->at + k);
  }
  make_primitive(&own->normal);
  own->gap = gap;
  return true;
}

/* ---- a corner and a face -----------------------------------------------------------------------
 */

static tp_near way_of(const tp_relief *r, int vertex, int axis, const tp_relief *of, int from) {
  return tp_near_sub(tp_surface_near(&r->surface, vertex, axis),
                     tp_surface_near(&of->surface, from, axis));
}

/* By doubles: certainly farther from the plane than the band. */
static bool is_far(const finder *f, const tp_relief *r, int vertex, const tp_relief *of,
                   long triangle) {
  const int *t = of->surface.triangles + 3 * triangle;
  tp_near a[3], b[3], c[3], height = {0, 0}, square = {0, 0};
  for (int k = 0; k < 3; k++) {
    a[k] = way_of(r, vertex, k, of, t[0]);
    b[k] = way_of(of, t[1], k, of, t[0]);
    c[k] = way_of(of, t[2], k, of, t[0]);
  }
  for (int k = 0; k < 3; k++) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    const tp_near n = tp_near_sub(tp_near_mul(b[i], c[j]), tp_near_mul(b[j], c[i]));
    height = tp_near_add(height, tp_near_mul(n, a[k]));
    square = tp_near_add(square, tp_near_mul(n, n));
  }
  const double least = fabs(height.value) - height.error;
  return least > 0 &&
         least * least > (square.value + square.error) * f->near_band * f->near_band * (1 + 1e-14);
}

/* Is it over the triangle, seen along its normal v[0]? */
static bool is_over(finder *f, const fmpz *point, const tp_relief *of, long triangle) {
  const int *t = of->surface.triangles + 3 * triangle;
  for (int k = 0; k < 3; k++) {
    const fmpz *from = tp_relief_point(of, t[k]);
    tp_whole_sub(f->v + 2, tp_relief_point(of, t[(k + 1) % 3]), from);
    tp_whole_sub(f->v + 3, point, from);
    tp_whole_cross(f->v + 4, f->v + 2, f->v + 3);
    tp_whole_dot(f->n + 2, f->v + 4, f->v);
    if (fmpz_sgn(f->n + 2) < 0) return false;
  }
  return true;
}

/* With the normal in v[0], the height in n[0] and the normal's square in n[1]. */
static bool is_near_face(finder *f, const tp_relief *r, int vertex, const tp_relief *of,
                         long triangle) {
  if (is_far(f, r, vertex, of, triangle)) return false;
  const fmpz *point = tp_relief_point(r, vertex);
  tp_relief_normal(f->v, of, triangle);
  tp_whole_sub(f->v + 1, point, tp_relief_point(of, of->surface.triangles[3 * triangle]));
  tp_whole_dot(f->n, f->v, f->v + 1);
  tp_whole_dot(f->n + 1, f->v, f->v);
  return is_within(f, f->n, f->n + 1) && is_over(f, point, of, triangle);
}

/* Does a face of the rock at the corner look against the normal v[0]? */
static bool is_facing(finder *f, int vertex) {
  const tp_relief *r = f->rock;
  for (long k = r->starts[vertex]; k < r->starts[vertex + 1]; k++) {
    tp_relief_normal(f->v + 2, r, r->at[k]);
    tp_whole_dot(f->n + 2, f->v, f->v + 2);
    if (fmpz_sgn(f->n + 2) < 0) return true;
  }
  return false;
}

/* Does an edge from a corner of the rock lead deeper behind a face of the ground, the normal v[0],
 * than the band? */
static bool leads_behind(finder *f, int vertex, int along, long face) {
  const int end = tp_relief_end(f->rock, vertex, along);
  const int *corners = f->ground->surface.triangles + 3 * face;
  tp_whole_sub(f->v + 1, tp_relief_point(f->rock, end), tp_relief_point(f->ground, corners[0]));
  tp_whole_dot(f->n + 2, f->v, f->v + 1);
  return fmpz_sgn(f->n + 2) < 0 && !is_within(f, f->n + 2, f->n + 1);
}

static bool any_leads_behind(finder *f, int vertex, long face) {
  const tp_relief *r = f->rock;
  for (long k = 3 * r->starts[vertex]; k < 3 * r->starts[vertex + 1]; k++) {
    const tp_relief_edge *e = r->edges + r->edge_of[3L * r->at[k / 3] + k % 3];
    if (!e->is_edge || (e->from != vertex && e->to != vertex)) continue;
    if (leads_behind(f, vertex, e->from == vertex ? e->to : e->from, face)) return true;
  }
  return false;
}

static bool rock_corner(finder *f, int vertex, long face) {
  if (!is_near_face(f, f->rock, vertex, f->ground, face)) return true;
  if (!is_facing(f, vertex) || any_leads_behind(f, vertex, face)) return true;
  fmpz_neg(f->n + 2, f->n);
  return add(f, tp_relief_point(f->rock, vertex), f->v, f->n + 2, f->n + 1, f->v,
             distance(f, f->n, f->n + 1));
}

/* Is all of the ground about its corner in front of no plane through it across v[0], which looks
 * out of the rock? */
static bool stands_out(finder *f, int vertex) {
  const tp_relief *r = f->ground;
  for (long k = r->starts[vertex]; k < r->starts[vertex + 1]; k++) {
    for (int c = 0; c < 3; c++) {
      const int other = r->surface.triangles[3L * r->at[k] + c];
      tp_whole_sub(f->v + 2, tp_relief_point(r, other), tp_relief_point(r, vertex));
      tp_whole_dot(f->n + 2, f->v, f->v + 2);
      if (fmpz_sgn(f->n + 2) < 0) return false;
    }
  }
  return true;
}

static bool ground_corner(finder *f, int vertex, long face) {
  if (!is_near_face(f, f->ground, vertex, f->rock, face) || !stands_out(f, vertex)) return true;
  const double gap = distance(f, f->n, f->n + 1);
  tp_whole_neg(f->v);
  fmpz_zero(f->n);
  return add(f, tp_relief_point(f->ground, vertex), f->v, f->n, f->n + 1, f->v, gap);
}

/* ---- two edges ---------------------------------------------------------------------------------
 */

/* By doubles: boxes about both certainly farther apart than the band. */
static bool are_far(const finder *f, const tp_relief_edge *e, const tp_relief_edge *g) {
  for (int k = 0; k < 3; k++) {
    const double *a = f->rock->surface.near, *b = f->ground->surface.near;
    const double p = a[3L * e->from + k], q = a[3L * e->to + k];
    const double r = b[3L * g->from + k], s = b[3L * g->to + k];
    const double apart = fmax(fmin(p, q) - fmax(r, s), fmin(r, s) - fmax(p, q));
    if (apart > f->near_band + 4 * DBL_EPSILON) return true;
  }
  return false;
}

/* Do the triangles at an edge of a relief lie, by `way`, before (1) or behind (-1) the plane
 * through it across the normal `c`? Those along it do either. */
static bool lie(finder *f, const tp_relief *r, const tp_relief_edge *e, const tp_whole *c,
                int way) {
  for (int k = 0; k < 2 && e->triangles[k] >= 0; k++) {
    tp_whole_sub(f->v + 7, tp_relief_point(r, e->opposite[k]), tp_relief_point(r, e->from));
    tp_whole_dot(f->n + 3, c, f->v + 7);
    if (fmpz_sgn(f->n + 3) * way < 0) return false;
  }
  return true;
}

/* The normal out of the ground, v[3] or what is against it: 1 or -1; 0 where they do not stand out
 * against each other. */
static int way_out(finder *f, const tp_relief_edge *e, const tp_relief_edge *g) {
  const bool ahead = lie(f, f->rock, e, f->v + 3, 1) && lie(f, f->ground, g, f->v + 3, -1);
  const bool back = lie(f, f->rock, e, f->v + 3, -1) && lie(f, f->ground, g, f->v + 3, 1);
  return (int)ahead - (int)back;
}

/* 0 <= (w x u) . c <= c^2, with u in v[which]: into n[number]. */
static bool is_on(finder *f, int which, int number) {
  tp_whole_cross(f->v + 5, f->v + 2, f->v + which);
  tp_whole_dot(f->n + number, f->v + 5, f->v + 3);
  return fmpz_sgn(f->n + number) >= 0 && fmpz_cmp(f->n + number, f->n) <= 0;
}

/* u in v[0], v in v[1], w in v[2], c in v[3], c^2 in n[0], t in n[2]. */
static bool edges(finder *f, const tp_relief_edge *e, const tp_relief_edge *g) {
  if (are_far(f, e, g)) return true;
  const fmpz *p = tp_relief_point(f->rock, e->from), *q = tp_relief_point(f->ground, g->from);
  tp_whole_sub(f->v, tp_relief_point(f->rock, e->to), p);
  tp_whole_sub(f->v + 1, tp_relief_point(f->ground, g->to), q);
  tp_whole_sub(f->v + 2, q, p);
  tp_whole_cross(f->v + 3, f->v, f->v + 1);
  if (tp_whole_is_zero(f->v + 3)) return true;
  tp_whole_dot(f->n, f->v + 3, f->v + 3);
  tp_whole_dot(f->n + 1, f->v + 2, f->v + 3); /* from the rock to the ground along c */
  if (!is_within(f, f->n + 1, f->n) || !is_on(f, 1, 2) || !is_on(f, 0, 2)) return true;
  const int way = way_out(f, e, g);
  if (way == 0) return true;
  const double gap = -way * distance(f, f->n + 1, f->n);
  if (way < 0) tp_whole_neg(f->v + 3);
  return add(f, q, f->v + 1, f->n + 2, f->n, f->v + 3, gap);
}

/* ---- a pair of triangles -----------------------------------------------------------------------
 */

static bool is_first(const tp_relief *r, int vertex, long triangle) {
  return r->is_corner[vertex] && r->at[r->starts[vertex]] == triangle;
}

static const tp_relief_edge *edge_at(const tp_relief *r, long triangle, int side) {
  const tp_relief_edge *own = r->edges + r->edge_of[3 * triangle + side];
  return own->is_edge && own->triangles[0] == triangle ? own : NULL;
}

static bool look(void *of, long rock, long ground) {
  finder *f = of;
  const int *a = f->rock->surface.triangles + 3 * rock;
  const int *b = f->ground->surface.triangles + 3 * ground;
  bool done = true;
  for (int k = 0; k < 3; k++) {
    if (is_first(f->rock, a[k], rock)) done = done && rock_corner(f, a[k], ground);
    if (is_first(f->ground, b[k], ground)) done = done && ground_corner(f, b[k], rock);
  }
  for (int k = 0; k < 9 && done; k++) {
    const tp_relief_edge *e = edge_at(f->rock, rock, k / 3);
    const tp_relief_edge *g = edge_at(f->ground, ground, k % 3);
    if (e != NULL && g != NULL) done = edges(f, e, g);
  }
  return done;
}

/* ---- all ---------------------------------------------------------------------------------------
 */

tp_ground_contact *tp_ground_contacts_next(tp_ground_contacts *c) {
  tp_ground_contact *items = tp_grow(c->items, c->count, &c->room, sizeof *c->items);
  if (items == NULL) return NULL;
  c->items = items;
  tp_ground_contact *own = items + c->count++;
  tp_whole_init(&own->normal);
  for (int k = 0; k < 3; k++) fmpq_init(own->at + k);
  return own;
}

void tp_ground_contacts_clear(tp_ground_contacts *c) {
  for (long k = 0; k < c->count; k++) {
    tp_whole_clear(&c->items[k].normal);
    for (int axis = 0; axis < 3; axis++) fmpq_clear(c->items[k].at + axis);
  }
  free(c->items);
  *c = (tp_ground_contacts){0};
}

static void set_near_band(finder *f, const fmpq_t band) {
  fmpq_t near;
  fmpq_init(near);
  fmpq_set(near, band);
  fmpq_div_2exp(near, near, (ulong)f->rock->surface.exponent);
  f->near_band = tp_surface_nearest(near) * (1 + 4 * DBL_EPSILON) + DBL_MIN;
  fmpq_clear(near);
}

bool tp_ground_contacts_find(tp_ground_contacts *contacts, const tp_relief *rock,
                             const tp_relief *ground, const fmpq_t band) {
  finder f = {.contacts = contacts, .rock = rock, .ground = ground};
  *contacts = (tp_ground_contacts){0};
  fmpz_init(f.band_top);
  fmpz_init(f.band_bottom);
  fmpz_mul(f.band_top, fmpq_numref(band), fmpq_numref(band));
  fmpz_mul(f.band_bottom, fmpq_denref(band), fmpq_denref(band));
  set_near_band(&f, band);
  for (int k = 0; k < VECTORS; k++) tp_whole_init(f.v + k);
  for (int k = 0; k < NUMBERS; k++) fmpz_init(f.n + k);
  bool done = tp_triangle_tree_pairs(&rock->tree, &ground->tree, f.near_band, look, &f);
  for (int k = 0; k < VECTORS; k++) tp_whole_clear(f.v + k);
  for (int k = 0; k < NUMBERS; k++) fmpz_clear(f.n + k);
  fmpz_clear(f.band_top);
  fmpz_clear(f.band_bottom);
  contacts->found = contacts->count;
  done = done && tp_ground_contacts_reduce(contacts);
  return done;
}
