/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The distribution of one variable, in doubles: its distribution function, quantiles, density, mean
 * and deviation, also truncated. Closed forms, and of the normal and the beta distribution the
 * functions of the GNU Scientific Library; the quantile of beta by Newton's method on the logarithm
 * of its distribution function, kept in a bracket (beta.c).
 *
 * Both tails are carried, p and q = 1 - p, each right by itself, so that a quantile is as good at
 * q = 1e-12 as at p = 1e-12: right to 1e-13 of the spread between the 1e-12 tails, for beta to
 * 1e-12 of its range. */

#ifndef TP_SAMPLING_DISTRIBUTION_H
#define TP_SAMPLING_DISTRIBUTION_H

#include "common/message.h"
#include "sampling/tails.h"

typedef enum tp_distribution_kind {
  TP_DISTRIBUTION_LIST, /* these values, each as likely as every other */
  TP_DISTRIBUTION_UNIFORM,
  TP_DISTRIBUTION_NORMAL,
  TP_DISTRIBUTION_LOGNORMAL,
  TP_DISTRIBUTION_TRIANGULAR,
  TP_DISTRIBUTION_BETA,
  TP_DISTRIBUTION_EMPIRICAL /* quantiles linear between the values, from the least to the largest */
} tp_distribution_kind;

/* Made by the calls below alone, whatever they are given: tp_distribution_check says whether it is
 * a distribution, before anything else is asked of it. Holds no memory. */
typedef struct tp_distribution {
  tp_distribution_kind kind;
  double mean, deviation;      /* normal; lognormal: of the variable itself */
  double log_mean, log_spread; /* lognormal: of its logarithm */
  double low, high;            /* ends of a uniform, triangular or beta one */
  double mode;                 /* triangular */
  double a, b;                 /* beta, on [low, high] */
  const double *values;        /* list, empirical: rising; the caller's */
  size_t count;
  bool truncated;
  double truncated_low, truncated_high;
  tp_tails below, above; /* where it is truncated, of the distribution that is not */
  double mass;           /* that lies between */
} tp_distribution;

tp_distribution tp_distribution_list(const double *values, size_t count);
tp_distribution tp_distribution_uniform(double low, double high);
tp_distribution tp_distribution_normal(double mean, double deviation);
tp_distribution tp_distribution_lognormal(double mean, double deviation);
tp_distribution tp_distribution_triangular(double low, double mode, double high);
tp_distribution tp_distribution_beta(double a, double b, double low, double high);
tp_distribution tp_distribution_empirical(const double *values, size_t count);

/* Given that it lies within [low, high]; an end may be infinite. Truncates once, not twice. */
tp_distribution tp_distribution_truncated(tp_distribution whole, double low, double high);

/* Is it one? TP_BAD_INPUT, and what to do, where parameters contradict each other or the truncation
 * leaves nothing; `name` is the variable's, from outside. */
tp_status tp_distribution_check(const tp_distribution *d, const char *name, tp_place place,
                                tp_message *message) TP_MUST_USE;

/* uniform, normal ...; NULL for a number that is no kind. */
const char *tp_distribution_kind_name(tp_distribution_kind kind);

/* The number below which the probability is u, 0 < u < 1; and by both tails. */
double tp_distribution_quantile(const tp_distribution *d, double u);
double tp_distribution_at(const tp_distribution *d, tp_tails tails);

/* The quantile at the probability of a standard normal variable below z, whatever |z| up to 37. */
double tp_distribution_at_score(const tp_distribution *d, double z);

/* P(X <= x), and with P(X > x). */
double tp_distribution_cdf(const tp_distribution *d, double x);
tp_tails tp_distribution_tails(const tp_distribution *d, double x);

/* 0 outside, and everywhere for a list. */
double tp_distribution_density(const tp_distribution *d, double x);

double tp_distribution_mean(const tp_distribution *d);
double tp_distribution_deviation(const tp_distribution *d);

#endif
