/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Wilson's interval, its simultaneous form for several categories, Student's interval for means of
 * replicates, and the samples needed for a half width. */

#include "statistics/proportion.h"

#include "statistics/score.h"

#include <math.h>

/* (count + z^2/2 -+ z sqrt(count (n - count) / n + z^2/4)) / (n + z^2); an end is 0 or 1 where the
 * count is 0 or n, which the roundings would miss. */
static tp_estimate by_score(uint64_t count, uint64_t samples, double z) {
  if (samples == 0) return (tp_estimate){NAN, 0, 1};
  const double n = (double)samples, hits = (double)count, misses = (double)(samples - count);
  const double half = z * sqrt(hits / n * misses + z * z / 4), whole = n + z * z;
  return (tp_estimate){.value = hits / n,
                       .low = count > 0 ? fmax((hits + z * z / 2 - half) / whole, 0) : 0,
                       .high =
                           count < samples ? 1 - fmax((misses + z * z / 2 - half) / whole, 0) : 1};
}

tp_estimate tp_proportion(uint64_t count, uint64_t samples, double confidence) {
  return by_score(count, samples, tp_normal_score(confidence, 1));
}

void tp_proportions(tp_estimate *estimates, const uint64_t *counts, size_t categories,
                    uint64_t samples, double confidence) {
  const double z = tp_normal_score(confidence, categories);
  for (size_t k = 0; k < categories; k++) estimates[k] = by_score(counts[k], samples, z);
}

tp_estimate tp_mean_of_replicates(const double *values, size_t replicates, double confidence) {
  const double n = (double)replicates;
  double sum = 0, squares = 0;
  for (size_t k = 0; k < replicates; k++) sum += values[k];
  const double mean = sum / n;
  for (size_t k = 0; k < replicates; k++) squares += (values[k] - mean) * (values[k] - mean);
  const double student = tp_student_score(confidence, n - 1);
  const double half = student * sqrt(squares / (n * (n - 1)));
  return (tp_estimate){mean, mean - half, mean + half};
}

/* The width falls by the root of the samples, about the share that Wilson's interval has in its
 * middle. */
uint64_t tp_proportion_samples(uint64_t count, uint64_t samples, double confidence,
                               double half_width) {
  const double z = tp_normal_score(confidence, 1), n = (double)samples, square = z * z;
  const double middle = ((double)count + square / 2) / (n + square);
  const double wanted = square * middle * (1 - middle) / (half_width * half_width) - square;
  return wanted > 1 ? (uint64_t)fmin(ceil(wanted), 0x1p62) : 1;
}
