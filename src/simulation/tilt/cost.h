/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a run of dynamics will take, told before it begins, in steps of springs; a step or a look of
 * rigid contacts counts as many. */

#ifndef TP_TILT_COST_H
#define TP_TILT_COST_H

#include "tilt/tilting.h"

/* Bad input where a run that may last so long takes more steps than its budget (budget.h): at the
 * number that asks for most of them, with what would help. */
TP_MUST_USE tp_status tp_tilting_check_cost(const tp_tilting *tilting, double longest_s);

/* Budgets of a search by so many factors on the shaking; 0: as many as it has by default. */
double tp_tilting_search_budgets(size_t factors);

/* Steps of the engine that are left of the budget of all runs. */
double tp_tilting_steps_left(const tp_tilting *tilting);

/* How many more runs like those so far fit into the budget of one. */
double tp_tilting_runs_left(const tp_tilting *tilting);

/* So many steps were made. */
void tp_tilting_count_steps(tp_tilting *tilting, double steps);

#endif
