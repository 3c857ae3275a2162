/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What lies between two points of a range that are on different sides of the wanted value, or at
 * it. */

#ifndef TP_BACK_ANALYSIS_FIND_LEVEL_H
#define TP_BACK_ANALYSIS_FIND_LEVEL_H

#include "back_analysis/find_sample.h"

/* Between two points on different sides: a solution, or a stretch of them, or a jump. */
void tp_search_cross(tp_search *search, tp_sample low, tp_sample high);

/* About points from `first` to `last` that are not told from the wanted value; `before` and `after`
 * are told, or NULL where there is none: a solution, a stretch of solutions, or a touch. */
void tp_search_level(tp_search *search, const tp_sample *before, const tp_sample *first,
                     const tp_sample *last, const tp_sample *after);

#endif
