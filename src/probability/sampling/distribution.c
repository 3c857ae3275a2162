/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Of a truncated distribution p = (F(x) - F(low)) / mass, and back F = F(low) + p mass, where all
 * three are told by the smaller tail, so that nothing cancels far out. */

#include "sampling/distribution.h"

#include "sampling/beta.h"

#include <gsl/gsl_cdf.h>
#include <math.h>

/* How many of the rising values are below x, or no more than it. */
static size_t rank_of(const tp_distribution *d, double x, bool strictly) {
  size_t from = 0, to = d->count;
  while (from < to) {
    const size_t middle = from + (to - from) / 2;
    const bool counts = strictly ? d->values[middle] < x : d->values[middle] <= x;
    if (counts) from = middle + 1;
    if (!counts) to = middle;
  }
  return from;
}

/* The place of x among the values, 0 at the first and count - 1 at the last. */
static double place_of(const tp_distribution *d, double x, bool strictly) {
  const size_t below = rank_of(d, x, strictly);
  if (below == 0) return 0;
  if (below == d->count) return (double)(d->count - 1);
  const double low = d->values[below - 1], high = d->values[below];
  return (double)(below - 1) + (high > low ? (x - low) / (high - low) : 1);
}

static tp_tails triangular_tails(const tp_distribution *d, double x) {
  const double width = d->high - d->low;
  if (x <= d->mode) {
    const double p = (x - d->low) / width * ((x - d->low) / (d->mode - d->low));
    return x > d->low ? (tp_tails){p, 1 - p} : (tp_tails){0, 1};
  }
  const double q = (d->high - x) / width * ((d->high - x) / (d->high - d->mode));
  return x < d->high ? (tp_tails){1 - q, q} : (tp_tails){1, 0};
}

static double triangular_at(const tp_distribution *d, tp_tails tails) {
  const double width = d->high - d->low;
  if (tails.p * width <= d->mode - d->low) {
    return d->low + sqrt(tails.p * width * (d->mode - d->low));
  }
  return d->high - sqrt(tails.q * width * (d->high - d->mode));
}

static tp_tails normal_tails(double z) {
  return (tp_tails){gsl_cdf_ugaussian_P(z), gsl_cdf_ugaussian_Q(z)};
}

static double normal_at(tp_tails tails) {
  return tails.p <= tails.q ? gsl_cdf_ugaussian_Pinv(tails.p) : gsl_cdf_ugaussian_Qinv(tails.q);
}

/* Of the whole; `strictly` without the probability of x itself, which lists and ties have. */
static tp_tails whole_tails(const tp_distribution *d, double x, bool strictly) {
  const double last = (double)d->count - 1;
  switch (d->kind) {
  case TP_DISTRIBUTION_LIST: {
    const double rank = (double)rank_of(d, x, strictly), count = (double)d->count;
    return (tp_tails){rank / count, (count - rank) / count};
  }
  case TP_DISTRIBUTION_UNIFORM: {
    const double width = d->high - d->low, at = fmin(fmax(x, d->low), d->high);
    return (tp_tails){(at - d->low) / width, (d->high - at) / width};
  }
  case TP_DISTRIBUTION_NORMAL:
    return normal_tails((x - d->mean) / d->deviation);
  case TP_DISTRIBUTION_LOGNORMAL:
    return x > 0 ? normal_tails((log(x) - d->log_mean) / d->log_spread) : (tp_tails){0, 1};
  case TP_DISTRIBUTION_TRIANGULAR:
    return triangular_tails(d, x);
  case TP_DISTRIBUTION_BETA:
    return tp_beta_tails(d->a, d->b, (x - d->low) / (d->high - d->low));
  case TP_DISTRIBUTION_EMPIRICAL: {
    const double place = place_of(d, x, strictly);
    return (tp_tails){place / last, (last - place) / last};
  }
  }
  return (tp_tails){NAN, NAN};
}

/* Of those from `first` to before `end`. */
static double listed_at(const tp_distribution *d, double p, size_t first, size_t end) {
  const double rank = ceil(p * (double)(end - first));
  const size_t k = first + (rank > 1 ? (size_t)rank - 1 : 0);
  return d->values[k < end ? k : end - 1];
}

static double value_at(const tp_distribution *d, double place) {
  const size_t last = d->count - 1, below = place < (double)last ? (size_t)place : last;
  if (below == last) return d->values[last];
  const double part = place - (double)below;
  return d->values[below] * (1 - part) + d->values[below + 1] * part;
}

static double whole_at(const tp_distribution *d, tp_tails tails) {
  switch (d->kind) {
  case TP_DISTRIBUTION_LIST:
    return listed_at(d, tails.p, 0, d->count);
  case TP_DISTRIBUTION_UNIFORM: {
    const double width = d->high - d->low;
    return tails.p <= tails.q ? d->low + tails.p * width : d->high - tails.q * width;
  }
  case TP_DISTRIBUTION_NORMAL:
    return d->mean + d->deviation * normal_at(tails);
  case TP_DISTRIBUTION_LOGNORMAL:
    return exp(d->log_mean + d->log_spread * normal_at(tails));
  case TP_DISTRIBUTION_TRIANGULAR:
    return triangular_at(d, tails);
  case TP_DISTRIBUTION_BETA: {
    const tp_tails part = tp_beta_at(d->a, d->b, tails);
    const double width = d->high - d->low;
    return tails.p <= tails.q ? d->low + part.p * width : d->high - part.q * width;
  }
  case TP_DISTRIBUTION_EMPIRICAL:
    return value_at(d, tails.p * (double)(d->count - 1));
  }
  return NAN;
}

tp_distribution tp_distribution_truncated(tp_distribution whole, double low, double high) {
  tp_distribution d = whole;
  d.truncated = true;
  d.truncated_low = low;
  d.truncated_high = high;
  /* nothing is computed of parameters that are none: GSL would end the process */
  if (tp_distribution_check(&whole, "", (tp_place){0}, NULL) != TP_OK) return d;
  d.below = whole_tails(&whole, low, true);
  d.above = whole_tails(&whole, high, false);
  d.mass = d.below.q < d.above.p ? d.below.q - d.above.q : d.above.p - d.below.p;
  return d;
}

double tp_distribution_at(const tp_distribution *d, tp_tails tails) {
  if (!d->truncated) return whole_at(d, tails);
  if (d->kind == TP_DISTRIBUTION_LIST) {
    return listed_at(d, tails.p, rank_of(d, d->truncated_low, true),
                     rank_of(d, d->truncated_high, false));
  }
  const tp_tails whole = {d->below.p + tails.p * d->mass, d->above.q + tails.q * d->mass};
  return fmin(fmax(whole_at(d, whole), d->truncated_low), d->truncated_high);
}

double tp_distribution_quantile(const tp_distribution *d, double u) {
  return tp_distribution_at(d, (tp_tails){u, 1 - u});
}

double tp_distribution_at_score(const tp_distribution *d, double z) {
  if (!d->truncated && d->kind == TP_DISTRIBUTION_NORMAL) return d->mean + d->deviation * z;
  if (!d->truncated && d->kind == TP_DISTRIBUTION_LOGNORMAL) {
    return exp(d->log_mean + d->log_spread * z);
  }
  return tp_distribution_at(d, normal_tails(z));
}

tp_tails tp_distribution_tails(const tp_distribution *d, double x) {
  const tp_tails whole = whole_tails(d, x, false);
  if (!d->truncated) return whole;
  if (x < d->truncated_low) return (tp_tails){0, 1};
  if (x >= d->truncated_high) return (tp_tails){1, 0};
  const double p = d->below.q < whole.p ? d->below.q - whole.q : whole.p - d->below.p;
  const double q = whole.q < d->above.p ? whole.q - d->above.q : d->above.p - whole.p;
  return (tp_tails){p / d->mass, q / d->mass};
}

double tp_distribution_cdf(const tp_distribution *d, double x) {
  return tp_distribution_tails(d, x).p;
}

static double normal_density(double z) {
  static const double at_zero = 0.39894228040143268;
  return at_zero * exp(-0.5 * z * z);
}

static double triangular_density(const tp_distribution *d, double x) {
  if (!(x >= d->low && x <= d->high)) return 0;
  const double peak = 2 / (d->high - d->low);
  if (x == d->mode) return peak;
  return x < d->mode ? peak * ((x - d->low) / (d->mode - d->low))
                     : peak * ((d->high - x) / (d->high - d->mode));
}

static double empirical_density(const tp_distribution *d, double x) {
  const size_t below = rank_of(d, x, false);
  if (below == 0 || below == d->count) return 0;
  return 1 / ((double)(d->count - 1) * (d->values[below] - d->values[below - 1]));
}

static double whole_density(const tp_distribution *d, double x) {
  switch (d->kind) {
  case TP_DISTRIBUTION_LIST:
    return 0;
  case TP_DISTRIBUTION_UNIFORM:
    return x >= d->low && x <= d->high ? 1 / (d->high - d->low) : 0;
  case TP_DISTRIBUTION_NORMAL:
    return normal_density((x - d->mean) / d->deviation) / d->deviation;
  case TP_DISTRIBUTION_LOGNORMAL:
    if (!(x > 0)) return 0;
    return normal_density((log(x) - d->log_mean) / d->log_spread) / (d->log_spread * x);
  case TP_DISTRIBUTION_TRIANGULAR:
    return triangular_density(d, x);
  case TP_DISTRIBUTION_BETA: {
    const double width = d->high - d->low;
    return tp_beta_density(d->a, d->b, (x - d->low) / width) / width;
  }
  case TP_DISTRIBUTION_EMPIRICAL:
    return empirical_density(d, x);
  }
  return NAN;
}

double tp_distribution_density(const tp_distribution *d, double x) {
  if (!d->truncated) return whole_density(d, x);
  return x >= d->truncated_low && x <= d->truncated_high ? whole_density(d, x) / d->mass : 0;
}
