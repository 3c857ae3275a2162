/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A study run: chunk after chunk of a fixed number of samples. The samples of a chunk are shared
 * out to threads, each filling its own row; rows are written and counted in their order. So what
 * comes out depends neither on the threads nor on where a run was interrupted. */

#include "batch/share.h"
#include "common/clock.h"
#include "common/host.h"
#include "common/options.h"
#include "study/result.h"
#include "study/roughness.h"
#include "study/row_csv.h"
#include "study/rows.h"
#include "study/sample.h"

#include <stdatomic.h>
#include <stdlib.h>

TP_OPTIONS_END(tp_study_options, progress);

void tp_study_options_init(tp_study_options *options, size_t size) {
  const tp_study_options defaults = {.size = sizeof defaults, .shard = 1, .shards = 1};
  tp_options_fill(options, size, &defaults);
}

/* A run, with room for one chunk. */
typedef struct run {
  const tp_study *study;
  const tp_study_options *options;
  tp_rows rows;
  tp_tally tally;
  tp_study_row *chunk;
  double *values;
  tp_study_at *at;
  atomic_bool stopped;
  uint64_t next, past; /* chunks */
  uint64_t first;      /* sample */
} run;

static tp_status start(run *r, tp_message *message) {
  const tp_study *study = r->study;
  const size_t tilts = study->tilt_count + 1;
  r->chunk = calloc(study->chunk, sizeof *r->chunk);
  r->values = calloc(study->chunk * study->variable_count, sizeof *r->values);
  r->at = calloc(study->chunk * tilts, sizeof *r->at);
  if (r->chunk == NULL || r->values == NULL || r->at == NULL) {
    return tp_fail_memory(message, "the samples");
  }
  for (size_t k = 0; k < study->chunk; k++) {
    r->chunk[k].values = r->values + k * study->variable_count;
    r->chunk[k].at = r->at + k * tilts;
  }
  return TP_OK;
}

static void end(run *r) {
  free(r->chunk);
  free(r->values);
  free(r->at);
  tp_rows_close(&r->rows);
  tp_tally_clear(&r->tally);
}

/* ---- a chunk -----------------------------------------------------------------------------------
 */

static tp_status solve_one(tp_workspace *workspace, const void *task, size_t block,
                           tp_message *message) {
  run *r = *(run *const *)task;
  (void)workspace;
  if (r->options->stop != NULL && !atomic_load(&r->stopped) &&
      r->options->stop(r->options->context)) {
    atomic_store(&r->stopped, true);
  }
  if (atomic_load(&r->stopped)) return TP_OK;
  tp_study_row *row = r->chunk + block;
  const double began = tp_clock_now();
  tp_status status = tp_study_solve(row, r->study, r->study->tilt_count, message);
  row->seconds = tp_clock_now() - began;
  if (status == TP_OK) status = tp_study_measure_roughness(row, r->study, message);
  if (status == TP_OK) tp_study_round_row(row, r->study);
  return status;
}

static tp_status keep_chunk(run *r, size_t count, tp_message *message) {
  tp_text text = {0};
  tp_status status = TP_OK;
  for (size_t k = 0; k < count && status == TP_OK; k++) {
    if (r->rows.path != NULL) tp_study_write_row(&text, r->study, r->chunk + k);
    status = tp_tally_add(&r->tally, r->chunk + k, message);
  }
  if (status == TP_OK) status = tp_rows_add(&r->rows, &text, message);
  tp_text_drop(&text);
  return status;
}

/* What was solved of a chunk in which the study is stopped is not kept. */
static tp_status take_chunk(run *r, tp_message *message) {
  const uint64_t first = r->next * r->study->chunk;
  const size_t count = tp_study_chunk_size(r->study, r->next);
  run *const task = r;
  tp_blocks_summary summary;
  for (size_t k = 0; k < count; k++) {
    r->chunk[k].sample = first + k;
    r->chunk[k].why = NULL;
  }
  tp_status status = tp_study_draw(r->values, r->study, first, count, message);
  if (status == TP_OK) {
    status = tp_share_out(&summary, solve_one, &task, count, 1, r->options->threads, message);
  }
  if (status == TP_OK && !atomic_load(&r->stopped)) status = keep_chunk(r, count, message);
  for (size_t k = 0; k < count; k++) free(r->chunk[k].why);
  r->next++;
  return status;
}

/* ---- all of them -------------------------------------------------------------------------------
 */

static tp_status take_row(void *context, tp_study_row *row, bool *enough, tp_message *message) {
  run *r = context;
  (void)enough;
  if (row->sample == r->first + r->tally.samples) return tp_tally_add(&r->tally, row, message);
  return tp_refuse(message, TP_FAULT_FORMAT, (tp_place){r->rows.path, 0, 0},
                   "the rows are out of order; the file was changed since it was written");
}

/* Rows that were written before. */
static tp_status go_on(run *r, tp_message *message) {
  r->next += r->rows.progress.chunks;
  return tp_rows_go_on(&r->rows, take_row, r, message);
}

static bool is_certain(const run *r) {
  return r->options->shards == 1 && tp_tally_is_certain(&r->tally);
}

static tp_status take_chunks(run *r, tp_study_end *ended, tp_message *message) {
  const uint64_t chunks = tp_study_chunks(r->study), shard = r->options->shard - 1;
  r->next = chunks * shard / r->options->shards;
  r->past = chunks * (shard + 1) / r->options->shards;
  r->first = r->next * r->study->chunk;
  const uint64_t past = r->past * r->study->chunk, all = r->study->samples;
  const size_t of = (size_t)((past < all ? past : all) - r->next * r->study->chunk);
  tp_status status = go_on(r, message);
  while (status == TP_OK && r->next < r->past && !is_certain(r) && !atomic_load(&r->stopped)) {
    status = take_chunk(r, message);
    if (status == TP_OK && r->options->progress != NULL && !atomic_load(&r->stopped)) {
      r->options->progress(r->options->context, (size_t)r->tally.samples, of);
    }
  }
  *ended = atomic_load(&r->stopped) ? TP_STUDY_INTERRUPTED
           : r->next < r->past      ? TP_STUDY_CERTAIN
           : r->options->shards > 1 ? TP_STUDY_SHARD
                                    : TP_STUDY_COMPLETE;
  return status;
}

static tp_status check(const tp_study_options *options, tp_message *message) {
  enum { MOST_SHARDS = 1000000 };
  if (options->shards >= 1 && options->shards <= MOST_SHARDS && options->shard >= 1 &&
      options->shard <= options->shards) {
    return TP_OK;
  }
  return tp_refuse(message, TP_FAULT_ARGUMENT, (tp_place){0},
                   "a shard is one from 1 to the number of shards, of a million at most");
}

tp_status tp_study_run(tp_study_result **result, const tp_study *study,
                       const tp_study_options *options, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, result);
  TP_REFUSE_NULL(message, study);
  TP_REFUSE_NULL(message, options);
  tp_study_options taken = tp_study_options_default();
  TP_TAKE_OPTIONS(message, taken, options);
  tp_status status = check(options, message);
  if (status != TP_OK) return status;
  run r = {.study = study, .options = options, .rows = {.descriptor = -1}};
  tp_study_end ended = TP_STUDY_COMPLETE;
  status = tp_tally_init(&r.tally, study, message);
  if (status == TP_OK) status = start(&r, message);
  if (status == TP_OK) status = tp_rows_open(&r.rows, study, options, message);
  if (status == TP_OK) status = take_chunks(&r, &ended, message);
  if (status == TP_OK) status = tp_study_sum_up(result, &r.tally, ended, options, message);
  end(&r);
  return status;
}
