/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Which factor of safety governs a case of one block: the least of those that count. */

#ifndef TP_STABILITY_GOVERNING_H
#define TP_STABILITY_GOVERNING_H

#include "topple.h"
#include "verdict/safety.h"

/* The factor of safety that governs each case, from what the solution holds. */
void tp_solution_govern(tp_solution *solution, const tp_scene *scene);

/* The state of a case, for the rule that chooses among cases, directions and earthquakes. */
tp_safety tp_case_safety(const tp_case *of);

/* A case that stands, or of which that is open, counts under another earthquake, or without one,
 * too. Where the bounds of its factor there are less, the factor of the case has these, and may be
 * undecided. */
void tp_case_add_state(tp_case *to, const tp_safety *other);

#endif
