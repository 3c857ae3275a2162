/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "rest/touch.h"

#include "grow.h"
#include "message.h"

#include <stdlib.h>

void tp_touches_clear(tp_touches *touches) {
  free(touches->items);
  *touches = (tp_touches){0};
}

static bool same_point(const tp_body *a, long i, const tp_body *b, long j) {
  return fmpq_equal(a->x + i, b->x + j) && fmpq_equal(a->y + i, b->y + j);
}

tp_status tp_touches_add(tp_touches *touches, const tp_bodies *bodies, bool of_base, long vertex,
                         long edge, tp_message *message) {
  const tp_body *one = of_base ? &bodies->base : &bodies->block;
  const tp_body *other = of_base ? &bodies->block : &bodies->base;
  bool on_edge = true;
  if (same_point(one, vertex, other, edge)) {
    on_edge = false;
  } else if (same_point(one, vertex, other, tp_body_next(other, edge))) {
    edge = tp_body_next(other, edge);
    on_edge = false;
  }
  const tp_touch touch =
      of_base ? (tp_touch){edge, vertex, on_edge, false} : (tp_touch){vertex, edge, false, on_edge};
  for (long k = 0; k < touches->count; k++) {
    const tp_touch *known = touches->items + k;
    if (known->block == touch.block && known->base == touch.base &&
        known->on_block_edge == touch.on_block_edge && known->on_base_edge == touch.on_base_edge) {
      return TP_OK;
    }
  }
  tp_touch *room = tp_grow(touches->items, touches->count, &touches->capacity, sizeof *room);
  if (room == NULL) return tp_fail_memory(message, "the points of contact");
  touches->items = room;
  touches->items[touches->count++] = touch;
  return TP_OK;
}

const fmpq *tp_touch_x(const tp_bodies *bodies, const tp_touch *touch) {
  return touch->on_block_edge ? bodies->base.x + touch->base : bodies->block.x + touch->block;
}

const fmpq *tp_touch_y(const tp_bodies *bodies, const tp_touch *touch) {
  return touch->on_block_edge ? bodies->base.y + touch->base : bodies->block.y + touch->block;
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

static void set_edge(numbers *n, const tp_body *body, long edge) {
  const long next = tp_body_next(body, edge);
  fmpq_sub(n->dx, body->x + next, body->x + edge);
  fmpq_sub(n->dy, body->y + next, body->y + edge);
}

/* With d the direction of the edge its outward normal is n = (d_y, -d_x), n . r = -d x r and
 * n . r' = -d . r. */
static bool presses(numbers *n, const tp_bodies *bodies, bool of_block, long edge, int turn) {
  set_edge(n, of_block ? &bodies->block : &bodies->base, edge);
  fmpq_mul(n->product, n->dx, n->rx);
  fmpq_addmul(n->product, n->dy, n->ry);
  const int along = fmpq_sgn(n->product) * (of_block ? -turn : turn);
  if (along != 0) return along > 0;
  fmpq_mul(n->product, n->dx, n->ry);
  fmpq_submul(n->product, n->dy, n->rx);
  return fmpq_sgn(n->product) < 0;
}

/* 1 where the boundary turns to the left in the vertex, 0 where it goes straight on. */
static int corner_turn(const tp_body *body, long k) {
  const long before = tp_body_before(body, k), next = tp_body_next(body, k);
  return tp_points_turn(body->x + before, body->y + before, body->x + k, body->y + k,
                        body->x + next, body->y + next);
}

/* Sign of the side on which a neighbour of vertex `k` lies of the edge, an edge that begins or ends
 * in the point of `k`: 1 inside. */
static int side_of(numbers *n, const tp_body *body, long k, long neighbour) {
  fmpq_t x, y;
  fmpq_init(x);
  fmpq_init(y);
  fmpq_sub(x, body->x + neighbour, body->x + k);
  fmpq_sub(y, body->y + neighbour, body->y + k);
  fmpq_mul(n->product, n->dx, y);
  fmpq_submul(n->product, n->dy, x);
  fmpq_clear(x);
  fmpq_clear(y);
  return fmpq_sgn(n->product);
}

/* Does the line of an edge part the corners: its own on its inside, the other on the outside? */
static bool parts(numbers *n, const tp_bodies *bodies, bool of_block, long edge,
                  const tp_touch *touch) {
  const tp_body *own = of_block ? &bodies->block : &bodies->base;
  const tp_body *other = of_block ? &bodies->base : &bodies->block;
  const long k = of_block ? touch->block : touch->base, l = of_block ? touch->base : touch->block;
  set_edge(n, own, edge);
  return side_of(n, own, k, tp_body_before(own, k)) >= 0 &&
         side_of(n, own, k, tp_body_next(own, k)) >= 0 &&
         side_of(n, other, l, tp_body_before(other, l)) <= 0 &&
         side_of(n, other, l, tp_body_next(other, l)) <= 0;
}

static bool corners_stop(numbers *n, const tp_bodies *bodies, const tp_touch *touch, int turn) {
  const bool notch_of_block = corner_turn(&bodies->block, touch->block) < 0;
  const bool notch_of_base = corner_turn(&bodies->base, touch->base) < 0;
  const long edges[2][2] = {{tp_body_before(&bodies->base, touch->base), touch->base},
                            {tp_body_before(&bodies->block, touch->block), touch->block}};
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

bool tp_touch_stops(const tp_bodies *bodies, const tp_touch *touch, const tp_exact_point *pivot,
                    int turn) {
  numbers n;
  numbers_init(&n);
  fmpq_sub(n.rx, tp_touch_x(bodies, touch), &pivot->x);
  fmpq_sub(n.ry, tp_touch_y(bodies, touch), &pivot->y);
  bool stops = false;
  if (fmpq_is_zero(n.rx) && fmpq_is_zero(n.ry)) {
    stops = false;
  } else if (touch->on_base_edge) {
    stops = presses(&n, bodies, false, touch->base, turn);
  } else if (touch->on_block_edge) {
    stops = presses(&n, bodies, true, touch->block, turn);
  } else {
    stops = corners_stop(&n, bodies, touch, turn);
  }
  numbers_clear(&n);
  return stops;
}
