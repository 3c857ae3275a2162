/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Back-analysis: the result of a scene at a number, and the list of what is found. */

#ifndef TP_BACK_ANALYSIS_FIND_SAMPLE_H
#define TP_BACK_ANALYSIS_FIND_SAMPLE_H

#include "back_analysis/find_state.h"

/* The result of a case that a number is found for; false where it is none. */
bool tp_search_value(tp_bounded *value, const tp_case *own, tp_find_target target);

/* Is the target a factor of safety? */
bool tp_find_target_is_factor(tp_find_target target);

tp_sample tp_search_sample(tp_search *search, double x);

/* 1 above the wanted value, -1 below; 0 where that is not certain. */
int tp_search_side(const tp_sample *at);

void tp_search_add_solution(tp_search *search, double low, double high);
void tp_search_add_touching(tp_search *search, double low, double high);
/* Each end lies between two numbers. */
void tp_search_add_interval(tp_search *search, const double from[2], const double to[2]);

#endif
