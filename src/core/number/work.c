/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Formula of the work of a step, and its bound for one question and for all. */

#include "number/work.h"

#include <math.h>
#include <stddef.h>

double tp_work_allowed(long columns) {
  static const double fixed = 6e7;      /* looks at a column in doubles, some nanoseconds each */
  static const double by_column = 1000; /* ... and a thousand looks at every one */
  return fixed + by_column * (double)columns;
}

void tp_work_begin(tp_work *work, long columns) {
  static const double share = 0.25; /* four questions may be as dear as may be */
  if (work == NULL) return;
  const double allowed = tp_work_allowed(columns);
  work->most = fmin(allowed, work->spent + share * allowed);
}

bool tp_work_spend(tp_work *work, double steps, long columns, long bits) {
  if (work == NULL) return true;
  if (work->spent > work->most) return false;
  /* Arb's price of a product in looks: linear in its bits, and from 2^13 of them on by squares */
  static const double linear = 0x1p-7, square = 0x1p-20;
  static const double of_step = 150; /* columns that a step costs whatever their number */
  const double b = (double)bits, each = 1 + linear * b + square * b * b;
  work->spent += steps * ((double)columns + of_step) * each;
  return work->spent <= work->most;
}
