/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Which of several results is the worst: what collapses comes first, then what can begin to move,
 * what is undecided, what misses the required factor, and the rest. Among equals the greater
 * required factor over the factor comes first, 1 where none is required; of an undecided factor its
 * upper bound counts, then its lower bound (verdict/safety.h). */

#ifndef TP_STABILITY_SEVERITY_H
#define TP_STABILITY_SEVERITY_H

#include "topple.h"
#include "verdict/safety.h"

typedef struct tp_severity {
  int rank;               /* from the greatest on */
  double need, most_need; /* by the upper and by the lower bound of the factor */
} tp_severity;

tp_severity tp_severity_of_safety(const tp_safety *safety, bool is_required, double required);
tp_severity tp_severity_of(const tp_case *own);
/* Below 0: the first is the worse one. */
int tp_severity_compare(tp_severity one, tp_severity other);
/* The direction of a solution that is the worst. */
size_t tp_severity_worst(const tp_solution *solution);

#endif
