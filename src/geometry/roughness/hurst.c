/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* By the structure function: half the slope of ln S over ln d, least squares over the lags from one
 * step to a 40th of the length. Means at neighbouring lags come from the same heights, so residuals
 * tell nothing of the spread: it is that of the exponents of eight parts of the profile, each by
 * the same lags, and the range is their Student's t of seven degrees of freedom over their mean.
 *
 * By the spectrum: least squares of ln P over ln f from 4 / length, below which the window blurs,
 * to 1 / (8 step), above which the chain's straight pieces do (Geweke and Porter-Hudak, J. Time
 * Series Analysis 4 (1983) 221-238). The logarithm of an ordinate has variance pi^2 / 6, so the
 * slope has (pi^2 / 6) c / S, S the spread of ln f and c the ordinates' number over that of
 * independent ones: N / n for the zeros, and for a Hann window 1 + 2 (4/9 + 1/36), whose neighbours
 * correlate. */

#include "roughness/hurst.h"

#include "number/series.h"

#include <stdlib.h>

enum { PARTS = 8, LAGS_LEAST = 4, LAGS_MOST = 128, FREQUENCIES_LEAST = 8, LAG_SHARE = 40 };

static const double student = 2.3646242510102993; /* 95 %, PARTS - 1 degrees of freedom */
static const double normal = 1.959963984540054;

/* H by these lags; false where two heights at some lag never differ. */
static bool exponent_by_lags(double *exponent, const tp_profile_lag *lags, size_t count) {
  double x[LAGS_MOST], y[LAGS_MOST];
  for (size_t j = 0; j < count; j++) {
    if (!(lags[j].structure > 0)) return false;
    x[j] = log(lags[j].distance);
    y[j] = log(lags[j].structure);
  }
  tp_series_line line;
  if (!tp_series_fit(&line, x, y, count)) return false;
  *exponent = line.slope / 2;
  return true;
}

/* The spread of the exponents of all parts, as that of their mean. */
static bool find_spread(double *spread, const tp_heights *h, const size_t *steps, size_t count) {
  double parts[PARTS];
  tp_profile_lag lags[LAGS_MOST];
  const size_t length = h->count / PARTS;
  for (size_t k = 0; k < PARTS; k++) {
    const tp_heights own = {h->values + k * length, length, h->step, h->mean_square};
    for (size_t j = 0; j < count; j++) lags[j] = tp_lag_measure(&own, steps[j]);
    if (!exponent_by_lags(parts + k, lags, count)) return false;
  }
  *spread = tp_series_deviation(parts, PARTS) / sqrt(PARTS);
  return true;
}

void tp_hurst_by_structure(tp_profile_estimate *hurst, double range[2], const tp_heights *h,
                           const tp_profile_lag *lags) {
  const size_t most = (h->count - 1) / LAG_SHARE, count = tp_lag_steps(NULL, most);
  size_t steps[LAGS_MOST];
  double spread;
  *hurst = (tp_profile_estimate){.found = false};
  if (count < LAGS_LEAST || count > LAGS_MOST) return;
  (void)tp_lag_steps(steps, most);
  hurst->found = exponent_by_lags(&hurst->value, lags, count);
  range[0] = h->step;
  range[1] = (double)steps[count - 1] * h->step;
  hurst->has_range = hurst->found && find_spread(&spread, h, steps, count);
  if (!hurst->has_range) return;
  hurst->low = hurst->value - student * spread;
  hurst->high = hurst->value + student * spread;
}

bool tp_hurst_by_spectrum(tp_profile_estimate *hurst, double range[2], const tp_spectrum *spectrum,
                          size_t samples, double step, tp_profile_window window) {
  static const double of_logarithm = 1.6449340668482264; /* pi^2 / 6 */
  static const double hann = 1 + 2 * (4.0 / 9 + 1.0 / 36);
  const double length = (double)(samples - 1) * step;
  const double from = 4 / length, to = 1 / (8 * step);
  *hurst = (tp_profile_estimate){.found = false};
  double *x = calloc(2 * spectrum->count, sizeof *x);
  if (x == NULL) return false;
  double *y = x + spectrum->count;
  size_t count = 0;
  for (size_t j = 0; j < spectrum->count; j++) {
    const tp_profile_density own = spectrum->densities[j];
    if (own.frequency < from || own.frequency > to || !(own.density > 0)) continue;
    x[count] = log(own.frequency);
    y[count++] = log(own.density);
  }
  tp_series_line line;
  if (count >= FREQUENCIES_LEAST && tp_series_fit(&line, x, y, count)) {
    const double filled = (double)(2 * (spectrum->count - 1)) / (double)samples;
    const double dependent = filled * (window == TP_WINDOW_HANN ? hann : 1);
    const double half = normal * sqrt(of_logarithm * dependent / line.spread_x) / 2;
    const double value = (-line.slope - 1) / 2;
    *hurst = (tp_profile_estimate){.found = true,
                                   .has_range = true,
                                   .value = value,
                                   .low = value - half,
                                   .high = value + half};
    range[0] = from;
    range[1] = to;
  }
  free(x);
  return true;
}
