/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The facet that governs sliding by angles (evaluation/sliding_facet.h), and its two factors, in
 * doubles with bounds. */

#ifndef TP_CASE_FILTER_SLIDING_FILTER_H
#define TP_CASE_FILTER_SLIDING_FILTER_H

#include "case_filter/case_filter.h"

typedef struct tp_sliding_told {
  bool counts;               /* no other facet stands in the way of sliding along this one */
  bool is_level;             /* the factor with roughness is that by shear strength */
  tp_fos_state shear, rough; /* a number, or nothing overturns */
  tp_near by_shear, by_roughness;
  bool has_critical; /* both are 1 at tan(phi + i), */
  tp_near critical;  /* that */
} tp_sliding_told;

/* The tangent of the tilt at which it begins to slide along that facet under loads, if it does.
 * False where doubles do not tell. */
TP_MUST_USE bool tp_sliding_filter_start(bool *starts, tp_near *critical, const tp_case_told *told);

/* False where doubles do not tell, or where no friction would do. */
bool tp_sliding_filter(tp_sliding_told *sliding, const tp_case_told *told, tp_near tilt_tangent);

#endif
