/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Rows are scaled by powers of two. With u = 2^-53, a sum of n products in doubles is off by less
 * than 2 (n + 2) u times the sum of their sizes, whatever the rounding mode; sums of terms that are
 * not negative, each of fewer than n + 8 roundings, are covered by a factor 1 + 4 (n + 8) u. */

#include "contact_modes/enclosed_solve.h"

#include "number/ball.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

typedef struct enclosing {
  long n, bits;
  const arb_mat_struct *a, *b;
  double *matrix, *inverse, *work; /* n x n, row by row: A, R, and room */
  double *off;                     /* by row: sum of |A - its doubles| */
  long *scale;                     /* by row, as an exponent of two */
  arb_mat_t residual;
} enclosing;

static double upwards(const enclosing *s, double number) {
  return number * (1 + 4 * (double)(s->n + 8) * DBL_EPSILON) + DBL_MIN;
}

/* ---- the inverse -------------------------------------------------------------------------------
 */

/* A double near to a ball over 2^scale, and how far off at most. */
static double near_to(double *off, const arb_t ball, long scale) {
  arb_t own;
  arb_init(own);
  arb_mul_2exp_si(own, ball, -scale);
  const tp_near near = tp_ball_near(own);
  arb_clear(own);
  *off += near.error;
  return near.value;
}

static bool set_matrix(enclosing *s) {
  for (long r = 0; r < s->n; r++) {
    double most = 0, off = 0;
    for (long c = 0; c < s->n; c++) {
      const arb_struct *entry = arb_mat_entry(s->a, r, c);
      most = fmax(most, fabs(arf_get_d(arb_midref(entry), ARF_RND_NEAR)));
    }
    if (!(most > 0) || !isfinite(most)) return false;
    s->scale[r] = ilogb(most);
    for (long c = 0; c < s->n; c++) {
      const arb_struct *entry = arb_mat_entry(s->a, r, c);
      const bool none = arb_is_zero(entry);
      s->matrix[r * s->n + c] = none ? 0 : near_to(&off, entry, s->scale[r]);
    }
    s->off[r] = upwards(s, off);
  }
  return true;
}

static void swap_rows(double *matrix, long n, long r, long q) {
  for (long c = 0; c < n && r != q; c++) {
    const double own = matrix[r * n + c];
    matrix[r * n + c] = matrix[q * n + c];
    matrix[q * n + c] = own;
  }
}

/* Row r less so much of row q. */
static void subtract(double *matrix, long n, long r, long q, double factor, long from) {
  for (long c = from; c < n; c++) matrix[r * n + c] -= factor * matrix[q * n + c];
}

/* Gauss and Jordan's, with the largest pivot of each column. */
static bool invert(enclosing *s) {
  const long n = s->n;
  for (long k = 0; k < n * n; k++) s->work[k] = s->matrix[k];
  for (long k = 0; k < n * n; k++) s->inverse[k] = k % (n + 1) == 0 ? 1 : 0;
  for (long k = 0; k < n; k++) {
    long best = k;
    for (long r = k + 1; r < n; r++) {
      if (fabs(s->work[r * n + k]) > fabs(s->work[best * n + k])) best = r;
    }
    swap_rows(s->work, n, k, best);
    swap_rows(s->inverse, n, k, best);
    const double pivot = s->work[k * n + k];
    if (!(fabs(pivot) > DBL_MIN)) return false;
    for (long c = 0; c < n; c++) {
      s->work[k * n + c] /= pivot;
      s->inverse[k * n + c] /= pivot;
    }
    for (long r = 0; r < n; r++) {
      const double factor = s->work[r * n + k];
      if (r == k || factor == 0) continue;
      subtract(s->work, n, r, k, factor, k);
      subtract(s->inverse, n, r, k, factor, 0);
    }
  }
  return true;
}

/* A bound of the row sums of |I - R A|; row sums of |A| are in `work`. */
static double bound_of_rest(enclosing *s) {
  const long n = s->n;
  const double rounding = 2 * (double)(n + 2) * DBL_EPSILON;
  double most = 0, *sizes = s->work, *row = s->work + n;
  for (long r = 0; r < n; r++) {
    sizes[r] = 0;
    for (long c = 0; c < n; c++) sizes[r] += fabs(s->matrix[r * n + c]);
  }
  for (long r = 0; r < n; r++) {
    double sum = 0;
    for (long c = 0; c < n; c++) row[c] = r == c ? 1 : 0;
    for (long k = 0; k < n; k++) {
      const double own = s->inverse[r * n + k];
      if (own == 0) continue;
      for (long c = 0; c < n; c++) row[c] -= own * s->matrix[k * n + c];
      sum += fabs(own) * (rounding * upwards(s, sizes[k]) + s->off[k]);
    }
    for (long c = 0; c < n; c++) sum += fabs(row[c]);
    sum += rounding; /* of the one */
    if (!isfinite(sum)) return INFINITY;
    most = fmax(most, sum);
  }
  return upwards(s, most);
}

/* ---- the solution ------------------------------------------------------------------------------
 */

static void set_residual(enclosing *s, const arb_mat_t x) {
  for (long r = 0; r < s->n; r++) {
    arb_struct *own = arb_mat_entry(s->residual, r, 0);
    arb_set(own, arb_mat_entry(s->b, r, 0));
    for (long c = 0; c < s->n; c++) {
      const arb_struct *entry = arb_mat_entry(s->a, r, c);
      if (!arb_is_zero(entry)) arb_submul(own, entry, arb_mat_entry(x, c, 0), s->bits);
    }
    arb_mul_2exp_si(own, own, -s->scale[r]);
  }
}

/* x0 comes nearer, exactly a number with no bound. */
static void improve(enclosing *s, arb_mat_t x) {
  arb_t step;
  arb_init(step);
  set_residual(s, x);
  for (long r = 0; r < s->n; r++) {
    s->work[r] = arf_get_d(arb_midref(arb_mat_entry(s->residual, r, 0)), ARF_RND_NEAR);
  }
  for (long r = 0; r < s->n; r++) {
    double sum = 0;
    for (long c = 0; c < s->n; c++) sum += s->inverse[r * s->n + c] * s->work[c];
    arb_set_d(step, sum);
    arb_struct *own = arb_mat_entry(x, r, 0);
    arb_add(own, own, step, s->bits);
    mag_zero(arb_radref(own));
  }
  arb_clear(step);
}

static bool enclose(enclosing *s, arb_mat_t x, double rest) {
  double most = 0, *sizes = s->work, *sums = s->work + s->n;
  set_residual(s, x);
  for (long r = 0; r < s->n; r++) {
    const tp_near near = tp_ball_near(arb_mat_entry(s->residual, r, 0));
    const bool none = arb_is_zero(arb_mat_entry(s->residual, r, 0));
    sizes[r] = none ? 0 : fabs(near.value) + near.error;
  }
  for (long r = 0; r < s->n; r++) {
    double sum = 0;
    for (long c = 0; c < s->n; c++) sum += fabs(s->inverse[r * s->n + c]) * sizes[c];
    if (!isfinite(sum)) return false;
    sums[r] = sum == 0 ? 0 : upwards(s, sum);
    most = fmax(most, sums[r]);
  }
  const double common = most == 0 ? 0 : upwards(s, rest * most / (1 - rest));
  for (long r = 0; r < s->n; r++) {
    const double within = sums[r] + common;
    if (within == 0) continue;
    mag_t radius;
    mag_init(radius);
    mag_set_d(radius, upwards(s, within));
    arb_add_error_mag(arb_mat_entry(x, r, 0), radius);
    mag_clear(radius);
  }
  return true;
}

static bool solve(enclosing *s, arb_mat_t x) {
  enum { STEPS = 4 };
  static const double least = 0.25; /* far from one: x0 comes nearer by that at each step */
  if (!set_matrix(s) || !invert(s)) return false;
  const double rest = bound_of_rest(s);
  if (!(rest < least)) return false;
  arb_mat_zero(x);
  for (int k = 0; k < STEPS; k++) improve(s, x);
  return enclose(s, x, rest);
}

bool tp_enclosed_solve(bool *solved, arb_mat_t x, const arb_mat_t a, const arb_mat_t b, long bits) {
  const long n = arb_mat_nrows(a);
  const size_t square = (size_t)(n * n) + 2 * (size_t)n + 1;
  enclosing s = {.n = n,
                 .bits = bits,
                 .a = a,
                 .b = b,
                 .matrix = calloc(square, sizeof *s.matrix),
                 .inverse = calloc(square, sizeof *s.inverse),
                 .work = calloc(square, sizeof *s.work),
                 .off = calloc((size_t)n + 1, sizeof *s.off),
                 .scale = calloc((size_t)n + 1, sizeof *s.scale)};
  const bool made =
      s.matrix != NULL && s.inverse != NULL && s.work != NULL && s.off != NULL && s.scale != NULL;
  arb_mat_init(s.residual, n, 1);
  *solved = made && solve(&s, x);
  arb_mat_clear(s.residual);
  free(s.matrix);
  free(s.inverse);
  free(s.work);
  free(s.off);
  free(s.scale);
  return made;
}
