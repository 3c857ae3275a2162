/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Solves a problem that is prepared already, at its tilt and at further ones. */

#ifndef TP_STABILITY_SOLVE_H
#define TP_STABILITY_SOLVE_H

#include "stability/problem.h"
#include "stability/tilts.h"

/* Fill a solution, zero but for its effects, in which the preparation was noted. What it holds on
 * failure is the caller's to free as well. */
TP_MUST_USE tp_status tp_solve_problem(tp_solution *solution, const tp_problem *problem,
                                       const tp_solve_options *options, tp_message *message);
/* The same, and at further tilts. */
TP_MUST_USE tp_status tp_solve_problem_tilts(tp_solution *solution, tp_tilts *tilts,
                                             const tp_problem *problem,
                                             const tp_solve_options *options, tp_message *message);

#endif
