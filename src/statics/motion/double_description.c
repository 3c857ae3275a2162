/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Double description method for a cone of twists in three dimensions; cones that are flat or
 * contain a line are cut here, solid ones by motion/solid_cone.h. */

#include "motion/double_description.h"

#include "motion/solid_cone.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

void tp_description_clear(tp_description *d) {
  for (long k = 0; k < d->room; k++) tp_vector_clear(&d->rays[k].twist);
  tp_vector_clear(&d->line);
  free(d->rays);
  free(d->next);
  memset(d, 0, sizeof *d);
}

/* All of the room stays initialised. */
static bool make_room(tp_description *d, long room) {
  d->rays = calloc((size_t)room, sizeof *d->rays);
  if (d->rays == NULL) return false;
  for (long k = 0; k < room; k++) tp_vector_init(&d->rays[k].twist);
  d->room = room;
  return true;
}

/* What is at work. */
typedef struct cutting {
  tp_description *d;
  const tp_normals *n;
  int signs[2];   /* of h . a, ray by ray */
  tp_vector h[2]; /* at work */
} cutting;

static const tp_vector *h_of(cutting *c, int which, long normal) {
  tp_normals_set_h(c->h + which, c->n, normal);
  return c->h + which;
}

static int sign_of(const cutting *c, const arb_t ball, const tp_vector *a, const tp_vector *b) {
  return tp_vector_judge(&c->n->judge, ball, a, b);
}

static int dot_sign(const cutting *c, const tp_vector *a, const tp_vector *b) {
  arb_t dot;
  arb_init(dot);
  tp_vector_dot(dot, a, b, c->n->judge.precision);
  const int sign = sign_of(c, dot, a, b);
  arb_clear(dot);
  return sign;
}

/* ray = +- a x b, to that side of `above`; false where the side is open. */
static bool set_ray(const cutting *c, tp_described_ray *ray, const tp_vector *a, const tp_vector *b,
                    const tp_vector *above, long normal) {
  tp_vector_cross(&ray->twist, a, b, c->n->judge.precision);
  const int side = dot_sign(c, &ray->twist, above);
  if (side != 1 && side != -1) return false;
  if (side < 0) tp_vector_neg(&ray->twist);
  ray->normal = normal;
  tp_normals_near(ray->near, &ray->twist);
  return true;
}

/* Between a ray with h . a > 0 and one with h . b < 0: (h . a) b - (h . b) a points along it. */
static void set_between(tp_vector *between, const cutting *c, const tp_vector *a,
                        const tp_vector *b, const tp_vector *h) {
  const long bits = c->n->judge.precision;
  arb_t of_a, of_b;
  arb_init(of_a);
  arb_init(of_b);
  tp_vector_dot(of_a, h, a, bits);
  tp_vector_dot(of_b, h, b, bits);
  for (int k = 0; k < 3; k++) {
    arb_mul(between->of + k, b->of + k, of_a, bits);
    arb_submul(between->of + k, a->of + k, of_b, bits);
  }
  arb_clear(of_a);
  arb_clear(of_b);
}

/* Where the plane of h crosses that of `plane` between two rays. */
static bool cross_face(cutting *c, tp_described_ray *ray, const tp_vector *plane,
                       const tp_vector *a, const tp_vector *b, long by, long normal) {
  const tp_vector *h = h_of(c, 1, by);
  tp_vector between;
  tp_vector_init(&between);
  set_between(&between, c, a, b, h);
  const bool done = set_ray(c, ray, plane, h, &between, normal);
  tp_vector_clear(&between);
  return done;
}

static void move_ray(tp_description *d, long to, long from) {
  if (to == from) return;
  const tp_described_ray spare = d->rays[to];
  d->rays[to] = d->rays[from];
  d->rays[from] = spare;
}

/* A cone of two dimensions in a plane, or of one: what is below is cut off. */
static tp_motion_outcome cut_flat(cutting *c, long by) {
  tp_description *d = c->d;
  if (d->count == 2 && c->signs[0] * c->signs[1] < 0) {
    const int below = c->signs[0] < 0 ? 0 : 1;
    const tp_vector *plane = d->rank == 2 ? &d->line : h_of(c, 0, d->rays[0].normal);
    tp_described_ray *ray = d->rays + below;
    const long normal = d->rank == 2 ? by : ray->normal;
    tp_described_ray made = {.normal = normal};
    tp_vector_init(&made.twist);
    const bool done =
        cross_face(c, &made, plane, &d->rays[1 - below].twist, &ray->twist, by, normal);
    const tp_described_ray old = *ray;
    *ray = made;
    made = old;
    tp_vector_clear(&made.twist);
    return done ? TP_MOTION_PROVEN : TP_MOTION_OPEN;
  }
  long kept = 0;
  for (long k = 0; k < d->count; k++) {
    if (c->signs[k] >= 0) move_ray(d, kept++, k);
  }
  if (kept < 2) d->flat = true;
  d->count = kept;
  return TP_MOTION_PROVEN;
}

static tp_motion_outcome cut(cutting *c, long by) {
  const tp_description *d = c->d;
  bool below = false;
  for (long k = 0; k < d->count; k++) {
    const tp_described_ray *ray = d->rays + k;
    c->signs[k] = tp_normal_sign(c->n, c->n->items + by, &ray->twist, ray->near, -1);
    if (c->signs[k] == TP_OPEN_SIGN) return TP_MOTION_OPEN;
    below = below || c->signs[k] < 0;
  }
  return below ? cut_flat(c, by) : TP_MOTION_PROVEN;
}

/* Is b along a, either way? 1, 0, or TP_OPEN_SIGN. */
static int is_along(const cutting *c, const tp_vector *a, const tp_vector *b) {
  tp_vector cross;
  tp_vector_init(&cross);
  tp_vector_cross(&cross, a, b, c->n->judge.precision);
  int along = 1;
  for (int k = 0; k < 3 && along != 0; k++) {
    const int sign = sign_of(c, cross.of + k, a, b);
    if (sign == TP_OPEN_SIGN) along = TP_OPEN_SIGN;
    if (sign == 1 || sign == -1) along = 0;
  }
  tp_vector_clear(&cross);
  return along;
}

static void bring_forward(long *normals, long to, long from) {
  const long spare = normals[to];
  normals[to] = normals[from];
  normals[from] = spare;
}

/* The normals that K begins with, as many as are independent, up to three, are brought to the
 * front; three of them turn to the left. */
static tp_motion_outcome find_first(cutting *c, long *normals, long count) {
  tp_description *d = c->d;
  d->rank = count > 0 ? 1 : 0;
  for (long k = 1; k < count && d->rank < 3; k++) {
    if (d->rank == 1) {
      const int along = is_along(c, h_of(c, 0, normals[0]), h_of(c, 1, normals[k]));
      if (along == TP_OPEN_SIGN) return TP_MOTION_OPEN;
      if (along != 0) {
        d->flat = d->flat || c->n->families[c->n->items[normals[0]].family].sense !=
                                 c->n->families[c->n->items[normals[k]].family].sense;
        continue;
      }
      bring_forward(normals, 1, k);
      tp_vector_cross(&d->line, h_of(c, 0, normals[0]), h_of(c, 1, normals[1]),
                      c->n->judge.precision);
      d->rank = 2;
    } else {
      const int side = dot_sign(c, &d->line, h_of(c, 0, normals[k]));
      if (side == TP_OPEN_SIGN) return TP_MOTION_OPEN;
      if (side == 0) continue;
      bring_forward(normals, 2, k);
      if (side < 0) bring_forward(normals, 1, 2);
      d->rank = 3;
    }
  }
  if (count > 0) d->plane = normals[0];
  return TP_MOTION_PROVEN;
}

/* The cone of two half-spaces, across its line. */
static bool begin_across(cutting *c, const long *normals) {
  tp_description *d = c->d;
  const tp_vector *a = h_of(c, 0, normals[0]), *b = h_of(c, 1, normals[1]);
  d->flat = false;
  d->count = 2;
  return set_ray(c, d->rays, a, &d->line, b, normals[0]) &&
         set_ray(c, d->rays + 1, b, &d->line, a, normals[1]);
}

static tp_motion_outcome describe_across(cutting *c, const long *normals, long count) {
  if (!make_room(c->d, 2)) return TP_MOTION_OUT_OF_MEMORY;
  tp_motion_outcome outcome = begin_across(c, normals) ? TP_MOTION_PROVEN : TP_MOTION_OPEN;
  for (long k = 2; k < count && outcome == TP_MOTION_PROVEN; k++) outcome = cut(c, normals[k]);
  return outcome;
}

/* From the face with the first line on. */
static long start_of(const tp_solid_cone *solid) {
  long start = solid->start;
  if (solid->flat) return start;
  for (long k = 0, ray = start; k < solid->count; k++, ray = solid->rays[ray].after) {
    if (solid->rays[ray].face < solid->rays[start].face) start = ray;
  }
  return start;
}

static bool take_solid(tp_description *d, tp_solid_cone *solid) {
  if (!make_room(d, solid->count + 1)) return false;
  long ray = start_of(solid);
  for (d->count = 0; d->count < solid->count; ray = solid->rays[ray].after) {
    tp_solid_ray *from = solid->rays + ray;
    tp_described_ray *own = d->rays + d->count++;
    for (int k = 0; k < 3; k++) {
      arb_swap(own->twist.of + k, from->twist.of + k);
      own->near[k] = from->near[k];
    }
    own->normal = from->face;
    own->lines = from->lines;
  }
  d->flat = solid->flat;
  if (d->flat && d->count == 2) d->rays[1].normal = d->rays[0].normal;
  if (!d->flat) {
    d->next = solid->next;
    solid->next = NULL;
  }
  return true;
}

static tp_motion_outcome describe_pointed(cutting *c, const long *normals, long count,
                                          tp_work *work) {
  tp_solid_cone solid;
  tp_motion_outcome outcome = tp_solid_cone_init(&solid, c->n, normals, count, work);
  if (outcome != TP_MOTION_PROVEN) return outcome;
  if (!take_solid(c->d, &solid)) outcome = TP_MOTION_OUT_OF_MEMORY;
  tp_solid_cone_clear(&solid);
  for (long k = 0; k < count && outcome == TP_MOTION_PROVEN && c->d->flat; k++) {
    outcome = cut(c, normals[k]);
  }
  return outcome;
}

/* The first and the last line of every family, in an order like a random one, the same each time.
 */
static long gather(long *normals, const tp_normals *n) {
  long count = 0;
  for (long k = 0; k < n->family_count; k++) {
    const tp_contact_family *own = n->families + k;
    normals[count++] = own->first;
    if (own->count > 1) normals[count++] = own->first + own->count - 1;
  }
  uint64_t state = 1;
  for (long k = count - 1; k > 0; k--) {
    state = state * 6364136223846793005U + 1442695040888963407U; /* Knuth's MMIX */
    bring_forward(normals, k, (long)((state >> 33) % (uint64_t)(k + 1)));
  }
  return count;
}

tp_motion_outcome tp_description_init(tp_description *d, const tp_normals *n, tp_work *work) {
  memset(d, 0, sizeof *d);
  tp_vector_init(&d->line);
  cutting c = {.d = d, .n = n};
  for (int k = 0; k < 2; k++) tp_vector_init(c.h + k);
  long *normals = calloc(2 * (size_t)n->family_count + 1, sizeof *normals);
  tp_motion_outcome outcome = TP_MOTION_OUT_OF_MEMORY;
  if (normals != NULL) {
    const long count = gather(normals, n);
    outcome = find_first(&c, normals, count);
    if (outcome == TP_MOTION_PROVEN && d->rank == 2) outcome = describe_across(&c, normals, count);
    if (outcome == TP_MOTION_PROVEN && d->rank == 3) {
      outcome = describe_pointed(&c, normals, count, work);
    }
  }
  free(normals);
  for (int k = 0; k < 2; k++) tp_vector_clear(c.h + k);
  if (outcome != TP_MOTION_PROVEN) tp_description_clear(d);
  return outcome;
}
