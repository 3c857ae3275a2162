/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The rays of the cone K of twists (motion/twists.h), by one half-space after the other: Motzkin's
 * double description in three dimensions. That of a K with an inside and without a line is
 * motion/solid_cone.h's; any other K has two rays at most, beside its line, and each half-space
 * costs two signs.
 *
 * Every new ray is the cross product of the normals of the two planes that it lies on, so that its
 * entries stay as short as those are. Signs are exact, or as the judge has them. */

#ifndef TP_MOTION_DOUBLE_DESCRIPTION_H
#define TP_MOTION_DOUBLE_DESCRIPTION_H

#include "motion/normals.h"

#include "number/work.h"

typedef struct tp_described_ray {
  tp_vector twist;
  double near[3];
  long normal; /* that it lies on; of a cone of three dimensions, that of the face after it */
  long lines;  /* of such a cone: the first of its other normal lines, along `next`, or -1 */
} tp_described_ray;

typedef struct tp_description {
  int rank; /* of all h together: 3 where K has no line in it */
  long count, room;
  tp_described_ray *rays;
  bool flat;      /* K, or what of it lies across its line, has one dimension less */
  tp_vector line; /* rank 2: within K, both ways; the rays then are those across it */
  long plane;     /* rank 1 and 2: one of the normal lines */
  long *next;     /* of a cone of three dimensions without a line, by normal line; else NULL */
} tp_description;

TP_MUST_USE tp_motion_outcome tp_description_init(tp_description *description,
                                                  const tp_normals *normals, tp_work *work);
void tp_description_clear(tp_description *description);

#endif
