/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Tangent points and centre of a rounded corner in balls from the tangent of half the interior
 * angle, and the tip taken off all moments or, in model paper, not (docs/mechanics.md section 4;
 * Appendix B). */

#include "block/corners.h"

#include <stdlib.h>
#include <string.h>

void tp_corner_ball_init(tp_corner_ball *ball) {
  tp_ball_point_init(&ball->before);
  tp_ball_point_init(&ball->after);
  tp_ball_point_init(&ball->centre);
  arb_init(ball->length);
  arb_init(ball->radius);
  arb_init(ball->half_tangent);
}

void tp_corner_ball_clear(tp_corner_ball *ball) {
  tp_ball_point_clear(&ball->before);
  tp_ball_point_clear(&ball->after);
  tp_ball_point_clear(&ball->centre);
  arb_clear(ball->length);
  arb_clear(ball->radius);
  arb_clear(ball->half_tangent);
}

/* An edge from the vertex: its vector, exact, and its length. */
typedef struct edge {
  fmpz_t dx, dy;
  arb_t length;
} edge;

static void edge_init(edge *e, const tp_lattice *l, long from, long to, long bits) {
  fmpz_init(e->dx);
  fmpz_init(e->dy);
  arb_init(e->length);
  fmpz_sub(e->dx, l->x + to, l->x + from);
  fmpz_sub(e->dy, l->y + to, l->y + from);
  fmpz_t square;
  fmpz_init(square);
  fmpz_mul(square, e->dx, e->dx);
  fmpz_addmul(square, e->dy, e->dy);
  arb_sqrt_fmpz(e->length, square, bits);
  fmpz_clear(square);
}

static void edge_clear(edge *e) {
  fmpz_clear(e->dx);
  fmpz_clear(e->dy);
  arb_clear(e->length);
}

/* The point at `distance` from the vertex along an edge. */
static void along(tp_ball_point *point, const tp_lattice *l, long vertex, const edge *e,
                  const arb_t distance, long bits) {
  arb_t share;
  arb_init(share);
  arb_div(share, distance, e->length, bits);
  arb_mul_fmpz(point->x, share, e->dx, bits);
  arb_add_fmpz(point->x, point->x, l->x + vertex, bits);
  arb_mul_fmpz(point->y, share, e->dy, bits);
  arb_add_fmpz(point->y, point->y, l->y + vertex, bits);
  arb_clear(share);
}

/* tan(theta / 2) = (|u| |w| - u . w) / (u x w), u and w the edges after and before. */
static void set_half_tangent(arb_t value, const edge *u, const edge *w, long bits) {
  fmpz_t dot, cross;
  fmpz_init(dot);
  fmpz_init(cross);
  fmpz_mul(dot, u->dx, w->dx);
  fmpz_addmul(dot, u->dy, w->dy);
  fmpz_mul(cross, u->dx, w->dy);
  fmpz_submul(cross, u->dy, w->dx);
  arb_mul(value, u->length, w->length, bits);
  arb_sub_fmpz(value, value, dot, bits);
  arb_div_fmpz(value, value, cross, bits);
  fmpz_clear(dot);
  fmpz_clear(cross);
}

void tp_corner_evaluate(tp_corner_ball *ball, const tp_corner *corner, const tp_lattice *l,
                        long bits) {
  edge u, w;
  edge_init(&u, l, corner->vertex, corner->after, bits);
  edge_init(&w, l, corner->vertex, corner->before, bits);
  set_half_tangent(ball->half_tangent, &u, &w, bits);
  arb_set_fmpq(ball->radius, corner->radius, bits);
  arb_div(ball->length, ball->radius, ball->half_tangent, bits);
  along(&ball->after, l, corner->vertex, &u, ball->length, bits);
  along(&ball->before, l, corner->vertex, &w, ball->length, bits);
  /* the centre is a radius away from the tangent point, to the left of the edge after */
  arb_t share;
  arb_init(share);
  arb_div(share, ball->radius, u.length, bits);
  arb_mul_fmpz(ball->centre.x, share, u.dy, bits);
  arb_sub(ball->centre.x, ball->after.x, ball->centre.x, bits);
  arb_mul_fmpz(ball->centre.y, share, u.dx, bits);
  arb_add(ball->centre.y, ball->after.y, ball->centre.y, bits);
  arb_clear(share);
  edge_clear(&u);
  edge_clear(&w);
}

static void tip(tp_region *region, const tp_corner *corner, const tp_lattice *l, long bits) {
  tp_corner_ball c;
  tp_ball_point vertex;
  tp_corner_ball_init(&c);
  tp_ball_point_init(&vertex);
  tp_corner_evaluate(&c, corner, l, bits);
  arb_set_fmpz(vertex.x, l->x + corner->vertex);
  arb_set_fmpz(vertex.y, l->y + corner->vertex);
  tp_region_add_tip(region, &vertex, &c.before, &c.after, &c.centre, bits);
  tp_corner_ball_clear(&c);
  tp_ball_point_clear(&vertex);
}

/* Take a region of the block's own density off the moments. */
static void take_off(tp_moments *moments, const tp_region *region, const tp_section *section,
                     long bits) {
  arb_struct sums[TP_SUM_COUNT];
  for (int k = 0; k < TP_SUM_COUNT; k++) arb_init(sums + k);
  tp_region_sums(sums, region, bits);
  arb_sub(moments->area2, moments->area2, sums + TP_A2, bits);
  for (int k = 0; k < TP_SUM_COUNT; k++) {
    arb_mul_fmpz(sums + k, sums + k, section->density_weights, bits);
    arb_sub(moments->weighted + k, moments->weighted + k, sums + k, bits);
    arb_clear(sums + k);
  }
}

void tp_corners_take_off(tp_moments *moments, const tp_corners *corners, const tp_section *section,
                         const tp_lattice *lattice, long bits) {
  if (corners->keeps_mass || corners->count == 0) return;
  tp_region tips;
  tp_region_init(&tips);
  for (long k = 0; k < corners->count; k++) tip(&tips, corners->items + k, lattice, bits);
  take_off(moments, &tips, section, bits);
  tp_region_clear(&tips);
}

/* A coordinate of the scene in lattice units from the local origin: exact. */
static void set_coordinate(arb_t value, const fmpq_t coordinate, const fmpz_t origin,
                           const tp_lattice *lattice, const fmpq_t metres_per_unit, long bits) {
  fmpq_t units;
  fmpq_init(units);
  fmpq_mul(units, coordinate, metres_per_unit);
  fmpq_div(units, units, lattice->step_m);
  fmpq_sub_fmpz(units, units, origin);
  arb_set_fmpq(value, units, bits);
  fmpq_clear(units);
}

void tp_arc_tip_evaluate(tp_corner_ball *ball, const tp_arc_tip *tip, const tp_lattice *l,
                         const fmpq_t metres_per_unit, long bits) {
  const struct {
    tp_ball_point *point;
    const fmpq *x, *y;
  } points[] = {{&ball->before, tip->before_x, tip->before_y},
                {&ball->after, tip->after_x, tip->after_y},
                {&ball->centre, tip->centre_x, tip->centre_y}};
  for (int k = 0; k < 3; k++) {
    set_coordinate(points[k].point->x, points[k].x, l->origin_x, l, metres_per_unit, bits);
    set_coordinate(points[k].point->y, points[k].y, l->origin_y, l, metres_per_unit, bits);
  }
  arb_sub(ball->radius, ball->after.x, ball->centre.x, bits);
  arb_sub(ball->length, ball->after.y, ball->centre.y, bits);
  arb_hypot(ball->radius, ball->radius, ball->length, bits);
}

void tp_arcs_take_off(tp_moments *moments, const tp_section *section, const tp_lattice *lattice,
                      const fmpq_t metres_per_unit, long bits) {
  tp_region tips;
  tp_corner_ball c;
  tp_ball_point vertex;
  tp_region_init(&tips);
  tp_corner_ball_init(&c);
  tp_ball_point_init(&vertex);
  for (long k = 0; k < section->arc_tips.count; k++) {
    const tp_arc_tip *own = section->arc_tips.items + k;
    tp_arc_tip_evaluate(&c, own, lattice, metres_per_unit, bits);
    if (own->inwards) {
      tp_region_add_segment(&tips, &c.before, &c.after, &c.centre, bits);
      continue;
    }
    arb_set_fmpz(vertex.x, lattice->x + own->vertex);
    arb_set_fmpz(vertex.y, lattice->y + own->vertex);
    tp_region_add_tip(&tips, &vertex, &c.before, &c.after, &c.centre, bits);
  }
  take_off(moments, &tips, section, bits);
  tp_region_clear(&tips);
  tp_corner_ball_clear(&c);
  tp_ball_point_clear(&vertex);
}

const tp_corner *tp_corners_at(const tp_corners *corners, long vertex) {
  long low = 0, high = corners->count;
  while (low < high) {
    const long middle = low + (high - low) / 2;
    if (corners->items[middle].vertex < vertex) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  const bool found = low < corners->count && corners->items[low].vertex == vertex;
  return found ? corners->items + low : NULL;
}

void tp_corners_clear(tp_corners *corners) {
  for (long k = 0; k < corners->count; k++) fmpq_clear(corners->items[k].radius);
  free(corners->items);
  memset(corners, 0, sizeof *corners);
}
