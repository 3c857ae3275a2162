/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Moments about a pivot and their factor of safety, in doubles with bounds. */

#ifndef TP_CASE_FILTER_MOMENTS_FILTER_H
#define TP_CASE_FILTER_MOMENTS_FILTER_H

#include "case_filter/standing_filter.h"

/* The tilt at which it topples about a pivot on which it stands level. */
typedef struct tp_filter_turning {
  bool never;      /* up to 90 degrees it does not */
  tp_near tangent; /* else of the critical angle */
} tp_filter_turning;

/* False where doubles do not tell, or where it does not stand level. */
TP_MUST_USE bool tp_filter_turns(tp_filter_turning *turning, const tp_filter_case *of,
                                 const tp_filter_pivot *pivot);

/* The factor of turning about an admissible pivot, as tp_case_filter_tell takes them: it stands
 * level on each. False where doubles do not tell. */
TP_MUST_USE bool tp_moments_filter(tp_filter_way *way, const tp_case_told *told,
                                   const tp_filter_state *state, const tp_filter_pivot *pivot);

#endif
