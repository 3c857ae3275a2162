/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A solution before anything is evaluated: what the scene says of itself, and room for the rest. */

#ifndef TP_STABILITY_SOLUTION_H
#define TP_STABILITY_SOLUTION_H

#include "problem/problem.h"

/* Without cases, and with room for two; NULL where memory is exhausted. To be freed by
 * tp_solution_free. */
tp_solution *tp_solution_new(void);

/* What is exact, once for all rungs, and the cases with their arrays. A solution that fails half
 * way is still to be freed. */
TP_MUST_USE tp_status tp_solution_describe(tp_solution *solution, const tp_problem *problem,
                                           const tp_solve_options *options, tp_message *message);

#endif
