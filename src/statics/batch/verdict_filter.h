/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The verdict of a block in an array by doubles with bounds (case_filter/block_filter.h). */

#ifndef TP_BATCH_VERDICT_FILTER_H
#define TP_BATCH_VERDICT_FILTER_H

#include "batch/turning.h"
#include "case_filter/case_filter.h"

/* At any tilt, and at its own where it has one. */
typedef struct tp_block_told {
  tp_case_told of;
  bool has_tilt;
  tp_case_told_at at;
} tp_block_told;

/* With its angles, NaN where it has none. TP_OK, with the filter that `told` refers to;
 * TP_UNDECIDED where doubles do not tell, or not all digits that tp_solve gives by default;
 * TP_OUT_OF_MEMORY. */
TP_MUST_USE tp_status tp_verdict_filter(tp_block_told *told, tp_case_filter *filter,
                                        tp_workspace *workspace, tp_vertices vertices,
                                        const tp_turning_task *task, double friction_deg,
                                        double tilt_deg, tp_message *message);

#endif
