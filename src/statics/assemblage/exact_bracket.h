/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The greatest load that forces hold, where doubles do not tell: between that of the exact program
 * with the least strength of all joints and that with the greatest, and no farther apart than these
 * are. An arrangement that stands by 1e-30 of its length is told from one that falls by as much.
 *
 * What pivots find (assemblage/exact_simplex.h) is then checked to prove what it is to prove, in
 * rationals, from the program alone. */

#ifndef TP_ASSEMBLAGE_EXACT_BRACKET_H
#define TP_ASSEMBLAGE_EXACT_BRACKET_H

#include "assemblage/load_bracket.h"

/* Few blocks with coordinates of few digits: it takes some tens of ms at most. */
bool tp_exact_bracket_is_quick(const tp_assemblage *assemblage);

/* Narrow a bracket of `program`, which is of these strengths and loads. It stays as it is where the
 * loads are not known exactly, or where there is no greatest load. A bound of minus an infinity: no
 * load is held. */
TP_MUST_USE tp_status tp_exact_bracket_narrow(tp_load_bracket *bracket,
                                              const tp_force_program *program,
                                              const tp_contact_strength *strengths,
                                              const tp_weight_loads *loads, tp_message *message);

#endif
