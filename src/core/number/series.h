/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Series of doubles by the GNU Scientific Library: the discrete Fourier transform of a power of two
 * of real numbers (radix 2, in place; Cooley and Tukey), the line of least squares, and a standard
 * deviation. None asks for memory. */

#ifndef TP_NUMBER_SERIES_H
#define TP_NUMBER_SERIES_H

#include <stdbool.h>
#include <stddef.h>

/* The powers |Y_j|^2, j = 0 ... count / 2, of the transform Y of `values`, which are lost. `count`
 * is a power of two of at least 2; false for another one. Costs some 5 count log2(count) / 2
 * operations; a power is right to a few roundings of the largest. */
bool tp_series_powers(double *powers, double *values, size_t count);

/* y = at_zero + slope x through `count` points with |residuals|^2 in all. False where there are
 * fewer than two, or all x are equal. */
typedef struct tp_series_line {
  double at_zero, slope, spread_x; /* sum of (x - mean x)^2 */
  double residuals;
} tp_series_line;

bool tp_series_fit(tp_series_line *line, const double *x, const double *y, size_t count);

/* The standard deviation of a sample of at least two. */
double tp_series_deviation(const double *values, size_t count);

#endif
