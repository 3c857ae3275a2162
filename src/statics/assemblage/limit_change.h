/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* By how much the greatest load changes from one program to one near by, of the same contacts: what
 * changed, at the prices that the twists of its mechanism are (sensitivity of linear programs;
 * Boyd and Vandenberghe, Convex Optimization, 2004, section 5.6). To first order, in doubles:
 * for a search, not for proofs. */

#ifndef TP_ASSEMBLAGE_LIMIT_CHANGE_H
#define TP_ASSEMBLAGE_LIMIT_CHANGE_H

#include "assemblage/load_bracket.h"

/* `bracket` is of `from` and has a bound, with forces and twists near it. */
double tp_limit_change(const tp_load_bracket *bracket, const tp_force_program *from,
                       const tp_force_program *to);

#endif
