/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Solves the scene at each point by the pool of batch/share.h, one point a chunk, until it is
 * stopped. By ranks, in batches: the first tells how many points, 0 of which end it; then their
 * numbers, as the bits of doubles in a sum to which the others add 0; each solves a part, and the
 * results come together in the same way. */

#include "study/points.h"

#include "batch/share.h"
#include "study/sample.h"
#include "study/together.h"

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

static tp_status solve_here(double *numbers, const tp_study *study, const double *values,
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

/* ---- by ranks ----------------------------------------------------------------------------------
 */

/* In a batch; fewer points than these are solved by the first rank alone, sooner than they are
 * given out. */
enum { BATCH = 4096, FEWEST = 32 };

/* Room for a batch: the points, and of each its results, behind how ranks fared. */
typedef struct batch {
  const tp_study *study;
  const tp_study_options *options;
  uint64_t *points, *results, *sums;
} batch;

/* Before the results. */
enum { FAILED, STOPPED, RESULTS };

static void clear(batch *b) {
  free(b->points);
  free(b->results);
  free(b->sums);
}

static tp_status make_room(batch *b, const tp_study *study, const tp_study_options *options,
                           tp_message *message) {
  const size_t numbers = BATCH * study->variable_count,
               results = RESULTS + BATCH * TP_POINT_NUMBERS;
  *b = (batch){.study = study,
               .options = options,
               .points = calloc(numbers, sizeof *b->points),
               .results = calloc(results, sizeof *b->results),
               .sums = calloc(numbers > results ? numbers : results, sizeof *b->sums)};
  if (b->points != NULL && b->results != NULL && b->sums != NULL) return TP_OK;
  return tp_fail_memory(message, "points of a study");
}

/* The next batch, which the first rank has in `values`. */
static tp_status give_out(batch *b, const double *values, size_t count, tp_message *message) {
  const size_t numbers = count * b->study->variable_count;
  memset(b->points, 0, numbers * sizeof *b->points);
  if (values != NULL) memcpy(b->points, values, numbers * sizeof *b->points);
  return tp_together_sum(b->options->ranks, NULL, b->sums, b->points, numbers, message);
}

/* A part of the batch here, and the others by the others; all of it is in `sums`, and `*failed`
 * where one failed, of which the first rank has the status. */
static tp_status solve_batch(batch *b, size_t count, bool *failed, tp_message *message) {
  const tp_study_ranks *ranks = b->options->ranks;
  const size_t variables = b->study->variable_count, size = RESULTS + count * TP_POINT_NUMBERS;
  const size_t first = (size_t)tp_rank_share(ranks, ranks->rank, count);
  const size_t past = (size_t)tp_rank_share(ranks, ranks->rank + 1, count);
  bool stopped = false;
  memset(b->results, 0, size * sizeof *b->results);
  tp_status status = solve_here((double *)(b->results + RESULTS) + first * TP_POINT_NUMBERS,
                                b->study, (const double *)b->sums + first * variables, past - first,
                                b->options, &stopped, message);
  b->results[FAILED] = status != TP_OK;
  b->results[STOPPED] = stopped;
  const tp_status told = tp_together_sum(ranks, NULL, b->sums, b->results, size, message);
  if (told != TP_OK) return told;
  *failed = b->sums[FAILED] > 0;
  return *failed ? tp_together_agree(ranks, status, failed, message) : TP_OK;
}

/* How many points come next; where there are any, whether all ranks have room for them. */
static tp_status tell_count(uint64_t *count, const tp_study_options *options, tp_status room,
                            bool *failed, tp_message *message) {
  const uint64_t own = *count;
  *failed = false;
  const tp_status told = tp_together_sum(options->ranks, NULL, count, &own, 1, message);
  if (told != TP_OK || *count == 0) return told;
  return tp_together_agree(options->ranks, room, failed, message);
}

static tp_status solve_by_ranks(double *numbers, const tp_study *study, const double *values,
                                size_t count, const tp_study_options *options, bool *stopped,
                                tp_message *message) {
  batch b;
  bool failed = false;
  tp_status status = make_room(&b, study, options, message);
  *stopped = false;
  for (size_t at = 0; at < count && status == TP_OK && !failed && !*stopped; at += BATCH) {
    const size_t size = count - at < BATCH ? count - at : BATCH;
    uint64_t told = size;
    status = tell_count(&told, options, TP_OK, &failed, message);
    if (status == TP_OK) status = give_out(&b, values + at * study->variable_count, size, message);
    if (status == TP_OK) status = solve_batch(&b, size, &failed, message);
    if (status != TP_OK) break;
    memcpy(numbers + at * TP_POINT_NUMBERS, b.sums + RESULTS,
           size * TP_POINT_NUMBERS * sizeof *numbers);
    *stopped = b.sums[STOPPED] > 0;
  }
  clear(&b);
  return status;
}

tp_status tp_study_solve_points(double *numbers, const tp_study *study, const double *values,
                                size_t count, const tp_study_options *options, bool *stopped,
                                tp_message *message) {
  const bool alone = tp_rank_count(options->ranks) == 1 || count < FEWEST;
  return (alone ? solve_here : solve_by_ranks)(numbers, study, values, count, options, stopped,
                                               message);
}

tp_status tp_study_help_with_points(const tp_study *study, const tp_study_options *options,
                                    tp_message *message) {
  batch b;
  const tp_status room = make_room(&b, study, options, message);
  uint64_t count = 0;
  bool failed = false;
  tp_status status = tell_count(&count, options, room, &failed, message);
  while (status == TP_OK && count > 0) {
    if (!failed) status = give_out(&b, NULL, (size_t)count, message);
    if (!failed && status == TP_OK) status = solve_batch(&b, (size_t)count, &failed, message);
    count = 0;
    if (status == TP_OK) status = tell_count(&count, options, room, &failed, message);
  }
  clear(&b);
  return status;
}

tp_status tp_study_end_points(const tp_study_options *options, tp_status status,
                              tp_message *message) {
  const uint64_t none = 0;
  uint64_t all = 0;
  tp_message own = {.text = ""};
  const tp_status told = tp_together_sum(options->ranks, NULL, &all, &none, 1, &own);
  if (status != TP_OK || told == TP_OK) return status;
  if (message != NULL) *message = own;
  return told;
}
