/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A D A^T of a program of forces between blocks, D diagonal, with a sparse Cholesky factor: 3 x 3
 * for each block and each pair of blocks that touch, ordered by minimum degree (CXSparse, Davis
 * 2006). */

#ifndef TP_ASSEMBLAGE_NORMAL_EQUATIONS_H
#define TP_ASSEMBLAGE_NORMAL_EQUATIONS_H

#include "assemblage/force_program.h"

typedef struct tp_normal_equations {
  const tp_force_program *program;
  void *matrix, *symbolic, *factor; /* of CXSparse */
  long *pair_place; /* 3 a contact: where its blocks' rows begin in each column of the later one */
  long *own_place;  /* 3 a block: where its own rows begin in each of its columns */
  double *work;     /* by row */
} tp_normal_equations;

/* TP_DEPENDENCY_FAILED where Topple was built without CXSparse. To be cleared on failure too. */
TP_MUST_USE tp_status tp_normal_equations_init(tp_normal_equations *normal,
                                               const tp_force_program *program,
                                               tp_message *message);
void tp_normal_equations_clear(tp_normal_equations *normal);

/* With such a diagonal; false where rounding leaves it no longer positive, or memory is exhausted.
 */
bool tp_normal_equations_factorise(tp_normal_equations *normal, const double *diagonal);

/* In place. */
void tp_normal_equations_solve(tp_normal_equations *normal, double *rows);

#endif
