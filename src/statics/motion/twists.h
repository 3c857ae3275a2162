/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The twists by which a block can leave its base or stay in contact, to first order: the cone
 * K = {a : h_i . a >= 0} of mechanics section 6a, by its rays.
 *
 * Of every family of contact points only its first and its last normal line bound K. A pointed K is
 * cut out of three half-spaces by one after the other (motion/double_description.h): its rays stand
 * in a circle, each face between two of them lies on one normal line. A K with a line in it is cut
 * into pieces without by rays of its own: then some faces lie on one plane. */

#ifndef TP_MOTION_TWISTS_H
#define TP_MOTION_TWISTS_H

#include "motion/normals.h"

#include "number/work.h"

typedef struct tp_ray {
  tp_vector twist;             /* of any length, about the origin */
  double near[3];              /* likewise in doubles (tp_normals_near) */
  long site;                   /* that it turns about, or -1 */
  long axis;                   /* that it moves along without turning, or -1 */
  long first_line, line_count; /* in `lines`; none where they are not told */
} tp_ray;

/* What lies between two rays, with h . a = 0 for the normal line. */
typedef struct tp_twist_face {
  long from, to; /* rays */
  long normal;
} tp_twist_face;

typedef struct tp_twists {
  long ray_count, ray_room;
  tp_ray *rays;
  long face_count;
  tp_twist_face *faces;
  long line_count, line_room;
  long *lines;       /* the normal lines that bound K and that a ray lies on, in their order */
  bool has_interior; /* of three dimensions, bounded by the faces */
  bool everything;   /* nothing bounds it */
} tp_twists;

TP_MUST_USE tp_motion_outcome tp_twists_init(tp_twists *twists, const tp_normals *normals,
                                             tp_work *work);
void tp_twists_clear(tp_twists *twists);

/* Add the ray of turning about a point of the cones, `sense` 1 counter-clockwise, or -1: its
 * number, or -1 when memory is exhausted. */
long tp_twists_add_turn(tp_twists *twists, const tp_normals *normals, long point, int sense);

/* Tell of the ray added last that it lies on a normal line, besides those that were told before;
 * false when memory is exhausted. */
TP_MUST_USE bool tp_twists_tell_line(tp_twists *twists, long line);

#endif
