/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Area, first and second moments of triangles and of circular sectors added in balls; a sector's
 * moments by sines of its half angle, turned and moved to its centre. */

#include "block/region.h"

enum { A, X, Y, XX, YY, XY };

void tp_region_init(tp_region *region) {
  for (int k = 0; k < 6; k++) arb_init(region->of + k);
}

void tp_region_clear(tp_region *region) {
  for (int k = 0; k < 6; k++) arb_clear(region->of + k);
}

void tp_ball_point_init(tp_ball_point *point) {
  arb_init(point->x);
  arb_init(point->y);
}

void tp_ball_point_clear(tp_ball_point *point) {
  arb_clear(point->x);
  arb_clear(point->y);
}

/* sum += area / divisor (s t + p0 q0 + p1 q1 + p2 q2), s and t the sums of the p and of the q. */
static void add_second(arb_t sum, const arb_t area, const arb_srcptr p[3], const arb_srcptr q[3],
                       long bits) {
  arb_t s, t;
  arb_init(s);
  arb_init(t);
  for (int k = 0; k < 3; k++) {
    arb_add(s, s, p[k], bits);
    arb_add(t, t, q[k], bits);
  }
  arb_mul(s, s, t, bits);
  for (int k = 0; k < 3; k++) arb_addmul(s, p[k], q[k], bits);
  arb_mul(s, s, area, bits);
  arb_div_ui(s, s, 12, bits);
  arb_add(sum, sum, s, bits);
  arb_clear(s);
  arb_clear(t);
}

static void add_first(arb_t sum, const arb_t area, const arb_srcptr p[3], long bits) {
  arb_t s;
  arb_init(s);
  for (int k = 0; k < 3; k++) arb_add(s, s, p[k], bits);
  arb_mul(s, s, area, bits);
  arb_div_ui(s, s, 3, bits);
  arb_add(sum, sum, s, bits);
  arb_clear(s);
}

void tp_ball_point_cross(arb_t cross, const tp_ball_point *p, const tp_ball_point *q,
                         const tp_ball_point *r, long bits) {
  arb_t ux, uy, vx, vy;
  arb_init(ux);
  arb_init(uy);
  arb_init(vx);
  arb_init(vy);
  arb_sub(ux, q->x, p->x, bits);
  arb_sub(uy, q->y, p->y, bits);
  arb_sub(vx, r->x, p->x, bits);
  arb_sub(vy, r->y, p->y, bits);
  arb_mul(cross, ux, vy, bits);
  arb_submul(cross, uy, vx, bits);
  arb_clear(ux);
  arb_clear(uy);
  arb_clear(vx);
  arb_clear(vy);
}

void tp_region_add_triangle(tp_region *region, const tp_ball_point *p, const tp_ball_point *q,
                            const tp_ball_point *r, long bits) {
  const arb_srcptr x[3] = {p->x, q->x, r->x}, y[3] = {p->y, q->y, r->y};
  arb_t area;
  arb_init(area);
  tp_ball_point_cross(area, p, q, r, bits);
  arb_mul_2exp_si(area, area, -1);
  arb_add(region->of + A, region->of + A, area, bits);
  add_first(region->of + X, area, x, bits);
  add_first(region->of + Y, area, y, bits);
  add_second(region->of + XX, area, x, x, bits);
  add_second(region->of + YY, area, y, y, bits);
  add_second(region->of + XY, area, x, y, bits);
  arb_clear(area);
}

/* Area, first and second moments of a sector about its centre, in its own frame. */
typedef struct sector {
  arb_t area, first, along, across;
} sector;

static void sector_init(sector *s, const arb_t radius, const arb_t angle, long bits) {
  arb_t power, sine;
  arb_init(power);
  arb_init(sine);
  arb_init(s->area);
  arb_init(s->first);
  arb_init(s->along);
  arb_init(s->across);
  arb_sqr(power, radius, bits);
  arb_mul(s->area, power, angle, bits);
  arb_mul_2exp_si(s->area, s->area, -1);
  arb_mul_2exp_si(sine, angle, -1);
  arb_sin(sine, sine, bits);
  arb_mul(power, power, radius, bits);
  arb_mul(s->first, power, sine, bits);
  arb_mul_2exp_si(s->first, s->first, 1);
  arb_div_ui(s->first, s->first, 3, bits);
  arb_mul(power, power, radius, bits);
  arb_mul_2exp_si(power, power, -3);
  arb_sin(sine, angle, bits);
  arb_add(s->along, angle, sine, bits);
  arb_mul(s->along, s->along, power, bits);
  arb_sub(s->across, angle, sine, bits);
  arb_mul(s->across, s->across, power, bits);
  arb_clear(power);
  arb_clear(sine);
}

static void sector_clear(sector *s) {
  arb_clear(s->area);
  arb_clear(s->first);
  arb_clear(s->along);
  arb_clear(s->across);
}

/* sum -= c area + d first */
static void subtract_first(arb_t sum, const sector *s, const arb_t c, const arb_t d, long bits) {
  arb_submul(sum, c, s->area, bits);
  arb_submul(sum, d, s->first, bits);
}

/* sum -= c e area + (c f + d e) first + d f along + g h across, for the second moment of c + d u +
 * g v and e + f u + h v. */
static void subtract_second(arb_t sum, const sector *s, const arb_t c, const arb_t d, const arb_t g,
                            const arb_t e, const arb_t f, const arb_t h, long bits) {
  arb_t product;
  arb_init(product);
  arb_mul(product, c, e, bits);
  arb_submul(sum, product, s->area, bits);
  arb_mul(product, c, f, bits);
  arb_addmul(product, d, e, bits);
  arb_submul(sum, product, s->first, bits);
  arb_mul(product, d, f, bits);
  arb_submul(sum, product, s->along, bits);
  arb_mul(product, g, h, bits);
  arb_submul(sum, product, s->across, bits);
  arb_clear(product);
}

void tp_region_subtract_sector(tp_region *region, const tp_ball_point *centre, const arb_t radius,
                               const arb_t angle, const tp_ball_point *along, long bits) {
  sector s;
  arb_t normal_x; /* the normal of the bisector is (-along.y, along.x) */
  sector_init(&s, radius, angle, bits);
  arb_init(normal_x);
  arb_neg(normal_x, along->y);
  const arb_srcptr cx = centre->x, cy = centre->y, dx = along->x, dy = along->y;
  arb_sub(region->of + A, region->of + A, s.area, bits);
  subtract_first(region->of + X, &s, cx, dx, bits);
  subtract_first(region->of + Y, &s, cy, dy, bits);
  subtract_second(region->of + XX, &s, cx, dx, normal_x, cx, dx, normal_x, bits);
  subtract_second(region->of + YY, &s, cy, dy, dx, cy, dy, dx, bits);
  subtract_second(region->of + XY, &s, cx, dx, normal_x, cy, dy, dx, bits);
  arb_clear(normal_x);
  sector_clear(&s);
}

static void distance(arb_t value, const tp_ball_point *p, const tp_ball_point *q, long bits) {
  arb_t dy;
  arb_init(dy);
  arb_sub(value, p->x, q->x, bits);
  arb_sub(dy, p->y, q->y, bits);
  arb_hypot(value, value, dy, bits);
  arb_clear(dy);
}

void tp_region_add_tip(tp_region *region, const tp_ball_point *vertex, const tp_ball_point *before,
                       const tp_ball_point *after, const tp_ball_point *centre, long bits) {
  tp_ball_point direction;
  arb_t radius, angle, size;
  tp_ball_point_init(&direction);
  arb_init(radius);
  arb_init(angle);
  arb_init(size);
  tp_region_add_triangle(region, vertex, after, centre, bits);
  tp_region_add_triangle(region, vertex, centre, before, bits);
  distance(radius, after, centre, bits);
  distance(angle, vertex, after, bits); /* its half has the tangent l / r */
  arb_div(angle, angle, radius, bits);
  arb_atan(angle, angle, bits);
  arb_mul_2exp_si(angle, angle, 1);
  distance(size, vertex, centre, bits);
  arb_sub(direction.x, vertex->x, centre->x, bits);
  arb_sub(direction.y, vertex->y, centre->y, bits);
  arb_div(direction.x, direction.x, size, bits);
  arb_div(direction.y, direction.y, size, bits);
  tp_region_subtract_sector(region, centre, radius, angle, &direction, bits);
  tp_ball_point_clear(&direction);
  arb_clear(radius);
  arb_clear(angle);
  arb_clear(size);
}

void tp_region_add_segment(tp_region *region, const tp_ball_point *from, const tp_ball_point *to,
                           const tp_ball_point *centre, long bits) {
  tp_region rest; /* triangle less sector: the segment, negative */
  tp_ball_point middle;
  arb_t radius, angle, size;
  tp_region_init(&rest);
  tp_ball_point_init(&middle);
  arb_init(radius);
  arb_init(angle);
  arb_init(size);
  tp_region_add_triangle(&rest, centre, to, from, bits);
  arb_add(middle.x, from->x, to->x, bits);
  arb_mul_2exp_si(middle.x, middle.x, -1);
  arb_add(middle.y, from->y, to->y, bits);
  arb_mul_2exp_si(middle.y, middle.y, -1);
  distance(radius, from, centre, bits);
  distance(size, &middle, centre, bits);
  distance(angle, from, &middle, bits);
  arb_div(angle, angle, size, bits);
  arb_atan(angle, angle, bits);
  arb_mul_2exp_si(angle, angle, 1);
  arb_sub(middle.x, middle.x, centre->x, bits);
  arb_sub(middle.y, middle.y, centre->y, bits);
  arb_div(middle.x, middle.x, size, bits);
  arb_div(middle.y, middle.y, size, bits);
  tp_region_subtract_sector(&rest, centre, radius, angle, &middle, bits);
  for (int k = 0; k < 6; k++) arb_sub(region->of + k, region->of + k, rest.of + k, bits);
  tp_region_clear(&rest);
  tp_ball_point_clear(&middle);
  arb_clear(radius);
  arb_clear(angle);
  arb_clear(size);
}

void tp_region_sums(arb_struct sums[TP_SUM_COUNT], const tp_region *region, long bits) {
  /* A2 is twice the area, X6 six times the first moment, and so on (ring_sums.h) */
  static const unsigned long factors[TP_SUM_COUNT] = {2, 6, 6, 12, 12, 24};
  static const int names[TP_SUM_COUNT] = {TP_A2, TP_X6, TP_Y6, TP_XX12, TP_YY12, TP_XY24};
  for (int k = 0; k < TP_SUM_COUNT; k++)
    arb_mul_ui(sums + names[k], region->of + k, factors[k], bits);
}
