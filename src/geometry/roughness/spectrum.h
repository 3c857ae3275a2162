/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The power spectral density of evenly sampled heights. */

#ifndef TP_ROUGHNESS_SPECTRUM_H
#define TP_ROUGHNESS_SPECTRUM_H

#include "roughness/lags.h"

typedef struct tp_spectrum {
  size_t count; /* of densities: half the length of the transform, and one more */
  tp_profile_density *densities;
} tp_spectrum;

/* False when memory is exhausted. */
TP_MUST_USE bool tp_spectrum_init(tp_spectrum *spectrum, const tp_heights *heights,
                                  tp_profile_window window);

#endif
