/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A block above its base while it comes to rest: both as rings with their inside on the left, the
 * block in a pose, exactly and in doubles.
 *
 * The doubles are coordinates relative to the base's first point, rounded once: each is off by at
 * most 2^-53 of its size. They choose what is looked at exactly, and decide nothing. */

#ifndef TP_BODIES_H
#define TP_BODIES_H

#include "plane/polyline.h"
#include "rest/pose.h"
#include "topple.h"

typedef struct tp_body {
  long count;
  fmpq *x, *y;
  double *u, *v;
} tp_body;

/* A point of exact coordinates. */
typedef struct tp_exact_point {
  fmpq x, y;
} tp_exact_point;

typedef struct tp_bodies {
  tp_body own;   /* the block in its own coordinates; no doubles */
  tp_body block; /* in its pose */
  tp_body base;
  long profile_count; /* vertices of the profile: the base's first, from right to left */
  tp_exact_point own_centroid, centroid;
  tp_pose pose;
} tp_bodies;

/* The outline runs counter-clockwise, as does the base's ring, reversed. On failure cleared. */
TP_MUST_USE tp_status tp_bodies_init(tp_bodies *bodies, const tp_polyline *outline,
                                     const tp_polyline *base_ring, const tp_exact_point *centroid,
                                     tp_message *message);
void tp_bodies_clear(tp_bodies *bodies);

/* Put the block where its pose says. */
void tp_bodies_place(tp_bodies *bodies);

void tp_exact_point_init(tp_exact_point *point);
void tp_exact_point_clear(tp_exact_point *point);
void tp_exact_dot(fmpq_t product, const tp_exact_point *p, const tp_exact_point *q);
void tp_exact_cross(fmpq_t product, const tp_exact_point *p, const tp_exact_point *q);

static inline long tp_body_next(const tp_body *body, long k) {
  return k + 1 == body->count ? 0 : k + 1;
}

static inline long tp_body_before(const tp_body *body, long k) {
  return k == 0 ? body->count - 1 : k - 1;
}

#endif
