/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The critical angle of a block by double arithmetic, where that proves it; and by exact arithmetic
 * as tp_solve has it, where not. */

#ifndef TP_BATCH_TURNING_H
#define TP_BATCH_TURNING_H

#include "batch/outline_scan.h"

/* Which turning is asked about, and how. */
typedef struct tp_turning_task {
  tp_direction towards;
  bool simple; /* it is known that no outline meets itself */
  const tp_scan_kernel *kernel;
} tp_turning_task;

typedef struct tp_block_turning {
  double angle_deg, error_deg; /* NaN without an admissible pivot */
  long pivot;                  /* the vertex, from 0, or -1; where the filter tells it, too: */
  long first;                  /* the left end of the underside, */
  int edges;                   /* how many it has, */
  bool counter_clockwise;      /* and whether they follow it in the outline, or precede it */
} tp_block_turning;

/* TP_OK, or TP_NO_ANSWER without an admissible pivot, where that is proven; TP_UNDECIDED where
 * doubles prove nothing; TP_OUT_OF_MEMORY. */
TP_MUST_USE tp_status tp_turning_filter(tp_block_turning *turning, tp_workspace *workspace,
                                        tp_vertices vertices, const tp_turning_task *task,
                                        tp_message *message);

/* The same by exact arithmetic; any status of tp_solve. */
TP_MUST_USE tp_status tp_turning_solve(tp_block_turning *turning, tp_vertices vertices,
                                       tp_direction towards, tp_message *message);

#endif
