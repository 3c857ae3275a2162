/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A square linear system A x = b in balls, by an approximate inverse in doubles (Krawczyk 1969):
 * with R near A^-1 and e a bound of the row sums of |I - R A| below one,
 *
 *     |x - x0| <= |R| |b - A x0| + e max(|R| |b - A x0|) / (1 - e).
 *
 * x0 is improved by R (b - A x0) some times first, so that the bound tells what A and b themselves
 * leave open, and little more. Cost: four n^3 in doubles, a hundredth of the same in balls. */

#ifndef TP_CONTACT_MODES_ENCLOSED_SOLVE_H
#define TP_CONTACT_MODES_ENCLOSED_SOLVE_H

#include "topple_basics.h"

#include <arb_mat.h>

/* `solved`: x, n x 1, is enclosed. Not where A is too near to a singular one for doubles. False
 * when memory is exhausted. */
TP_MUST_USE bool tp_enclosed_solve(bool *solved, arb_mat_t x, const arb_mat_t a, const arb_mat_t b,
                                   long bits);

#endif
