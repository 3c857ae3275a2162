/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Moment sums over the boundary of a ring, in four arithmetics.
 *
 * With c = x_k y_{k+1} - x_{k+1} y_k over the edges of a counter-clockwise ring (Green's theorem;
 * docs/mechanics.md section 2), each sum is a ring expression without division:
 *     A2 = sum c = 2 int dA,                X6 = sum (x_k + x_{k+1}) c = 6 int x dA,   Y6 likewise,
 *     XX12 = sum (x_k^2 + x_k x_{k+1} + x_{k+1}^2) c = 12 int x^2 dA,                YY12 likewise,
 *     XY24 = sum (x_k y_{k+1} + x_{k+1} y_k + 2 x_k y_k + 2 x_{k+1} y_{k+1}) c = 24 int x y dA.
 * Nanoseconds per vertex in cache, measured on a Xeon of 2.6 GHz, area and centroid or all six:
 *     double 0.5 or 0.8 with AVX-512, 0.7 or 1.1 with AVX2, 1.1 or 2.0 with SSE2;
 *     pairs of doubles 1.3 or 3.6, 1.7 or 4.9, 5.7 or 17; exactly 26 or 85; balls 280 for all six;
 * but a call takes some 16 ns in double and 40 in pairs even for a few vertices. Beyond the caches
 * memory is the limit.
 * Each entry has a `_first` form for the first `sum_count` of them alone: TP_AREA_SUM_COUNT, which
 * give area and centroid, or TP_SUM_COUNT. */

#ifndef TP_BLOCK_RING_SUMS_H
#define TP_BLOCK_RING_SUMS_H

#include "common/instructions.h"

#include <arb.h>
#include <flint/fmpz.h>
#include <stdbool.h>

enum { TP_A2, TP_X6, TP_Y6, TP_XX12, TP_YY12, TP_XY24, TP_SUM_COUNT };
enum { TP_AREA_SUM_COUNT = TP_Y6 + 1 };

/* Degree of each sum in x and in y. */
typedef struct tp_degree {
  int x, y;
} tp_degree;
extern const tp_degree tp_sum_degree[TP_SUM_COUNT];

/* Exactly. The sums must be initialised. */
void tp_ring_sums_exact(fmpz sums[TP_SUM_COUNT], const fmpz *x, const fmpz *y, long count);
void tp_ring_sums_exact_first(fmpz *sums, const fmpz *x, const fmpz *y, long count, int sum_count);

/* In balls of `bits` bits. */
void tp_ring_sums_ball(arb_struct sums[TP_SUM_COUNT], const fmpz *x, const fmpz *y, long count,
                       long bits);
void tp_ring_sums_ball_first(arb_struct *sums, const fmpz *x, const fmpz *y, long count, long bits,
                             int sum_count);

/* The most threads that sum one ring. */
enum { TP_SUMS_THREADS = 16 };

/* How the two forms in double go about their work; the result does not depend on `instructions`
 * and `threads`. Only sets that are present may be asked for. */
typedef struct tp_sums_plan {
  int sum_count; /* TP_AREA_SUM_COUNT or TP_SUM_COUNT */
  tp_instructions instructions;
  int threads; /* at most TP_SUMS_THREADS; 0: as many as the process may run on, one up to
                  3 * 2^18 edges */
} tp_sums_plan;

/* In double with a proven bound: |sums[k] - truth| <= bounds[k], for coordinates that are exact
 * or (`exact` false) integers times a power of two rounded to nearest, the largest of each axis at
 * least 1: otherwise underflow cannot be bounded, and the bounds are infinite. The same bits on
 * every machine. */
void tp_ring_sums_double(double sums[TP_SUM_COUNT], double bounds[TP_SUM_COUNT], const double *u,
                         const double *v, long count, bool exact);
void tp_ring_sums_double_first(double *sums, double *bounds, const double *u, const double *v,
                               long count, bool exact, tp_sums_plan plan);

/* The unevaluated sum high + low, |low| at most half a unit in the last place of `high`. */
typedef struct tp_double_pair {
  double high, low;
} tp_double_pair;

/* In pairs of doubles with a proven bound: |high + low - truth| <= bound, for coordinates that are
 * integers of magnitude up to 2^53. The same bits on every machine. */
void tp_ring_sums_compensated(tp_double_pair sums[TP_SUM_COUNT], double bounds[TP_SUM_COUNT],
                              const double *u, const double *v, long count);
void tp_ring_sums_compensated_first(tp_double_pair *sums, double *bounds, const double *u,
                                    const double *v, long count, tp_sums_plan plan);

#endif
