/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "motion/double_description.h"

#include <stdlib.h>
#include <string.h>

enum { OPEN_SIGN = 2 };

void tp_description_clear(tp_description *d) {
  for (long k = 0; k < d->room; k++) tp_vector_clear(&d->rays[k].twist);
  tp_vector_clear(&d->line);
  free(d->rays);
  memset(d, 0, sizeof *d);
}

/* Rays come and go by swaps, so that all of the room stays initialised. */
static bool make_room(tp_description *d, long room) {
  if (room <= d->room) return true;
  room += room / 2;
  tp_described_ray *more = realloc(d->rays, (size_t)room * sizeof *more);
  if (more == NULL) return false;
  for (long k = d->room; k < room; k++) tp_vector_init(&more[k].twist);
  d->rays = more;
  d->room = room;
  return true;
}

/* What is at work. */
typedef struct cutting {
  tp_description *d;
  const tp_normals *n;
  int *signs; /* of h . a, ray by ray */
  long sign_room;
  double checks; /* since they were last counted as work */
  tp_work *work;
} cutting;

static const tp_vector *h_of(const cutting *c, long normal) {
  return &c->n->items[normal].h;
}

static int sign_of(const cutting *c, const arb_t ball, const tp_vector *a, const tp_vector *b) {
  return tp_judge_sign(&c->n->judge, ball, tp_vector_log2_size(a) + tp_vector_log2_size(b));
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
static bool cross_face(const cutting *c, tp_described_ray *ray, const tp_vector *plane,
                       const tp_vector *a, const tp_vector *b, long by, long normal) {
  tp_vector between;
  tp_vector_init(&between);
  set_between(&between, c, a, b, h_of(c, by));
  const bool done = set_ray(c, ray, plane, h_of(c, by), &between, normal);
  tp_vector_clear(&between);
  return done;
}

static void move_ray(tp_description *d, long to, long from) {
  if (to == from) return;
  const tp_described_ray spare = d->rays[to];
  d->rays[to] = d->rays[from];
  d->rays[from] = spare;
}

/* No ray is above the plane: K shrinks to what lies in it. */
static void keep_zeros(cutting *c) {
  tp_description *d = c->d;
  long zeros[2] = {-1, -1}, count = 0;
  for (long k = 0; k < d->count && count < 2; k++) {
    if (c->signs[k] == 0) zeros[count++] = k;
  }
  if (count == 2 && zeros[0] == 0 && zeros[1] == d->count - 1 && d->count > 2) {
    const long normal = d->rays[d->count - 1].normal; /* the last face leads on to the first ray */
    move_ray(d, 1, d->count - 1);
    d->rays[0].normal = d->rays[1].normal = normal;
  } else {
    for (long k = 0; k < count; k++) move_ray(d, k, zeros[k]);
    if (count == 2) d->rays[1].normal = d->rays[0].normal;
  }
  d->count = count;
  d->flat = true;
}

/* A cone of three dimensions, cut by a plane with rays on both sides: those above it stay, in their
 * order, with one new ray for each face that it crosses. */
static tp_motion_outcome cut_solid(cutting *c, long by) {
  tp_description *d = c->d;
  const long count = d->count;
  if (!make_room(d, 2 * count + 4)) return TP_MOTION_OUT_OF_MEMORY;
  long next = count; /* the new order is put together behind the old one */
  for (long k = 0; k < count; k++) {
    const long after = (k + 1) % count;
    tp_described_ray *own = d->rays + k, *other = d->rays + after;
    const int sign = c->signs[k], then = c->signs[after];
    const long face = own->normal;
    if (sign * then < 0) {
      const bool down = sign > 0;
      const tp_vector *above = down ? &own->twist : &other->twist;
      const tp_vector *below = down ? &other->twist : &own->twist;
      tp_described_ray *made = d->rays + next + (down ? 1 : 0);
      if (!cross_face(c, made, h_of(c, face), above, below, by, down ? by : face)) {
        return TP_MOTION_OPEN;
      }
    }
    if (sign >= 0) {
      const bool leaves = sign == 0 && then < 0;
      for (int e = 0; e < 3; e++) { /* `other` may still need it as its neighbour */
        arb_set(d->rays[next].twist.of + e, own->twist.of + e);
        d->rays[next].near[e] = own->near[e];
      }
      d->rays[next].normal = leaves ? by : face;
      next++;
    }
    if (sign * then < 0) next++;
  }
  for (long k = count; k < next; k++) move_ray(d, k - count, k);
  d->count = next - count;
  return TP_MOTION_PROVEN;
}

/* A cone of two dimensions in a plane, or of one: what is below is cut off. */
static tp_motion_outcome cut_flat(cutting *c, long by) {
  tp_description *d = c->d;
  if (d->count == 2 && c->signs[0] * c->signs[1] < 0) {
    const int below = c->signs[0] < 0 ? 0 : 1;
    const tp_vector *plane = d->rank == 2 ? &d->line : h_of(c, d->rays[0].normal);
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

static bool pay(cutting *c, double checks) {
  static const double at_once = 1e6, by_column = 0.1; /* of the price of a column */
  c->checks += checks;
  if (c->checks < at_once) return true;
  const long columns = (long)(c->checks * by_column);
  c->checks = 0;
  return tp_work_spend(c->work, 1, columns, 1);
}

static tp_motion_outcome cut(cutting *c, long by) {
  tp_description *d = c->d;
  if (!pay(c, (double)d->count + 1)) return TP_MOTION_TOO_DEAR;
  if (d->count > c->sign_room) {
    const long room = 2 * d->count;
    int *more = realloc(c->signs, (size_t)room * sizeof *more);
    if (more == NULL) return TP_MOTION_OUT_OF_MEMORY;
    c->signs = more;
    c->sign_room = room;
  }
  long above = 0, below = 0;
  for (long k = 0; k < d->count; k++) {
    const tp_described_ray *ray = d->rays + k;
    c->signs[k] = tp_normal_sign(c->n, c->n->items + by, &ray->twist, ray->near, -1);
    if (c->signs[k] == OPEN_SIGN) return TP_MOTION_OPEN;
    above += c->signs[k] > 0;
    below += c->signs[k] < 0;
  }
  if (below == 0) return TP_MOTION_PROVEN;
  if (d->rank == 2 || d->flat) return cut_flat(c, by);
  if (above > 0) return cut_solid(c, by);
  keep_zeros(c);
  return TP_MOTION_PROVEN;
}

/* Is b along a, either way? 1, 0, or OPEN_SIGN. */
static int is_along(const cutting *c, const tp_vector *a, const tp_vector *b) {
  tp_vector cross;
  tp_vector_init(&cross);
  tp_vector_cross(&cross, a, b, c->n->judge.precision);
  int along = 1;
  for (int k = 0; k < 3 && along != 0; k++) {
    const int sign = sign_of(c, cross.of + k, a, b);
    if (sign == OPEN_SIGN) along = OPEN_SIGN;
    if (sign == 1 || sign == -1) along = 0;
  }
  tp_vector_clear(&cross);
  return along;
}

/* The normals that K begins with: as many as are independent, up to three. */
static tp_motion_outcome find_first(cutting *c, long first[3], const long *normals, long count) {
  tp_description *d = c->d;
  d->rank = count > 0 ? 1 : 0;
  first[0] = count > 0 ? normals[0] : -1;
  for (long k = 1; k < count && d->rank < 3; k++) {
    if (d->rank == 1) {
      const int along = is_along(c, h_of(c, first[0]), h_of(c, normals[k]));
      if (along == OPEN_SIGN) return TP_MOTION_OPEN;
      if (along != 0) {
        d->flat = d->flat || c->n->families[c->n->items[first[0]].family].sense !=
                                 c->n->families[c->n->items[normals[k]].family].sense;
        continue;
      }
      first[1] = normals[k];
      tp_vector_cross(&d->line, h_of(c, first[0]), h_of(c, first[1]), c->n->judge.precision);
      d->rank = 2;
    } else {
      const int side = dot_sign(c, &d->line, h_of(c, normals[k]));
      if (side == OPEN_SIGN) return TP_MOTION_OPEN;
      if (side == 0) continue;
      first[2] = normals[k];
      d->rank = 3;
    }
  }
  d->plane = first[0];
  return TP_MOTION_PROVEN;
}

/* The cone of two or of three half-spaces. */
static bool begin(cutting *c, const long first[3]) {
  tp_description *d = c->d;
  if (d->rank < 2) return true;
  d->flat = false;
  d->count = d->rank;
  const tp_vector *h[3];
  for (int k = 0; k < d->rank; k++) h[k] = h_of(c, first[k]);
  if (d->rank == 2) {
    return set_ray(c, d->rays, h[0], &d->line, h[1], first[0]) &&
           set_ray(c, d->rays + 1, h[1], &d->line, h[0], first[1]);
  }
  for (int k = 0; k < 3; k++) { /* ray k lies on planes k - 1 and k: the face after it on plane k */
    const int before = (k + 2) % 3, other = (k + 1) % 3;
    if (!set_ray(c, d->rays + k, h[before], h[k], h[other], first[k])) return false;
  }
  return true;
}

/* The first and the last line of every family, in an order that is no order of theirs, so that K is
 * small soon. */
static long gather(long *normals, const tp_normals *n) {
  enum { STRIDE = 7919 }; /* a prime */
  const long families = n->family_count;
  long count = 0;
  for (long k = 0; k < families; k++) {
    const long at = families % STRIDE == 0 ? k : (long)((size_t)k * STRIDE % (size_t)families);
    const tp_contact_family *own = n->families + at;
    normals[count++] = own->first;
    if (own->count > 1) normals[count++] = own->first + own->count - 1;
  }
  return count;
}

tp_motion_outcome tp_description_init(tp_description *d, const tp_normals *n, tp_work *work) {
  memset(d, 0, sizeof *d);
  tp_vector_init(&d->line);
  cutting c = {.d = d, .n = n, .work = work};
  long *normals = calloc(2 * (size_t)n->family_count + 1, sizeof *normals);
  tp_motion_outcome outcome = TP_MOTION_OUT_OF_MEMORY;
  if (normals != NULL && make_room(d, 4)) {
    const long count = gather(normals, n);
    long first[3] = {-1, -1, -1};
    outcome = find_first(&c, first, normals, count);
    if (outcome == TP_MOTION_PROVEN && !begin(&c, first)) outcome = TP_MOTION_OPEN;
    for (long k = 0; k < count && outcome == TP_MOTION_PROVEN && d->rank > 1; k++) {
      outcome = cut(&c, normals[k]);
    }
  }
  free(normals);
  free(c.signs);
  if (outcome != TP_MOTION_PROVEN) tp_description_clear(d);
  return outcome;
}
