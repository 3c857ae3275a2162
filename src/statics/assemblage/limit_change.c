/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* minimise -s has the Lagrangian -s - y . (A f + w0 + s w1) - z . f + w . (f - most), with
 * w = max(0, A^T y): what it changes by, f, s, y and w kept, is what -s does. */

#include "assemblage/limit_change.h"

#include <math.h>

/* y . (A f + w0 + s w1) of a program, with w . most at the prices of `from`. */
static double value_of(const tp_load_bracket *b, const tp_force_program *from,
                       const tp_force_program *p) {
  double sum = 0;
  for (long r = 0; r < p->rows; r++) {
    sum += b->twists[r] * (p->dead[r].value + b->bound * p->live[r].value);
  }
  for (long k = 0; k < p->count; k++) {
    sum += b->forces[k] * tp_force_column_work(p->columns + k, b->twists);
    if (isfinite(p->columns[k].most.value)) {
      sum += fmax(0, tp_force_column_work(from->columns + k, b->twists)) * p->columns[k].most.value;
    }
  }
  return sum;
}

double tp_limit_change(const tp_load_bracket *b, const tp_force_program *from,
                       const tp_force_program *to) {
  double live = 0;
  for (long r = 0; r < from->rows; r++) live -= from->live[r].value * b->twists[r];
  return (value_of(b, from, to) - value_of(b, from, from)) / live;
}
