/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The coefficients A, B and d of one pair in the equation of a turn (rest/turning.h), exact. */

#include "rest/turning.h"

void tp_turning_numbers_init(tp_turning_numbers *n) {
  fmpq *const all[] = {n->a, n->b, n->c, n->s, n->d, n->g, n->square};
  for (size_t k = 0; k < sizeof all / sizeof all[0]; k++) fmpq_init(all[k]);
}

void tp_turning_numbers_clear(tp_turning_numbers *n) {
  fmpq *const all[] = {n->a, n->b, n->c, n->s, n->d, n->g, n->square};
  for (size_t k = 0; k < sizeof all / sizeof all[0]; k++) fmpq_clear(all[k]);
}

/* What of a pair is the block's is turned from where it is on the block, so that P, whose digits
 * grow from turn to turn, enters with the base alone. */
void tp_turning_pair_init(tp_turning_pair *p, const tp_bodies *b, const tp_turning *turning,
                          const tp_candidate *pair) {
  const tp_body *one = pair->of_base ? &b->base : &b->own;
  const tp_body *other = pair->of_base ? &b->own : &b->base;
  const tp_exact_point *from_one = pair->of_base ? &turning->pivot : &turning->own;
  const tp_exact_point *from_other = pair->of_base ? &turning->own : &turning->pivot;
  const long next = tp_body_next(other, pair->edge);
  tp_exact_point_init(&p->vertex);
  tp_exact_point_init(&p->edge);
  tp_exact_point_init(&p->along);
  fmpq_sub(&p->vertex.x, one->x + pair->vertex, &from_one->x);
  fmpq_sub(&p->vertex.y, one->y + pair->vertex, &from_one->y);
  fmpq_sub(&p->edge.x, other->x + pair->edge, &from_other->x);
  fmpq_sub(&p->edge.y, other->y + pair->edge, &from_other->y);
  fmpq_sub(&p->along.x, other->x + next, other->x + pair->edge);
  fmpq_sub(&p->along.y, other->y + next, other->y + pair->edge);
  if (pair->of_base) {
    tp_pose_turn_vector(&p->edge.x, &p->edge.y, &b->pose);
    tp_pose_turn_vector(&p->along.x, &p->along.y, &b->pose);
  } else {
    tp_pose_turn_vector(&p->vertex.x, &p->vertex.y, &b->pose);
  }
}

void tp_turning_pair_clear(tp_turning_pair *p) {
  tp_exact_point_clear(&p->vertex);
  tp_exact_point_clear(&p->edge);
  tp_exact_point_clear(&p->along);
}

void tp_turning_numbers_of(tp_turning_numbers *n, const tp_bodies *bodies,
                           const tp_turning *turning, const tp_candidate *pair) {
  const int way = pair->of_base ? -turning->turn : turning->turn;
  tp_turning_pair p;
  tp_turning_pair_init(&p, bodies, turning, pair);
  tp_exact_cross(n->a, &p.vertex, &p.along);
  tp_exact_dot(n->c, &p.along, &p.vertex);
  fmpq_mul_si(n->b, n->c, -way);
  fmpq_mul_si(n->s, n->a, way);
  tp_exact_cross(n->d, &p.edge, &p.along);
  tp_exact_dot(n->g, &p.along, &p.edge);
  tp_exact_dot(n->square, &p.along, &p.along);
  tp_turning_pair_clear(&p);
}
