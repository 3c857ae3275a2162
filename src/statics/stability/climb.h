/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The ladder climbed for a problem: at every rung the stages of a solve (evaluation/stages.h), as
 * far as a lower one has not settled them. */

#ifndef TP_STABILITY_CLIMB_H
#define TP_STABILITY_CLIMB_H

#include "problem/problem.h"
#include "stability/tilts.h"

/* Fills in a solution whose cases are described, and those of the tilts, or NULL, that its first
 * rung tells, which still lack the factors that govern. TP_UNDECIDED where the last rung leaves
 * something open: the results stand, enclosures all of them. */
TP_MUST_USE tp_status tp_climb(tp_solution *solution, const tp_problem *problem,
                               const tp_solve_options *options, tp_tilts *tilts,
                               tp_message *message);

#endif
