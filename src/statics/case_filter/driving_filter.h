/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The factor of safety on driving loads (onset/onset_driving.h), in doubles with bounds. */

#ifndef TP_CASE_FILTER_DRIVING_FILTER_H
#define TP_CASE_FILTER_DRIVING_FILTER_H

#include "case_filter/standing_filter.h"

typedef struct tp_driving_told {
  tp_fos_told fos;
  bool has_mechanism;     /* one alone begins there: */
  tp_mechanism mechanism; /* if has_mechanism: this one */
} tp_driving_told;

/* False where doubles do not tell. */
TP_MUST_USE bool tp_driving_filter(tp_driving_told *driving, const tp_case_told *told,
                                   const tp_filter_state *state);

#endif
