/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The factor of safety that governs, as stability/governing.c has it, in doubles with bounds. */

#ifndef TP_CASE_FILTER_FACTOR_FILTER_H
#define TP_CASE_FILTER_FACTOR_FILTER_H

#include "case_filter/standing_filter.h"

/* The moment of all loads about a pivot that holds the block back is x - t y, of the weight alone
 * by its arms: x / y is the tangent of its critical angle. */
void tp_filter_arms(tp_near *x, tp_near *y, const tp_filter_case *of, const tp_filter_pivot *pivot);

/* Fills in the factor; false where doubles do not tell. */
TP_MUST_USE bool tp_factor_filter(tp_case_told_at *at, const tp_case_told *told,
                                  const tp_filter_state *state);

#endif
