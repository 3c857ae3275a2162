/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Inertia M r of a ray, contact forces and contact normals about the centroid, in the lengths of a
 * question (docs/mechanics.md section 6a). */

#include "motion/newton.h"

/* The centroid moves by (s v_x - theta y, s v_y + theta x). */
void tp_newton_inertia(tp_vector *own, const tp_motion_question *q, const tp_ray *ray) {
  const long bits = q->judge.precision;
  const arb_struct *a = ray->twist.of;
  arb_mul(own->of, a, q->scale, bits);
  arb_submul(own->of, a + 2, q->y, bits);
  arb_mul(own->of + 1, a + 1, q->scale, bits);
  arb_addmul(own->of + 1, a + 2, q->x, bits);
  arb_mul(own->of + 2, a + 2, q->gyration, bits);
  if (ray->axis < 0) return;
  arb_zero(own->of + 2);
}

void tp_newton_force(tp_vector *own, const tp_motion_question *q, const tp_normals *n,
                     const tp_mode_edge *edge) {
  const long bits = q->judge.precision;
  arb_t arm;
  arb_init(arm);
  tp_normals_edge(own, n, edge->point, edge->against);
  arb_mul(arm, q->cones->x + edge->point, q->scale, bits);
  arb_sub(arm, arm, q->x, bits);
  arb_mul(own->of + 2, arm, own->of + 1, bits);
  arb_mul(arm, q->cones->y + edge->point, q->scale, bits);
  arb_sub(arm, arm, q->y, bits);
  arb_submul(own->of + 2, arm, own->of, bits);
  tp_vector_neg(own);
  arb_clear(arm);
}

void tp_newton_normal(tp_vector *own, const tp_motion_question *q, const tp_normals *n,
                      long normal) {
  const long bits = q->judge.precision;
  tp_vector h;
  tp_vector_init(&h);
  tp_normals_set_h(&h, n, normal);
  arb_mul(own->of, h.of, q->gyration, bits);
  arb_mul(own->of + 1, h.of + 1, q->gyration, bits);
  arb_mul(own->of + 2, h.of + 2, q->scale, bits); /* s t . q - t . (x, y) */
  arb_submul(own->of + 2, h.of + 1, q->x, bits);
  arb_addmul(own->of + 2, h.of, q->y, bits);
  tp_vector_clear(&h);
}
