/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Draws the samples of a chunk, shares them out to threads by batch/share.h, and writes and counts
 * their rows in order. */

#include "study/block.h"

#include "batch/share.h"
#include "common/clock.h"
#include "common/threads.h"
#include "study/roughness.h"
#include "study/row_csv.h"
#include "study/sample.h"

#include <stdlib.h>

tp_status tp_block_init(tp_block *block, const tp_study *study, const tp_study_options *options,
                        tp_tally *tally, size_t chunks, tp_message *message) {
  const size_t tilts = study->tilt_count + 1;
  *block = (tp_block){.study = study,
                      .options = options,
                      .tally = tally,
                      .rows = calloc(study->chunk, sizeof *block->rows),
                      .values = calloc(study->chunk * study->variable_count, sizeof(double)),
                      .at = calloc(study->chunk * tilts, sizeof *block->at),
                      .chunk_counts = calloc(chunks, sizeof *block->chunk_counts)};
  if (block->rows == NULL || block->values == NULL || block->at == NULL ||
      block->chunk_counts == NULL) {
    return tp_fail_memory(message, "the samples");
  }
  for (size_t k = 0; k < study->chunk; k++) {
    block->rows[k].values = block->values + k * study->variable_count;
    block->rows[k].at = block->at + k * tilts;
  }
  return TP_OK;
}

void tp_block_clear(tp_block *block) {
  free(block->rows);
  free(block->values);
  free(block->at);
  free(block->chunk_counts);
  tp_text_drop(&block->text);
}

void tp_block_begin(tp_block *block) {
  block->count = block->invalid_count = 0;
  block->text.length = 0;
}

/* ---- a chunk -----------------------------------------------------------------------------------
 */

/* By what the first second has come to, of a sample for each thread at least. */
static void foretell(tp_block *b) {
  static const double second = 1;
  const tp_study_options *options = b->options;
  if (options->forecast == NULL || atomic_load(&b->foretold)) return;
  const size_t threads = options->threads > 0 ? options->threads : tp_threads_present();
  const size_t solved = atomic_fetch_add(&b->solved, 1) + 1;
  const double elapsed = tp_clock_now() - b->began;
  if (elapsed < second || solved < threads || solved >= b->planned) return;
  const size_t left = (size_t)(b->planned - solved);
  if (atomic_exchange(&b->foretold, true)) return;
  options->forecast(options->context, left, elapsed / (double)solved * (double)left);
}

static tp_status solve_one(tp_workspace *workspace, const void *task, size_t at,
                           tp_message *message) {
  tp_block *b = *(tp_block *const *)task;
  const tp_study_options *options = b->options;
  (void)workspace;
  if (options->stop != NULL && !atomic_load(&b->stopped) && options->stop(options->context)) {
    atomic_store(&b->stopped, true);
  }
  if (atomic_load(&b->stopped)) return TP_OK;
  tp_study_row *row = b->rows + at;
  const double began = tp_clock_now();
  tp_status status = tp_study_solve(row, b->study, b->study->tilt_count, message);
  row->seconds = tp_clock_now() - began;
  foretell(b);
  if (status == TP_OK) status = tp_study_measure_roughness(row, b->study, message);
  if (status == TP_OK) tp_study_round_row(row, b->study);
  return status;
}

static tp_status take_rows(tp_block *b, uint64_t chunk, size_t count, tp_message *message) {
  tp_row_counts *counts = b->chunk_counts + b->count;
  const size_t began = b->text.length;
  tp_row_counts_begin(counts, b->study);
  for (size_t k = 0; k < count; k++) {
    const tp_study_row *row = b->rows + k;
    if (b->options->rows != NULL) tp_study_write_row(&b->text, b->study, row);
    tp_row_counts_row(counts, b->study, row, b->tally->first);
    tp_tally_keep(b->tally, row);
    if (row->at[0].outcome == TP_STUDY_INVALID && b->invalid_count < TP_STUDY_BAD) {
      b->invalid[b->invalid_count++] = row->sample;
    }
  }
  if (b->text.failed) return tp_fail_memory(message, "the rows");
  if (b->options->rows != NULL) {
    tp_row_counts_text(counts, chunk + 1, b->text.data + began, b->text.length - began);
  }
  b->ends[b->count++] = b->text.length;
  return TP_OK;
}

tp_status tp_block_compute(tp_block *b, uint64_t chunk, tp_message *message) {
  const uint64_t first = tp_chunk_sample(b->study, chunk);
  const size_t count = tp_study_chunk_size(b->study, chunk);
  tp_block *const task = b;
  tp_blocks_summary summary;
  for (size_t k = 0; k < count; k++) {
    b->rows[k].sample = first + k;
    b->rows[k].why = NULL;
  }
  tp_status status = tp_study_draw(b->values, b->study, first, count, message);
  if (status == TP_OK) {
    status = tp_share_out(&summary, solve_one, &task, count, 1, b->options->threads, message);
  }
  /* what was solved of a chunk in which the study is stopped is not kept */
  if (status == TP_OK && !atomic_load(&b->stopped)) status = take_rows(b, chunk, count, message);
  for (size_t k = 0; k < count; k++) free(b->rows[k].why);
  return status;
}

/* ---- some of it --------------------------------------------------------------------------------
 */

void tp_block_counts(tp_row_counts *counts, const tp_block *block, size_t count) {
  tp_row_counts_begin(counts, block->study);
  for (size_t k = 0; k < count; k++)
    tp_row_counts_add(counts, block->chunk_counts + k, block->study);
}

void tp_block_cut(tp_block *block, size_t count, uint64_t past_sample) {
  block->count = count;
  block->text.length = count > 0 ? block->ends[count - 1] : 0;
  while (block->invalid_count > 0 && block->invalid[block->invalid_count - 1] >= past_sample) {
    block->invalid_count--;
  }
}
