/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A round: computed, summed, cut where the study ends in it, written at its place, recorded. */

#include "study/rounds.h"

#include "common/clock.h"
#include "common/grow.h"

#include <math.h>
#include <stdlib.h>

static const double seconds_of_round = 0.25;

/* What ranks tell in a round: whole numbers that add up. */
typedef struct telling {
  uint64_t failed, stopped, chunks;
  uint64_t size; /* of the next round, told by the first alone */
  tp_row_counts counts;
} telling;

typedef struct told {
  telling before, all;
} told;

/* How a round was written: by whom not, and which invalid samples are among the first. */
typedef struct writing {
  uint64_t failed;
  tp_invalid invalid;
} writing;

static tp_status sum(told *t, const tp_rounds *r, const telling *own, tp_message *message) {
  const size_t count =
      offsetof(telling, counts) / sizeof(uint64_t) + tp_row_counts_numbers(r->study);
  return tp_together_sum(r->options->ranks, (uint64_t *)&t->before, (uint64_t *)&t->all,
                         (const uint64_t *)own, count, message);
}

/* ---- compute -----------------------------------------------------------------------------------
 */

tp_status tp_rounds_note_span(tp_rounds *r, uint64_t chunk, tp_message *message) {
  const uint64_t first = tp_chunk_sample(r->study, chunk);
  const size_t count = tp_study_chunk_size(r->study, chunk);
  if (tp_rank_is_first(r->options->ranks) || first - r->tally.first >= r->tally.room) return TP_OK;
  tp_rows_span *last = r->span_count > 0 ? r->spans + r->span_count - 1 : NULL;
  if (last != NULL && last->first + last->count == first) {
    last->count += count;
    return TP_OK;
  }
  tp_rows_span *grown = tp_grow(r->spans, r->span_count, &r->span_room, sizeof *grown);
  if (grown == NULL) return tp_fail_memory(message, "the summary of a study");
  r->spans = grown;
  grown[r->span_count++] = (tp_rows_span){first, count};
  return TP_OK;
}

/* The chunks of this rank: those before `*past`. */
static uint64_t begin(const tp_rounds *r, uint64_t *past) {
  const uint64_t left = r->past - r->next, ranks = tp_rank_count(r->options->ranks);
  const uint64_t share = (left + ranks - 1) / ranks;
  const uint64_t size = share < r->size ? share : r->size;
  const uint64_t rank = tp_rank_of(r->options->ranks);
  const uint64_t first = size * rank < left ? size * rank : left;
  *past = r->next + (first + size < left ? first + size : left);
  return r->next + first;
}

/* Rounds of the same time, as the first rank finds it. */
static uint64_t next_size(const tp_rounds *r, double seconds) {
  if (!tp_rank_is_first(r->options->ranks)) return 0;
  if (tp_rank_count(r->options->ranks) == 1 || r->block.count == 0) return 1;
  const double wanted = floor((double)r->block.count * seconds_of_round / seconds);
  const double most = fmin(TP_BLOCK_CHUNKS, 2 * (double)r->block.count);
  return (uint64_t)fmax(1, fmin(wanted, most));
}

static tp_status compute(tp_rounds *r, telling *own, tp_message *message) {
  uint64_t past = 0;
  const double began = tp_clock_now();
  tp_status status = r->recorded;
  if (status != TP_OK && message != NULL) *message = r->complaint;
  tp_block_begin(&r->block);
  for (uint64_t chunk = begin(r, &past);
       chunk < past && status == TP_OK && !atomic_load(&r->block.stopped); chunk++) {
    status = tp_block_compute(&r->block, chunk, message);
    if (status == TP_OK) status = tp_rounds_note_span(r, chunk, message);
  }
  *own = (telling){.failed = status != TP_OK,
                   .stopped = atomic_load(&r->block.stopped),
                   .chunks = r->block.count,
                   .size = next_size(r, tp_clock_now() - began)};
  tp_block_counts(&own->counts, &r->block, r->block.count);
  return status;
}

/* ---- where the study ends ----------------------------------------------------------------------
 */

/* After how many chunks of the block is the study certain? All of them where it is not. */
static size_t count_up_to_certain(bool *certain, const tp_rounds *r, const tp_row_counts *before) {
  tp_row_counts sum = r->tally.counts;
  *certain = false;
  if (!(r->study->half_width > 0) || r->options->shards > 1) return r->block.count;
  tp_row_counts_add(&sum, before, r->study);
  for (size_t k = 0; k < r->block.count; k++) {
    tp_row_counts_add(&sum, r->block.chunk_counts + k, r->study);
    *certain = tp_row_counts_is_certain(&sum, r->study);
    if (*certain) return k + 1;
  }
  return r->block.count;
}

/* Chunks count up to the first that is missing, since its rank was stopped, or after which the
 * study is certain: where there is one, what ranks tell is told again of those alone. */
static tp_status cut(tp_rounds *r, told *t, bool stopped, bool *ended, tp_message *message) {
  bool certain = false;
  uint64_t before = 0, all = 0, past = 0;
  size_t count = count_up_to_certain(&certain, r, &t->before.counts);
  const uint64_t own = certain || stopped;
  tp_status status = tp_together_sum(r->options->ranks, &before, &all, &own, 1, message);
  *ended = all > 0;
  if (status != TP_OK || all == 0) return status;
  if (before > 0) count = 0;
  tp_block_cut(&r->block, count, tp_chunk_sample(r->study, begin(r, &past) + count));
  telling kept = {.chunks = count};
  tp_block_counts(&kept.counts, &r->block, count);
  return sum(t, r, &kept, message);
}

/* ---- write -------------------------------------------------------------------------------------
 */

/* Through the first rank, where only one process can write. */
static tp_status put_in_turn(tp_rounds *r, tp_message *message) {
  const tp_study_ranks *ranks = r->options->ranks;
  tp_status status = TP_OK;
  if (!tp_rank_is_first(ranks)) {
    return tp_together_send(ranks, r->block.text.data, r->block.text.length, message);
  }
  status = tp_rows_put(&r->rows, &r->block.text, 0, message);
  for (size_t rank = 1; rank < tp_rank_count(ranks); rank++) {
    tp_text text = {0};
    void *bytes = NULL;
    const tp_status received = tp_together_receive(ranks, rank, &bytes, &text.length, message);
    text.data = bytes;
    if (status == TP_OK) status = received;
    if (status == TP_OK) status = tp_rows_put(&r->rows, &text, 0, message);
    free(bytes);
  }
  return status;
}

/* Those of the block that are among the first of all. */
static void find_invalid(tp_invalid *found, const tp_rounds *r, const tp_row_counts *before) {
  const uint64_t known =
      r->tally.counts.outcomes[0][TP_STUDY_INVALID] + before->outcomes[0][TP_STUDY_INVALID];
  *found = (tp_invalid){{0}};
  for (size_t k = 0; k < r->block.invalid_count; k++) {
    tp_tally_note_invalid(found, known + k, r->block.invalid[k]);
  }
}

static tp_status record(tp_rounds *r, tp_message *message) {
  if (!tp_rank_is_first(r->options->ranks)) return TP_OK;
  tp_progress *progress = &r->rows.progress;
  const uint64_t first = tp_shard_chunk(r->study, progress->shard, progress->shards);
  progress->chunks = r->next - first;
  progress->counts = r->tally.counts;
  progress->invalid = r->tally.invalid;
  return tp_rows_record(&r->rows, message);
}

/* All of it is in the file before the first rank tells so. */
static tp_status write_block(tp_rounds *r, const told *t, tp_message *message) {
  const tp_study_ranks *ranks = r->options->ranks;
  const uint64_t at = r->tally.counts.bytes + t->before.counts.bytes;
  writing own = {0}, before, all;
  tp_status status = r->rows.path == NULL || r->rows.regular
                         ? tp_rows_put(&r->rows, &r->block.text, at, message)
                         : put_in_turn(r, message);
  own.failed = status != TP_OK;
  find_invalid(&own.invalid, r, &t->before.counts);
  const tp_status summed =
      tp_together_sum(ranks, (uint64_t *)&before, (uint64_t *)&all, (uint64_t *)&own,
                      sizeof own / sizeof(uint64_t), message);
  if (summed != TP_OK) return summed;
  if (all.failed > 0) {
    r->over = true;
    return tp_together_tell(ranks, status, before.failed, message);
  }
  for (size_t k = 0; k < TP_STUDY_BAD; k++) {
    r->tally.invalid.places[k] += all.invalid.places[k];
  }
  tp_row_counts_add(&r->tally.counts, &t->all.counts, r->study);
  r->next += t->all.chunks;
  r->recorded = record(r, &r->complaint);
  return TP_OK;
}

tp_status tp_rounds_next(tp_rounds *r, bool *ended, tp_message *message) {
  telling own;
  told t;
  *ended = false;
  const tp_status computed = compute(r, &own, message);
  tp_status status = sum(&t, r, &own, message);
  if (status != TP_OK) return status;
  if (t.all.failed > 0) {
    r->over = true;
    return tp_together_tell(r->options->ranks, computed, t.before.failed, message);
  }
  const size_t size = (size_t)t.all.size;
  if (r->study->half_width > 0 || t.all.stopped > 0) {
    status = cut(r, &t, own.stopped > 0, ended, message);
  }
  if (status == TP_OK) status = write_block(r, &t, message);
  r->size = size;
  return status;
}
