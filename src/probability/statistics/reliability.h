/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A problem of reliability: variables with their distributions, dependent by a Gaussian copula, and
 * a limit-state function g of them that is not above 0 where the block fails. All methods work in
 * the space of independent standard normal scores z: y = L z (copula.h), x_i the quantile of
 * variable i at the probability of y_i. That is exact, not Nataf's approximation, as the copula is
 * what is given. */

#ifndef TP_STATISTICS_RELIABILITY_H
#define TP_STATISTICS_RELIABILITY_H

#include "sampling/distribution.h"

#include <stdint.h>

/* g at `count` points, one after another in `x`; NaN where it is undecided. Many are asked for at
 * once, so that they can be shared out to threads. A status other than TP_OK ends the method. */
typedef tp_status (*tp_limit_state)(double *g, void *context, const double *x, size_t count,
                                    tp_message *message);

typedef struct tp_reliability {
  size_t dimensions;
  const tp_distribution *variables; /* checked; with a list among them there is no design point */
  const double *correlation;        /* of the normal scores; NULL: independent */
  tp_limit_state limit_state;
  void *context;
} tp_reliability;

#endif
