/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "rest/bodies.h"

#include "message.h"

#include <stdlib.h>
#include <string.h>

void tp_exact_point_init(tp_exact_point *point) {
  fmpq_init(&point->x);
  fmpq_init(&point->y);
}

void tp_exact_point_clear(tp_exact_point *point) {
  fmpq_clear(&point->x);
  fmpq_clear(&point->y);
}

void tp_exact_dot(fmpq_t product, const tp_exact_point *p, const tp_exact_point *q) {
  fmpq_mul(product, &p->x, &q->x);
  fmpq_addmul(product, &p->y, &q->y);
}

void tp_exact_cross(fmpq_t product, const tp_exact_point *p, const tp_exact_point *q) {
  fmpq_mul(product, &p->x, &q->y);
  fmpq_submul(product, &p->y, &q->x);
}

/* FLINT's vectors of rationals end the process without memory, so they are made by hand. */
static bool body_init(tp_body *body, long count) {
  *body = (tp_body){.count = count};
  body->x = calloc((size_t)count, sizeof *body->x);
  body->y = calloc((size_t)count, sizeof *body->y);
  body->u = calloc((size_t)count, sizeof *body->u);
  body->v = calloc((size_t)count, sizeof *body->v);
  if (body->x == NULL || body->y == NULL || body->u == NULL || body->v == NULL) return false;
  for (long k = 0; k < count; k++) {
    fmpq_init(body->x + k);
    fmpq_init(body->y + k);
  }
  return true;
}

static void body_clear(tp_body *body) {
  if (body->x != NULL && body->y != NULL && body->u != NULL && body->v != NULL) {
    for (long k = 0; k < body->count; k++) {
      fmpq_clear(body->x + k);
      fmpq_clear(body->y + k);
    }
  }
  free(body->x);
  free(body->y);
  free(body->u);
  free(body->v);
  *body = (tp_body){0};
}

/* Coordinates in doubles, relative to the base's first point. */
static void round_points(tp_body *body, const tp_body *base) {
  fmpq_t rest;
  fmpq_init(rest);
  for (long k = 0; k < body->count; k++) {
    fmpq_sub(rest, body->x + k, base->x);
    body->u[k] = fmpq_get_d(rest);
    fmpq_sub(rest, body->y + k, base->y);
    body->v[k] = fmpq_get_d(rest);
  }
  fmpq_clear(rest);
}

/* The profile from right to left, then two corners so far below it that no block that hangs on the
 * profile reaches them. */
static void set_base(tp_body *base, const tp_polyline *ring, const tp_polyline *outline) {
  const long profile = ring->count - 2;
  fmpq_t low, size;
  fmpq_init(low);
  fmpq_init(size);
  fmpq_set(low, ring->y);
  for (long k = 0; k < profile; k++) {
    fmpq_set(base->x + k, ring->x + profile - 1 - k);
    fmpq_set(base->y + k, ring->y + profile - 1 - k);
    if (fmpq_cmp(base->y + k, low) < 0) fmpq_set(low, base->y + k);
  }
  tp_polyline_size(base->x + profile, size, outline);
  fmpq_add(size, size, base->x + profile);
  fmpq_mul_si(size, size, 2);
  fmpq_sub(low, low, size);
  for (long k = 0; k < 2; k++) {
    fmpq_set(base->x + profile + k, ring->x + (k == 0 ? 0 : profile - 1));
    fmpq_set(base->y + profile + k, low);
  }
  fmpq_clear(low);
  fmpq_clear(size);
}

tp_status tp_bodies_init(tp_bodies *bodies, const tp_polyline *outline,
                         const tp_polyline *base_ring, const tp_exact_point *centroid,
                         tp_message *message) {
  memset(bodies, 0, sizeof *bodies);
  tp_pose_init(&bodies->pose);
  tp_exact_point_init(&bodies->centroid);
  tp_exact_point_init(&bodies->own_centroid);
  if (!body_init(&bodies->own, outline->count) || !body_init(&bodies->block, outline->count) ||
      !body_init(&bodies->base, base_ring->count)) {
    tp_bodies_clear(bodies);
    return tp_fail_memory(message, "the resting block");
  }
  bodies->profile_count = base_ring->count - 2;
  for (long k = 0; k < outline->count; k++) {
    fmpq_set(bodies->own.x + k, outline->x + k);
    fmpq_set(bodies->own.y + k, outline->y + k);
  }
  set_base(&bodies->base, base_ring, outline);
  fmpq_set(&bodies->own_centroid.x, &centroid->x);
  fmpq_set(&bodies->own_centroid.y, &centroid->y);
  round_points(&bodies->base, &bodies->base);
  tp_bodies_place(bodies);
  return TP_OK;
}

void tp_bodies_clear(tp_bodies *bodies) {
  body_clear(&bodies->own);
  body_clear(&bodies->block);
  body_clear(&bodies->base);
  tp_pose_clear(&bodies->pose);
  tp_exact_point_clear(&bodies->centroid);
  tp_exact_point_clear(&bodies->own_centroid);
}

void tp_bodies_place(tp_bodies *bodies) {
  for (long k = 0; k < bodies->own.count; k++) {
    tp_pose_apply(bodies->block.x + k, bodies->block.y + k, &bodies->pose, bodies->own.x + k,
                  bodies->own.y + k);
  }
  tp_pose_apply(&bodies->centroid.x, &bodies->centroid.y, &bodies->pose, &bodies->own_centroid.x,
                &bodies->own_centroid.y);
  round_points(&bodies->block, &bodies->base);
}
