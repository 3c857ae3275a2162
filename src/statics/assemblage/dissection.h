/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* An order of free blocks in which their normal equations fill in little: nested dissection (George
 * 1973). All are cut in two where few touch across the cut; those come last, and both sides are cut
 * likewise. Of n blocks in the plane the factor has some n log n entries, and takes some n^1.5
 * steps. */

#ifndef TP_ASSEMBLAGE_DISSECTION_H
#define TP_ASSEMBLAGE_DISSECTION_H

#include "assemblage/force_program.h"

/* Blocks that are eliminated together: those on a cut, or few that are not cut any more. */
typedef struct tp_dissected_part {
  long first, end; /* in the order */
  long parent;     /* the part of the cut that it was parted by, which comes later; -1: none */
} tp_dissected_part;

typedef struct tp_dissection {
  long block_count, part_count;
  long *order;              /* numbers of free blocks */
  long *place;              /* where each of them stands in the order */
  long *first, *neighbours; /* by number: those that it touches, each once; ascending */
  tp_dissected_part *parts; /* each behind all that have it as their parent */
} tp_dissection;

/* False when memory is exhausted; then still to be cleared. */
TP_MUST_USE bool tp_dissection_init(tp_dissection *dissection, const tp_force_program *program);
void tp_dissection_clear(tp_dissection *dissection);

#endif
