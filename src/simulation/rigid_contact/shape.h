/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The boundaries of block and base as what can touch: convex corners, sharp or rounded, and faces,
 * straight or hollow. A corner touches a face or a rounded corner; of two sharp corners neither
 * presses into the other, and two faces that lie on each other touch in the corners at their ends.
 *
 * All lengths are over the extent of the block. */

#ifndef TP_RIGID_CONTACT_SHAPE_H
#define TP_RIGID_CONTACT_SHAPE_H

#include "rigid_body/body.h"

/* Directions of normals of an arc, counter-clockwise from the first. */
typedef struct tp_normal_range {
  double first, sweep; /* radians */
} tp_normal_range;

typedef struct tp_round_corner {
  tp_xy centre;
  double radius;         /* 0: sharp */
  tp_normal_range range; /* between the normals of its edges */
  long before, behind;   /* its edges; the same of an arc */
} tp_round_corner;

typedef struct tp_contact_face {
  bool hollow;               /* an arc whose centre lies outside of the rock; else straight */
  tp_xy from, along, normal; /* of a straight one: unit vectors, the normal out of the rock */
  double length;
  tp_xy centre; /* of a hollow one */
  double radius;
  tp_normal_range range; /* directions from its centre to its points */
  long edge;
} tp_contact_face;

typedef struct tp_contact_shape {
  long corner_count, face_count;
  tp_round_corner *corners;
  tp_contact_face *faces;
} tp_contact_shape;

/* Of a boundary; false when memory is exhausted, and the shape is then cleared. */
TP_MUST_USE bool tp_contact_shape_init(tp_contact_shape *shape, const tp_boundary *boundary,
                                       double extent_m);
void tp_contact_shape_clear(tp_contact_shape *shape);

/* Where a direction lies to a range: within it, or by how much outside (negative) of the end that
 * is nearer; 0 or positive within: the distance to the nearer end. */
double tp_normal_range_margin(tp_normal_range range, double direction);

#endif
