/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A cone of three dimensions, cut out of three half-spaces h . a >= 0 by one after the other: its
 * rays stand in a circle, with a face between each and the next.
 *
 * Every line that is still to cut waits at one ray that it cuts off (conflict lists: Clarkson and
 * Shor, Discrete Comput. Geom. 4, 1989), so that a cut costs as much as it changes: from that ray
 * on both ways the rays below the plane go, and what waited at them waits at one of the two that
 * the new face then lies between, or cuts nothing off any more. Of n lines in random order all cuts
 * together cost O(n log n) signs, which are exact, or as the judge has them. A new ray is the cross
 * product of the h of its two faces, in their order around the cone, so that its entries stay as
 * short as those are. */

#ifndef TP_MOTION_SOLID_CONE_H
#define TP_MOTION_SOLID_CONE_H

#include "motion/normals.h"

#include "number/work.h"

typedef struct tp_solid_ray {
  tp_vector twist;
  double near[3];
  long before, after; /* rays */
  long face;          /* the normal line of the face between this ray and the next */
  long lines;         /* the first of those that wait here or pass through it, but for its faces */
} tp_solid_ray;

typedef struct tp_solid_cone {
  const tp_normals *n;
  long room;
  tp_solid_ray *rays; /* in any order */
  long unused;        /* a chain of those that are none, by `after` */
  long count;
  long start;     /* of the circle: a ray, where there is one */
  long *next;     /* by normal line: along the rays' chains */
  long *below;    /* by normal line: a ray that it cuts off, or -1 */
  bool flat;      /* it has no inside: its `count` rays are 0, 1 or 2, from `start` on */
  tp_vector h[2]; /* at work */
  double checks;
} tp_solid_cone;

/* Of the first `count` >= 3 lines, in the order given: the h of the first three turn to the left,
 * h_0 x h_1 . h_2 > 0. A flat cone is returned as it became so; lines behind may cut it further. */
TP_MUST_USE tp_motion_outcome tp_solid_cone_init(tp_solid_cone *cone, const tp_normals *normals,
                                                 const long *lines, long count, tp_work *work);
void tp_solid_cone_clear(tp_solid_cone *cone);

#endif
