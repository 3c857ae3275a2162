/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A quantile of a column of independent samples, linear between the order statistics, and a
 * distribution-free interval: from the l-th smallest to the h-th, where the binomial number of
 * samples below the true quantile is below l, and at least h, with no more than half of 1 -
 * confidence each (David and Nagaraja, Order Statistics, 2003, section 7.1). Tails of the binomial
 * are summed term by term from their largest, right to some 1e-10 of themselves up to 1e9 samples.
 */

#ifndef TP_STATISTICS_QUANTILES_H
#define TP_STATISTICS_QUANTILES_H

#include "statistics/estimate.h"

#include <stddef.h>

/* Rising order; a NaN has no place in it. */
void tp_column_sort(double *values, size_t count);

/* At the probability p, 0 < p < 1, of at least one sorted value. An end of the interval that so few
 * samples do not tell is infinite; none excludes the quantile itself. */
tp_estimate tp_column_quantile(const double *sorted, size_t count, double p, double confidence);

#endif
