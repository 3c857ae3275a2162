/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A scaled program of less strength: tan(phi) and all bounds divided, with its bound on errors. */

#include "linear_program/scaled.h"

#include "number/binary.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Size one again, by the power of two that is returned. */
static double normalise(double column[3]) {
  const double size = tp_larger(fabs(column[0]), fabs(column[1]));
  double factor;
  if (size > 0x1p-1000 && size < 0x1p1000) {
    factor = tp_two_to(-tp_binary_exponent(size));
  } else {
    int exponent = 0;
    (void)frexp(size, &exponent);
    factor = ldexp(1, -exponent);
  }
  for (int row = 0; row < 3; row++) column[row] *= factor;
  return factor;
}

bool tp_scaled_copy(tp_scaled *copy, const tp_scaled *scaled) {
  const size_t count = (size_t)scaled->count + 1;
  *copy = *scaled;
  copy->columns = calloc(count, sizeof *copy->columns);
  copy->most = scaled->most != NULL ? calloc(count, sizeof *copy->most) : NULL;
  copy->at_most = scaled->most != NULL ? calloc(count, sizeof *copy->at_most) : NULL;
  arb_init(copy->x);
  arb_init(copy->y);
  arb_set(copy->x, scaled->x);
  arb_set(copy->y, scaled->y);
  if (copy->columns == NULL ||
      (scaled->most != NULL && (copy->most == NULL || copy->at_most == NULL))) {
    tp_scaled_clear(copy);
    return false;
  }
  memcpy(copy->columns, scaled->columns, (count - 1) * sizeof *copy->columns);
  if (scaled->most != NULL) memcpy(copy->most, scaled->most, (count - 1) * sizeof *copy->most);
  return true;
}

void tp_scaled_divide_strength(tp_scaled *scaled, const tp_scaled *given, long edges,
                               double divisor) {
  double factor = 0;
  for (int row = 0; row < 3; row++) scaled->largest[row] = given->largest[row];
  for (long k = 0; k < edges; k += 2) {
    double *with = scaled->columns[k], *against = scaled->columns[k + 1];
    for (int row = 0; row < 3; row++) {
      const double first = given->columns[k][row], second = given->columns[k + 1][row];
      const double mean = (first + second) / 2, half = (first - second) / (2 * divisor);
      with[row] = mean + half;
      against[row] = mean - half;
    }
    factor = tp_larger(tp_larger(factor, normalise(with)), normalise(against));
    for (int row = 0; row < 3; row++) {
      const double own = tp_larger(fabs(with[row]), fabs(against[row]));
      scaled->largest[row] = tp_larger(scaled->largest[row], own);
    }
  }
  /* three roundings of what is at most the largest over a small divisor */
  double largest = 0;
  for (int row = 0; row < 3; row++) largest = fmax(largest, given->largest[row]);
  scaled->error = factor * (1 + 1 / divisor) * (given->error + 3 * DBL_EPSILON * largest);
  for (long k = edges; k < given->count; k++) scaled->most[k] = given->most[k] / divisor;
}
