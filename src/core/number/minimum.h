/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The least value of a function in doubles between two numbers, beside one where it is less than at
 * both: what a search proposes. By Brent's method (Algorithms for Minimization without Derivatives,
 * 1973, chapter 5) as the GNU Scientific Library has it. */

#ifndef TP_NUMBER_MINIMUM_H
#define TP_NUMBER_MINIMUM_H

#include <stdbool.h>

/* The value at a number, finite. */
typedef double (*tp_minimum_function)(double x, void *context);

typedef struct tp_minimum {
  double low, x, high;                 /* in order */
  double low_value, value, high_value; /* at `x` less than at both ends */
} tp_minimum;

/* Narrow it until it is no wider than `width`, or after `most` steps. False where it is none. */
bool tp_minimum_narrow(tp_minimum *minimum, tp_minimum_function function, void *context,
                       double width, int most);

#endif
