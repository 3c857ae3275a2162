/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* How much work proofs may take, counted and not timed, so that the same input gives the same
 * answer on every machine.
 *
 * The unit is one column of a program at 64 bits, some 30 ns; a step over n columns at b bits
 * counts (n + 150) (1 + b / 128 + (b / 1024)^2), the 150 for what does not depend on n. */

#ifndef TP_NUMBER_WORK_H
#define TP_NUMBER_WORK_H

#include <stdbool.h>

typedef struct tp_work {
  double spent;
  double most; /* of the question in hand: beyond it steps are refused */
} tp_work;

/* Of all questions on all rungs: seconds, and more for a large contact. */
double tp_work_allowed(long columns);

/* A question may take a share of what is allowed, so that one that is too dear leaves enough for
 * the others. */
void tp_work_begin(tp_work *work, long columns);

/* Count steps over the columns; false where too much is spent. With NULL everything is allowed. */
bool tp_work_spend(tp_work *work, double steps, long columns, long bits);

#endif
