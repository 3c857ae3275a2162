/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Newton's law for a block at rest, M a = w + sum f, about its centroid: its terms in the lengths
 * of a question, accelerations over gravity and forces over the weight, each as three balls. */

#ifndef TP_MOTION_NEWTON_H
#define TP_MOTION_NEWTON_H

#include "motion/mode.h"
#include "motion/question.h"

/* M r: what it takes to accelerate the block by the twist of a ray. */
void tp_newton_inertia(tp_vector *own, const tp_motion_question *question, const tp_ray *ray);

/* -e: the force along an edge of a friction cone, brought to the side of the inertia. */
void tp_newton_force(tp_vector *own, const tp_motion_question *question, const tp_normals *normals,
                     const tp_cone_edge *edge);

/* k^2 M^-1 h of a normal line: times a force it is the acceleration along the normal, times k^2. */
void tp_newton_normal(tp_vector *own, const tp_motion_question *question, const tp_normals *normals,
                      long normal);

#endif
