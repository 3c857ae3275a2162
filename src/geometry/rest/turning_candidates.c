/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The pairs that may touch first, by doubles with running bounds: with E a bound of the errors of
 * differences of coordinates and |p| = |p_x| + |p_y|, a product p x q or p . q is off by at most
 * 2 E (|p| + |q|), the rounding of it included, as E is at least 2^-51 of all coordinates. */

#define _GNU_SOURCE /* qsort_r */
#include "rest/turning.h"

#include "number/binary.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

static double smaller(double held, double other) {
  return other < held ? other : held;
}

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
  tp_turning *turning;
  double u, v; /* P */
  int turn;
  double error;
} search;

static seen see(const search *q, bool of_base, long vertex, long edge) {
  const tp_body *one = tp_bodies_ring(q->bodies, of_base);
  const tp_body *other = tp_bodies_ring(q->bodies, !of_base);
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
  tp_candidates *found = &q->turning->pairs;
  found->looked_at++;
  const seen n = see(q, of_base, vertex, edge);
  range t;
  if (!root_range(&t, &n) || t.low > found->best) return true;
  const int on = on_edge(&n, t);
  if (on < 0) return true;
  const tp_candidate pair = {of_base, vertex, edge, t.low, t.high, on > 0 && t.low > 0};
  if (t.low > 0 && t.high <= found->best) q->turning->is_close = true;
  return tp_candidates_note(found, pair);
}

/* Bounds of sin phi and 1 - cos phi for a turn up to tan(phi / 2) = t. */
typedef struct swing {
  double sine, versine;
} swing;

static swing swing_up_to(double t) {
  const double slack = 1 + 8 * DBL_EPSILON;
  if (!(t < 1)) return (swing){1, isfinite(t) ? fmin(2, 2 / (1 + 1 / (t * t)) * slack) : 2};
  return (swing){2 * t / (1 + t * t) * slack, 2 * t * t / (1 + t * t) * slack};
}

/* Where a vertex of the block comes meanwhile: from r it moves by -(1 - cos phi) r + sin phi r'. */
static tp_edges_box swept(const search *q, swing most, long vertex) {
  const double u = q->bodies->posed.u[vertex], v = q->bodies->posed.v[vertex];
  const double pad = 8 * q->error;
  const double back_u = -most.versine * (u - q->u), back_v = -most.versine * (v - q->v);
  const double on_u = -q->turn * most.sine * (v - q->v), on_v = q->turn * most.sine * (u - q->u);
  return (tp_edges_box){u + smaller(back_u, 0) + smaller(on_u, 0) - pad,
                        u + tp_larger(back_u, 0) + tp_larger(on_u, 0) + pad,
                        v + smaller(back_v, 0) + smaller(on_v, 0) - pad,
                        v + tp_larger(back_v, 0) + tp_larger(on_v, 0) + pad};
}

/* An edge of the block and what it can touch: only what its box meets, as it turns, and its line.
 * With the outward normal n and q a point of the base, seen from P, the height of q over the line
 * is n . q - n . r - (1 - cos phi) n . q + turn sin phi e . q,    r where the edge begins. */
typedef struct sweep {
  const search *of;
  long edge;
  swing most;
  tp_edges_box box;
  double eu, ev, d, size; /* d = n . r; |e| + |r| */
} sweep;

static sweep sweep_edge(const search *q, long edge) {
  const tp_body *block = &q->bodies->posed;
  const long next = tp_body_next(block, edge);
  const double ru = block->u[edge] - q->u, rv = block->v[edge] - q->v;
  sweep s = {.of = q, .edge = edge, .most = swing_up_to(q->turning->pairs.best)};
  const tp_edges_box from = swept(q, s.most, edge), to = swept(q, s.most, next);
  s.box = (tp_edges_box){smaller(from.low_u, to.low_u), tp_larger(from.high_u, to.high_u),
                         smaller(from.low_v, to.low_v), tp_larger(from.high_v, to.high_v)};
  s.eu = block->u[next] - block->u[edge];
  s.ev = block->v[next] - block->v[edge];
  s.d = s.ev * ru - s.eu * rv;
  s.size = fabs(s.eu) + fabs(s.ev) + fabs(ru) + fabs(rv);
  return s;
}

static bool may_meet(const sweep *s, const tp_edges_box *box) {
  if (box->low_u > s->box.high_u || box->high_u < s->box.low_u || box->low_v > s->box.high_v ||
      box->high_v < s->box.low_v) {
    return false;
  }
  const double half_u = (box->high_u - box->low_u) / 2, half_v = (box->high_v - box->low_v) / 2;
  const double u = box->low_u + half_u - s->of->u, v = box->low_v + half_v - s->of->v;
  const double across = s->ev * u - s->eu * v, along = s->of->turn * (s->eu * u + s->ev * v);
  const double wide = fabs(s->ev) * half_u + fabs(s->eu) * half_v;
  const double deep = fabs(s->eu) * half_u + fabs(s->ev) * half_v;
  const double least = across - wide - s->d - s->most.versine * tp_larger(across + wide, 0) +
                       s->most.sine * smaller(along - deep, 0);
  return !(least > 16 * s->of->error * (s->size + fabs(u) + fabs(v) + half_u + half_v));
}

static bool note_edges(const sweep *s, long first, long end) {
  const tp_body *base = &s->of->bodies->base;
  const long last = s->of->bodies->profile_count - 1;
  bool done = true;
  for (long k = first; k < end && done; k++) {
    const long next = k < last ? k + 1 : k;
    const tp_edges_box box = {
        smaller(base->u[k], base->u[next]), tp_larger(base->u[k], base->u[next]),
        smaller(base->v[k], base->v[next]), tp_larger(base->v[k], base->v[next])};
    if (!may_meet(s, &box)) continue;
    done = (k == last || note_pair(s->of, false, s->edge, k)) && note_pair(s->of, true, k, s->edge);
  }
  return done;
}

/* Down the tree of boxes. */
static bool note_profile(const sweep *s) {
  enum { DEEPEST = 64 };
  const tp_boxes *boxes = &s->of->bodies->boxes;
  long due[DEEPEST], count = 0;
  bool done = true;
  due[count++] = 1;
  while (count > 0 && done) {
    const long node = due[--count];
    s->of->turning->pairs.looked_at++;
    if (!may_meet(s, boxes->nodes + node)) continue;
    if (node < boxes->leaves) {
      due[count++] = 2 * node + 1;
      due[count++] = 2 * node;
    } else {
      long first, end;
      tp_boxes_edges(&first, &end, boxes, node);
      done = note_edges(s, first, end);
    }
  }
  return done;
}

/* The vertex in which the edge begins on the upright ends of the base and on its floor. */
static bool note_ends(const sweep *s) {
  const tp_bodies *b = s->of->bodies;
  const long left = b->profile_count - 1;
  if (s->box.low_u > b->base.u[left] && s->box.high_u < b->base.u[0] &&
      s->box.low_v > b->base.v[left + 1]) {
    return true;
  }
  bool done = true;
  for (long edge = left; edge < b->base.count && done; edge++) {
    done = note_pair(s->of, false, s->edge, edge);
  }
  return done;
}

/* Vertices of the block first, then those of the base, each along the block; of one vertex or edge
 * of that the ends of the base first, then along its ring. */
static int compare_pairs(const void *a, const void *b, void *context) {
  const tp_candidate *one = a, *other = b;
  const tp_bodies *bodies = context;
  if (one->of_base != other->of_base) return one->of_base ? 1 : -1;
  const bool of_base = one->of_base;
  const long block = of_base ? one->edge - other->edge : one->vertex - other->vertex;
  if (block != 0) return block < 0 ? -1 : 1;
  if (of_base) return one->vertex < other->vertex ? -1 : 1;
  const long ends = bodies->profile_count - 1;
  if ((one->edge >= ends) != (other->edge >= ends)) return one->edge >= ends ? -1 : 1;
  return one->edge < other->edge ? -1 : 1;
}

void tp_turning_latest(double *low, double *high, const tp_turning *turning,
                       const tp_bodies *bodies) {
  fmpq_t arm;
  fmpq_init(arm);
  fmpq_sub(arm, &bodies->centroid.x, &turning->pivot.x);
  const double u = fabs(fmpq_get_d(arm));
  fmpq_sub(arm, &bodies->centroid.y, &turning->pivot.y);
  const double v = fmpq_get_d(arm);
  fmpq_clear(arm);
  const double t = tan(M_PI_4 + atan2(v, u) / 2);
  /* Between these the roundings, below 2^-51 of the angle's radian, are less than the slack. */
  static const double least = 1e-4, most = 1e4, slack = 1e-9;
  *low = u > 0 && t > least ? fmin(t, most) * (1 - slack) : 0;
  *high = u > 0 && t > 0 && t < most ? fmax(t, least) * (1 + slack) : INFINITY;
}

bool tp_turning_candidates(tp_turning *turning, const tp_bodies *bodies, double limit) {
  search q = {.bodies = bodies, .turning = turning, .turn = turning->turn, .error = bodies->error};
  q.u = tp_bodies_round(bodies, &turning->pivot.x, bodies->base.x);
  q.v = tp_bodies_round(bodies, &turning->pivot.y, bodies->base.y);
  tp_candidates *pairs = &turning->pairs;
  pairs->count = pairs->blind = 0;
  pairs->best = limit;
  turning->is_close = false;
  bool done = true;
  for (long k = 0; k < bodies->posed.count && done; k++) {
    const sweep s = sweep_edge(&q, k);
    done = note_ends(&s) && note_profile(&s);
  }
  tp_candidates_settle(pairs);
  if (pairs->count > 1) {
    qsort_r(pairs->items, (size_t)pairs->count, sizeof *pairs->items, compare_pairs,
            (void *)bodies);
  }
  return done;
}
