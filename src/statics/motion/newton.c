/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Inertia M r of a ray, contact forces and contact normals about the centroid, in the lengths of a
 * question (docs/mechanics.md section 6a). */

#include "motion/newton.h"

void tp_newton_arms(arb_t x, arb_t y, const tp_motion_question *q, const arb_t point_x,
                    const arb_t point_y, long bits) {
  arb_mul(x, point_x, q->scale, bits);
  arb_sub(x, x, q->x, bits);
  arb_mul(y, point_y, q->scale, bits);
  arb_sub(y, y, q->y, bits);
}

void tp_newton_moment(tp_vector *force, const tp_motion_question *q, const arb_t x, const arb_t y,
                      long bits) {
  arb_t arm_x, arm_y;
  arb_init(arm_x);
  arb_init(arm_y);
  tp_newton_arms(arm_x, arm_y, q, x, y, bits);
  tp_ball_moment(force->of, arm_x, arm_y, bits);
  arb_clear(arm_x);
  arb_clear(arm_y);
}

void tp_newton_inertia(tp_vector *own, const tp_motion_question *q, const tp_ray *ray) {
  tp_ball_inertia(own->of, ray->twist.of, q->scale, q->x, q->y, q->gyration, ray->axis < 0,
                  q->judge.precision);
}

void tp_newton_force(tp_vector *own, const tp_motion_question *q, const tp_normals *n,
                     const tp_cone_edge *edge) {
  const tp_cones *cones = q->cones;
  tp_normals_edge(own, n, edge->point, edge->against);
  const arb_struct x = tp_cones_x(cones, edge->point), y = tp_cones_y(cones, edge->point);
  tp_newton_moment(own, q, &x, &y, q->judge.precision);
  tp_vector_neg(own);
}

void tp_newton_normal(tp_vector *own, const tp_motion_question *q, const tp_normals *n,
                      long normal) {
  tp_vector h;
  tp_vector_init(&h);
  tp_normals_set_h(&h, n, normal);
  tp_ball_response(own->of, h.of, q->scale, q->x, q->y, q->gyration, q->judge.precision);
  tp_vector_clear(&h);
}
