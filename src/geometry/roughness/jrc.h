/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* JRC of a measured profile by the correlations of correlations_table.h, each at the step that it
 * is meant for. */

#ifndef TP_ROUGHNESS_JRC_H
#define TP_ROUGHNESS_JRC_H

#include "roughness/course.h"

/* Fill in the profile's jrc from its other numbers. `points` are those before they were resampled
 * and detrended: where they lie close enough, a correlation's input is measured on them anew at its
 * own step, otherwise at the profile's points. */
TP_MUST_USE tp_status tp_jrc_measure(tp_profile *profile, const tp_course *points,
                                     tp_message *message);

/* Eq. (10): i over the decimal logarithm of JCS over the normal stress. */
TP_MUST_USE tp_status tp_jrc_by_equation_10(tp_profile *profile, double jcs_mpa,
                                            double normal_stress_kpa, tp_message *message);

#endif
