/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The tilts at which a mode can begin under cohesion and bonds, in doubles with bounds. */

#ifndef TP_CASE_FILTER_STRONG_MODES_H
#define TP_CASE_FILTER_STRONG_MODES_H

#include "case_filter/mode_capacities.h"
#include "case_filter/near_interval.h"

/* False where doubles do not tell. */
TP_MUST_USE bool tp_strong_mode_find(tp_mode_interval *own, const tp_plan_mode *mode,
                                     const tp_filter_case *of);

/* Where all points open against all bonds. */
TP_MUST_USE bool tp_strong_leaving_find(tp_near_interval *own, const tp_filter_case *of);

#endif
