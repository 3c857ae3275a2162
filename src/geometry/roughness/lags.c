/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Sums over all pairs at a lag, O(n) each, in eight lanes so that no addition waits for the one
 * before; they are estimates, whose spread is wider than their rounding by orders. Some 45 lags
 * cost less than the transform that would give all. The first lag at which the autocorrelation is
 * 1/e or less is bracketed by two of the grid and then halved to one step, and between the two
 * steps taken as straight. */

#include "roughness/lags.h"

enum { LANES = 8, PER_TENFOLD = 8 };

tp_profile_lag tp_lag_measure(const tp_heights *h, size_t steps) {
  const double *y = h->values, *z = h->values + steps;
  const size_t pairs = h->count - steps;
  double agree[LANES] = {0}, differ[LANES] = {0};
  size_t k = 0;
  for (; k + LANES <= pairs; k += LANES) {
    for (size_t lane = 0; lane < LANES; lane++) {
      const double difference = z[k + lane] - y[k + lane];
      agree[lane] += y[k + lane] * z[k + lane];
      differ[lane] += difference * difference;
    }
  }
  for (; k < pairs; k++) {
    agree[0] += y[k] * z[k];
    differ[0] += (z[k] - y[k]) * (z[k] - y[k]);
  }
  for (size_t lane = 1; lane < LANES; lane++) {
    agree[0] += agree[lane];
    differ[0] += differ[lane];
  }
  return (tp_profile_lag){.distance = (double)steps * h->step,
                          .structure = differ[0] / (double)pairs,
                          .correlation =
                              h->mean_square > 0 ? agree[0] / (double)pairs / h->mean_square : 1,
                          .pairs = pairs};
}

size_t tp_lag_steps(size_t *steps, size_t most) {
  size_t count = 0, last = 0;
  for (int j = 0;; j++) {
    const double wanted = round(pow(10, (double)j / PER_TENFOLD));
    if (wanted > (double)most) return count;
    const size_t own = (size_t)wanted;
    if (own == last) continue;
    if (steps != NULL) steps[count] = own;
    count++;
    last = own;
  }
}

tp_profile_estimate tp_correlation_length(const tp_heights *h, const tp_profile_lag *lags,
                                          size_t count) {
  static const double falls_to = 0.36787944117144233; /* 1 / e */
  size_t j = 0;
  while (j < count && lags[j].correlation > falls_to) j++;
  if (j == count) return (tp_profile_estimate){.found = false};
  const tp_profile_lag none = {.distance = 0, .correlation = 1};
  tp_profile_lag before = j > 0 ? lags[j - 1] : none, after = lags[j];
  size_t low = (size_t)round(before.distance / h->step);
  size_t high = (size_t)round(after.distance / h->step);
  while (high - low > 1) {
    const size_t middle = low + (high - low) / 2;
    const tp_profile_lag own = tp_lag_measure(h, middle);
    const bool above = own.correlation > falls_to;
    *(above ? &low : &high) = middle;
    *(above ? &before : &after) = own;
  }
  const double part = (before.correlation - falls_to) / (before.correlation - after.correlation);
  return (tp_profile_estimate){.found = true, .value = before.distance + part * h->step};
}
