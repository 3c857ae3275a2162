/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Rows of a complete study copied from CSV into HDF5: checks before the run, columns, rows in
 * blocks, attributes, and an end without a file where it is interrupted (docs/study.md). */

#include "common/host.h"
#include "hdf5/column.h"
#include "hdf5/hdf5.h"
#include "hdf5/texts.h"
#include "study/rows.h"
#include "study/sources.h"

#include <stdlib.h>

typedef struct writing {
  const tp_study *study;
  tp_hdf5_file file;
  tp_hdf5_stop *stop;
  void *context; /* of that */
  tp_hdf5_column *columns;
  size_t count;
  uint64_t rows, done; /* done: in the file */
  size_t filled;       /* of the block */
  tp_rows_stretch stretch;
  bool stopped;
} writing;

/* ---- before ------------------------------------------------------------------------------------
 */

tp_status tp_hdf5_check(const char *path, const tp_study *study, const char *csv, bool restart,
                        tp_message *message) {
  TP_GUARD_HOST;
  const tp_place place = {path, 0, 0};
  struct stat own;
  tp_progress progress = {0};
  bool there = false;
  /* nobody named the CSV */
  if (lstat(csv, &own) == 0 && S_ISLNK(own.st_mode)) {
    return tp_refuse(
        message, TP_FAULT_ARGUMENT, (tp_place){csv, 0, 0},
        "this is a link, into which the rows would go first; remove it, or name another "
        "file");
  }
  if (stat(path, &own) != 0) {
    if (lstat(path, &own) != 0) return TP_OK;
    return tp_fail(message, TP_SYSTEM_FAILED, place,
                   "cannot be written: it is a link that leads nowhere");
  }
  if (!S_ISREG(own.st_mode)) {
    return tp_refuse(message, TP_FAULT_ARGUMENT, place,
                     "HDF5 needs a separate file; name another one");
  }
  if (tp_study_reads(study, &own)) {
    return tp_refuse(
        message, TP_FAULT_ARGUMENT, place,
        "this is a file that the study reads, and would be lost; write to another name");
  }
  if (restart) {
    if (tp_hdf5_file_is_ours(path)) return TP_OK;
    return tp_refuse(message, TP_FAULT_ARGUMENT, place,
                     "this file is there, and is not the rows of a study, the only files that are "
                     "written over; remove it, or name another file");
  }
  const tp_status status = tp_progress_read(&progress, &there, csv, study, message);
  if (status != TP_OK || there) return status;
  return tp_refuse(
      message, TP_FAULT_ARGUMENT, place,
      "this file is there, and no '%.300s' to continue from; restart to write over it, or "
      "name another file",
      csv);
}

/* ---- rows --------------------------------------------------------------------------------------
 */

static tp_status write_block(writing *w, tp_message *message) {
  for (size_t k = 0; k < w->count && w->filled > 0; k++) {
    if (!tp_hdf5_column_write(w->columns + k, w->done, w->filled)) {
      return tp_hdf5_fail(&w->file, message);
    }
  }
  w->done += w->filled;
  w->filled = 0;
  return TP_OK;
}

static tp_status take_row(void *context, tp_study_row *row, tp_message *message) {
  writing *w = context;
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
  w->stopped = w->stopped || (w->stop != NULL && w->stop(w->context));
  if (w->stopped) return TP_OK;
  return tp_rows_parse(&w->stretch, chunk, text, w->rows, take_row, w, message);
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

static tp_status write_rows(writing *w, const tp_progress *progress, tp_message *message) {
  tp_status status = note_all(w, message);
  if (status == TP_OK) status = open_columns(w, message);
  if (status == TP_OK) {
    tp_row_counts seen;
    tp_row_counts_begin(&seen, w->study);
    w->stretch = (tp_rows_stretch){w->file.csv, w->study, progress, 0, progress->chunks};
    status = tp_rows_read(&seen, &w->stretch, take_chunk, w, message);
    if (status == TP_OK) status = tp_rows_check(&seen, &w->stretch, message);
  }
  if (status == TP_OK && !w->stopped) status = write_block(w, message);
  for (size_t k = 0; k < w->count; k++) tp_hdf5_column_close(w->columns + k, w->filled);
  free(w->columns);
  return status;
}

tp_status tp_hdf5_write(const char *path, const tp_study *study, const char *csv,
                        tp_hdf5_stop *stop, void *context, tp_message *message) {
  TP_GUARD_HOST;
  tp_progress progress = {0};
  bool there = false;
  tp_status status = tp_progress_read(&progress, &there, csv, study, message);
  if (status != TP_OK) return status;
  if (!there || progress.shards != 1) {
    return tp_refuse(message, TP_FAULT_FORMAT, (tp_place){csv, 0, 0},
                     "these are not rows of a whole study");
  }
  const uint64_t most = progress.chunks * study->chunk;
  writing w = {.study = study,
               .stop = stop,
               .context = context,
               .rows = most < study->samples ? most : study->samples};
  status = tp_hdf5_file_begin(&w.file, path, csv, message);
  if (status == TP_OK) status = write_rows(&w, &progress, message);
  return tp_hdf5_file_end(&w.file, status, !w.stopped, message);
}
