/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Before the first round: the rows opened by the first rank, then by the others, and what is there
 * read by all, each a part of the chunks. After the last: columns brought together. */

#include "study/rounds.h"

#include <stdlib.h>
#include <string.h>

/* ---- open --------------------------------------------------------------------------------------
 */

/* What the first rank finds: of the others it is 0. */
typedef struct found {
  uint64_t failed, regular, chunks;
  tp_invalid invalid;
  tp_row_counts counts;
} found;

/* Are the counts of as many samples as the chunks have? */
static tp_status check_counts(const tp_rounds *r, tp_message *message) {
  const tp_progress *progress = &r->rows.progress;
  const uint64_t first = tp_shard_chunk(r->study, progress->shard, progress->shards);
  const uint64_t past = first + progress->chunks;
  if (past <= r->past && progress->counts.samples ==
                             tp_chunk_sample(r->study, past) - tp_chunk_sample(r->study, first)) {
    return TP_OK;
  }
  return tp_refuse(message, TP_FAULT_FORMAT, (tp_place){r->rows.path, 0, 0},
                   "the progress beside these rows is not theirs; put it back as it was, restart, "
                   "or name another file");
}

static tp_status open_first(tp_rounds *r, tp_message *message) {
  tp_status status = tp_rows_open(&r->rows, r->study, r->options, message);
  return status == TP_OK && r->rows.path != NULL ? check_counts(r, message) : status;
}

static tp_status open_rows(tp_rounds *r, tp_message *message) {
  const tp_study_ranks *ranks = r->options->ranks;
  const bool first = tp_rank_is_first(ranks);
  tp_progress *progress = &r->rows.progress;
  found own = {0}, before, all;
  tp_status status = first ? open_first(r, message) : TP_OK;
  own.failed = status != TP_OK;
  if (first && status == TP_OK) {
    own.regular = r->rows.regular;
    own.chunks = progress->chunks;
    own.invalid = progress->invalid;
    own.counts = progress->counts;
  }
  const size_t count = offsetof(found, counts) / sizeof(uint64_t) + tp_row_counts_numbers(r->study);
  const tp_status told = tp_together_sum(ranks, (uint64_t *)&before, (uint64_t *)&all,
                                         (uint64_t *)&own, count, message);
  if (told != TP_OK) return told;
  if (all.failed > 0) {
    r->over = true;
    return tp_together_tell(ranks, status, before.failed, message);
  }
  if (!first) status = tp_rows_join(&r->rows, r->study, r->options, all.regular > 0, message);
  progress->chunks = all.chunks;
  progress->counts = r->tally.counts = all.counts;
  progress->invalid = r->tally.invalid = all.invalid;
  return tp_together_agree(ranks, status, &r->over, message);
}

/* ---- what is there -----------------------------------------------------------------------------
 */

typedef struct reading {
  tp_rounds *rounds;
  tp_rows_stretch stretch;
} reading;

static tp_status keep_row(void *context, tp_study_row *row, tp_message *message) {
  const reading *own = context;
  (void)message;
  tp_tally_keep(&own->rounds->tally, row);
  return TP_OK;
}

/* The columns of what they have room for; all else is in the counts. */
static tp_status keep_chunk(void *context, uint64_t chunk, tp_text *text, tp_message *message) {
  const reading *own = context;
  tp_rounds *r = own->rounds;
  const uint64_t before = tp_chunk_sample(r->study, chunk) - r->tally.first;
  if (before >= r->tally.room) return TP_OK;
  const tp_status status = tp_rounds_note_span(r, chunk, message);
  if (status != TP_OK) return status;
  return tp_rows_parse(&own->stretch, chunk, text, r->tally.room - before, keep_row, context,
                       message);
}

/* Each rank a part; that all of them together are what was written, the first one tells. */
static tp_status read_rows(tp_rounds *r, tp_message *message) {
  const tp_study_ranks *ranks = r->options->ranks;
  const tp_progress *progress = &r->rows.progress;
  const size_t rank = tp_rank_of(ranks);
  reading own = {.rounds = r,
                 .stretch = {.path = r->rows.path,
                             .study = r->study,
                             .progress = progress,
                             .first = r->next + tp_rank_share(ranks, rank, progress->chunks),
                             .past = r->next + tp_rank_share(ranks, rank + 1, progress->chunks)}};
  tp_row_counts seen, before, all;
  tp_row_counts_begin(&seen, r->study);
  tp_status status = tp_rows_read(&seen, &own.stretch, keep_chunk, &own, message);
  const tp_status agreed = tp_together_agree(ranks, status, &r->over, message);
  if (agreed != TP_OK || r->over) return agreed;
  status = tp_together_sum(ranks, (uint64_t *)&before, (uint64_t *)&all, (uint64_t *)&seen,
                           tp_row_counts_numbers(r->study), message);
  if (status != TP_OK) return status;
  if (tp_rank_is_first(ranks)) {
    status = tp_rows_check(&all, &own.stretch, message);
    if (status == TP_OK) status = tp_rows_cut(&r->rows, message);
  }
  return tp_together_agree(ranks, status, &r->over, message);
}

tp_status tp_rounds_go_on(tp_rounds *r, tp_message *message) {
  const tp_status status = open_rows(r, message);
  if (status != TP_OK || r->over || r->rows.progress.chunks == 0) return status;
  const tp_status read = read_rows(r, message);
  r->next += r->rows.progress.chunks;
  return read;
}

/* ---- columns -----------------------------------------------------------------------------------
 */

static tp_status send_columns(const tp_rounds *r, tp_message *message) {
  const tp_study_ranks *ranks = r->options->ranks;
  const size_t spans = (size_t)r->span_count;
  size_t rows = 0;
  for (size_t k = 0; k < spans; k++) rows += r->spans[k].count;
  const size_t head = sizeof(uint64_t) + spans * sizeof *r->spans;
  /* columns have no more than their room, of which a span may have less */
  char *bytes = malloc(head + rows * r->tally.column_count * sizeof(double));
  if (bytes == NULL) { /* the first one is told why not afterwards */
    const tp_status sent = tp_together_send(ranks, NULL, 0, message);
    return sent == TP_OK ? tp_fail_memory(message, "the summary of a study") : sent;
  }
  const uint64_t count = spans;
  memcpy(bytes, &count, sizeof count);
  if (spans > 0) memcpy(bytes + sizeof count, r->spans, spans * sizeof *r->spans);
  char *at = bytes + head;
  for (size_t k = 0; k < r->tally.column_count; k++) {
    for (size_t j = 0; j < spans; j++) {
      const tp_rows_span *span = r->spans + j;
      memcpy(at, r->tally.columns[k] + (span->first - r->tally.first),
             span->count * sizeof(double));
      at += span->count * sizeof(double);
    }
  }
  const tp_status status = tp_together_send(ranks, bytes, (size_t)(at - bytes), message);
  free(bytes);
  return status;
}

static void place_columns(const tp_rounds *r, const char *bytes) {
  uint64_t spans = 0;
  memcpy(&spans, bytes, sizeof spans);
  const char *at = bytes + sizeof spans + spans * sizeof(tp_rows_span);
  for (size_t k = 0; k < r->tally.column_count; k++) {
    for (size_t j = 0; j < spans; j++) {
      tp_rows_span span;
      memcpy(&span, bytes + sizeof spans + j * sizeof span, sizeof span);
      memcpy(r->tally.columns[k] + (span.first - r->tally.first), at, span.count * sizeof(double));
      at += span.count * sizeof(double);
    }
  }
}

static tp_status receive_columns(const tp_rounds *r, tp_message *message) {
  const tp_study_ranks *ranks = r->options->ranks;
  tp_status status = TP_OK;
  for (size_t rank = 1; rank < tp_rank_count(ranks) && status == TP_OK; rank++) {
    void *bytes = NULL;
    size_t size = 0;
    status = tp_together_receive(ranks, rank, &bytes, &size, message);
    if (status == TP_OK && size > 0) place_columns(r, bytes);
    free(bytes);
  }
  return status;
}

tp_status tp_rounds_gather(tp_rounds *r, tp_message *message) {
  const tp_study_ranks *ranks = r->options->ranks;
  tp_status status = r->recorded;
  if (status != TP_OK && message != NULL) *message = r->complaint;
  if (tp_rank_count(ranks) > 1) {
    const tp_status gathered =
        tp_rank_is_first(ranks) ? receive_columns(r, message) : send_columns(r, message);
    if (status == TP_OK) status = gathered;
  }
  return tp_together_agree(ranks, status, &r->over, message);
}
