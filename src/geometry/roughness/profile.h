/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* From a chain of exact points to all numbers of its roughness. */

#ifndef TP_ROUGHNESS_PROFILE_H
#define TP_ROUGHNESS_PROFILE_H

#include "plane/polyline.h"
#include "topple_profile.h"

/* What is measured, and what it is called. */
typedef struct tp_profile_subject {
  const tp_polyline *chain;
  tp_profile_origin origin;
  const char *title, *length_unit; /* the unit outlives the profile, the title may be NULL */
  double metres_per_unit;
  size_t source_count;
  const char *const *sources;
} tp_profile_subject;

/* The double nearest to a length unit in metres: a quotient of two small whole numbers. */
static inline double tp_metres_of_unit(const fmpq_t metres_per_unit) {
  return fmpz_get_d(fmpq_numref(metres_per_unit)) / fmpz_get_d(fmpq_denref(metres_per_unit));
}

/* Are the options what they may be? */
TP_MUST_USE tp_status tp_profile_check_options(const tp_profile_options *options,
                                               tp_message *message);

/* With options that were checked. */
TP_MUST_USE tp_status tp_profile_measure(tp_profile **profile, const tp_profile_subject *subject,
                                         const tp_profile_options *options, tp_message *message);

#endif
