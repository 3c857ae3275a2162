/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The pose after a turn. Where t is rational it is exact. Where the line passes through P the block
 * takes the line's direction, exactly, and its lengths those of a root that is cut off. Else t is
 * rounded, and one factor k near 1 on the block's lengths, measured from P, brings the pair
 * together: k (V - P) x e = (E - P) x e, or of a vertex of the base (V - P) x e = k (E - P) x e. P
 * stays in its place in each. */

#include "rest/turning.h"

#include "number/divide.h"

#include <arb.h>
#include <math.h>

/* t to so many bits: TP_POSE_BITS of them stay after the pose is shortened. */
enum { ROOT_BITS = TP_POSE_BITS + 128 };

static bool rational_root(fmpq_t t, const tp_turning *turning) {
  const fmpz *top = fmpq_numref(turning->radicand), *bottom = fmpq_denref(turning->radicand);
  if (!fmpz_is_square(top) || !fmpz_is_square(bottom)) return false;
  fmpz_t p, q;
  fmpz_init(p);
  fmpz_init(q);
  fmpz_sqrt(p, top);
  fmpz_sqrt(q, bottom);
  fmpq_set_fmpz_frac(t, p, q);
  fmpq_add(t, t, turning->top);
  fmpq_div(t, t, turning->bottom);
  if (turning->turn < 0) fmpq_neg(t, t);
  fmpz_clear(p);
  fmpz_clear(q);
  return true;
}

static void rounded_root(fmpq_t t, const tp_turning *turning) {
  arb_t root, part;
  arb_init(root);
  arb_init(part);
  arb_set_fmpq(root, turning->radicand, 2 * ROOT_BITS);
  arb_sqrt(root, root, 2 * ROOT_BITS);
  arb_set_fmpq(part, turning->top, 2 * ROOT_BITS);
  arb_add(root, root, part, 2 * ROOT_BITS);
  arb_set_fmpq(part, turning->bottom, 2 * ROOT_BITS);
  arb_div(root, root, part, ROOT_BITS);
  arf_get_fmpq(t, arb_midref(root));
  if (turning->turn < 0) fmpq_neg(t, t);
  arb_clear(root);
  arb_clear(part);
}

/* Does the vertex lie behind the edge (-1), on it (0), or beside or before it? */
static int side_of(const tp_turning_pair *p) {
  fmpq_t height, base, place;
  fmpq_init(height);
  fmpq_init(base);
  fmpq_init(place);
  tp_exact_cross(height, &p->vertex, &p->along);
  tp_exact_cross(base, &p->edge, &p->along);
  const int side = fmpq_cmp(height, base);
  tp_exact_dot(place, &p->vertex, &p->along);
  tp_exact_dot(base, &p->edge, &p->along);
  fmpq_sub(place, place, base);
  tp_exact_dot(base, &p->along, &p->along);
  const bool beside = fmpq_sgn(place) < 0 || fmpq_cmp(place, base) > 0;
  fmpq_clear(height);
  fmpq_clear(base);
  fmpq_clear(place);
  return beside || side > 0 ? 1 : side < 0 ? -1 : 0;
}

/* Turn the block into the direction of a line through P: from r to e, or of a vertex of the base
 * from e to r, by e . r + i (r x e) or its conjugate; away from e where e . R r is below zero at
 * the root. */
static void turn_along(tp_bodies *b, const tp_candidate *pair, const tp_turning_numbers *n,
                       const fmpq_t near) {
  fmpq_t u, v, side;
  fmpq_init(u);
  fmpq_init(v);
  fmpq_init(side);
  fmpq_mul(u, near, near);
  fmpq_sub_si(u, u, 1);
  fmpq_mul(side, u, n->c);
  fmpq_abs(v, near);
  fmpq_mul_si(v, v, 2);
  fmpq_mul(v, v, n->s);
  fmpq_sub(side, v, side);
  fmpq_set(u, n->c);
  fmpq_set(v, n->a);
  if (pair->of_base) fmpq_neg(v, v);
  if (fmpq_sgn(side) < 0) {
    fmpq_neg(u, u);
    fmpq_neg(v, v);
  }
  tp_pose_turn_along(&b->pose, u, v);
  fmpq_clear(u);
  fmpq_clear(v);
  fmpq_clear(side);
}

/* Bring the pair together by the block's lengths; false: no factor does, as the vertex is on the
 * line through P along the edge. */
static bool stretch(tp_bodies *b, const tp_turning *turning, const tp_candidate *pair) {
  tp_turning_pair p;
  fmpq_t vertex, edge;
  fmpq_init(vertex);
  fmpq_init(edge);
  tp_turning_pair_init(&p, b, turning, pair);
  tp_exact_cross(vertex, &p.vertex, &p.along);
  tp_exact_cross(edge, &p.edge, &p.along);
  if (pair->of_base) fmpq_swap(vertex, edge);
  const bool possible = tp_divide(edge, edge, vertex) && fmpq_sgn(edge) > 0;
  if (possible) tp_pose_scale(&b->pose, edge);
  tp_turning_pair_clear(&p);
  fmpq_clear(vertex);
  fmpq_clear(edge);
  return possible;
}

/* Turn by the root, so that this pair touches exactly; false where no pose near it does. */
static bool turn_exactly(tp_bodies *b, const tp_turning *turning, const tp_candidate *pair) {
  tp_turning_numbers n;
  fmpq_t t;
  bool possible = true;
  tp_turning_numbers_init(&n);
  fmpq_init(t);
  tp_turning_numbers_of(&n, b, turning, pair);
  if (rational_root(t, turning)) {
    tp_pose_turn_half(&b->pose, t);
  } else {
    rounded_root(t, turning);
    if (fmpq_is_zero(n.d)) {
      turn_along(b, pair, &n, t);
    } else {
      tp_pose_turn_half(&b->pose, t);
      tp_pose_shorten(&b->pose);
      possible = stretch(b, turning, pair);
    }
  }
  tp_pose_pin(&b->pose, &turning->own.x, &turning->own.y, &turning->pivot.x, &turning->pivot.y);
  tp_bodies_place(b);
  tp_turning_numbers_clear(&n);
  fmpq_clear(t);
  return possible;
}

/* Does the vertex lie behind the edge (-1), on it (0), or beside or before it? By doubles where
 * these tell; of the pair that was brought together exactly they need not tell its height. */
static int side_of_pair(const tp_bodies *b, const tp_turning *turning, long k) {
  const tp_candidate *pair = turning->pairs.items + k;
  const tp_body *one = tp_bodies_ring(b, pair->of_base), *other = tp_bodies_ring(b, !pair->of_base);
  const long next = tp_body_next(other, pair->edge);
  const double eu = other->u[next] - other->u[pair->edge];
  const double ev = other->v[next] - other->v[pair->edge];
  const double ru = one->u[pair->vertex] - other->u[pair->edge];
  const double rv = one->v[pair->vertex] - other->v[pair->edge];
  const double bound = 8 * b->error * (fabs(eu) + fabs(ev) + fabs(ru) + fabs(rv));
  const double height = ru * ev - rv * eu, place = ru * eu + rv * ev;
  const double whole = eu * eu + ev * ev;
  if (height > bound || place < -bound || place > whole + bound) return 1;
  if (k == turning->exact && place > bound && place < whole - bound) return 0;
  tp_turning_pair p;
  tp_turning_pair_init(&p, b, turning, pair);
  const int side = side_of(&p);
  tp_turning_pair_clear(&p);
  return side;
}

static bool is_free(const tp_bodies *b, const tp_turning *turning) {
  bool free = true;
  for (long k = 0; k < turning->pairs.count && free; k++) {
    free = side_of_pair(b, turning, k) >= 0;
  }
  return free;
}

tp_status tp_turning_touches(tp_touches *touches, const tp_turning *turning,
                             const tp_bodies *bodies, tp_message *message) {
  long kept = 0;
  for (long k = 0; k < touches->count; k++) {
    const tp_touch touch = touches->items[k];
    if (tp_touch_is_in(bodies, &touch, &turning->about)) touches->items[kept++] = touch;
  }
  touches->count = kept;
  touches->listed = -1; /* its table is another's */
  tp_status status = TP_OK;
  for (long k = 0; k < turning->pairs.count && status == TP_OK; k++) {
    const tp_candidate *pair = turning->pairs.items + k;
    if (side_of_pair(bodies, turning, k) != 0) continue;
    status = tp_touches_add(touches, bodies, pair->of_base, pair->vertex, pair->edge, message);
  }
  return status;
}

bool tp_turning_do(tp_turning *turning, tp_bodies *bodies) {
  tp_pose before;
  tp_pose_init(&before);
  tp_pose_set(&before, &bodies->pose);
  bool done = false;
  for (long k = 0; k < turning->pairs.count && !done; k++) {
    if (k > 0) {
      tp_pose_set(&bodies->pose, &before);
      tp_bodies_place(bodies);
    }
    turning->exact = k;
    /* A line that passes close by P takes a long stretch to reach. */
    done = turn_exactly(bodies, turning, turning->pairs.items + k) &&
           tp_pose_is_true(&bodies->pose) && is_free(bodies, turning);
  }
  tp_pose_clear(&before);
  return done;
}
