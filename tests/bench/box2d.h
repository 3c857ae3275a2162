/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A block on its base in Box2D, the physics engine, for comparison. */

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

#ifdef __cplusplus
}
#endif
#endif
