/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "number/work.h"

#include <math.h>
#include <stddef.h>

double tp_work_allowed(long columns) {
  static const double fixed = 6e7, by_column = 1000;
  return fixed + by_column * (double)columns;
}

void tp_work_begin(tp_work *work, long columns) {
  static const double share = 0.25;
  if (work == NULL) return;
  const double allowed = tp_work_allowed(columns);
  work->most = fmin(allowed, work->spent + share * allowed);
}

bool tp_work_spend(tp_work *work, double steps, long columns, long bits) {
  if (work == NULL) return true;
  if (work->spent > work->most) return false;
  const double b = (double)bits, each = 1 + b / 128 + b * b / (1024.0 * 1024.0);
  work->spent += steps * ((double)columns + 150) * each;
  return work->spent <= work->most;
}
