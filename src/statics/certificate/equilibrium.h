/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The proof that the base bears a wrench: factors on its columns, found in doubles and enclosed in
 * balls, that balance it. */

#ifndef TP_CERTIFICATE_EQUILIBRIUM_H
#define TP_CERTIFICATE_EQUILIBRIUM_H

#include "certificate/question.h"
#include "linear_program/basis.h"

/* Do the basis and the capacities that the scaled program has at their bound balance the wrench?
 * Fewer than three columns are completed by others, with a share of nothing. */
tp_answer tp_equilibrium_of(tp_basis *basis, const tp_limit_question *question,
                            const tp_scaled *scaled, const tp_vector *wrench);

/* A push from within the cone of all forces: a sum of the edges at the first and the last point,
 * weighted unevenly so that no symmetry of the block makes a tie, in units of the scaled program's
 * force.
 */
enum { TP_PUSH_EDGES = 4 };
extern const double tp_equilibrium_push_weights[TP_PUSH_EDGES];
long tp_equilibrium_push_edge(const tp_cones *cones, int k);
void tp_equilibrium_push(tp_vector *push, const tp_limit_question *question,
                         const tp_scaled *scaled);

/* Such a push in doubles, of the scaled program's own edges and in its units. */
void tp_equilibrium_push_near(tp_near push[3], const tp_cones *cones, const tp_scaled *scaled);

/* Does an answer of the scaled program prove, in doubles with their bounds, that a wrench is borne
 * beside some of the push? False where they do not tell, or capacities are in play. Both in the
 * program's units. */
bool tp_equilibrium_is_told(const tp_simplex_answer *found, const tp_scaled *scaled,
                            const tp_near push[3], const tp_near wrench[3]);

/* The program's answer for a wrench and a push in its units. */
tp_simplex_answer tp_equilibrium_solve_near(tp_scaled *scaled, const tp_near push[3],
                                            const tp_near wrench[3]);

/* Of all that balance a wrench, with a share t of the push as large as can be: in doubles, and at
 * the question's bits. A share below zero says that the base does not bear it. */
tp_simplex_answer tp_equilibrium_solve(tp_scaled *scaled, const tp_vector *push,
                                       const tp_vector *wrench);
tp_simplex_answer tp_equilibrium_solve_precisely(const tp_limit_question *question,
                                                 tp_scaled *scaled, const tp_vector *push,
                                                 const tp_vector *wrench);

/* Does the base bear the wrench? Of all that balance it, a share of the push as large as can be and
 * two columns are tried first: the share is above zero wherever the wrench lies inside what the
 * base bears. TP_NO is what doubles say, and proves nothing. */
tp_answer tp_equilibrium_bears(const tp_limit_question *question, tp_scaled *scaled,
                               const tp_vector *push, const tp_vector *wrench);

#endif
