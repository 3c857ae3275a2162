/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Mean and deviation: closed forms; of a truncated distribution the integrals over (0, 1) of the
 * quantile and of its square about the mean, by the double exponential rule (Takahasi and Mori,
 * Publ. RIMS 9 (1974) 721-741) over either half, cut at the mode of a triangular one, where the
 * quantile has a bend: right to 1e-12 of the deviation. What is listed is summed. */

#include "sampling/distribution.h"

#include <math.h>

/* Lists: plain sums. */
static double list_sum(const tp_distribution *d, double about, int power, size_t *count) {
  double sum = 0;
  *count = 0;
  for (size_t k = 0; k < d->count; k++) {
    const double value = d->values[k];
    if (d->truncated && (value < d->truncated_low || value > d->truncated_high)) continue;
    sum += power == 1 ? value - about : (value - about) * (value - about);
    (*count)++;
  }
  return sum;
}

static double list_moment(const tp_distribution *d, double about, int power) {
  size_t count;
  const double sum = list_sum(d, about, power, &count);
  return sum / (double)count;
}

/* Empirical: the quantile is linear between the values; of each stretch what is left of it. */
static double empirical_moment(const tp_distribution *d, double about, int power) {
  const double last = (double)(d->count - 1);
  const double from = d->truncated ? d->below.p * last : 0,
               to = d->truncated ? d->above.p * last : last;
  double sum = 0;
  for (size_t k = 0; k + 1 < d->count; k++) {
    const double begin = fmax(from, (double)k), end = fmin(to, (double)k + 1);
    if (!(begin < end)) continue;
    const double rise = d->values[k + 1] - d->values[k];
    const double x = d->values[k] + rise * (begin - (double)k) - about;
    const double y = d->values[k] + rise * (end - (double)k) - about;
    sum += (end - begin) * (power == 1 ? (x + y) / 2 : (x * x + x * y + y * y) / 3);
  }
  return sum / (to - from);
}

/* The integral over the lower part, of probability `part`, or over the upper one. s = 1 / (1 +
 * exp(-pi sinh t)) goes through (0, 1), and past |t| = 4 by less than 1e-37. */
static double half_moment(const tp_distribution *d, double about, int power, double part,
                          bool upper) {
  enum { STEPS = 256 };
  static const double step = 1.0 / 64, pi = 3.14159265358979324;
  double sum = 0;
  if (!(part > 0)) return 0;
  for (int k = -STEPS; k <= STEPS; k++) {
    const double t = k * step, grown = exp(-pi * sinh(t)), s = 1 / (1 + grown);
    const double weight = pi * cosh(t) * s * (grown / (1 + grown));
    const double tail = part * s;
    const tp_tails tails = upper ? (tp_tails){1 - tail, tail} : (tp_tails){tail, 1 - tail};
    const double value = tp_distribution_at(d, tails) - about;
    sum += weight * (power == 1 ? value : value * value);
  }
  return sum * step * part;
}

static double truncated_moment(const tp_distribution *d, double about, int power) {
  if (d->kind == TP_DISTRIBUTION_LIST) return list_moment(d, about, power);
  if (d->kind == TP_DISTRIBUTION_EMPIRICAL) return empirical_moment(d, about, power);
  const bool bent = d->kind == TP_DISTRIBUTION_TRIANGULAR;
  const tp_tails cut = bent ? tp_distribution_tails(d, d->mode) : (tp_tails){0.5, 0.5};
  return half_moment(d, about, power, cut.p, false) + half_moment(d, about, power, cut.q, true);
}

double tp_distribution_mean(const tp_distribution *d) {
  if (d->truncated) {
    const double about = tp_distribution_quantile(d, 0.5);
    return about + truncated_moment(d, about, 1);
  }
  switch (d->kind) {
  case TP_DISTRIBUTION_LIST:
    return d->values[0] + list_moment(d, d->values[0], 1);
  case TP_DISTRIBUTION_UNIFORM:
    return d->low + (d->high - d->low) / 2;
  case TP_DISTRIBUTION_NORMAL:
  case TP_DISTRIBUTION_LOGNORMAL:
    return d->mean;
  case TP_DISTRIBUTION_TRIANGULAR:
    return (d->low + d->mode + d->high) / 3;
  case TP_DISTRIBUTION_BETA:
    return d->low + (d->high - d->low) * (d->a / (d->a + d->b));
  case TP_DISTRIBUTION_EMPIRICAL:
    return d->values[0] + empirical_moment(d, d->values[0], 1);
  }
  return NAN;
}

double tp_distribution_deviation(const tp_distribution *d) {
  const double width = d->high - d->low;
  if (d->truncated) return sqrt(truncated_moment(d, tp_distribution_mean(d), 2));
  switch (d->kind) {
  case TP_DISTRIBUTION_LIST:
    return sqrt(list_moment(d, tp_distribution_mean(d), 2));
  case TP_DISTRIBUTION_UNIFORM:
    return width / sqrt(12);
  case TP_DISTRIBUTION_NORMAL:
  case TP_DISTRIBUTION_LOGNORMAL:
    return d->deviation;
  case TP_DISTRIBUTION_TRIANGULAR: {
    const double part = d->mode - d->low;
    return sqrt((width * width - width * part + part * part) / 18);
  }
  case TP_DISTRIBUTION_BETA: {
    const double sum = d->a + d->b;
    return width / sum * sqrt(d->a * d->b / (sum + 1));
  }
  case TP_DISTRIBUTION_EMPIRICAL:
    return sqrt(empirical_moment(d, tp_distribution_mean(d), 2));
  }
  return NAN;
}
