/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* By stripes of columns: each is factorised by itself, then taken from all behind it in squares
 * that stay in the machine's registers, six by three. */

#include "assemblage/front.h"

#include <math.h>

enum { STRIPE = 48, HIGH = 6, WIDE = 3 };

/* c -= a b^T, of `count` columns of a and b. */
static void take_tall(double *restrict c, long step, const double *restrict a,
                      const double *restrict b, long rows, long count) {
  double sum[WIDE][HIGH] = {{0}};
  for (long k = 0; k < count; k++, a += rows, b += rows) {
    for (int j = 0; j < WIDE; j++) {
      for (int i = 0; i < HIGH; i++) sum[j][i] += a[i] * b[j];
    }
  }
  for (int j = 0; j < WIDE; j++) {
    for (int i = 0; i < HIGH; i++) c[j * step + i] -= sum[j][i];
  }
}

static void take_short(double *restrict c, long step, const double *restrict a,
                       const double *restrict b, long rows, long count) {
  double sum[WIDE][WIDE] = {{0}};
  for (long k = 0; k < count; k++, a += rows, b += rows) {
    for (int j = 0; j < WIDE; j++) {
      for (int i = 0; i < WIDE; i++) sum[j][i] += a[i] * b[j];
    }
  }
  for (int j = 0; j < WIDE; j++) {
    for (int i = 0; i < WIDE; i++) c[j * step + i] -= sum[j][i];
  }
}

/* From the columns from … end - 1 of `target`, whose first row is row `top` of the stripe, on and
 * below the diagonal. */
static void take_all(double *target, long step, const double *stripe, long rows, long count,
                     long top, long end) {
  for (long j = top; j < end; j += WIDE) {
    double *own = target + (j - top) * step - top;
    long i = j;
    for (; i + HIGH <= rows; i += HIGH) {
      take_tall(own + i, step, stripe + i, stripe + j, rows, count);
    }
    if (i < rows) take_short(own + i, step, stripe + i, stripe + j, rows, count);
  }
}

/* Columns first … end - 1, from the diagonal down. */
static bool factorise_stripe(double *columns, long rows, long first, long end) {
  for (long j = first; j < end; j++) {
    double *restrict own = columns + j * rows;
    for (long k = first; k < j; k++) {
      const double *restrict other = columns + k * rows;
      const double share = other[j];
      for (long i = j; i < rows; i++) own[i] -= share * other[i];
    }
    if (!(own[j] > 0 && isfinite(own[j]))) return false;
    const double over = 1 / sqrt(own[j]);
    for (long i = j; i < rows; i++) own[i] *= over;
  }
  return true;
}

bool tp_front_factorise(double *columns, long rows, long own, double *rest) {
  for (long first = 0; first < own; first += STRIPE) {
    const long end = first + STRIPE < own ? first + STRIPE : own;
    const double *stripe = columns + first * rows;
    if (!factorise_stripe(columns, rows, first, end)) return false;
    take_all(columns + end * rows + end, rows, stripe, rows, end - first, end, own);
    take_all(rest, rows - own, stripe, rows, end - first, own, rows);
  }
  return true;
}

/* Three columns at a time: they take turns only within the square at their diagonal. */
void tp_front_solve(double *restrict v, const double *restrict columns, long rows, long own) {
  for (long j = 0; j < own; j += WIDE) {
    const double *a = columns + j * rows, *b = a + rows, *c = b + rows;
    const double x = v[j] /= a[j];
    const double y = v[j + 1] = (v[j + 1] - x * a[j + 1]) / b[j + 1];
    const double z = v[j + 2] = (v[j + 2] - x * a[j + 2] - y * b[j + 2]) / c[j + 2];
    for (long i = j + WIDE; i < rows; i++) v[i] -= x * a[i] + y * b[i] + z * c[i];
  }
}

void tp_front_solve_back(double *restrict v, const double *restrict columns, long rows, long own) {
  enum { SUMS = 2 };
  for (long j = own - WIDE; j >= 0; j -= WIDE) {
    const double *a = columns + j * rows, *b = a + rows, *c = b + rows;
    double x[SUMS] = {0}, y[SUMS] = {0}, z[SUMS] = {0};
    long i = j + WIDE;
    for (; i + SUMS <= rows; i += SUMS) {
      for (int k = 0; k < SUMS; k++) {
        x[k] += a[i + k] * v[i + k];
        y[k] += b[i + k] * v[i + k];
        z[k] += c[i + k] * v[i + k];
      }
    }
    for (; i < rows; i++) {
      x[0] += a[i] * v[i];
      y[0] += b[i] * v[i];
      z[0] += c[i] * v[i];
    }
    v[j + 2] = (v[j + 2] - (z[0] + z[1])) / c[j + 2];
    v[j + 1] = (v[j + 1] - (y[0] + y[1]) - b[j + 2] * v[j + 2]) / b[j + 1];
    v[j] = (v[j] - (x[0] + x[1]) - a[j + 1] * v[j + 1] - a[j + 2] * v[j + 2]) / a[j];
  }
}
