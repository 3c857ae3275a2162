/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Which contact points a case lists as pivots. Of a contact of a million points only those that
 * can matter are: a list of all of them takes more memory than everything else. */

#ifndef TP_EVALUATION_PIVOT_LIST_H
#define TP_EVALUATION_PIVOT_LIST_H

#include "problem/problem.h"

/* Does a case of so many contact points list all of them? */
bool tp_pivots_list_all(tp_pivots_listed asked, size_t count);

/* Is a contact point asked for before the limit is known? */
bool tp_pivots_list_from_start(const tp_case *result, const tp_problem *problem,
                               tp_pivots_listed asked, size_t point);

/* List those that are: kinds and places, which are exact. False
 * when memory is exhausted. */
TP_MUST_USE bool tp_pivots_list(tp_case *result, const tp_problem *problem, tp_pivots_listed asked);

/* List the contact points, too, that bear the limit, and those that a limit or the onset turns
 * about, as the case now has them. False when memory is exhausted. */
TP_MUST_USE bool tp_pivots_list_more(tp_case *result, const tp_problem *problem);

/* Where a listed contact point stands in the list. */
size_t tp_pivots_place(const tp_case *result, size_t point);

#endif
