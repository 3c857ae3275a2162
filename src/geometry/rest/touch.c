/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Set of touches in a hash table, and the exact signs of first and second derivatives that decide
 * whether a touch stops a turn. */

#include "rest/touch.h"

#include "common/grow.h"
#include "common/message.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

void tp_touches_clear(tp_touches *touches) {
  free(touches->items);
  free(touches->slots);
  *touches = (tp_touches){0};
}

/* Does a vertex of one body lie in one of the other? */
static bool same_point(const tp_bodies *bodies, bool of_base, long vertex, long other) {
  const tp_exact_point p = tp_bodies_point(bodies, of_base, vertex);
  const tp_exact_point q = tp_bodies_point(bodies, !of_base, other);
  return fmpq_equal(&p.x, &q.x) && fmpq_equal(&p.y, &q.y);
}

static bool is_same(const tp_touch *a, const tp_touch *b) {
  return a->block == b->block && a->base == b->base && a->on_block_edge == b->on_block_edge &&
         a->on_base_edge == b->on_base_edge;
}

/* ---- each once ---------------------------------------------------------------------------------
 * A block may touch in 100 000 points: a table of those noted finds the ones that come again. Who
 * shortens the list makes the table anew. */

static size_t hash_of(const tp_touch *touch) {
  const uint64_t spread = UINT64_C(0x9e3779b97f4a7c15);
  const uint64_t kinds = (uint64_t)touch->on_block_edge * 2 + (uint64_t)touch->on_base_edge;
  uint64_t hash = ((uint64_t)touch->block * spread) ^ (uint64_t)touch->base;
  hash = (hash * spread) ^ kinds;
  return (size_t)(hash * spread >> 16);
}

/* The place of a touch in the table, or the free one where it belongs. */
static long *slot_of(const tp_touches *touches, const tp_touch *touch) {
  const size_t mask = (size_t)touches->slot_count - 1;
  size_t k = hash_of(touch) & mask;
  while (touches->slots[k] != 0 && !is_same(touches->items + touches->slots[k] - 1, touch)) {
    k = (k + 1) & mask;
  }
  return touches->slots + k;
}

/* At least twice as many places as items, with one more. */
static bool list_all(tp_touches *touches) {
  enum { LEAST = 16 };
  if (touches->listed == touches->count && 2 * (touches->count + 1) <= touches->slot_count) {
    return true;
  }
  long room = touches->slot_count > 0 ? touches->slot_count : LEAST;
  while (room < 2 * (touches->count + 1)) room *= 2;
  if (room != touches->slot_count) {
    long *slots = realloc(touches->slots, (size_t)room * sizeof *slots);
    if (slots == NULL) return false;
    touches->slots = slots;
    touches->slot_count = room;
  }
  memset(touches->slots, 0, (size_t)room * sizeof *touches->slots);
  for (long k = 0; k < touches->count; k++) *slot_of(touches, touches->items + k) = k + 1;
  touches->listed = touches->count;
  return true;
}

tp_status tp_touches_add(tp_touches *touches, const tp_bodies *bodies, bool of_base, long vertex,
                         long edge, tp_message *message) {
  const long next = tp_body_next(tp_bodies_ring(bodies, !of_base), edge);
  bool on_edge = true;
  if (same_point(bodies, of_base, vertex, edge)) {
    on_edge = false;
  } else if (same_point(bodies, of_base, vertex, next)) {
    edge = next;
    on_edge = false;
  }
  const tp_touch touch =
      of_base ? (tp_touch){edge, vertex, on_edge, false} : (tp_touch){vertex, edge, false, on_edge};
  if (!list_all(touches)) return tp_fail_memory(message, "the points of contact");
  long *slot = slot_of(touches, &touch);
  if (*slot != 0) return TP_OK;
  tp_touch *room = tp_grow(touches->items, touches->count, &touches->capacity, sizeof *room);
  if (room == NULL) return tp_fail_memory(message, "the points of contact");
  touches->items = room;
  touches->items[touches->count++] = touch;
  *slot = touches->listed = touches->count;
  return TP_OK;
}

static long vertex_of(const tp_touch *touch) {
  return touch->on_block_edge ? touch->base : touch->block;
}

tp_exact_point tp_touch_point(const tp_bodies *bodies, const tp_touch *touch) {
  return tp_bodies_point(bodies, touch->on_block_edge, vertex_of(touch));
}

const fmpq *tp_touch_x(const tp_bodies *bodies, const tp_touch *touch) {
  return tp_bodies_x(bodies, touch->on_block_edge, vertex_of(touch));
}

const fmpq *tp_touch_y(const tp_bodies *bodies, const tp_touch *touch) {
  return tp_bodies_y(bodies, touch->on_block_edge, vertex_of(touch));
}

/* Work space of the predicates. */
typedef struct numbers {
  fmpq_t rx, ry, dx, dy, product;
} numbers;

static void numbers_init(numbers *n) {
  fmpq_init(n->rx);
  fmpq_init(n->ry);
  fmpq_init(n->dx);
  fmpq_init(n->dy);
  fmpq_init(n->product);
}

static void numbers_clear(numbers *n) {
  fmpq_clear(n->rx);
  fmpq_clear(n->ry);
  fmpq_clear(n->dx);
  fmpq_clear(n->dy);
  fmpq_clear(n->product);
}

static void set_edge(numbers *n, const tp_bodies *bodies, bool of_base, long edge) {
  const tp_exact_point from = tp_bodies_point(bodies, of_base, edge);
  const tp_exact_point to =
      tp_bodies_point(bodies, of_base, tp_body_next(tp_bodies_ring(bodies, of_base), edge));
  fmpq_sub(n->dx, &to.x, &from.x);
  fmpq_sub(n->dy, &to.y, &from.y);
}

/* With d the direction of the edge its outward normal is n = (d_y, -d_x), n . r = -d x r and
 * n . r' = -d . r. */
static bool presses(numbers *n, const tp_bodies *bodies, bool of_block, long edge, int turn) {
  set_edge(n, bodies, !of_block, edge);
  fmpq_mul(n->product, n->dx, n->rx);
  fmpq_addmul(n->product, n->dy, n->ry);
  const int along = fmpq_sgn(n->product) * (of_block ? -turn : turn);
  if (along != 0) return along > 0;
  fmpq_mul(n->product, n->dx, n->ry);
  fmpq_submul(n->product, n->dy, n->rx);
  return fmpq_sgn(n->product) < 0;
}

/* 1 where the boundary turns to the left in the vertex, 0 where it goes straight on. */
static int corner_turn(const tp_bodies *bodies, bool of_base, long k) {
  const tp_body *ring = tp_bodies_ring(bodies, of_base);
  const tp_exact_point before = tp_bodies_point(bodies, of_base, tp_body_before(ring, k));
  const tp_exact_point corner = tp_bodies_point(bodies, of_base, k);
  const tp_exact_point next = tp_bodies_point(bodies, of_base, tp_body_next(ring, k));
  return tp_points_turn(&before.x, &before.y, &corner.x, &corner.y, &next.x, &next.y);
}

/* Sign of the side on which a neighbour of vertex `k` lies of the edge, an edge that begins or ends
 * in the point of `k`: 1 inside. */
static int side_of(numbers *n, const tp_bodies *bodies, bool of_base, long k, long neighbour) {
  const tp_exact_point from = tp_bodies_point(bodies, of_base, k);
  const tp_exact_point to = tp_bodies_point(bodies, of_base, neighbour);
  fmpq_t x, y;
  fmpq_init(x);
  fmpq_init(y);
  fmpq_sub(x, &to.x, &from.x);
  fmpq_sub(y, &to.y, &from.y);
  fmpq_mul(n->product, n->dx, y);
  fmpq_submul(n->product, n->dy, x);
  fmpq_clear(x);
  fmpq_clear(y);
  return fmpq_sgn(n->product);
}

/* Does the line of an edge part the corners: its own on its inside, the other on the outside? */
static bool parts(numbers *n, const tp_bodies *bodies, bool of_block, long edge,
                  const tp_touch *touch) {
  const tp_body *own = tp_bodies_ring(bodies, !of_block);
  const tp_body *other = tp_bodies_ring(bodies, of_block);
  const long k = of_block ? touch->block : touch->base, l = of_block ? touch->base : touch->block;
  set_edge(n, bodies, !of_block, edge);
  return side_of(n, bodies, !of_block, k, tp_body_before(own, k)) >= 0 &&
         side_of(n, bodies, !of_block, k, tp_body_next(own, k)) >= 0 &&
         side_of(n, bodies, of_block, l, tp_body_before(other, l)) <= 0 &&
         side_of(n, bodies, of_block, l, tp_body_next(other, l)) <= 0;
}

static bool corners_stop(numbers *n, const tp_bodies *bodies, const tp_touch *touch, int turn) {
  const bool notch_of_block = corner_turn(bodies, false, touch->block) < 0;
  const bool notch_of_base = corner_turn(bodies, true, touch->base) < 0;
  const long edges[2][2] = {{tp_body_before(&bodies->base, touch->base), touch->base},
                            {tp_body_before(&bodies->posed, touch->block), touch->block}};
  if (notch_of_block || notch_of_base) {
    const long *notch = edges[notch_of_block ? 1 : 0];
    return presses(n, bodies, notch_of_block, notch[0], turn) ||
           presses(n, bodies, notch_of_block, notch[1], turn);
  }
  bool stops = true;
  for (int body = 0; body < 2 && stops; body++) {
    for (int k = 0; k < 2 && stops; k++) {
      stops = !parts(n, bodies, body == 1, edges[body][k], touch) ||
              presses(n, bodies, body == 1, edges[body][k], turn);
    }
  }
  return stops;
}

/* From one touch to another in doubles: each off by bodies->error at most. */
static void set_arm(double *u, double *v, const tp_bodies *bodies, const tp_touch *touch,
                    const tp_touch *about) {
  const tp_touch *const both[2] = {touch, about};
  double at_u[2], at_v[2];
  for (int k = 0; k < 2; k++) {
    const tp_body *ring = tp_bodies_ring(bodies, both[k]->on_block_edge);
    at_u[k] = ring->u[vertex_of(both[k])];
    at_v[k] = ring->v[vertex_of(both[k])];
  }
  *u = at_u[0] - at_u[1];
  *v = at_v[0] - at_v[1];
}

bool tp_touch_is_in(const tp_bodies *bodies, const tp_touch *touch, const tp_touch *other) {
  double u, v;
  if (is_same(touch, other)) return true;
  set_arm(&u, &v, bodies, touch, other);
  if (fabs(u) > bodies->error || fabs(v) > bodies->error) return false;
  const tp_exact_point p = tp_touch_point(bodies, touch), q = tp_touch_point(bodies, other);
  return fmpq_equal(&p.x, &q.x) && fmpq_equal(&p.y, &q.y);
}

/* The first order of `presses` in doubles, for a vertex on an edge: 1 presses, -1 does not, 0
 * open. The product is off by 2 error (|d| + |r|) at most (rest/turning_candidates.c). */
static int presses_by_far(const tp_bodies *bodies, const tp_touch *touch, const tp_touch *about,
                          int turn) {
  const bool of_block = touch->on_block_edge;
  if (!of_block && !touch->on_base_edge) return 0;
  const tp_body *ring = tp_bodies_ring(bodies, !of_block);
  const long edge = of_block ? touch->block : touch->base, next = tp_body_next(ring, edge);
  const double du = ring->u[next] - ring->u[edge], dv = ring->v[next] - ring->v[edge];
  double ru, rv;
  set_arm(&ru, &rv, bodies, touch, about);
  const double along = (du * ru + dv * rv) * (of_block ? -turn : turn);
  const double bound = 4 * bodies->error * (fabs(du) + fabs(dv) + fabs(ru) + fabs(rv));
  return along > bound ? 1 : along < -bound ? -1 : 0;
}

bool tp_touch_stops(const tp_bodies *bodies, const tp_touch *touch, const tp_touch *about,
                    int turn) {
  const int by_far = presses_by_far(bodies, touch, about, turn);
  if (by_far != 0) return by_far > 0;
  if (tp_touch_is_in(bodies, touch, about)) return false;
  const tp_exact_point point = tp_touch_point(bodies, touch);
  const tp_exact_point pivot = tp_touch_point(bodies, about);
  numbers n;
  numbers_init(&n);
  fmpq_sub(n.rx, &point.x, &pivot.x);
  fmpq_sub(n.ry, &point.y, &pivot.y);
  bool stops = false;
  if (touch->on_base_edge) {
    stops = presses(&n, bodies, false, touch->base, turn);
  } else if (touch->on_block_edge) {
    stops = presses(&n, bodies, true, touch->block, turn);
  } else {
    stops = corners_stop(&n, bodies, touch, turn);
  }
  numbers_clear(&n);
  return stops;
}
