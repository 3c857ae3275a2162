/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The linear program of simplex.h on the midpoints of the data at any number of bits, where doubles
 * do not tell facets apart: the same steps, from the bounds at which the scaled program's last one
 * ended. Nothing here is certain either. */

#ifndef TP_LINEAR_PROGRAM_PRECISE_H
#define TP_LINEAR_PROGRAM_PRECISE_H

#include "linear_program/cones.h"
#include "linear_program/scaled.h"
#include "number/work.h"
#include "plane/vector.h"

/* With fewer bits it is hardly better than the 53 of doubles: some go to roundings (GUARD). */
enum { TP_PRECISE_BITS = 128 };

/* Its steps are counted as work. In the scaled program's units, its flags of what is at its bound
 * included; the dual is not given. TP_SIMPLEX_STUCK where the work is too much, data are not
 * finite, half a gigabyte would not do, or memory is exhausted, which the scaled program then
 * notes. */
tp_simplex_answer tp_precise_solve(tp_scaled *scaled, const tp_cones *cones,
                                   const tp_vector *direction, const tp_vector *target,
                                   tp_work *work, long bits);

#endif
