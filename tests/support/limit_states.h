/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Limit states of a closed form, and their design points as the first-order method finds them. */

#ifndef TP_TEST_LIMIT_STATES_H
#define TP_TEST_LIMIT_STATES_H

#include "statistics/form.h"

enum { MOST = 10 };

/* A limit state, with what it is made of, and the points that it was asked at. */
typedef struct limit_state {
  double (*g)(const double *x, const double *of, size_t n);
  size_t n;
  double of[MOST + 1];
  uint64_t points;
} limit_state;

/* Of a limit state, which it counts the points of. */
tp_reliability problem_of(limit_state *own, const tp_distribution *variables,
                          const double *correlation);

/* By the first-order method, with its calls, its distance and its importances compared. */
tp_form found(const tp_reliability *problem);

/* of[n] + sum of[k] x_k. */
double plane(const double *x, const double *of, size_t n);
/* of[n]^2 - |x - of|^2: fails without a sphere. */
double sphere(const double *x, const double *of, size_t n);
/* Undecided beyond the last number, and failing beyond 5, of the first variable. */
double gap(const double *x, const double *of, size_t n);

/* The value is the truth to within this. */
void near(double value, double truth, double room);
/* GSL must not call its handler. */
void refuse_gsl(void);

#endif
