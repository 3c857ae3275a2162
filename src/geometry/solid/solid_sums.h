/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Volume, first and second moments of a solid: sums over signed tetrahedra between the local origin
 * and each triangle, in doubles with bounds or in whole numbers. Both are one formula
 * (solid_sums_in.h).
 *
 * Doubles are added by halves, so that a sum of n terms is off by some log2 n roundings of its
 * partial sums: for a million triangles of a boulder 12 digits are certain, for 0.13 s;
 * whole numbers take 0.8 s. */

#ifndef TP_SOLID_SOLID_SUMS_H
#define TP_SOLID_SOLID_SUMS_H

#include "solid/surface.h"

typedef enum tp_solid_sum {
  TP_SOLID_V6,  /* six times the volume */
  TP_SOLID_X24, /* 24 times the integrals of x, y, z */
  TP_SOLID_Y24,
  TP_SOLID_Z24,
  TP_SOLID_XX120, /* 120 times those of x x, y y, z z, y z, z x, x y */
  TP_SOLID_YY120,
  TP_SOLID_ZZ120,
  TP_SOLID_YZ120,
  TP_SOLID_ZX120,
  TP_SOLID_XY120,
  TP_SOLID_SUM_COUNT
} tp_solid_sum;

/* The two axes of each second moment. */
static const int tp_solid_axes[6][2] = {{0, 0}, {1, 1}, {2, 2}, {1, 2}, {2, 0}, {0, 1}};

/* All of them, of `near`. */
void tp_solid_sums_near(tp_near sums[TP_SOLID_SUM_COUNT], const tp_surface *surface);

/* All of them, of `whole`, times `multiple`: 1 where points have no weights. Both are initialised.
 */
void tp_solid_sums_exact(fmpz *sums, fmpz_t multiple, const tp_surface *surface);

/* Those up to TP_SOLID_Z24, of `whole`, where points have no weights, for less than half of the
 * cost; initialised. */
void tp_solid_first_sums_exact(fmpz *sums, const tp_surface *surface);

#endif
