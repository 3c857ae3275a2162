/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* An optimal basis of the limit's linear program,
 *
 *     maximise t subject to  sum_k f_k column_k + t direction = target,  f >= 0,
 *
 * first in doubles; and where those were wrong, exactly on the midpoints of the data. */

#ifndef TP_LINEAR_PROGRAM_BASIS_H
#define TP_LINEAR_PROGRAM_BASIS_H

#include "common/message.h"
#include "linear_program/scaled.h"

typedef struct tp_basis {
  tp_simplex_outcome outcome;
  int count;       /* columns in it, t aside */
  long columns[3]; /* those that balance the target; the rest of `columns` is -1 */
} tp_basis;

tp_basis tp_basis_of(const tp_simplex_answer *answer);

/* The exact one of some columns, `count` of them, TP_SIMPLEX_STUCK where data are not finite at
 * this precision; a status where the solver or memory fails. */
TP_MUST_USE tp_status tp_basis_exact(tp_basis *basis, const tp_cones *cones, const long *columns,
                                     long count, const tp_vector *direction,
                                     const tp_vector *target, long bits);

/* The column that spans the other face beside the edge `shared` of the face of `shared` and
 * `other`, which bears nothing, or all that it can where it is `full`; -1 where the cone is flat.
 */
long tp_basis_across(const tp_scaled *scaled, long shared, long other, bool full);

#endif
