/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Binomial tails summed from their largest term give the ranks of the interval's ends; the quantile
 * is interpolated between order statistics. */

#include "statistics/quantiles.h"

#include <gsl/gsl_cdf.h>
#include <math.h>
#include <stdlib.h>

static int compare(const void *left, const void *right) {
  const double a = *(const double *)left, b = *(const double *)right;
  return (a > b) - (a < b);
}

void tp_column_sort(double *values, size_t count) {
  qsort(values, count, sizeof *values, compare);
}

/* ln x!; lgamma would write to signgam, which all threads share. */
static double log_factorial(double x) {
  int sign;
  return lgamma_r(x + 1, &sign);
}

/* P(B <= k), k at most the mean of B of n trials of probability p: the terms fall from k down. */
static double lower_tail(double n, double p, double k) {
  if (k < 0) return 0;
  const double largest = exp(log_factorial(n) - log_factorial(k) - log_factorial(n - k) +
                             k * log(p) + (n - k) * log1p(-p));
  double term = 1, sum = 1;
  for (double j = k; j > 0 && term > 0x1p-60 * sum; j--) {
    term *= j / (n - j + 1) * ((1 - p) / p);
    sum += term;
  }
  return largest * sum;
}

/* The largest l with P(B <= l - 1) <= `most`, or 0: from where the normal distribution has it. */
static double rank_below(double n, double p, double most) {
  const double mean = n * p, spread = sqrt(mean * (1 - p));
  double rank = floor(mean - gsl_cdf_ugaussian_Qinv(most) * spread);
  rank = fmin(fmax(rank, 0), floor(mean));
  while (rank > 0 && lower_tail(n, p, rank - 1) > most) rank--;
  while (rank <= mean && lower_tail(n, p, rank) <= most) rank++;
  return rank;
}

/* Part of the way to infinity is infinitely far; from the one to the other, the nearer. */
static double between(double low, double high, double part) {
  if (part == 0 || low == high) return low;
  if (isinf(low) && isinf(high)) return part < 0.5 ? low : high;
  return low * (1 - part) + high * part;
}

tp_estimate tp_column_quantile(const double *sorted, size_t count, double p, double confidence) {
  const double n = (double)count, most = (1 - confidence) / 2, place = p * (n - 1);
  const size_t below = (size_t)place, above = below + 1 < count ? below + 1 : below;
  const double part = place - (double)below;
  const double low = rank_below(n, p, most), high = rank_below(n, 1 - p, most);
  const double value = between(sorted[below], sorted[above], part);
  tp_estimate e = {value, -INFINITY, INFINITY};
  if (low > 0) e.low = fmin(sorted[(size_t)low - 1], value);
  if (high > 0) e.high = fmax(sorted[count - (size_t)high], value);
  return e;
}
