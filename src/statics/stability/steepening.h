/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* By how much a block that lies at its place, and stands, may steepen until a motion can begin. */

#ifndef TP_STABILITY_STEEPENING_H
#define TP_STABILITY_STEEPENING_H

#include "topple.h"

/* The window of motions that bounds how far the block may steepen: the first above the solution's
 * tilt, or that which begins there; NULL: none. */
const tp_window *tp_steepening_window(const tp_solution *solution, const tp_case *own);

/* Of each case of a solution in the frame of the world, from the windows that it holds. */
void tp_solution_steepen(tp_solution *solution);

#endif
