/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The critical angles of many blocks: each by the filter, or where that proves nothing by exact
 * arithmetic. */

#include "batch/blocks.h"
#include "batch/share.h"
#include "batch/turning.h"

/* Blocks handed out at once: some tens of microseconds of work. */
enum { CHUNK = 512 };

typedef struct critical_task {
  const tp_critical_columns *columns;
  const tp_outlines *outlines;
  tp_turning_task turning;
} critical_task;

static tp_status find(tp_workspace *workspace, const void *task, size_t block,
                      tp_message *message) {
  const critical_task *t = task;
  const tp_critical_columns *c = t->columns;
  const tp_vertices vertices = tp_outlines_at(t->outlines, block);
  tp_block_turning turning;
  tp_status status = tp_turning_filter(&turning, workspace, vertices, &t->turning, message);
  if (status == TP_UNDECIDED) {
    workspace->summary.climbed++;
    status = tp_turning_solve(&turning, vertices, t->turning.towards, message);
  }
  if (c->angle_deg != NULL) c->angle_deg[block] = turning.angle_deg;
  if (c->error_deg != NULL) c->error_deg[block] = turning.error_deg;
  if (c->pivot != NULL) c->pivot[block] = turning.pivot;
  if (c->status != NULL) c->status[block] = status;
  return status;
}

tp_status tp_blocks_critical_angles(const tp_critical_columns *columns, tp_blocks_summary *summary,
                                    const tp_outlines *outlines, const tp_blocks_options *options,
                                    tp_message *message) {
  TP_GUARD_HOST;
  tp_blocks_options own = tp_blocks_options_default();
  TP_BLOCKS_BEGIN(message, columns, summary, outlines, own, options);
  const critical_task task = {.columns = columns,
                              .outlines = outlines,
                              .turning = {.towards = options->towards,
                                          .simple = options->simple,
                                          .kernel = tp_scan_kernel_choose(TP_INSTRUCTIONS_BEST)}};
  return tp_share_out(summary, find, &task, outlines->count, CHUNK, options->threads, message);
}
