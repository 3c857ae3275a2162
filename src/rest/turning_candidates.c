/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The pairs that may touch first, by doubles with running bounds: with E a bound of the errors of
 * differences of coordinates and |p| = |p_x| + |p_y|, a product p x q or p . q is off by at most
 * 2 E (|p| + |q|), the rounding of it included, as E is at least 2^-51 of all coordinates. */

#include "rest/turning.h"

#include <float.h>
#include <math.h>

/* [low, high] holds the truth. */
typedef struct range {
  double low, high;
} range;

/* A pair as seen from P, in doubles. */
typedef struct seen {
  double a, b, c, s, d, g, square;
  double error_r, error_o; /* of products of e with r (A, B, C, S), and with E - P (d, g) */
} seen;

typedef struct search {
  const tp_bodies *bodies;
  tp_candidates *found;
  double u, v; /* P */
  int turn;
  double error;
} search;

static seen see(const search *q, bool of_base, long vertex, long edge) {
  const tp_body *one = of_base ? &q->bodies->base : &q->bodies->block;
  const tp_body *other = of_base ? &q->bodies->block : &q->bodies->base;
  const long next = tp_body_next(other, edge);
  const double eu = other->u[next] - other->u[edge], ev = other->v[next] - other->v[edge];
  const double ru = one->u[vertex] - q->u, rv = one->v[vertex] - q->v;
  const double ou = other->u[edge] - q->u, ov = other->v[edge] - q->v;
  const int way = of_base ? -q->turn : q->turn;
  const double long_e = fabs(eu) + fabs(ev);
  seen n = {.a = ru * ev - rv * eu,
            .c = eu * ru + ev * rv,
            .d = ou * ev - ov * eu,
            .g = eu * ou + ev * ov,
            .square = eu * eu + ev * ev,
            .error_r = 2 * q->error * (long_e + fabs(ru) + fabs(rv)),
            .error_o = 2 * q->error * (long_e + fabs(ou) + fabs(ov))};
  n.b = -way * n.c;
  n.s = way * n.a;
  return n;
}

/* t; false where it is certain that there is no root after the start. */
static bool root_range(range *t, const seen *n) {
  const double squares = n->a * n->a + n->b * n->b + n->d * n->d;
  const double radicand = n->a * n->a + n->b * n->b - n->d * n->d;
  const double bound = 2.5 * ((fabs(n->a) + fabs(n->b)) * n->error_r + fabs(n->d) * n->error_o) +
                       2.5 * (n->error_r * n->error_r + n->error_o * n->error_o) +
                       8 * DBL_EPSILON * squares;
  if (radicand + bound < 0) return false;
  const double slack = 1 + 8 * DBL_EPSILON;
  const double top_low = (n->b + sqrt(fmax(radicand - bound, 0)) / slack) - 2 * n->error_r;
  const double top_high = (n->b + sqrt(radicand + bound) * slack) + 2 * n->error_r;
  const double bottom = n->a + n->d, spread = 2 * (n->error_r + n->error_o);
  *t = (range){0, INFINITY};
  if (fabs(bottom) <= spread) return true;
  const double ends[2] = {bottom - spread, bottom + spread};
  range quotient = {INFINITY, -INFINITY};
  for (int k = 0; k < 2; k++) {
    quotient.low = fmin(quotient.low, fmin(top_low / ends[k], top_high / ends[k]));
    quotient.high = fmax(quotient.high, fmax(top_low / ends[k], top_high / ends[k]));
  }
  quotient.low -= 4 * DBL_EPSILON * fabs(quotient.low);
  quotient.high += 4 * DBL_EPSILON * fabs(quotient.high);
  if (quotient.high < 0) return false;
  *t = (range){fmax(quotient.low, 0), quotient.high};
  return true;
}

/* Is the place on the edge, at some t of the range? 1 for certain, -1 for certain not, else 0. As t
 * moves by dt the angle moves by at most 2 dt, and the place by |r| |e| times that. */
static int on_edge(const seen *n, range t) {
  if (!isfinite(t.high)) return 0;
  const double middle = t.low + (t.high - t.low) / 2, whole = 1 + middle * middle;
  const double place = n->c * (1 - middle * middle) / whole + n->s * 2 * middle / whole - n->g;
  const double reach = (fabs(n->c) + fabs(n->s)) * (t.high - t.low + 8 * DBL_EPSILON);
  const double bound = 1.01 * reach + 4 * (n->error_r + n->error_o);
  if (place < -bound || place > n->square + 2 * n->error_r + bound) return -1;
  return place > bound && place < n->square - 2 * n->error_r - bound ? 1 : 0;
}

static bool note_pair(const search *q, bool of_base, long vertex, long edge) {
  const seen n = see(q, of_base, vertex, edge);
  range t;
  if (!root_range(&t, &n) || t.low > q->found->best) return true;
  const int on = on_edge(&n, t);
  if (on < 0) return true;
  const bool certain = on > 0 && t.low > 0;
  return tp_candidates_note(q->found, (tp_candidate){of_base, vertex, edge, t.low}, t.high,
                            certain);
}

/* The vertices of the profile that a part of the block between two abscissas can come to before
 * some pair touches for certain: it moves by at most the angle of that turn times its arm. */
static void in_reach(long *first, long *last, const search *q, double reach, double from,
                     double to) {
  const double moves = fmin(2, 2 * atan(q->found->best)) * reach + 4 * q->error;
  tp_candidates_reach(first, last, q->bodies, fmax(fmin(from, to) - moves, q->u - reach),
                      fmin(fmax(from, to) + moves, q->u + reach));
}

/* A vertex of the block on edges of the base, its upright ends among them. */
static bool note_vertex(const search *q, double reach, long vertex) {
  const double u = q->bodies->block.u[vertex];
  bool done = true;
  for (long edge = q->bodies->profile_count - 1; edge < q->bodies->base.count && done; edge++) {
    done = note_pair(q, false, vertex, edge);
  }
  long first, last;
  in_reach(&first, &last, q, reach, u, u);
  for (long edge = first; edge < last && done; edge++) done = note_pair(q, false, vertex, edge);
  return done;
}

/* Vertices of the base on an edge of the block. */
static bool note_edge(const search *q, double reach, long edge) {
  const tp_body *block = &q->bodies->block;
  long first, last;
  in_reach(&first, &last, q, reach, block->u[edge], block->u[tp_body_next(block, edge)]);
  bool done = true;
  for (long vertex = first; vertex <= last && done; vertex++) {
    done = note_pair(q, true, vertex, edge);
  }
  return done;
}

bool tp_turning_candidates(tp_turning *turning, const tp_bodies *bodies) {
  const tp_body *block = &bodies->block, *base = &bodies->base;
  fmpq_t rest;
  fmpq_init(rest);
  search q = {.bodies = bodies, .found = &turning->pairs, .turn = turning->turn};
  q.error = tp_candidates_error(bodies);
  fmpq_sub(rest, &turning->pivot.x, base->x);
  q.u = fmpq_get_d(rest);
  fmpq_sub(rest, &turning->pivot.y, base->y);
  q.v = fmpq_get_d(rest);
  fmpq_clear(rest);
  double reach = 0;
  for (long k = 0; k < block->count; k++) {
    reach = fmax(reach, hypot(block->u[k] - q.u, block->v[k] - q.v));
  }
  reach += 4 * q.error + 4 * DBL_EPSILON * reach;
  bool done = true;
  for (long k = 0; k < block->count && done; k++) done = note_vertex(&q, reach, k);
  for (long k = 0; k < block->count && done; k++) done = note_edge(&q, reach, k);
  tp_candidates_settle(&turning->pairs);
  return done;
}
