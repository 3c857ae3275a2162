/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Back-analysis of a scene of many blocks: what is known at the numbers found. */

#ifndef TP_BACK_ANALYSIS_FIND_BLOCKS_H
#define TP_BACK_ANALYSIS_FIND_BLOCKS_H

#include "back_analysis/find_state.h"

/* What else is known at each solution; how it went is in search->status. A solution at which a
 * smaller factor of safety is proven is moved, or left out. */
void tp_search_tell_blocks(tp_search *search);

#endif
