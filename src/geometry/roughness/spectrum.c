/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The periodogram: with weights w_k (Hann, 1/2 - 1/2 cos(2 pi (k + 1/2) / n), or 1) the n heights
 * are filled up with zeros to N, a power of two, and
 *   P(f_j) = 2 step |sum w_k y_k e^(-2 pi i j k / N)|^2 / sum w_k^2,   f_j = j / (N step),
 * half of that at 0 and at 1 / (2 step). The sum of P over all f_j, times their distance 1 / (N
 * step), is the mean square sum (w y)^2 / sum w^2 (Parseval). One ordinate is an estimate whose
 * standard deviation is as large as itself; only means over many are narrow. */

#include "roughness/spectrum.h"

#include "number/series.h"

#include <stdlib.h>

static size_t next_power(size_t count) {
  size_t power = 2;
  while (power < count) power *= 2;
  return power;
}

/* The weighted heights, and the sum of the squared weights. */
static double weigh(double *weighted, const tp_heights *h, tp_profile_window window) {
  static const double two_pi = 6.283185307179586;
  double squares = 0;
  for (size_t k = 0; k < h->count; k++) {
    const double part = ((double)k + 0.5) / (double)h->count;
    const double weight = window == TP_WINDOW_HANN ? 0.5 - 0.5 * cos(two_pi * part) : 1;
    weighted[k] = weight * h->values[k];
    squares += weight * weight;
  }
  return squares;
}

bool tp_spectrum_init(tp_spectrum *spectrum, const tp_heights *h, tp_profile_window window) {
  const size_t length = next_power(h->count);
  *spectrum = (tp_spectrum){.count = length / 2 + 1};
  spectrum->densities = calloc(spectrum->count, sizeof *spectrum->densities);
  double *values = calloc(length + spectrum->count, sizeof *values);
  const bool done = spectrum->densities != NULL && values != NULL;
  if (done) {
    double *powers = values + length;
    const double squares = weigh(values, h, window);
    (void)tp_series_powers(powers, values, length); /* a power of two */
    for (size_t j = 0; j < spectrum->count; j++) {
      const double sides = j == 0 || j == length / 2 ? 1 : 2;
      spectrum->densities[j] =
          (tp_profile_density){.frequency = (double)j / ((double)length * h->step),
                               .density = sides * h->step * powers[j] / squares};
    }
  } else {
    free(spectrum->densities);
    *spectrum = (tp_spectrum){0};
  }
  free(values);
  return done;
}
