/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The Gaussian copula: y = L z makes independent standard normal z dependent ones, L L' = R, the
 * correlations of the normal scores (Nataf's model, Liu and Der Kiureghian 1986, with R for his
 * transformed matrix). R itself is what is given: for normal variables their correlation, and for
 * any others that of the scores, of which a rank correlation s is the same whatever the
 * distributions: s = (6 / pi) asin(r / 2).
 *
 * L by Cholesky's method, row by row. Each entry of R has, with those before it, a range in which
 * it can lie; the first that is out of it by more than 1e-10, for its roundings, is told. R may be
 * singular: a pivot whose square is below 1e-13 is taken for zero. L L' is R to 2e-10. */

#ifndef TP_SAMPLING_COPULA_H
#define TP_SAMPLING_COPULA_H

#include "common/message.h"

/* L, `dimensions` squared row by row, of R. TP_BAD_INPUT where R is no matrix of correlations, with
 * the pair that contradicts those before it; `names` of the variables, from outside, or NULL. */
tp_status tp_copula_factor(double *factor, const double *correlation, size_t dimensions,
                           const char *const *names, tp_message *message) TP_MUST_USE;

/* y = L z, in place. */
void tp_copula_apply(const double *factor, size_t dimensions, double *z);

/* The correlation of the scores for Spearman's rank correlation, 2 sin(pi s / 6), and the other
 * way.
 */
double tp_copula_of_rank(double rank);
double tp_copula_rank(double correlation);

#endif
