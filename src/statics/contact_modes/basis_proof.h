/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Factors on columns that make up a right-hand side, enclosed: of more columns than rows so many as
 * there are rows are chosen as the basis, the others keep the factors that they have, and the basis
 * is solved for in balls. */

#ifndef TP_CONTACT_MODES_BASIS_PROOF_H
#define TP_CONTACT_MODES_BASIS_PROOF_H

#include "topple.h"

#include <arb_mat.h>

typedef struct tp_basis_task {
  const arb_mat_struct *columns; /* rows x count */
  const arb_mat_struct *right;   /* rows x 1 */
  const double *preference;      /* by column: those of the most are taken first, where that is
                                    possible; above 0 */
  long bits;
} tp_basis_task;

/* `factors`, count x 1, are exact where they are given, and enclosures of the basis at the end.
 * TP_NO_ANSWER: the columns do not span all rows, certainly enough. */
TP_MUST_USE tp_status tp_basis_solve(arb_mat_t factors, const tp_basis_task *task,
                                     tp_message *message);

#endif
