/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Where the Cholesky factor of the normal equations of free blocks has entries, in the order of
 * their dissection: a front for each part of it. Three rows a block. */

#ifndef TP_ASSEMBLAGE_FACTOR_PLAN_H
#define TP_ASSEMBLAGE_FACTOR_PLAN_H

#include "assemblage/dissection.h"

enum { TP_BLOCK_ROWS = 3 };

/* Of one part: its own rows, then those of later blocks that the factor has in its columns. */
typedef struct tp_factor_front {
  long rows, own;
  long behind;  /* where the places of those blocks begin, ascending, among all such; there are
                   (rows - own) / 3 */
  long columns; /* where its rows x own entries begin in the factor */
} tp_factor_front;

typedef struct tp_factor_plan {
  tp_dissection dissection;
  tp_factor_front *fronts; /* by part */
  long *behind, behind_count, behind_room;
  long entries;                    /* of the factor */
  long rest_room;                  /* of what is left to later fronts, at most at a time */
  long most_rows;                  /* of a front */
  long *last_child, *child_before; /* by part: those that hang on it; -1 */
} tp_factor_plan;

/* False when memory is exhausted; then still to be cleared. */
TP_MUST_USE bool tp_factor_plan_init(tp_factor_plan *plan, const tp_force_program *program);
void tp_factor_plan_clear(tp_factor_plan *plan);

#endif
