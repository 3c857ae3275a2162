/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Centre of the circle through three points, points of it by the rational parametrisation, and
 * intersections of tangents, in exact rationals; the arc's angle in doubles for the choice of
 * points alone. */

#include "block/circle.h"

#include <math.h>

void tp_point_init(tp_point *p) {
  fmpq_init(p->x);
  fmpq_init(p->y);
}

void tp_point_clear(tp_point *p) {
  fmpq_clear(p->x);
  fmpq_clear(p->y);
}

void tp_point_difference(tp_point *d, const tp_point *p, const tp_point *q) {
  fmpq_sub(d->x, p->x, q->x);
  fmpq_sub(d->y, p->y, q->y);
}

static void dot(fmpq_t value, const tp_point *p, const tp_point *q) {
  fmpq_mul(value, p->x, q->x);
  fmpq_addmul(value, p->y, q->y);
}

static void cross(fmpq_t value, const tp_point *p, const tp_point *q) {
  fmpq_mul(value, p->x, q->y);
  fmpq_submul(value, p->y, q->x);
}

/* p + t q */
void tp_point_along(tp_point *sum, const tp_point *p, const fmpq_t t, const tp_point *q) {
  fmpq_set(sum->x, p->x);
  fmpq_set(sum->y, p->y);
  fmpq_addmul(sum->x, t, q->x);
  fmpq_addmul(sum->y, t, q->y);
}

void tp_circle_arc_init(tp_circle_arc *a) {
  tp_point_init(&a->p);
  tp_point_init(&a->q);
  tp_point_init(&a->centre);
}

void tp_circle_arc_clear(tp_circle_arc *a) {
  tp_point_clear(&a->p);
  tp_point_clear(&a->q);
  tp_point_clear(&a->centre);
}

/* The centre of the circle through p, m and q: with u = m - p and v = q - p,
 * C - p = (v_y |u|^2 - u_y |v|^2, u_x |v|^2 - v_x |u|^2) / (2 u x v). False where
 * m is not to the right of the chord from p to q: then the arc does not bulge outwards. */
bool tp_circle_arc_set_centre(tp_circle_arc *a, const tp_point *m) {
  tp_point u, v;
  fmpq_t uu, vv, area, t;
  tp_point_init(&u);
  tp_point_init(&v);
  fmpq_init(uu);
  fmpq_init(vv);
  fmpq_init(area);
  fmpq_init(t);
  tp_point_difference(&u, m, &a->p);
  tp_point_difference(&v, &a->q, &a->p);
  dot(uu, &u, &u);
  dot(vv, &v, &v);
  cross(area, &u, &v);
  const bool outwards = fmpq_sgn(area) > 0;
  if (outwards) {
    fmpq_add(area, area, area);
    fmpq_mul(t, v.y, uu);
    fmpq_submul(t, u.y, vv);
    fmpq_div(t, t, area);
    fmpq_add(a->centre.x, a->p.x, t);
    fmpq_mul(t, u.x, vv);
    fmpq_submul(t, v.x, uu);
    fmpq_div(t, t, area);
    fmpq_add(a->centre.y, a->p.y, t);
  }
  tp_point_clear(&u);
  tp_point_clear(&v);
  fmpq_clear(uu);
  fmpq_clear(vv);
  fmpq_clear(area);
  fmpq_clear(t);
  return outwards;
}

/* The angle of the arc, in (0, 2 pi), for the choice of points on it alone. Its sine and cosine are
 * exact before they are rounded: they are doubles whatever the size of the circle. */
double tp_circle_arc_angle(const tp_circle_arc *a) {
  tp_point u, v;
  fmpq_t square, sine, cosine;
  tp_point_init(&u);
  tp_point_init(&v);
  fmpq_init(square);
  fmpq_init(sine);
  fmpq_init(cosine);
  tp_point_difference(&u, &a->p, &a->centre);
  tp_point_difference(&v, &a->q, &a->centre);
  dot(square, &u, &u);
  cross(sine, &u, &v);
  dot(cosine, &u, &v);
  fmpq_div(sine, sine, square);
  fmpq_div(cosine, cosine, square);
  const bool more_than_half = fmpq_sgn(sine) < 0; /* of a turn, however little */
  const double turn = atan2(fmpq_get_d(sine), fmpq_get_d(cosine));
  tp_point_clear(&u);
  tp_point_clear(&v);
  fmpq_clear(square);
  fmpq_clear(sine);
  fmpq_clear(cosine);
  return more_than_half ? turn + 2 * M_PI : turn;
}

/* A point of the circle: p turned about the centre by the angle whose half has the tangent t. */
void tp_circle_arc_point(tp_point *r, const tp_circle_arc *a, const fmpq_t t) {
  tp_point u;
  fmpq_t cosine, sine, size;
  tp_point_init(&u);
  fmpq_init(cosine);
  fmpq_init(sine);
  fmpq_init(size);
  tp_point_difference(&u, &a->p, &a->centre);
  fmpq_mul(size, t, t);
  fmpq_one(cosine);
  fmpq_sub(cosine, cosine, size);
  fmpq_add_si(size, size, 1);
  fmpq_div(cosine, cosine, size);
  fmpq_add(sine, t, t);
  fmpq_div(sine, sine, size);
  fmpq_mul(r->x, cosine, u.x);
  fmpq_submul(r->x, sine, u.y);
  fmpq_mul(r->y, sine, u.x);
  fmpq_addmul(r->y, cosine, u.y);
  fmpq_add(r->x, r->x, a->centre.x);
  fmpq_add(r->y, r->y, a->centre.y);
  tp_point_clear(&u);
  fmpq_clear(cosine);
  fmpq_clear(sine);
  fmpq_clear(size);
}

/* Where the tangents at two points of the circle meet: C + R^2 (A + B) / (R^2 + A . B). */
void tp_circle_arc_tangents_meet(tp_point *m, const tp_circle_arc *a, const tp_point *p,
                                 const tp_point *q) {
  tp_point u, v;
  fmpq_t rr, t;
  tp_point_init(&u);
  tp_point_init(&v);
  fmpq_init(rr);
  fmpq_init(t);
  tp_point_difference(&u, p, &a->centre);
  tp_point_difference(&v, q, &a->centre);
  dot(rr, &u, &u);
  dot(t, &u, &v);
  fmpq_add(t, t, rr);
  fmpq_div(t, rr, t);
  fmpq_add(u.x, u.x, v.x);
  fmpq_add(u.y, u.y, v.y);
  tp_point_along(m, &a->centre, t, &u);
  tp_point_clear(&u);
  tp_point_clear(&v);
  fmpq_clear(rr);
  fmpq_clear(t);
}
