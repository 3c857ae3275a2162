/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* How heights at a distance from each other differ, and agree: of evenly sampled points. */

#ifndef TP_ROUGHNESS_LAGS_H
#define TP_ROUGHNESS_LAGS_H

#include "roughness/course.h"

/* Heights about their mean, at an even step. */
typedef struct tp_heights {
  const double *values;
  size_t count;
  double step, mean_square;
} tp_heights;

/* Of so many steps: mean of (y_k+m - y_k)^2, and mean of y_k y_k+m over the mean of y^2. */
tp_profile_lag tp_lag_measure(const tp_heights *heights, size_t steps);

/* The whole numbers of steps nearest to 8 in a tenfold, from 1 to `most`, each once, into `steps`
 * (NULL: only counted). Their number. */
size_t tp_lag_steps(size_t *steps, size_t most);

/* Where the autocorrelation first falls to 1/e, of the lags measured; not found where it does not.
 */
tp_profile_estimate tp_correlation_length(const tp_heights *heights, const tp_profile_lag *lags,
                                          size_t count);

#endif
