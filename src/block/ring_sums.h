/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Moment sums over the boundary of a ring, in three arithmetics.
 *
 * With c = x_k y_{k+1} - x_{k+1} y_k over the edges of a counter-clockwise ring (Green's theorem;
 * mechanics section 2), each sum is a ring expression without division:
 *     A2 = sum c = 2 int dA,                X6 = sum (x_k + x_{k+1}) c = 6 int x dA,   Y6 likewise,
 *     XX12 = sum (x_k^2 + x_k x_{k+1} + x_{k+1}^2) c = 12 int x^2 dA,                YY12 likewise,
 *     XY24 = sum (x_k y_{k+1} + x_{k+1} y_k + 2 x_k y_k + 2 x_{k+1} y_{k+1}) c = 24 int x y dA.
 * Cost per vertex: double about 2 ns, exact some 100 ns, balls some 300 ns. */

#ifndef TP_RING_SUMS_H
#define TP_RING_SUMS_H

#include <arb.h>
#include <flint/fmpz.h>
#include <stdbool.h>

enum { TP_A2, TP_X6, TP_Y6, TP_XX12, TP_YY12, TP_XY24, TP_SUM_COUNT };

/* Degree of each sum in x and in y. */
typedef struct tp_degree {
  int x, y;
} tp_degree;
extern const tp_degree tp_sum_degree[TP_SUM_COUNT];

/* Exactly. The sums must be initialised. */
void tp_ring_sums_exact(fmpz sums[TP_SUM_COUNT], const fmpz *x, const fmpz *y, long count);

/* In balls of `bits` bits. */
void tp_ring_sums_ball(arb_struct sums[TP_SUM_COUNT], const fmpz *x, const fmpz *y, long count,
                       long bits);

/* In double with a proven bound: |sums[k] - truth| <= bounds[k], for coordinates that are exact
 * or (`exact` false) integers times a power of two rounded to nearest, the largest of each axis at
 * least 1: otherwise underflow cannot be bounded, and the bounds are infinite. The same bits on
 * every machine. */
void tp_ring_sums_double(double sums[TP_SUM_COUNT], double bounds[TP_SUM_COUNT], const double *u,
                         const double *v, long count, bool exact);

#endif
