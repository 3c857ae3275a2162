/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The beta distribution on [0, 1] of two parameters from TP_BETA_LEAST to TP_BETA_MOST: its tails
 * by the continued fraction of the GNU Scientific Library, its quantile by Newton's method on ln
 * I_x(a, b) over ln x, kept in a bracket that is halved where a step leaves it: of the smaller
 * tail, and so right to 1e-12 of x where p < 1/2, and of 1 - x elsewhere. GSL's own inverse ends
 * the process where it does not converge. */

#ifndef TP_SAMPLING_BETA_H
#define TP_SAMPLING_BETA_H

#include "sampling/tails.h"

#define TP_BETA_LEAST 0.1
#define TP_BETA_MOST 10000.0

tp_tails tp_beta_tails(double a, double b, double x);

/* x and 1 - x as p and q. */
tp_tails tp_beta_at(double a, double b, tp_tails tails);

double tp_beta_density(double a, double b, double x);

#endif
