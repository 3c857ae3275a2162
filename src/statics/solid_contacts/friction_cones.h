/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Contact points of a solid and the cones of Coulomb that their forces lie in.
 *
 * A force f at the point r (from the centroid) with the normal n, which points into the rock, is
 * admissible where n . f >= 0 and |f|^2 |n|^2 - (n . f)^2 <= mu^2 (n . f)^2: the true cone, for a
 * normal of any length. A twist (v, omega) moves the point by a = v + omega x r; no admissible
 * force does negative work on it where |n| (n . a) >= mu |n x (a x n)|, the dual cone: its slope is
 * 1 / mu. Points are in lengths of which the farthest is about one away; exact numbers and doubles
 * of the same things stand side by side. */

#ifndef TP_SOLID_CONTACTS_FRICTION_CONES_H
#define TP_SOLID_CONTACTS_FRICTION_CONES_H

#include "number/near.h"
#include "topple_basics.h"

#include <flint/fmpq.h>

enum { TP_WRENCH = 6 };

typedef struct tp_friction_cone {
  fmpq at[3], normal[3];
  tp_near near_at[3];
  tp_near near_normal[3]; /* times a number, so that it is about one long */
  double unit[3];         /* along the normal, rounded */
  tp_near friction;       /* mu */
} tp_friction_cone;

typedef struct tp_friction_cones {
  long count;
  tp_friction_cone *cones;
} tp_friction_cones;

/* With room for so many, at zero; false when memory is exhausted. */
TP_MUST_USE bool tp_friction_cones_init(tp_friction_cones *cones, long count);
void tp_friction_cones_clear(tp_friction_cones *cones);

/* The doubles of a cone by its exact numbers: a normal that is not zero. */
void tp_friction_cone_settle(tp_friction_cone *cone, tp_near friction);

/* The column of a force in doubles: the force, and its moment about the centroid. */
void tp_friction_cone_column(double column[TP_WRENCH], const tp_friction_cone *cone,
                             const double force[3]);

/* How a twist moves a point, in doubles. */
void tp_friction_cone_motion(double motion[3], const tp_friction_cone *cone,
                             const double twist[TP_WRENCH]);

/* The force of the cone, with a normal part of one, against which the motion does most; returns how
 * much it gains on it, below zero where the motion meets it. `friction` is a share of mu. */
double tp_friction_cone_worst(double force[3], const tp_friction_cone *cone, const double motion[3],
                              double friction);

/* Certainly: does a force lie in the cone with mu times `share`? Does a twist in its dual? */
bool tp_friction_cone_holds(const tp_friction_cone *cone, const tp_near force[3], tp_near share);
bool tp_friction_cone_lets(const tp_friction_cone *cone, const double twist[TP_WRENCH],
                           tp_near share);

#endif
