/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Taylor series by Horner's rule in doubles with bounds; the arctangent with the bound of its
 * derivative. */

#include "number/near_angle.h"

#include "number/arctangent.h"

#include <stdbool.h>

enum { TERMS = 9 }; /* of each series behind its first */
static const double left_out = 2e-20;

/* 1 - x^2 / (a (a + 1)) (1 - x^2 / ((a + 2) (a + 3)) (...)) with a = `first`. */
static tp_near series(tp_near square, int first) {
  const tp_near one = {1, 0};
  tp_near sum = one;
  for (int k = TERMS - 1; k >= 0; k--) {
    const double a = first + 2 * k;
    sum = tp_near_sub(one, tp_near_div(tp_near_mul(square, sum), (tp_near){a * (a + 1), 0}));
  }
  sum.error += left_out;
  return sum;
}

void tp_near_sin_cos(tp_near *sine, tp_near *cosine, tp_near degrees) {
  static const tp_near radian = {0.017453292519943295,
                                 4e-18}; /* pi / 180 = 0.0174532925199432958 */
  const double size = fabs(degrees.value);
  if (!(size <= 90) || !(degrees.error < 1)) {
    *sine = *cosine = (tp_near){0, INFINITY};
    return;
  }
  const bool steep = size > 45;
  tp_near own = {size, degrees.error};
  if (steep) own = tp_near_sub((tp_near){90, 0}, own);
  const tp_near x = tp_near_mul(own, radian), square = tp_near_mul(x, x);
  const tp_near along = tp_near_mul(x, series(square, 2)), across = series(square, 1);
  *sine = steep ? across : along;
  *cosine = steep ? along : across;
  if (degrees.value < 0) *sine = tp_near_neg(*sine);
}

/* Its derivative is 180/pi / (1 + t^2), at most that between two tangents of one sign at the one
 * nearer to zero. */
tp_near tp_near_arctangent(tp_near tangent) {
  static const double degrees = 57.3; /* of one radian, and more */
  const double size = fabs(tangent.value), least = size > tangent.error ? size - tangent.error : 0;
  if (tangent.value == 0 && tangent.error == 0) return (tp_near){0, 0};
  if (!(size < 0x1p400) || (size != 0 && size < 0x1p-400)) return (tp_near){0, INFINITY};
  const double value = tp_arctangent_degrees(tangent.value, 1);
  const double error = degrees * tangent.error / (1 + least * least);
  return tp_near_of(value, error + fabs(value) * TP_ARCTANGENT_ERROR);
}
