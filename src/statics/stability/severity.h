/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Which of several results is the worse one: what is not met, or does not stand, before what is
 * open, that before what is met; among these by the greater required factor over the factor, 1
 * where none is required. What has no number counts as infinite, and what nothing drives as zero.
 */

#ifndef TP_STABILITY_SEVERITY_H
#define TP_STABILITY_SEVERITY_H

#include "topple.h"

typedef struct tp_severity {
  int rank; /* 2: not met, 1: open, 0: met */
  double need;
} tp_severity;

tp_severity tp_severity_of(const tp_case *own);
/* Below 0: the first is the worse one. */
int tp_severity_compare(tp_severity one, tp_severity other);
/* The direction of a solution that is the worst. */
size_t tp_severity_worst(const tp_solution *solution);

#endif
