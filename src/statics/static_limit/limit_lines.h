/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The straight lines that the facets of a contact lie on. Shears along one line are one force: its
 * cohesion is that of all facets on it together, however many pieces it is written in. */

#ifndef TP_STATIC_LIMIT_LIMIT_LINES_H
#define TP_STATIC_LIMIT_LIMIT_LINES_H

#include "problem/problem.h"

/* For each facet of the contact the first one on its line with the block on the same side of it;
 * for a contact in a point, itself. False when memory is exhausted. */
TP_MUST_USE bool tp_limit_lines_find(long *first, const tp_problem *problem);

#endif
