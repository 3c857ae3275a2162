/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Checks of a correlation matrix, its Cholesky factor row by row, and the conversion between rank
 * and score correlation. */

#include "sampling/copula.h"

#include "common/outside.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double pi = 3.14159265358979324;

double tp_copula_of_rank(double rank) {
  return 2 * sin(pi / 6 * rank);
}

double tp_copula_rank(double correlation) {
  return 6 / pi * asin(correlation / 2);
}

/* 'friction', or its number where there are no names. */
static void name_of(char text[160], const char *const *names, size_t k) {
  if (names == NULL) snprintf(text, 160, "variable %zu", k + 1);
  if (names != NULL) snprintf(text, 160, "'%s'", tp_quote_all(names[k]).text);
}

static tp_status refuse_entry(tp_message *message, const char *const *names, size_t row,
                              size_t column, const char *why) {
  char first[160], second[160];
  name_of(first, names, column);
  name_of(second, names, row);
  return tp_refuse(message, TP_FAULT_KEY, (tp_place){0}, "the correlation of %s with %s %s", first,
                   second, why);
}

static tp_status check_entries(const double *correlation, size_t n, const char *const *names,
                               tp_message *message) {
  char why[160];
  for (size_t row = 0; row < n; row++) {
    for (size_t column = 0; column <= row; column++) {
      const double own = correlation[row * n + column];
      if (row == column && own != 1) {
        return refuse_entry(message, names, row, column, "itself must be 1");
      }
      if (own != correlation[column * n + row]) {
        snprintf(why, sizeof why, "is given as %g and as %g: give it once", own,
                 correlation[column * n + row]);
        return refuse_entry(message, names, row, column, why);
      }
      if (!(fabs(own) <= 1)) {
        snprintf(why, sizeof why, "is %g: it must lie from -1 to 1", own);
        return refuse_entry(message, names, row, column, why);
      }
    }
  }
  return TP_OK;
}

/* One row of L. `left` is what the entries so far leave of 1, the square of the last. */
static tp_status factor_row(double *factor, const double *correlation, size_t n, size_t row,
                            const char *const *names, tp_message *message) {
  static const double square_least = 1e-13, entry_room = 1e-10;
  double left = 1;
  double *own = factor + row * n;
  for (size_t column = 0; column < row; column++) {
    const double *other = factor + column * n;
    double told = 0;
    for (size_t k = 0; k < column; k++) told += own[k] * other[k];
    const double rest = correlation[row * n + column] - told;
    const double most = other[column] * sqrt(left);
    if (!(fabs(rest) <= most + entry_room)) {
      char why[200];
      snprintf(
          why, sizeof why,
          "is %g, but by the correlations before it lies from %.6g to %.6g: change one of them",
          correlation[row * n + column], fmax(told - most, -1), fmin(told + most, 1));
      return refuse_entry(message, names, row, column, why);
    }
    if (other[column] > 0) own[column] = fmax(fmin(rest, most), -most) / other[column];
    left = fmax(left - own[column] * own[column], 0);
  }
  own[row] = left > square_least ? sqrt(left) : 0;
  return TP_OK;
}

tp_status tp_copula_factor(double *factor, const double *correlation, size_t dimensions,
                           const char *const *names, tp_message *message) {
  tp_status status = check_entries(correlation, dimensions, names, message);
  memset(factor, 0, dimensions * dimensions * sizeof *factor);
  for (size_t row = 0; row < dimensions && status == TP_OK; row++) {
    status = factor_row(factor, correlation, dimensions, row, names, message);
  }
  return status;
}

/* From the last on: each y is of the z up to its own. */
void tp_copula_apply(const double *factor, size_t dimensions, double *z) {
  for (size_t row = dimensions; row-- > 0;) {
    double y = 0;
    for (size_t k = 0; k <= row; k++) y += factor[row * dimensions + k] * z[k];
    z[row] = y;
  }
}
