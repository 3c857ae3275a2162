/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Moments about a pivot and their factor of safety, in doubles with bounds. */

#ifndef TP_CASE_FILTER_MOMENTS_FILTER_H
#define TP_CASE_FILTER_MOMENTS_FILTER_H

#include "case_filter/standing_filter.h"

/* The moment of all loads about a pivot that holds the block back is x - t y, of the weight alone
 * by its arms: x / y is the tangent of its critical angle. */
void tp_filter_arms(tp_near *x, tp_near *y, const tp_filter_case *of, const tp_filter_pivot *pivot);

/* The factor of turning about an admissible pivot, as tp_case_filter_tell takes them: they stand
 * level, and topple below 90 degrees. False where doubles do not tell. */
TP_MUST_USE bool tp_moments_filter(tp_filter_way *way, const tp_case_told *told,
                                   const tp_filter_state *state, const tp_filter_pivot *pivot);

#endif
