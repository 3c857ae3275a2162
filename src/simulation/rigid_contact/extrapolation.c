/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Modified midpoint rule with Gragg's smoothing and the extrapolation table in h^2. */

#include "rigid_contact/extrapolation.h"

#include <math.h>
#include <string.h>

enum { MOST_COLUMNS = 9 };

typedef struct problem {
  tp_rates rates;
  void *context;
  double time, step;
  const double *state, *first; /* and the rates there */
} problem;

/* The modified midpoint rule with `count` substeps, an even number, and Gragg's smoothing. */
static bool midpoint(double end[TP_MOTION_NUMBERS], const problem *p, int count) {
  const double h = p->step / count;
  double before[TP_MOTION_NUMBERS], now[TP_MOTION_NUMBERS], rates[TP_MOTION_NUMBERS];
  memcpy(before, p->state, sizeof before);
  for (int e = 0; e < TP_MOTION_NUMBERS; e++) now[e] = before[e] + h * p->first[e];
  for (int k = 1; k <= count; k++) {
    if (!p->rates(rates, p->context, p->time + k * h, now)) return false;
    if (k == count) break;
    for (int e = 0; e < TP_MOTION_NUMBERS; e++) {
      const double next = before[e] + 2 * h * rates[e];
      before[e] = now[e];
      now[e] = next;
    }
  }
  for (int e = 0; e < TP_MOTION_NUMBERS; e++) end[e] = (before[e] + now[e] + h * rates[e]) / 2;
  return true;
}

tp_step_answer tp_extrapolate(double next[TP_MOTION_NUMBERS], tp_rates rates, void *context,
                              double time, const double state[TP_MOTION_NUMBERS], double step,
                              double tolerance) {
  double first[TP_MOTION_NUMBERS], table[MOST_COLUMNS][TP_MOTION_NUMBERS];
  tp_step_answer answer = {.error = INFINITY};
  const problem p = {rates, context, time, step, state, first};
  if (!rates(first, context, time, state)) return answer;
  for (int k = 0; k < MOST_COLUMNS; k++) {
    double column[TP_MOTION_NUMBERS];
    answer.columns = k + 1;
    answer.error = INFINITY;
    if (!midpoint(column, &p, 2 * (k + 1))) return answer;
    double error = 0;
    for (int e = 0; e < TP_MOTION_NUMBERS; e++) {
      double own = column[e];
      for (int j = 0; j < k; j++) {
        const double before = table[j][e], ratio = (double)(k + 1) / (k - j);
        table[j][e] = own;
        own += (own - before) / (ratio * ratio - 1);
        if (j == k - 1) error = fmax(error, fabs(own - table[j][e]));
      }
      table[k][e] = own;
    }
    if (k < 2) continue;
    answer.error = error / tolerance;
    answer.reached = answer.error <= 1;
    if (answer.reached) {
      memcpy(next, table[k], sizeof table[k]);
      return answer;
    }
  }
  return answer;
}
