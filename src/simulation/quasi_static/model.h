/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A block on the springs of its contact, without units: lengths in extents of the block, from its
 * centroid; forces in its weight; displacements and closures in that closure at which springs along
 * one extent carry the weight. Stress is then the closure, and nothing depends on the stiffness but
 * `moves`. */

#ifndef TP_QUASI_STATIC_MODEL_H
#define TP_QUASI_STATIC_MODEL_H

#include "quasi_static/path.h"

typedef struct tp_joint_facet {
  tp_xy from, to; /* its ends; of a contact in a point the same */
  tp_xy tangent, normal;
  double length; /* or what the point stands for */
  bool in_a_point;
  double friction;               /* tan(phi) */
  double locked_from, locked_to; /* closures that the facet has without displacement */
  double locked_shear;           /* and its shear stress */
  long number;                   /* of the base, from 1 */
} tp_joint_facet;

typedef struct tp_path_model {
  const tp_rigid_body *body;
  long count;
  tp_joint_facet *facets;
  double shear_ratio;     /* k_s / k_n */
  double square_gyration; /* square of the radius of gyration */
  double moves;           /* a unit of displacement, in extents; 0: the weight stays in its place */
  double weight_n, closure_m; /* the units */
} tp_path_model;

/* The settings are checked here. On failure `model` is cleared. */
TP_MUST_USE tp_status tp_path_model_init(tp_path_model *model, const tp_rigid_body *body,
                                         const tp_path_settings *settings, tp_message *message);
void tp_path_model_clear(tp_path_model *model);

/* Components along x and y, and the moment or turn; forces about the centroid. */
typedef struct tp_three {
  double of[3];
} tp_three;

/* The weight and the other loads at a tilt, and their derivative by it (a difference of second
 * order, off by 2e-9: it tells signs, never a balance). */
tp_three tp_path_load(const tp_path_model *model, double tilt);
tp_three tp_path_load_rate(const tp_path_model *model, double tilt);

#endif
