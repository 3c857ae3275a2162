/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Tails by GSL's incomplete beta function, density by logarithms, quantile by Newton's method on
 * logarithms within a bisection bracket. */

#include "sampling/beta.h"

#include <gsl/gsl_cdf.h>
#include <math.h>

/* ln B(a, b); lgamma would write to signgam, which all threads share. */
static double log_beta(double a, double b) {
  int sign;
  return lgamma_r(a, &sign) + lgamma_r(b, &sign) - lgamma_r(a + b, &sign);
}

tp_tails tp_beta_tails(double a, double b, double x) {
  if (!(x > 0)) return (tp_tails){0, 1};
  if (!(x < 1)) return (tp_tails){1, 0};
  return (tp_tails){gsl_cdf_beta_P(x, a, b), gsl_cdf_beta_Q(x, a, b)};
}

double tp_beta_density(double a, double b, double x) {
  if (!(x >= 0 && x <= 1)) return 0;
  if (x == 0) return a > 1 ? 0 : a < 1 ? INFINITY : b;
  if (x == 1) return b > 1 ? 0 : b < 1 ? INFINITY : a;
  return exp((a - 1) * log(x) + (b - 1) * log1p(-x) - log_beta(a, b));
}

/* Where to begin with ln x: below the middle the first term of the series, x^a / (a B), above it as
 * of a normal variable. */
static double begin(double a, double b, double p, double of_beta) {
  const double mean = a / (a + b), deviation = sqrt(mean * (1 - mean) / (a + b + 1));
  const double normal = mean + deviation * gsl_cdf_ugaussian_Pinv(p);
  const double series = (log(p) + log(a) + of_beta) / a;
  return normal > mean / 4 ? log(normal) : series;
}

/* x with I_x(a, b) = p <= 1/2. ln I rises with t = ln x by x f(x) / I. */
static double smaller_tail(double a, double b, double p) {
  enum { STEPS = 200 };
  static const double least = -7000; /* ln x, at 1e-300 and a = 0.1 */
  const double wanted = log(p), of_beta = log_beta(a, b);
  double low = least, high = 0, t = begin(a, b, p, of_beta);
  for (int step = 0; step < STEPS; step++) {
    if (!(t > low && t < high)) t = 0.5 * (low + high);
    const double x = exp(t), own = gsl_cdf_beta_P(x, a, b);
    if (x < 0x1p-1000) return x; /* only of a < 1, where the series is exact */
    const double past = log(own) - wanted;
    if (past < 0) low = t;
    if (past > 0) high = t;
    const double move = past * own / exp(a * t + (b - 1) * log1p(-x) - of_beta);
    if (past == 0 || high - low <= 0x1p-52 * fabs(t)) return x;
    t -= move;
    if (fabs(move) < 0x1p-32) break; /* the next step would be as its square */
  }
  return exp(t);
}

tp_tails tp_beta_at(double a, double b, tp_tails tails) {
  if (!(tails.p > 0)) return (tp_tails){0, 1};
  if (!(tails.q > 0)) return (tp_tails){1, 0};
  const double part =
      tails.p <= tails.q ? smaller_tail(a, b, tails.p) : smaller_tail(b, a, tails.q);
  return tails.p <= tails.q ? (tp_tails){part, 1 - part} : (tp_tails){1 - part, part};
}
