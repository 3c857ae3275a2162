/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Solves the scene at each point by the pool of batch/share.h, one point a chunk, until it is
 * stopped. */

#include "study/points.h"

#include "batch/share.h"
#include "study/sample.h"

#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

typedef struct points {
  const tp_study *study;
  const tp_study_options *options;
  const double *values;
  double *numbers;
  atomic_bool stopped;
} points;

static tp_status solve_point(tp_workspace *workspace, const void *task, size_t block,
                             tp_message *message) {
  points *own = *(points *const *)task;
  const tp_study_options *options = own->options;
  (void)workspace;
  if (options->stop != NULL && options->stop(options->context)) atomic_store(&own->stopped, true);
  if (atomic_load(&own->stopped)) return TP_OK;
  double *values = calloc(own->study->variable_count, sizeof *values);
  if (values == NULL) return tp_fail_memory(message, "a point");
  memcpy(values, own->values + block * own->study->variable_count,
         own->study->variable_count * sizeof *values);
  tp_study_at at;
  tp_study_row row = {.values = values, .at = &at};
  const tp_status status = tp_study_solve(&row, own->study, 0, message);
  if (status == TP_OK) {
    double *numbers = own->numbers + block * TP_POINT_NUMBERS;
    memcpy(numbers, row.quantities, sizeof row.quantities);
    numbers[TP_POINT_TILT] = row.tilt_deg;
  }
  free(row.why);
  free(values);
  return status;
}

tp_status tp_study_solve_points(double *numbers, const tp_study *study, const double *values,
                                size_t count, const tp_study_options *options, bool *stopped,
                                tp_message *message) {
  points own = {.study = study, .options = options, .values = values, .numbers = numbers};
  points *const task = &own;
  tp_blocks_summary summary;
  const tp_status status =
      tp_share_out(&summary, solve_point, &task, count, 1, options->threads, message);
  *stopped = atomic_load(&own.stopped);
  return status;
}
