/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Rows of a complete study copied from CSV into HDF5: columns, rows in blocks, attributes, and an
 * end without a file where it is interrupted (docs/study.md).
 *
 * By ranks in rounds: in each every rank reads some blocks of rows, those after the ones of the
 * rank before it, which takes nearly all of the time; the first writes its own, and then what the
 * others have deflated, in the order of the rows. So the file is that of one process, and the first
 * has only the bytes of the file to write for the others. */

#include "common/host.h"
#include "hdf5/column.h"
#include "hdf5/hdf5.h"
#include "hdf5/texts.h"
#include "study/rows.h"
#include "study/together.h"

#include <stdlib.h>

enum { ROUND_BLOCKS = 4 }; /* of a rank, at most */

typedef struct writing {
  const tp_study *study;
  const tp_study_ranks *ranks;
  tp_hdf5_file file; /* of the first rank; of another one in memory */
  tp_hdf5_stop *stop;
  void *context; /* of that */
  tp_hdf5_column *columns;
  size_t count;
  uint64_t rows, first, past; /* all, and those of this rank in this round */
  uint64_t done;              /* before the block */
  size_t filled;              /* of the block */
  tp_text packed;             /* blocks of another rank than the first */
  tp_rows_stretch stretch;
  bool stopped, over; /* over: a rank failed, and the first has the status */
} writing;

/* ---- rows --------------------------------------------------------------------------------------
 */

static tp_status write_block(writing *w, tp_message *message) {
  const bool first = tp_rank_is_first(w->ranks);
  for (size_t k = 0; k < w->count && w->filled > 0; k++) {
    tp_hdf5_column *column = w->columns + k;
    if (!(first ? tp_hdf5_column_write(column, w->done, w->filled)
                : tp_hdf5_column_pack(column, &w->packed, w->done, w->filled))) {
      return tp_hdf5_fail(&w->file, message);
    }
  }
  w->done += w->filled;
  w->filled = 0;
  return TP_OK;
}

static tp_status take_row(void *context, tp_study_row *row, tp_message *message) {
  writing *w = context;
  if (row->sample < w->first) return TP_OK; /* of the rank before */
  for (size_t k = 0; k < w->count; k++) {
    tp_hdf5_column *column = w->columns + k;
    if (!tp_hdf5_column_put(column, w->filled,
                            tp_study_field_value(w->study, row, column->field))) {
      return tp_fail_memory(message, "the rows");
    }
  }
  w->filled++;
  return w->filled < tp_hdf5_block_rows(w->rows) ? TP_OK : write_block(w, message);
}

/* Once it is stopped, nothing more is taken. */
static tp_status take_chunk(void *context, uint64_t chunk, tp_text *text, tp_message *message) {
  writing *w = context;
  const uint64_t begins = tp_chunk_sample(w->study, chunk);
  w->stopped = w->stopped || (w->stop != NULL && w->stop(w->context));
  if (w->stopped || begins >= w->past) return TP_OK;
  return tp_rows_parse(&w->stretch, chunk, text, w->past - begins, take_row, w, message);
}

/* The rows of this rank in this round. A chunk in which they begin is counted by the rank that has
 * its first row. */
static tp_status read_share(writing *w, tp_row_counts *seen, tp_message *message) {
  const uint64_t chunk = w->study->chunk, whole = (w->first + chunk - 1) / chunk;
  tp_row_counts begun;
  tp_row_counts_begin(&begun, w->study);
  w->done = w->first;
  w->stretch.first = w->first / chunk;
  w->stretch.past = whole;
  tp_status status = tp_rows_read(&begun, &w->stretch, take_chunk, w, message);
  w->stretch.first = whole;
  w->stretch.past = (w->past + chunk - 1) / chunk;
  if (status == TP_OK) status = tp_rows_read(seen, &w->stretch, take_chunk, w, message);
  if (status == TP_OK && !w->stopped) status = write_block(w, message);
  return status;
}

static tp_status open_columns(writing *w, tp_message *message) {
  const size_t count = tp_study_field_count(w->study);
  w->columns = calloc(count, sizeof *w->columns);
  if (w->columns == NULL) return tp_fail_memory(message, "the rows");
  for (size_t k = 0; k < count; k++) {
    w->count++;
    if (!tp_hdf5_column_open(w->columns + k, w->file.id, w->study, k, w->rows)) {
      return tp_hdf5_fail(&w->file, message);
    }
  }
  return TP_OK;
}

static tp_status note_all(writing *w, tp_message *message) {
  const hid_t root = w->file.id;
  const bool noted = tp_hdf5_note_text(root, "topple", TP_VERSION) &&
                     tp_hdf5_note_count(root, "planned", w->study->samples) &&
                     tp_hdf5_note_count(root, "samples", w->rows);
  return noted ? tp_hdf5_note_texts(&w->file, w->study, message) : tp_hdf5_fail(&w->file, message);
}

static void close_columns(writing *w) {
  for (size_t k = 0; k < w->count; k++) tp_hdf5_column_close(w->columns + k, w->filled);
  free(w->columns);
  w->columns = NULL;
  w->count = w->filled = 0;
}

/* ---- rounds ------------------------------------------------------------------------------------
 */

/* Where the rows of a rank begin, in the round that begins with the row `round`. */
static uint64_t share_begins(const writing *w, uint64_t round, size_t rank) {
  const size_t ranks = tp_rank_count(w->ranks);
  const uint64_t block = tp_hdf5_block_rows(w->rows), blocks = (w->rows + block - 1) / block;
  const uint64_t each = (blocks + ranks - 1) / ranks;
  const uint64_t size = ranks > 1 && each > ROUND_BLOCKS ? ROUND_BLOCKS : each;
  const uint64_t begins = round + rank * size * block;
  return begins < w->rows ? begins : w->rows;
}

/* The rows of another rank than the first go into a file in memory, and from there packed. */
static tp_status pack_share(writing *w, tp_row_counts *seen, tp_message *message) {
  const char *path = w->file.path, *csv = w->file.csv;
  tp_text_drop(&w->packed);
  tp_status status = tp_hdf5_file_begin_in_memory(&w->file, path, csv, message);
  if (status == TP_OK) status = open_columns(w, message);
  if (status == TP_OK) status = read_share(w, seen, message);
  close_columns(w);
  return tp_hdf5_file_end(&w->file, status, false, message);
}

static tp_status take_share(writing *w, uint64_t round, tp_row_counts *seen, tp_message *message) {
  const size_t rank = tp_rank_of(w->ranks);
  w->first = share_begins(w, round, rank);
  w->past = share_begins(w, round, rank + 1);
  if (w->first >= w->past && w->first > 0) return TP_OK;
  return rank == 0 ? read_share(w, seen, message) : pack_share(w, seen, message);
}

static tp_status unpack_share(writing *w, const char *bytes, size_t size, tp_message *message) {
  const char *from = bytes, *const end = bytes + size;
  const uint64_t block = tp_hdf5_block_rows(w->rows);
  for (uint64_t row = w->first; row < w->past; row += block) {
    const uint64_t left = w->past - row;
    for (size_t k = 0; k < w->count; k++) {
      if (!tp_hdf5_column_unpack(w->columns + k, &from, end, row, left < block ? left : block)) {
        return tp_hdf5_fail(&w->file, message);
      }
    }
  }
  return TP_OK;
}

/* To the first rank, which writes the shares of all others behind its own. */
static tp_status bring_together(writing *w, uint64_t round, tp_message *message) {
  tp_status status = TP_OK;
  if (!tp_rank_is_first(w->ranks)) {
    if (w->first >= w->past) return TP_OK;
    return tp_together_send(w->ranks, w->packed.data, w->packed.length, message);
  }
  for (size_t rank = 1; rank < tp_rank_count(w->ranks); rank++) {
    w->first = share_begins(w, round, rank);
    w->past = share_begins(w, round, rank + 1);
    if (w->first >= w->past) return status;
    void *bytes = NULL;
    size_t size = 0;
    const tp_status received = tp_together_receive(w->ranks, rank, &bytes, &size, message);
    if (received != TP_OK) return received;
    if (status == TP_OK) status = unpack_share(w, bytes, size, message);
    free(bytes);
  }
  return status;
}

/* Of all ranks: did one fail, was one stopped? */
static tp_status agree(writing *w, tp_status status, tp_message *message) {
  const uint64_t own = w->stopped;
  uint64_t all = 0;
  status = tp_together_agree(w->ranks, status, &w->over, message);
  if (status == TP_OK && !w->over) status = tp_together_sum(w->ranks, NULL, &all, &own, 1, message);
  w->stopped = all > 0;
  w->over = w->over || status != TP_OK;
  return status;
}

/* All rows were seen that the study wrote. */
static tp_status check_rows(const writing *w, const tp_row_counts *seen, tp_message *message) {
  tp_row_counts all;
  const tp_status status = tp_together_sum(w->ranks, NULL, (uint64_t *)&all, (const uint64_t *)seen,
                                           tp_row_counts_numbers(w->study), message);
  if (status != TP_OK || !tp_rank_is_first(w->ranks)) return status;
  return tp_rows_check(&all, &w->stretch, message);
}

/* What fails in a round is told in the next one, the last of which has no rows. */
static tp_status write_rows(writing *w, tp_status begun, tp_message *message) {
  tp_row_counts seen;
  tp_row_counts_begin(&seen, w->study);
  tp_status status = agree(w, begun, message);
  for (uint64_t round = 0; !w->over && !w->stopped;) {
    if (status == TP_OK) status = take_share(w, round, &seen, message);
    status = agree(w, status, message);
    if (w->over || w->stopped || round >= w->rows) break;
    status = bring_together(w, round, message);
    round = share_begins(w, round, tp_rank_count(w->ranks));
  }
  return w->over || w->stopped ? status : check_rows(w, &seen, message);
}

static tp_status begin(writing *w, const char *path, tp_progress *progress, tp_message *message) {
  const char *csv = w->file.csv;
  bool there = false;
  tp_status status = tp_progress_read(progress, &there, csv, w->study, message);
  if (status != TP_OK) return status;
  if (!there || progress->shards != 1) {
    return tp_refuse(message, TP_FAULT_FORMAT, (tp_place){csv, 0, 0},
                     "these are not rows of a whole study");
  }
  const uint64_t most = progress->chunks * w->study->chunk;
  w->rows = most < w->study->samples ? most : w->study->samples;
  if (!tp_rank_is_first(w->ranks)) return TP_OK;
  status = tp_hdf5_file_begin(&w->file, path, csv, message);
  if (status == TP_OK) status = note_all(w, message);
  return status == TP_OK ? open_columns(w, message) : status;
}

tp_status tp_hdf5_write(const char *path, const tp_study *study, const char *csv,
                        const tp_study_ranks *ranks, tp_hdf5_stop *stop, void *context,
                        tp_message *message) {
  TP_GUARD_HOST;
  tp_progress progress = {0};
  writing w = {.study = study,
               .ranks = ranks,
               .file = {.path = path, .csv = csv, .id = H5I_INVALID_HID},
               .stop = stop,
               .context = context};
  w.stretch = (tp_rows_stretch){csv, study, &progress, 0, 0};
  const tp_status begun = begin(&w, path, &progress, message);
  const tp_status status = write_rows(&w, begun, message);
  close_columns(&w);
  tp_text_drop(&w.packed);
  if (!tp_rank_is_first(ranks)) return status;
  return tp_hdf5_file_end(&w.file, status, !w.stopped && !w.over, message);
}
