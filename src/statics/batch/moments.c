/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The calls for moments of one outline and of many. */

#include "batch/area.h"
#include "batch/blocks.h"
#include "batch/share.h"

#include <math.h>

/* Outlines handed out at once: some tens of microseconds of work. */
enum { CHUNK = 512 };

tp_status tp_outline_moments(tp_area_moments *moments, const double *xy, size_t count,
                             tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, moments);
  TP_REFUSE_NULL(message, xy);
  enum { SMALL = 512 };
  double room[SMALL];
  tp_workspace workspace = {.room = room, .capacity = SMALL, .borrowed = true};
  const tp_vertices vertices = tp_vertices_open(xy, count);
  tp_area_moments own;
  tp_area_centre centre;
  tp_status status = tp_area_filter(&own, &centre, &workspace, vertices,
                                    tp_scan_kernel_choose(TP_INSTRUCTIONS_BEST), message);
  tp_workspace_clear(&workspace);
  if (status == TP_UNDECIDED) status = tp_area_exact(&own, vertices, message);
  if (status == TP_OK) *moments = own;
  return status;
}

typedef struct moments_task {
  const tp_moment_columns *columns;
  const tp_outlines *outlines;
  const tp_scan_kernel *kernel;
} moments_task;

static void put_all(const tp_moment_columns *c, size_t block, const tp_area_moments *m) {
  tp_columns_put(c->area, c->area_error, block, m->area);
  tp_columns_put(c->centroid_x, c->centroid_x_error, block, m->centroid_x);
  tp_columns_put(c->centroid_y, c->centroid_y_error, block, m->centroid_y);
  tp_columns_put(c->second_moment_xx, c->second_moment_xx_error, block, m->second_moment_xx);
  tp_columns_put(c->second_moment_yy, c->second_moment_yy_error, block, m->second_moment_yy);
  tp_columns_put(c->second_moment_xy, c->second_moment_xy_error, block, m->second_moment_xy);
}

static tp_status find(tp_workspace *workspace, const void *task, size_t block,
                      tp_message *message) {
  const moments_task *t = task;
  const tp_bounded none = {.value = NAN, .error = NAN};
  const tp_vertices vertices = tp_outlines_at(t->outlines, block);
  tp_area_moments moments;
  tp_area_centre centre;
  tp_status status = tp_area_filter(&moments, &centre, workspace, vertices, t->kernel, message);
  if (status == TP_UNDECIDED) {
    workspace->summary.climbed++;
    status = tp_area_exact(&moments, vertices, message);
  }
  if (status != TP_OK) moments = (tp_area_moments){none, none, none, none, none, none};
  put_all(t->columns, block, &moments);
  if (t->columns->status != NULL) t->columns->status[block] = status;
  return status;
}

tp_status tp_outlines_moments(const tp_moment_columns *columns, tp_blocks_summary *summary,
                              const tp_outlines *outlines, const tp_blocks_options *options,
                              tp_message *message) {
  TP_GUARD_HOST;
  tp_blocks_options own = tp_blocks_options_default();
  TP_BLOCKS_BEGIN(message, columns, summary, outlines, own, options);
  const moments_task task = {columns, outlines, tp_scan_kernel_choose(TP_INSTRUCTIONS_BEST)};
  return tp_share_out(summary, find, &task, outlines->count, CHUNK, options->threads, message);
}
