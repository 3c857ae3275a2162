/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Quantiles of the normal distribution by GSL, and of Student's by the beta distribution. */

#include "statistics/score.h"

#include "sampling/beta.h"

#include <gsl/gsl_cdf.h>
#include <math.h>

double tp_normal_score(double confidence, size_t intervals) {
  return gsl_cdf_ugaussian_Qinv((1 - confidence) / 2 / (double)intervals);
}

/* nu / (nu + t^2) has the beta distribution of nu / 2 and 1 / 2. GSL's own quantile ends the
 * process where it does not converge. */
double tp_student_score(double confidence, double freedom) {
  if (freedom / 2 > TP_BETA_MOST) return tp_normal_score(confidence, 1);
  const tp_tails part = tp_beta_at(freedom / 2, 0.5, (tp_tails){1 - confidence, confidence});
  return sqrt(freedom * part.q / part.p);
}
