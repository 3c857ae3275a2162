/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A block above its base while it comes to rest: both as rings with their inside on the left, the
 * block in a pose, exactly and in doubles.
 *
 * The doubles are coordinates relative to the base's first point, over a power of two where they
 * are so large or small that products of four would leave the range of doubles. With their bound
 * they tell most of what is asked; exact numbers tell the rest. Those of the block are turned in
 * doubles; its exact coordinates are computed vertex by vertex, as they are asked for: of a pose
 * they have hundreds of digits, and few of its vertices ever touch.
 *
 * With u = 2^-53, each rounding of a rational is by 3 u of its size at most. Let M bound all
 * doubles, so that the block's own, from its first vertex, are at most 2 sqrt(2) M. A vertex turned
 * is c a - s b + p: off by at most (3 + 2 + 1 + 1) u of |c a| + |s b| <= 4 M, 3 u of |p| and u of
 * the sum, 32 u M in all; the difference of two coordinates by 66 u M, with its own rounding. */

#ifndef TP_REST_BODIES_H
#define TP_REST_BODIES_H

#include "plane/polyline.h"
#include "rest/boxes.h"
#include "rest/pose.h"
#include "topple.h"

typedef struct tp_body {
  long count;
  fmpq *x, *y;
  double *u, *v; /* of the block's own coordinates relative to its first vertex */
} tp_body;

/* A point of exact coordinates. */
typedef struct tp_exact_point {
  fmpq x, y;
} tp_exact_point;

typedef struct tp_bodies {
  tp_body own;    /* the block in its own coordinates */
  tp_body posed;  /* in its pose: the doubles, and what tp_bodies_point has computed */
  bool *is_exact; /* of its vertices */
  tp_body base;
  long profile_count; /* vertices of the profile: the base's first, from right to left */
  tp_boxes boxes;     /* around its edges */
  tp_exact_point own_centroid, centroid;
  tp_pose pose;
  tp_whole_pose whole;     /* the same, once the block is there */
  long exponent;           /* doubles are coordinates over 2^exponent */
  double base_size, error; /* largest double of the base; of differences of coordinates, by bound */
} tp_bodies;

/* The outline runs counter-clockwise, as does the base's ring, reversed. On failure cleared. */
TP_MUST_USE tp_status tp_bodies_init(tp_bodies *bodies, const tp_polyline *outline,
                                     const tp_polyline *base_ring, const tp_exact_point *centroid,
                                     tp_message *message);
void tp_bodies_clear(tp_bodies *bodies);

/* Put the block where its pose says. */
void tp_bodies_place(tp_bodies *bodies);

/* The difference of two coordinates in doubles, as those of the bodies. */
double tp_bodies_round(const tp_bodies *bodies, const fmpq *a, const fmpq *b);

/* A vertex of the base, or of the block in its pose: borrowed, until it is placed anew. */
tp_exact_point tp_bodies_point(const tp_bodies *bodies, bool of_base, long vertex);
const fmpq *tp_bodies_x(const tp_bodies *bodies, bool of_base, long vertex);
const fmpq *tp_bodies_y(const tp_bodies *bodies, bool of_base, long vertex);

void tp_exact_point_init(tp_exact_point *point);
void tp_exact_point_clear(tp_exact_point *point);
void tp_exact_dot(fmpq_t product, const tp_exact_point *p, const tp_exact_point *q);
void tp_exact_cross(fmpq_t product, const tp_exact_point *p, const tp_exact_point *q);

/* From one vertex to the next of a body's ring, and back. */
static inline long tp_body_next(const tp_body *body, long k) {
  return k + 1 == body->count ? 0 : k + 1;
}

static inline long tp_body_before(const tp_body *body, long k) {
  return k == 0 ? body->count - 1 : k - 1;
}

static inline const tp_body *tp_bodies_ring(const tp_bodies *bodies, bool of_base) {
  return of_base ? &bodies->base : &bodies->posed;
}

#endif
