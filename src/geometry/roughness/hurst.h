/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The exponent H of a self-affine profile, by two ways: heights at a distance d differ by d^2H in
 * the mean square, and the spectral density falls by f^-(1 + 2 H). */

#ifndef TP_ROUGHNESS_HURST_H
#define TP_ROUGHNESS_HURST_H

#include "roughness/spectrum.h"

/* By the structure function, of which `lags` holds what tp_lag_steps lists; `range` gets the
 * distances of the fit. */
void tp_hurst_by_structure(tp_profile_estimate *hurst, double range[2], const tp_heights *heights,
                           const tp_profile_lag *lags);

/* By the spectrum of `samples` heights; `range` gets the frequencies of the fit. False when memory
 * is exhausted. */
TP_MUST_USE bool tp_hurst_by_spectrum(tp_profile_estimate *hurst, double range[2],
                                      const tp_spectrum *spectrum, size_t samples, double step,
                                      tp_profile_window window);

#endif
