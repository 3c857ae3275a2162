/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The block of a problem as a rigid body on its base, in doubles, for what simulates its motion.
 *
 * Lengths in metres from the block's centroid at the start, in the frame of the base (x along it,
 * y normal to it), so that a block far from the origin of its scene loses no digits. The block's
 * pose is the displacement of its centroid and its turn; gaps of contacts that are closed at the
 * start are exactly zero there. */

#ifndef TP_RIGID_BODY_BODY_H
#define TP_RIGID_BODY_BODY_H

#include "load/wrench.h"
#include "rigid_body/boundary.h"

/* A contact that is closed at the start, found exactly (base/contact.h): an end of a facet, with
 * the direction of the facet and its normal into the block. */
typedef struct tp_closed_point {
  tp_xy at, tangent, normal; /* unit vectors; the tangent runs along the base to the right */
  long facet;                /* of the base, from 1; 0: an end face */
  double share_m;            /* the length of the facet that it stands for: half of it; 0 of a
                                contact in a point */
  double friction;           /* tan(phi) */
} tp_closed_point;

/* The loads besides the weight, in the frame of the base: force and moment about the centroid at
 * the start, each a sum over cos a, sin a, 1, 1 / cos a, 1 / cos^2 a of the tilt a (load/wrench.h),
 * x not mirrored. They are dead loads: they stay as at the start while the block moves. */
typedef struct tp_body_loads {
  bool given;
  double x_n[TP_BASIS], y_n[TP_BASIS], moment_nm[TP_BASIS];
} tp_body_loads;

typedef struct tp_rigid_body {
  tp_boundary outline, base;
  double *friction; /* tan(phi) by edge of the base */
  long closed_count;
  tp_closed_point *closed;
  bool weighed;                  /* the scene gives a unit weight; else 1 kN/m3 */
  double mass_kg, inertia_kg_m2; /* about the centroid */
  double thickness_m;
  double extent_m; /* the largest distance of the outline from the centroid */
  tp_body_loads loads;
  tp_direction towards; /* which side of the table goes down: left, the side of -x */
  tp_xy origin;         /* the centroid at the start, in metres of the scene: for the report */
} tp_rigid_body;

/* Standard gravity, m/s2: weights of scenes are forces, masses follow from it. */
#define TP_GRAVITY_M_S2 9.80665

/* The body of a problem for one direction of tilt, its roundings and arcs as arcs. Cohesion, bonds
 * and friction that depends on the stress are bad input here, with the place that calls for them.
 * On failure `body` is cleared. */
TP_MUST_USE tp_status tp_rigid_body_init(tp_rigid_body *body, const tp_problem *problem,
                                         tp_direction towards, tp_message *message);
void tp_rigid_body_clear(tp_rigid_body *body);

/* Where the block is, and how it moves. */
typedef struct tp_body_state {
  tp_xy moved;    /* of the centroid, m */
  double turned;  /* radians, counter-clockwise */
  tp_xy speed;    /* of the centroid, m/s */
  double turning; /* rad/s */
} tp_body_state;

/* A point of the block (as at the start, from its centroid) where the block is now; its velocity.
 */
tp_xy tp_rigid_body_place(const tp_body_state *state, tp_xy point);
tp_xy tp_rigid_body_velocity(const tp_body_state *state, tp_xy point);
double tp_rigid_body_kinetic_energy(const tp_rigid_body *body, const tp_body_state *state);

#endif
