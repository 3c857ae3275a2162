/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The factor of safety that governs, as stability/governing.c has it, in doubles with bounds. */

#ifndef TP_CASE_FILTER_FACTOR_FILTER_H
#define TP_CASE_FILTER_FACTOR_FILTER_H

#include "case_filter/standing_filter.h"

/* Fills in the factor; false where doubles do not tell. */
TP_MUST_USE bool tp_factor_filter(tp_case_told_at *at, const tp_case_told *told,
                                  const tp_filter_state *state);

#endif
