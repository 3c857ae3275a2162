/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Sums of the least-squares line over the facets in whole numbers, along x and y; they are turned
 * into the line between the ends once, at the end. Fractions are brought to one denominator. */

#include "base/mean_plane.h"

/* A point from the first end of the contact. */
typedef struct whole_point {
  fmpz_t x, y;
} whole_point;

static void point_init(whole_point *p) {
  fmpz_init(p->x);
  fmpz_init(p->y);
}

static void point_clear(whole_point *p) {
  fmpz_clear(p->x);
  fmpz_clear(p->y);
}

/* Over the facets, w = |da| times the distance between the ends: of w, w (x0 + x1),
 * 2 w (x0^2 + x0 x1 + x1^2), w (2 x0 y0 + x0 y1 + x1 y0 + 2 x1 y1) and the like. */
typedef struct sums {
  whole_point along; /* the line between the ends */
  fmpz_t w, x, y, xx, xy, yy;
  fmpz_t own, both_x, both_y, part; /* room for one facet */
} sums;

static void sums_init(sums *s) {
  fmpz *const all[] = {s->w,  s->x,   s->y,      s->xx,     s->xy,
                       s->yy, s->own, s->both_x, s->both_y, s->part};
  point_init(&s->along);
  for (size_t k = 0; k < sizeof all / sizeof all[0]; k++) fmpz_init(all[k]);
}

static void sums_clear(sums *s) {
  fmpz *const all[] = {s->w,  s->x,   s->y,      s->xx,     s->xy,
                       s->yy, s->own, s->both_x, s->both_y, s->part};
  point_clear(&s->along);
  for (size_t k = 0; k < sizeof all / sizeof all[0]; k++) fmpz_clear(all[k]);
}

/* sum += w (both both' + f0 g0 + f1 g1) */
static void add_square(fmpz_t sum, sums *s, const fmpz_t both, const fmpz_t both_other,
                       const fmpz_t f0, const fmpz_t g0, const fmpz_t f1, const fmpz_t g1) {
  fmpz_mul(s->part, both, both_other);
  fmpz_addmul(s->part, f0, g0);
  fmpz_addmul(s->part, f1, g1);
  fmpz_addmul(sum, s->own, s->part);
}

static void add_facet(sums *s, const whole_point *p, const whole_point *q) {
  fmpz_sub(s->both_x, q->x, p->x);
  fmpz_sub(s->both_y, q->y, p->y);
  fmpz_mul(s->own, s->along.x, s->both_x);
  fmpz_addmul(s->own, s->along.y, s->both_y);
  fmpz_abs(s->own, s->own);
  fmpz_add(s->w, s->w, s->own);
  fmpz_add(s->both_x, p->x, q->x);
  fmpz_add(s->both_y, p->y, q->y);
  fmpz_addmul(s->x, s->own, s->both_x);
  fmpz_addmul(s->y, s->own, s->both_y);
  add_square(s->xx, s, s->both_x, s->both_x, p->x, p->x, q->x, q->x);
  add_square(s->xy, s, s->both_x, s->both_y, p->x, p->y, q->x, q->y);
  add_square(s->yy, s, s->both_y, s->both_y, p->y, p->y, q->y, q->y);
}

/* rest = 2 f L - 3 g h, which with 6 S_ab or 6 S_aa, 2 S_a and 2 S_b is 12 L times a term of m. */
static void about_mean(fmpz_t rest, const fmpz_t f, const fmpz_t length, const fmpz_t g,
                       const fmpz_t h) {
  fmpz_t three;
  fmpz_init(three);
  fmpz_mul(three, g, h);
  fmpz_mul_ui(three, three, 3);
  fmpz_mul(rest, f, length);
  fmpz_mul_2exp(rest, rest, 1);
  fmpz_sub(rest, rest, three);
  fmpz_clear(three);
}

/* a = u x + v y, b = u y - v x, times the distance between the ends. */
static void turn_into_line(fmpz_t a, fmpz_t b, fmpz_t aa, fmpz_t ab, const sums *s) {
  const fmpz *u = s->along.x, *v = s->along.y;
  fmpz_t uu, uv, vv, apart;
  fmpz_init(uu);
  fmpz_init(uv);
  fmpz_init(vv);
  fmpz_init(apart);
  fmpz_fmma(a, u, s->x, v, s->y);
  fmpz_fmms(b, u, s->y, v, s->x);
  fmpz_mul(uu, u, u);
  fmpz_mul(uv, u, v);
  fmpz_mul(vv, v, v);
  fmpz_fmma(aa, uu, s->xx, vv, s->yy);
  fmpz_mul(apart, uv, s->xy);
  fmpz_addmul_ui(aa, apart, 2);
  fmpz_sub(uu, uu, vv);
  fmpz_sub(apart, s->yy, s->xx);
  fmpz_fmma(ab, uu, s->xy, uv, apart);
  fmpz_clear(uu);
  fmpz_clear(uv);
  fmpz_clear(vv);
  fmpz_clear(apart);
}

/* False where the ends are one point, which has no direction. */
static bool find_direction(fmpq_t u, fmpq_t v, const sums *s) {
  if (fmpz_is_zero(s->along.x) && fmpz_is_zero(s->along.y)) return false;
  fmpq_t slope, rise;
  fmpz_t a, b, aa, ab;
  fmpq_init(slope);
  fmpq_init(rise);
  fmpz_init(a);
  fmpz_init(b);
  fmpz_init(aa);
  fmpz_init(ab);
  turn_into_line(a, b, aa, ab, s);
  about_mean(fmpq_numref(slope), ab, s->w, a, b);
  about_mean(fmpq_denref(slope), aa, s->w, a, a);
  fmpq_set_fmpz(u, s->along.x);
  fmpq_set_fmpz(v, s->along.y);
  if (!fmpz_is_zero(fmpq_denref(slope))) { /* else no facet lies along the line at all */
    fmpq_canonicalise(slope);
    fmpq_mul_fmpz(rise, slope, s->along.y);
    fmpq_sub(u, u, rise);
    fmpq_mul_fmpz(rise, slope, s->along.x);
    fmpq_add(v, v, rise);
  }
  fmpq_clear(slope);
  fmpq_clear(rise);
  fmpz_clear(a);
  fmpz_clear(b);
  fmpz_clear(aa);
  fmpz_clear(ab);
  return true;
}

/* ---- of an outline -----------------------------------------------------------------------------
 */

static long next_of(const tp_polyline *line, long k) {
  return k + 1 == line->count ? 0 : k + 1;
}

/* The least common denominator from one point to another. */
static void find_denominator(fmpz_t denominator, const tp_polyline *line, long first, long last) {
  fmpz_one(denominator);
  for (long k = first;; k = next_of(line, k)) {
    fmpz_lcm(denominator, denominator, fmpq_denref(line->x + k));
    fmpz_lcm(denominator, denominator, fmpq_denref(line->y + k));
    if (k == last) return;
  }
}

/* value times the denominator, from there */
static void set_whole(fmpz_t whole, const fmpq *value, const fmpz_t denominator,
                      const fmpz_t from) {
  fmpz_divexact(whole, denominator, fmpq_denref(value));
  fmpz_mul(whole, whole, fmpq_numref(value));
  fmpz_sub(whole, whole, from);
}

bool tp_mean_plane_of_outline(fmpq_t u, fmpq_t v, const tp_polyline *line, long first, long last) {
  sums s;
  whole_point origin, p, q;
  fmpz_t denominator;
  sums_init(&s);
  point_init(&origin);
  point_init(&p);
  point_init(&q);
  fmpz_init(denominator);
  find_denominator(denominator, line, first, last);
  set_whole(origin.x, line->x + first, denominator, p.x); /* from zero */
  set_whole(origin.y, line->y + first, denominator, p.y);
  set_whole(s.along.x, line->x + last, denominator, origin.x);
  set_whole(s.along.y, line->y + last, denominator, origin.y);
  for (long k = first; k != last;) {
    k = next_of(line, k);
    set_whole(q.x, line->x + k, denominator, origin.x);
    set_whole(q.y, line->y + k, denominator, origin.y);
    add_facet(&s, &p, &q);
    fmpz_swap(p.x, q.x);
    fmpz_swap(p.y, q.y);
  }
  const bool found = find_direction(u, v, &s);
  if (found) {
    fmpq_div_fmpz(u, u, denominator);
    fmpq_div_fmpz(v, v, denominator);
  }
  sums_clear(&s);
  point_clear(&origin);
  point_clear(&p);
  point_clear(&q);
  fmpz_clear(denominator);
  return found;
}

/* ---- of a contact ------------------------------------------------------------------------------
 */

static void set_relative(whole_point *p, const tp_lattice *l, long point, long from) {
  fmpz_sub(p->x, l->x + point, l->x + from);
  fmpz_sub(p->y, l->y + point, l->y + from);
}

bool tp_mean_plane_of_contact(fmpq_t u, fmpq_t v, const tp_contact *contact, const tp_lattice *l) {
  const long first = contact->points[0].point;
  sums s;
  whole_point p, q;
  sums_init(&s);
  point_init(&p);
  point_init(&q);
  set_relative(&s.along, l, contact->points[contact->point_count - 1].point, first);
  for (long k = 0; k < contact->facet_count; k++) {
    const tp_facet *f = contact->facets + k;
    if (f->q0 == f->q1) continue;
    set_relative(&p, l, f->q0, first);
    set_relative(&q, l, f->q1, first);
    add_facet(&s, &p, &q);
  }
  const bool found = find_direction(u, v, &s);
  sums_clear(&s);
  point_clear(&p);
  point_clear(&q);
  return found;
}
