/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Inertia M r of a ray, contact forces and contact normals about the centroid, in the lengths of a
 * question (docs/mechanics.md section 6a). */

#include "motion/newton.h"

void tp_newton_inertia(tp_vector *own, const tp_motion_question *q, const tp_ray *ray) {
  tp_ball_inertia(own->of, ray->twist.of, q->scale, q->x, q->y, q->gyration, ray->axis < 0,
                  q->judge.precision);
}

void tp_newton_force(tp_vector *own, const tp_motion_question *q, const tp_normals *n,
                     const tp_cone_edge *edge) {
  const long bits = q->judge.precision;
  arb_t x, y;
  arb_init(x);
  arb_init(y);
  arb_mul(x, q->cones->x + edge->point, q->scale, bits);
  arb_sub(x, x, q->x, bits);
  arb_mul(y, q->cones->y + edge->point, q->scale, bits);
  arb_sub(y, y, q->y, bits);
  tp_normals_edge(own, n, edge->point, edge->against);
  tp_ball_moment(own->of, x, y, bits);
  tp_vector_neg(own);
  arb_clear(x);
  arb_clear(y);
}

void tp_newton_normal(tp_vector *own, const tp_motion_question *q, const tp_normals *n,
                      long normal) {
  tp_vector h;
  tp_vector_init(&h);
  tp_normals_set_h(&h, n, normal);
  tp_ball_response(own->of, h.of, q->scale, q->x, q->y, q->gyration, q->judge.precision);
  tp_vector_clear(&h);
}
