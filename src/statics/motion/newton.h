/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Newton's law for a block at rest, M a = w + sum f, about its centroid: its terms in the lengths
 * of a question, accelerations over gravity and forces over the weight, each as three balls. */

#ifndef TP_MOTION_NEWTON_H
#define TP_MOTION_NEWTON_H

#include "motion/mode.h"
#include "motion/question.h"

/* A point of the cones from the centroid, in the question's lengths; the moment about that of a
 * force there. */
void tp_newton_arms(arb_t x, arb_t y, const tp_motion_question *question, const arb_t point_x,
                    const arb_t point_y, long bits);
void tp_newton_moment(tp_vector *force, const tp_motion_question *question, const arb_t x,
                      const arb_t y, long bits);

/* M r: what it takes to accelerate the block by the twist of a ray. */
void tp_newton_inertia(tp_vector *own, const tp_motion_question *question, const tp_ray *ray);

/* -e: the force along an edge of a friction cone, brought to the side of the inertia. */
void tp_newton_force(tp_vector *own, const tp_motion_question *question, const tp_normals *normals,
                     const tp_cone_edge *edge);

/* k^2 M^-1 h of a normal line: times a force it is the acceleration along the normal, times k^2. */
void tp_newton_normal(tp_vector *own, const tp_motion_question *question, const tp_normals *normals,
                      long normal);

#endif
