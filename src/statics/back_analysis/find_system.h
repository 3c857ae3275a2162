/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Back-analysis of a scene of many blocks: its results at a number, of the direction that governs
 * there. */

#ifndef TP_BACK_ANALYSIS_FIND_SYSTEM_H
#define TP_BACK_ANALYSIS_FIND_SYSTEM_H

#include "back_analysis/find_state.h"

/* Is the target one of many blocks, and one that these have? */
TP_MUST_USE tp_status tp_search_check_system(const tp_search *search);

/* The result at at->x; `*unbounded`: it is above any number. */
TP_MUST_USE tp_status tp_search_take_system(tp_sample *at, bool *unbounded, tp_search *search);

/* What else is known at each solution; how it went is in search->status. */
void tp_search_tell_blocks(tp_search *search);

#endif
