/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A spectrum in bands, ten in a tenfold frequency: the mean of so many ordinates is as much
 * narrower as the root of their number. */

#ifndef TP_ROUGHNESS_BANDS_H
#define TP_ROUGHNESS_BANDS_H

#include "topple_profile.h"

typedef struct tp_band {
  size_t from, count;        /* its ordinates; frequency 0 is in none */
  double frequency, density; /* geometric mean of its ends, mean of its ordinates */
} tp_band;

/* The band after `*band`, which begins as {0}; false after the last. */
bool tp_band_next(tp_band *band, const tp_profile *profile);

#endif
