/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A zero of a function in doubles between two numbers at which its signs differ: what a search
 * proposes, and balls certify after it. By Brent's method (Algorithms for Minimization without
 * Derivatives, 1973, chapter 4) as the GNU Scientific Library has it: some ten values where the
 * function is smooth; where it leaps up to twice as many as halving takes. */

#ifndef TP_NUMBER_ROOT_H
#define TP_NUMBER_ROOT_H

#include <stdbool.h>

/* The value at a number; false where there is none, which ends the search. */
typedef bool (*tp_root_function)(double *value, void *context, double x);

typedef struct tp_root_search {
  tp_root_function value;
  void *context;
  double flat;  /* a value no larger than this will do for zero */
  double width; /* a bracket no wider than this will do; 0: one between whose ends lies no double */
  int most;     /* samples, at most */
} tp_root_search;

/* An end of the range, and the value there, which is not sampled again. */
typedef struct tp_root_end {
  double x, value;
} tp_root_end;

/* The signs at both ends are those at the ends of the range. */
typedef struct tp_root {
  double low, high;
  bool flat; /* the value is as good as zero at `low`, which is `high` */
} tp_root;

/* False where the signs at the ends do not differ, where a value is missing or no number, and after
 * the most values. */
bool tp_root_find(tp_root *root, const tp_root_search *search, tp_root_end low, tp_root_end high);

#endif
