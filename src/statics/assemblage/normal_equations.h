/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A D A^T of a program of forces between blocks, D diagonal, with a sparse Cholesky factor by the
 * multifrontal method (Duff and Reid 1983) in the order of a dissection. All memory is taken at
 * first. */

#ifndef TP_ASSEMBLAGE_NORMAL_EQUATIONS_H
#define TP_ASSEMBLAGE_NORMAL_EQUATIONS_H

#include "assemblage/factor_plan.h"
#include "assemblage/front.h"

typedef struct tp_normal_equations {
  const tp_force_program *program;
  const tp_front_kernel *kernel;
  tp_factor_plan plan;
  double *own_squares;  /* by block: its rows against themselves, by columns */
  double *pair_squares; /* by entry of neighbours: that one's rows against the block's, where it
                           comes later in the order */
  long *pair;           /* by contact: to which of those it adds; -1: to none */
  double *factor;       /* the columns of all fronts */
  double *rests;        /* the stack of what parts left */
  long *row_of;         /* by place in the order: its row in the front at hand */
  double *rows, *local; /* in the order, and of a front */
} tp_normal_equations;

/* To be cleared on failure too. */
TP_MUST_USE tp_status tp_normal_equations_init(tp_normal_equations *normal,
                                               const tp_force_program *program,
                                               tp_message *message);
void tp_normal_equations_clear(tp_normal_equations *normal);

/* With such a diagonal; false where rounding leaves it no longer positive. */
bool tp_normal_equations_factorise(tp_normal_equations *normal, const double *diagonal);

/* In place. */
void tp_normal_equations_solve(const tp_normal_equations *normal, double *rows);

#endif
