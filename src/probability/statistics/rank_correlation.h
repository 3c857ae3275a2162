/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Spearman's rank correlation, Pearson's of the ranks, equal values sharing the mean of theirs. The
 * interval by Fisher's transformation, artanh r with the variance (1 + r^2 / 2) / (n - 3) of Bonett
 * and Wright (Psychometrika 65 (2000) 23-28), which is made for |r| below 0.95. */

#ifndef TP_STATISTICS_RANK_CORRELATION_H
#define TP_STATISTICS_RANK_CORRELATION_H

#include "common/message.h"
#include "statistics/estimate.h"

/* Ranks from 1 on, of values none of which is NaN; infinite ones have their place. */
tp_status tp_ranks(double *ranks, const double *values, size_t count,
                   tp_message *message) TP_MUST_USE;

/* Of two columns of ranks. No number where all of a column are equal; of fewer than four samples
 * the interval is all from -1 to 1. */
tp_estimate tp_rank_correlation(const double *x, const double *y, size_t count, double confidence);

#endif
