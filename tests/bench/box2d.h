/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A block on its base, and columns on a stepped one, in Box2D, the physics engine, for comparison.
 */

#ifndef BENCH_BOX2D_H
#define BENCH_BOX2D_H

#include <stdbool.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct box2d_block {
  const double *under; /* x, y of the underside from left to right, metres */
  int under_count;
  double top;         /* its height there */
  const double *base; /* x, y of the ring of the rock, counter-clockwise */
  int base_count;
  double friction; /* tan(phi) */
  double extent;   /* of the block */
} box2d_block;

/* Set down at a tilt towards the left, in radians, for two seconds at 1 kHz: did it move by less
 * than a hundredth of its extent? */
bool box2d_stands(const box2d_block *block, double tilt);

/* Columns side by side from the toe on the left on, each base a step above the last. */
typedef struct box2d_columns {
  double width, step; /* metres */
  const double *heights;
  int count;
  double dip; /* of the bases, towards the left, in radians */
} box2d_columns;

/* Set down with a tan(phi) of all joints, for two seconds at 1 kHz: did none move by more than a
 * hundredth of the highest one? */
bool box2d_columns_stand(const box2d_columns *columns, double tangent);

#ifdef __cplusplus
}
#endif
#endif
