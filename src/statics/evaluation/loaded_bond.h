/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The moment of a contact's tensile bond about each of its points (docs/mechanics.md section 5): of
 * the part that opens as the block turns about the point.
 *
 * Of a facet from q0 to q1 with t = q1 - q0 the part beyond the pivot P opens, where (q - P) . t is
 * above zero. All of a facet that opens has the moment ((q0 + q1) / 2 - P) . t for a bond of 1, so
 * runs of facets that open wholly have one between them. */

#ifndef TP_EVALUATION_LOADED_BOND_H
#define TP_EVALUATION_LOADED_BOND_H

#include "evaluation/evaluation.h"

typedef struct tp_bond tp_bond;

/* NULL when memory is exhausted. */
tp_bond *tp_bond_new(const tp_evaluation *evaluation);
void tp_bond_free(tp_bond *bond);

/* For a strength of 1, in squares of lattice steps, about the k-th contact point: of what lies to
 * the right of it along each facet, or to the left. */
void tp_bond_moment(arb_t moment, const tp_bond *bond, const tp_evaluation *evaluation, long k,
                    bool to_the_right);

#endif
