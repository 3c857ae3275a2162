/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A block that turns about a point of its contact until it touches its base in another.
 *
 * Turned by phi about P, a vertex V at r = V - P from it comes to the line through E along e where
 *     A cos phi + B sin phi = d,    A = -e x r,  B = -turn e . r,  d = -e x (E - P),
 * the outward normal of the edge being (e_y, -e_x); of a vertex of the base and an edge of the
 * block the block is taken to stand still: B changes its sign. It goes in, and not out, at
 *     t = tan(phi / 2) = (B + sqrt(A^2 + B^2 - d^2)) / (A + d):
 * of the two roots of (A + d) t^2 - 2 B t + d - A the one at which the height over the line falls.
 * It lies on the edge if 0 <= e . (V - E) <= e . e, with C = e . r, S = turn A (or -turn A), g = e
 * . (E - P): (1 + t^2) e . (V - E) = -(C + g) t^2 + 2 S t + C - g. All of these are numbers a + b
 * sqrt(D) of rationals: signs and orders are decided exactly (number/surd.h). A corner that grazes
 * a line, D = 0, goes on. */

#ifndef TP_REST_TURNING_H
#define TP_REST_TURNING_H

#include "rest/candidates.h"
#include "rest/touch.h"

/* The pairs that touch first, at t = (top + sqrt(radicand)) / bottom. */
typedef struct tp_turning {
  tp_exact_point pivot; /* P */
  tp_exact_point own;   /* P in the block's own coordinates */
  tp_touch about;       /* the contact that lies there */
  int turn;             /* 1 counter-clockwise, -1 */
  tp_candidates pairs;  /* none: nothing stops it before the centroid has passed under P */
  bool is_close;        /* of the first stage: one may touch within the limit, short of certain */
  fmpq_t top, radicand, bottom;
  long exact; /* the pair that was brought together exactly */
} tp_turning;

/* About a point of the contact, by 1 or -1. */
void tp_turning_init(tp_turning *turning, const tp_bodies *bodies, const tp_touch *about, int turn);
void tp_turning_clear(tp_turning *turning);

/* What touches first after the start, while the centroid has not passed under P. */
TP_MUST_USE tp_status tp_turning_find(tp_turning *turning, const tp_bodies *bodies,
                                      tp_message *message);

/* Its first stage, in doubles: all pairs that may touch by tan(phi / 2) = limit and do not come
 * later than one that does for certain; pairs.best is below the limit if there is one. */
TP_MUST_USE bool tp_turning_candidates(tp_turning *turning, const tp_bodies *bodies, double limit);

/* Between which the centroid passes under P: tan(phi / 2). */
void tp_turning_latest(double *low, double *high, const tp_turning *turning,
                       const tp_bodies *bodies);

/* Turn the block until they touch, with P where it is. Where no rational pose does that, lengths of
 * the block give way by a share of 2^-TP_POSE_BITS (rest/pose.h), so that no two bodies overlap:
 * false where none of the pairs, taken as the exact one, spares the others. */
TP_MUST_USE bool tp_turning_do(tp_turning *turning, tp_bodies *bodies);

/* Of the touches keep those in P, and add the pairs that now touch. */
TP_MUST_USE tp_status tp_turning_touches(tp_touches *touches, const tp_turning *turning,
                                         const tp_bodies *bodies, tp_message *message);

/* The exact stage's numbers of a pair, in the current pose. */
typedef struct tp_turning_numbers {
  fmpq_t a, b, c, s, d, g, square; /* A, B, C, S, d, g, e . e */
} tp_turning_numbers;

void tp_turning_numbers_init(tp_turning_numbers *n);
void tp_turning_numbers_clear(tp_turning_numbers *n);
void tp_turning_numbers_of(tp_turning_numbers *n, const tp_bodies *bodies,
                           const tp_turning *turning, const tp_candidate *pair);

/* The vertex of a pair, from its place, and the direction of its edge and where that begins, all
 * from P, in the block's pose but for its shift. */
typedef struct tp_turning_pair {
  tp_exact_point vertex, edge, along;
} tp_turning_pair;

void tp_turning_pair_init(tp_turning_pair *p, const tp_bodies *bodies, const tp_turning *turning,
                          const tp_candidate *pair);
void tp_turning_pair_clear(tp_turning_pair *p);

#endif
