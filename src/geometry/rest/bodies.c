/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Rings of block and base with exact and rounded coordinates; the posed coordinates of the block
 * are rounded together and made exact vertex by vertex when asked for. */

#include "rest/bodies.h"

#include "common/message.h"
#include "number/word.h"

#include <arb.h>
#include <float.h>
#include <math.h>
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

/* Numerator and denominator of one word each? */
static bool is_short(const fmpq *value) {
  return tp_word_is_small(fmpq_numref(value)) && tp_word_is_small(fmpq_denref(value));
}

/* Rounded three times: a whole number of 126 bits, another, and their quotient; or cut off once. */
double tp_bodies_round(const tp_bodies *bodies, const fmpq *a, const fmpq *b) {
  const long exponent = bodies->exponent;
  if (is_short(a) && is_short(b)) {
    const __int128 p = tp_word_get(fmpq_numref(a)), q = tp_word_get(fmpq_denref(a)),
                   r = tp_word_get(fmpq_numref(b)), s = tp_word_get(fmpq_denref(b));
    const double value = (double)(p * s - r * q) / (double)(q * s);
    return exponent == 0 ? value : ldexp(value, (int)-exponent);
  }
  fmpq_t exact;
  fmpq_init(exact);
  fmpq_sub(exact, a, b);
  if (exponent > 0) fmpq_div_2exp(exact, exact, (flint_bitcnt_t)exponent);
  if (exponent < 0) fmpq_mul_2exp(exact, exact, (flint_bitcnt_t)-exponent);
  const double value = fmpq_get_d(exact);
  fmpq_clear(exact);
  return value;
}

/* Of the base's width and height, where doubles need one. */
static long find_exponent(const tp_body *base, long profile) {
  enum { MOST = 200 };
  long exponent = 0;
  fmpq_t size;
  fmpq_init(size);
  for (int axis = 0; axis < 2; axis++) {
    const fmpq *from = axis == 0 ? base->x : base->y;
    fmpq_sub(size, from, from + (axis == 0 ? profile - 1 : profile));
    const long own = (long)fmpz_bits(fmpq_numref(size)) - (long)fmpz_bits(fmpq_denref(size));
    if (axis == 0 || own > exponent) exponent = own;
  }
  fmpq_clear(size);
  return labs(exponent) > MOST ? exponent : 0;
}

/* Coordinates in doubles, relative to a body's first vertex. */
static void round_points(tp_body *body, const tp_bodies *bodies) {
  for (long k = 0; k < body->count; k++) {
    body->u[k] = tp_bodies_round(bodies, body->x + k, body->x);
    body->v[k] = tp_bodies_round(bodies, body->y + k, body->y);
  }
}

static double largest(const tp_body *body) {
  double most = 0;
  for (long k = 0; k < body->count; k++) {
    const double u = fabs(body->u[k]), v = fabs(body->v[k]);
    if (u > most) most = u;
    if (v > most) most = v;
  }
  return most;
}

/* The profile from right to left, then two corners so far below it that no block that hangs on the
 * profile reaches them. */
static void set_base(tp_body *base, const tp_polyline *ring, const tp_polyline *outline) {
  const long profile = ring->count - 2;
  fmpq_t low, size;
  fmpq_init(low);
  fmpq_init(size);
  long lowest = 0;
  for (long k = 0; k < profile; k++) {
    fmpq_set(base->x + k, ring->x + profile - 1 - k);
    fmpq_set(base->y + k, ring->y + profile - 1 - k);
    if (fmpq_cmp(base->y + k, base->y + lowest) < 0) lowest = k;
  }
  tp_polyline_size(base->x + profile, size, outline);
  fmpq_add(size, size, base->x + profile);
  fmpq_mul_si(size, size, 2);
  fmpq_sub(low, base->y + lowest, size);
  for (long k = 0; k < 2; k++) {
    fmpq_set(base->x + profile + k, ring->x + (k == 0 ? 0 : profile - 1));
    fmpq_set(base->y + profile + k, low);
  }
  fmpq_clear(low);
  fmpq_clear(size);
}

static bool allocate(tp_bodies *bodies, long outline, long base) {
  bodies->is_exact = calloc((size_t)outline, sizeof *bodies->is_exact);
  return bodies->is_exact != NULL && body_init(&bodies->own, outline) &&
         body_init(&bodies->posed, outline) && body_init(&bodies->base, base);
}

tp_status tp_bodies_init(tp_bodies *bodies, const tp_polyline *outline,
                         const tp_polyline *base_ring, const tp_exact_point *centroid,
                         tp_message *message) {
  memset(bodies, 0, sizeof *bodies);
  tp_pose_init(&bodies->pose);
  tp_whole_pose_init(&bodies->whole);
  tp_exact_point_init(&bodies->centroid);
  tp_exact_point_init(&bodies->own_centroid);
  bool done = allocate(bodies, outline->count, base_ring->count);
  if (done) {
    bodies->profile_count = base_ring->count - 2;
    for (long k = 0; k < outline->count; k++) {
      fmpq_set(bodies->own.x + k, outline->x + k);
      fmpq_set(bodies->own.y + k, outline->y + k);
    }
    set_base(&bodies->base, base_ring, outline);
    bodies->exponent = find_exponent(&bodies->base, bodies->profile_count);
    round_points(&bodies->own, bodies);
    round_points(&bodies->base, bodies);
    bodies->base_size = largest(&bodies->base);
    done = tp_boxes_init(&bodies->boxes, bodies->base.u, bodies->base.v, bodies->profile_count);
  }
  if (!done) {
    tp_bodies_clear(bodies);
    return tp_fail_memory(message, "the resting block");
  }
  fmpq_set(&bodies->own_centroid.x, &centroid->x);
  fmpq_set(&bodies->own_centroid.y, &centroid->y);
  tp_bodies_place(bodies);
  return TP_OK;
}

void tp_bodies_clear(tp_bodies *bodies) {
  body_clear(&bodies->own);
  body_clear(&bodies->posed);
  free(bodies->is_exact);
  bodies->is_exact = NULL;
  body_clear(&bodies->base);
  tp_boxes_clear(&bodies->boxes);
  tp_pose_clear(&bodies->pose);
  tp_whole_pose_clear(&bodies->whole);
  tp_exact_point_clear(&bodies->centroid);
  tp_exact_point_clear(&bodies->own_centroid);
}

/* The body, with the vertex in exact numbers. */
static const tp_body *exact_in(const tp_bodies *bodies, bool of_base, long vertex) {
  const tp_body *body = tp_bodies_ring(bodies, of_base);
  if (!of_base && !bodies->is_exact[vertex]) {
    tp_whole_pose_apply(body->x + vertex, body->y + vertex, &bodies->whole, bodies->own.x + vertex,
                        bodies->own.y + vertex);
    bodies->is_exact[vertex] = true;
  }
  return body;
}

tp_exact_point tp_bodies_point(const tp_bodies *bodies, bool of_base, long vertex) {
  const tp_body *body = exact_in(bodies, of_base, vertex);
  return (tp_exact_point){body->x[vertex], body->y[vertex]};
}

const fmpq *tp_bodies_x(const tp_bodies *bodies, bool of_base, long vertex) {
  return exact_in(bodies, of_base, vertex)->x + vertex;
}

const fmpq *tp_bodies_y(const tp_bodies *bodies, bool of_base, long vertex) {
  return exact_in(bodies, of_base, vertex)->y + vertex;
}

/* Where the first vertex lies, from the base's first: in balls of so many bits that all but the
 * farthest off origins leave 2^-56 of the base's size at most; exactly where they do not. */
static double place_first(const tp_bodies *b, bool is_y) {
  enum { BITS = 256 };
  const tp_pose *pose = &b->pose;
  const fmpq *const from = is_y ? b->base.y : b->base.x;
  const fmpq *const products[2][2] = {{pose->cosine, is_y ? b->own.y : b->own.x},
                                      {pose->sine, is_y ? b->own.x : b->own.y}};
  arb_t sum, one, other;
  arb_init(sum);
  arb_init(one);
  arb_init(other);
  arb_set_fmpq(sum, is_y ? pose->shift_y : pose->shift_x, BITS);
  arb_set_fmpq(one, from, BITS);
  arb_sub(sum, sum, one, BITS);
  for (int k = 0; k < 2; k++) {
    arb_set_fmpq(one, products[k][0], BITS);
    arb_set_fmpq(other, products[k][1], BITS);
    if (k == 1 && !is_y) arb_neg(one, one);
    arb_addmul(sum, one, other, BITS);
  }
  arb_mul_2exp_si(sum, sum, -b->exponent);
  double value = arf_get_d(arb_midref(sum), ARF_RND_NEAR);
  if (mag_get_d(arb_radref(sum)) > 0x1p-56 * b->base_size) {
    value = tp_bodies_round(b, is_y ? tp_bodies_y(b, false, 0) : tp_bodies_x(b, false, 0), from);
  }
  arb_clear(sum);
  arb_clear(one);
  arb_clear(other);
  return value;
}

void tp_bodies_place(tp_bodies *bodies) {
  tp_body *posed = &bodies->posed;
  memset(bodies->is_exact, 0, (size_t)posed->count * sizeof *bodies->is_exact);
  tp_whole_pose_set(&bodies->whole, &bodies->pose);
  tp_whole_pose_apply(&bodies->centroid.x, &bodies->centroid.y, &bodies->whole,
                      &bodies->own_centroid.x, &bodies->own_centroid.y);
  const double c = fmpq_get_d(bodies->pose.cosine), s = fmpq_get_d(bodies->pose.sine);
  const double first_u = place_first(bodies, false), first_v = place_first(bodies, true);
  for (long k = 0; k < posed->count; k++) {
    const double a = bodies->own.u[k], b = bodies->own.v[k];
    posed->u[k] = c * a - s * b + first_u;
    posed->v[k] = s * a + c * b + first_v;
  }
  bodies->error = 34 * DBL_EPSILON * fmax(bodies->base_size, largest(posed));
}
