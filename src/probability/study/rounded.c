/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Nine digits of what is computed are certain; rows show one more.
 *
 * A whole number of ten digits over, or times, a power of ten up to 10^22 is a quotient or product
 * of two doubles, so that its rounding is that of the decimal. */

#include "number/shortest.h"
#include "study/row.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { MOST_POWER = 22 };
static const double powers[MOST_POWER + 1] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                              1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                              1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

static double by_text(double value) {
  char text[TP_SHORTEST_SIZE];
  snprintf(text, sizeof text, "%.*e", TP_ROW_DIGITS - 1, value);
  return strtod(text, NULL);
}

/* The product is rounded once: where that might change which whole number is the nearest, the text
 * tells. */
double tp_study_rounded(double value) {
  static const double least = 1e-10, most = 1e9;
  const double size = fabs(value);
  if (size == 0 || !isfinite(value)) return value;
  if (!(size >= least && size < most)) return by_text(value);
  int power = 0;
  while (size * powers[power] < powers[TP_ROW_DIGITS - 1]) power++;
  const double scaled = size * powers[power], whole = rint(scaled);
  if (fabs(fabs(scaled - whole) - 0.5) < 1e-5) return by_text(value);
  return copysign(whole / powers[power], value);
}

void tp_study_round_row(tp_study_row *row, const tp_study *study) {
  for (size_t k = 0; k < TP_STUDY_QUANTITIES; k++) {
    row->quantities[k] = tp_study_rounded(row->quantities[k]);
  }
  for (size_t k = 0; k <= study->tilt_count; k++) {
    row->at[k].fos = tp_study_rounded(row->at[k].fos);
  }
  for (size_t k = 0; k < study->measure_count; k++) {
    row->measures[k] = tp_study_rounded(row->measures[k]);
  }
  row->fos_moments = tp_study_rounded(row->fos_moments);
  row->fos_sliding = tp_study_rounded(row->fos_sliding);
  row->pivot_x_m = tp_study_rounded(row->pivot_x_m);
  row->pivot_y_m = tp_study_rounded(row->pivot_y_m);
}
