/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Back-analysis of a scene of many blocks: its results at a number, of the direction that governs
 * there. */

#ifndef TP_BACK_ANALYSIS_FIND_SYSTEM_H
#define TP_BACK_ANALYSIS_FIND_SYSTEM_H

#include "back_analysis/find_state.h"
#include "block_system/system.h"

/* Is the target one of many blocks, and one that these have? */
TP_MUST_USE tp_status tp_search_check_system(const tp_search *search);

/* The result at at->x; `*unbounded`: it is above any number. */
TP_MUST_USE tp_status tp_search_take_system(tp_sample *at, bool *unbounded, tp_search *search);

/* Of many blocks fos and governing_fos are the factor of safety, the least by either definition. */
bool tp_find_target_is_governing(tp_find_target target);

/* Motions that are looked for at every number tried: of a few free blocks all; else none, so that
 * the factors are upper bounds. */
tp_motions_sought tp_search_cheap_motions(const tp_search *search);

/* The scene with the number x, solved. */
TP_MUST_USE tp_status tp_search_solve_system(tp_block_system **system, tp_search *search, double x,
                                             tp_motions_sought motions);

#endif
