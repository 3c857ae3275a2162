/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Heights of vertices over edges in doubles with a bound, then the exact least of the remaining
 * pairs, and the pairs that touch after the fall. */

#include "rest/drop.h"

#include "common/message.h"

#include <math.h>

typedef struct drop {
  const tp_bodies *bodies;
  tp_candidates *candidates;
  double error; /* of differences of coordinates */
} drop;

/* The height between a vertex and an edge above or below it, by doubles: with the slope s of the
 * edge its error is at most (2 + 2 |s|) of a coordinate's, and that of s itself, which the whole of
 * the edge bounds. An edge too short or upright for that is left to the exact stage. */
static bool note_pair(const drop *d, bool of_base, long vertex, long edge) {
  const tp_body *one = tp_bodies_ring(d->bodies, of_base);
  const tp_body *other = tp_bodies_ring(d->bodies, !of_base);
  const long next = tp_body_next(other, edge);
  const double width = fabs(other->u[next] - other->u[edge]), e = d->error;
  const double x = one->u[vertex];
  const double left = fmin(other->u[next], other->u[edge]);
  const double right = fmax(other->u[next], other->u[edge]);
  if (x < left - e || x > right + e) return true;
  tp_candidate candidate = {of_base, vertex, edge, -INFINITY, INFINITY, false};
  if (!(width > 8 * e)) return tp_candidates_note(d->candidates, candidate);
  const double rise = other->v[next] - other->v[edge];
  const double share = (x - other->u[edge]) / (other->u[next] - other->u[edge]);
  const double line = other->v[edge] + share * rise;
  const double gap = of_base ? line - one->v[vertex] : one->v[vertex] - line;
  const double bound = 8 * e * (1 + fabs(rise) / width);
  candidate.low = gap - bound;
  candidate.high = gap + bound;
  candidate.certain = x > left + e && x < right - e;
  return tp_candidates_note(d->candidates, candidate);
}

static bool note_all(const drop *d) {
  const tp_bodies *b = d->bodies;
  const tp_body *block = &b->posed;
  bool done = true;
  for (long k = 0; k < block->count && done; k++) {
    long first, last;
    tp_candidates_reach(&first, &last, b, block->u[k] - d->error, block->u[k] + d->error);
    for (long edge = first; edge < last && done; edge++) done = note_pair(d, false, k, edge);
  }
  for (long k = 0; k < block->count && done; k++) { /* the underside's edges run to the right */
    const double from = block->u[k], to = block->u[tp_body_next(block, k)];
    if (to < from - d->error) continue;
    long first, last;
    tp_candidates_reach(&first, &last, b, from - d->error, to + d->error);
    for (long vertex = first; vertex <= last && done; vertex++)
      done = note_pair(d, true, vertex, k);
  }
  return done;
}

/* The height of a pair, exactly; false where the vertex is not over the edge, or the edge stands
 * upright or belongs to the upper side of the block. */
static bool height_of(fmpq_t height, const tp_bodies *b, const tp_candidate *c) {
  const tp_body *ring = tp_bodies_ring(b, !c->of_base);
  const tp_exact_point p = tp_bodies_point(b, c->of_base, c->vertex);
  const tp_exact_point from = tp_bodies_point(b, !c->of_base, c->edge);
  const tp_exact_point to = tp_bodies_point(b, !c->of_base, tp_body_next(ring, c->edge));
  const int way = fmpq_cmp(&to.x, &from.x);
  if (c->of_base ? way <= 0 : way >= 0) return false;
  const fmpq *left = c->of_base ? &from.x : &to.x, *right = c->of_base ? &to.x : &from.x;
  if (fmpq_cmp(&p.x, left) < 0 || fmpq_cmp(&p.x, right) > 0) return false;
  fmpq_t part;
  fmpq_init(part);
  fmpq_sub(height, &to.y, &from.y);
  fmpq_sub(part, &p.x, &from.x);
  fmpq_mul(height, height, part);
  fmpq_sub(part, &to.x, &from.x);
  fmpq_div(height, height, part);
  fmpq_add(height, height, &from.y);
  fmpq_sub(height, &p.y, height);
  if (c->of_base) fmpq_neg(height, height);
  fmpq_clear(part);
  return true;
}

/* The least height; false where the block stands beside its base. */
static bool least_height(fmpq_t least, const drop *d) {
  fmpq_t height;
  fmpq_init(height);
  bool over = false;
  for (long k = 0; k < d->candidates->count; k++) {
    if (!height_of(height, d->bodies, d->candidates->items + k)) continue;
    if (!over || fmpq_cmp(height, least) < 0) fmpq_set(least, height);
    over = true;
  }
  fmpq_clear(height);
  return over;
}

/* The pairs that touch, once the block has fallen. */
static tp_status note_touches(tp_touches *touches, const drop *d, tp_message *message) {
  fmpq_t height;
  fmpq_init(height);
  tp_status status = TP_OK;
  for (long k = 0; k < d->candidates->count && status == TP_OK; k++) {
    const tp_candidate *c = d->candidates->items + k;
    if (!height_of(height, d->bodies, c) || !fmpq_is_zero(height)) continue;
    status = tp_touches_add(touches, d->bodies, c->of_base, c->vertex, c->edge, message);
  }
  fmpq_clear(height);
  return status;
}

tp_status tp_drop(fmpq_t height, bool *beside, tp_candidates *pairs, tp_bodies *bodies,
                  tp_touches *touches, tp_message *message) {
  const drop d = {.bodies = bodies, .candidates = pairs, .error = bodies->error};
  tp_status status = TP_OK;
  pairs->best = INFINITY;
  if (!note_all(&d)) status = tp_fail_memory(message, "the points of contact");
  tp_candidates_settle(pairs);
  if (status == TP_OK) *beside = !least_height(height, &d);
  if (status == TP_OK && !*beside) {
    fmpq_sub(bodies->pose.shift_y, bodies->pose.shift_y, height);
    tp_bodies_place(bodies);
    status = note_touches(touches, &d, message);
  }
  return status;
}
