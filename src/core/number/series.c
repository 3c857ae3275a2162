/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Power spectrum, least-squares line and standard deviation of a series by the GNU Scientific
 * Library; the transform runs over columns and rows of a table, so that each fits into a cache
 * (Bailey, J. Supercomputing 4 (1990) 23-35).
 *
 * GSL's handler of errors is never called (number/root.c tells why): what these functions refuse, a
 * count that is no power of two, is kept from them. */

#include "number/series.h"

#include <gsl/gsl_fft_complex.h>
#include <gsl/gsl_fit.h>
#include <gsl/gsl_statistics_double.h>
#include <math.h>

enum { ROWS_MOST = 1024, TOGETHER = 4, WHOLE_AT_ONCE = 8192 };

static const double pi = 3.14159265358979323846;

/* A transform of rows x columns complex numbers by transforms of columns, factors in between, and
 * transforms of rows (Bailey, J. Supercomputing 4 (1990) 23-35), so that each fits into a cache:
 * number k of the result stands in row k % rows, column k / rows. */
typedef struct table {
  double *z;
  size_t rows, columns;
} table;

/* Of so many columns side by side, which share the lines of memory that they lie in. */
static bool transform_columns(const table *t, size_t first, size_t together) {
  double column[TOGETHER][2 * ROWS_MOST];
  const double unit = -2 * pi / (double)(t->rows * t->columns);
  for (size_t row = 0; row < t->rows; row++) {
    const double *from = t->z + 2 * (row * t->columns + first);
    for (size_t k = 0; k < together; k++) {
      column[k][2 * row] = from[2 * k];
      column[k][2 * row + 1] = from[2 * k + 1];
    }
  }
  for (size_t k = 0; k < together; k++) {
    if (gsl_fft_complex_radix2_forward(column[k], 1, t->rows) != 0) return false;
  }
  for (size_t row = 0; row < t->rows; row++) {
    double *to = t->z + 2 * (row * t->columns + first);
    for (size_t k = 0; k < together; k++) {
      const double angle = unit * (double)(row * (first + k)), c = cos(angle), s = sin(angle);
      const double re = column[k][2 * row], im = column[k][2 * row + 1];
      to[2 * k] = c * re - s * im;
      to[2 * k + 1] = c * im + s * re;
    }
  }
  return true;
}

static bool transform(const table *t) {
  for (size_t first = 0; first < t->columns && t->rows > 1; first += TOGETHER) {
    if (!transform_columns(t, first, TOGETHER)) return false;
  }
  for (size_t row = 0; row < t->rows; row++) {
    double *own = t->z + 2 * row * t->columns;
    if (gsl_fft_complex_radix2_forward(own, 1, t->columns) != 0) return false;
  }
  return true;
}

static const double *at(const table *t, size_t k) {
  return t->z + 2 * ((k % t->rows) * t->columns + k / t->rows);
}

/* Two neighbours make one complex number z, and the transform Z of half as many holds that of all:
 * Y_j = (Z_j + Z'_j) / 2 - i e^(-2 pi i j / count) (Z_j - Z'_j) / 2, Z'_j the conjugate of
 * Z_(count / 2 - j). */
static double power_of(const table *t, size_t j) {
  const size_t half = t->rows * t->columns; /* a power of two */
  const double *here = at(t, j & (half - 1)), *there = at(t, (half - j) & (half - 1));
  const double even_re = (here[0] + there[0]) / 2, even_im = (here[1] - there[1]) / 2;
  const double odd_re = (here[1] + there[1]) / 2, odd_im = (there[0] - here[0]) / 2;
  const double angle = pi * (double)j / (double)half, c = cos(angle), s = sin(angle);
  const double re = even_re + c * odd_re + s * odd_im, im = even_im + c * odd_im - s * odd_re;
  return re * re + im * im;
}

bool tp_series_powers(double *powers, double *values, size_t count) {
  if (count < 2 || (count & (count - 1)) != 0) return false;
  const size_t half = count / 2;
  table t = {.z = values, .rows = 1, .columns = half};
  while (half > WHOLE_AT_ONCE && t.rows < ROWS_MOST && t.rows < t.columns) {
    t.rows *= 2;
    t.columns /= 2;
  }
  if (!transform(&t)) return false;
  for (size_t j = 0; j <= half; j++) powers[j] = power_of(&t, j);
  return true;
}

bool tp_series_fit(tp_series_line *line, const double *x, const double *y, size_t count) {
  if (count < 2) return false;
  tp_series_line own;
  double variance, covariance, of_slope; /* not used: they suppose errors that do not depend */
  own.spread_x = gsl_stats_tss(x, 1, count);
  if (!(own.spread_x > 0)) return false;
  (void)gsl_fit_linear(x, 1, y, 1, count, &own.at_zero, &own.slope, &variance, &covariance,
                       &of_slope, &own.residuals);
  *line = own;
  return true;
}

double tp_series_deviation(const double *values, size_t count) {
  return gsl_stats_sd(values, 1, count);
}
