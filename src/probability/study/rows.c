/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Opens or continues the file of rows under a lock, checks by its header and its progress that it
 * is of this study, and writes text at its place. */

#include "study/rows.h"

#include "output/file.h"
#include "study/row_csv.h"
#include "study/sources.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

static tp_status fail_writing(const tp_rows *rows, tp_message *message) {
  const int why = errno;
  const tp_status status =
      tp_fail(message, TP_SYSTEM_FAILED, (tp_place){rows->path, 0, 0},
              "cannot be written: %s; the rows written so far are kept, and the study "
              "continues from them once there is room",
              strerror(why));
  return tp_fail_because(message, status, why);
}

tp_status tp_rows_put(const tp_rows *rows, const tp_text *text, uint64_t at, tp_message *message) {
  const char *bytes = text->data;
  size_t left = text->length;
  if (rows->path == NULL || left == 0) return TP_OK;
  while (left > 0) {
    const ssize_t written = rows->regular ? pwrite(rows->descriptor, bytes, left, (off_t)at)
                                          : write(rows->descriptor, bytes, left);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return fail_writing(rows, message);
    bytes += written;
    at += (uint64_t)written;
    left -= (size_t)written;
  }
  return TP_OK;
}

tp_status tp_rows_record(const tp_rows *rows, tp_message *message) {
  if (rows->path == NULL || !rows->regular) return TP_OK;
  return tp_progress_write(&rows->progress, rows->path, rows->study, message);
}

tp_status tp_rows_cut(const tp_rows *rows, tp_message *message) {
  if (rows->path == NULL || !rows->regular) return TP_OK;
  return ftruncate(rows->descriptor, (off_t)rows->progress.counts.bytes) == 0
             ? TP_OK
             : fail_writing(rows, message);
}

/* ---- begin, or go on ---------------------------------------------------------------------------
 */

static tp_status check_sources(const tp_rows *rows, const struct stat *own, tp_message *message) {
  if (!tp_study_reads(rows->study, own)) return TP_OK;
  return tp_refuse(message, TP_FAULT_ARGUMENT, (tp_place){rows->path, 0, 0},
                   "this is a file that the study reads, and would be lost; write to another name");
}

/* The header alone. */
static tp_status begin(tp_rows *rows, tp_message *message) {
  tp_text text = {0};
  if (rows->regular && ftruncate(rows->descriptor, 0) != 0) return fail_writing(rows, message);
  tp_row_counts_begin(&rows->progress.counts, rows->study);
  rows->progress.invalid = (tp_invalid){{0}};
  tp_study_write_header(&text, rows->study);
  tp_status status = text.failed ? tp_fail_memory(message, "the rows") : TP_OK;
  if (status == TP_OK) tp_row_counts_text(&rows->progress.counts, 0, text.data, text.length);
  if (status == TP_OK) status = tp_rows_put(rows, &text, 0, message);
  tp_text_drop(&text);
  return status == TP_OK ? tp_rows_record(rows, message) : status;
}

/* Does the file, of so many bytes, begin as this, or as some of it where it is shorter? */
static tp_status begins_as(bool *begins, const tp_rows *rows, off_t size, const char *text,
                           tp_message *message) {
  const size_t all = strlen(text), length = size < (off_t)all ? (size_t)size : all;
  *begins = length == 0;
  if (*begins) return TP_OK;
  FILE *file = fopen(rows->path, "rbe");
  char *there = malloc(length);
  if (file != NULL && there != NULL && fread(there, length, 1, file) == 1) {
    *begins = memcmp(there, text, length) == 0;
  }
  if (file != NULL) fclose(file);
  const bool failed = there == NULL;
  free(there);
  return failed ? tp_fail_memory(message, "the rows") : TP_OK;
}

/* Before it is begun anew. Where that was said, or no chunk is whole, it has the whole header of
 * this study, or it begins as rows do and has the progress of a study next to it: a table of
 * anybody's may have a first column 'sample'. Else it has the header, or some of it, of a run that
 * was ended before it had written its progress. */
static tp_status check_there(const tp_rows *rows, bool restart, off_t size, tp_message *message) {
  tp_text header = {0};
  bool begins = false;
  tp_study_write_header(&header, rows->study);
  tp_status status = header.failed ? tp_fail_memory(message, "the rows") : TP_OK;
  if (status == TP_OK) status = begins_as(&begins, rows, size, header.data, message);
  begins = begins &&
           (size == 0 || (restart ? size >= (off_t)header.length : size <= (off_t)header.length));
  if (status == TP_OK && restart && !begins && tp_progress_is_there(rows->path)) {
    status = begins_as(&begins, rows, size, "sample,", message);
  }
  tp_text_drop(&header);
  if (status != TP_OK || begins) return status;
  return tp_refuse(message, TP_FAULT_ARGUMENT, (tp_place){rows->path, 0, 0},
                   "this file is there, and is not the rows of a study%s",
                   restart
                       ? ", the only files that are written over; remove it, or name another file"
                       : " to continue from; restart to write over rows, or name another file");
}

static tp_status check_going_on(const tp_rows *rows, const tp_study_options *options, off_t size,
                                tp_message *message) {
  const tp_progress *progress = &rows->progress;
  const tp_place place = {rows->path, 0, 0};
  if (progress->shard != options->shard || progress->shards != options->shards) {
    return tp_refuse(message, TP_FAULT_ARGUMENT, place,
                     "these are the rows of shard %zu of %zu; restart, or name another file",
                     progress->shard, progress->shards);
  }
  if (progress->chunks > 0 &&
      size < (off_t)progress->counts.bytes) { /* the header alone is begun anew */
    return tp_refuse(message, TP_FAULT_ARGUMENT, place,
                     "rows that were written are missing; restart, or name another file");
  }
  return TP_OK;
}

/* One run at a time: another one is told, on the same machine and where the file system can. */
static tp_status lock(const tp_rows *rows, tp_message *message) {
  if (flock(rows->descriptor, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return TP_OK;
  return tp_refuse(message, TP_FAULT_ARGUMENT, (tp_place){rows->path, 0, 0},
                   "another run is writing these rows; wait for it, or name another file");
}

static tp_status begin_or_go_on(tp_rows *rows, const tp_study_options *options,
                                tp_message *message) {
  struct stat state;
  bool there = false;
  if (fstat(rows->descriptor, &state) != 0) return fail_writing(rows, message);
  rows->regular = S_ISREG(state.st_mode);
  tp_status status = check_sources(rows, &state, message);
  if (status == TP_OK && rows->regular) status = lock(rows, message);
  if (status == TP_OK && rows->regular && !options->restart) {
    status = tp_progress_read(&rows->progress, &there, rows->path, rows->study, message);
  }
  if (status != TP_OK) return status;
  if (there) status = check_going_on(rows, options, state.st_size, message);
  if (status != TP_OK || rows->progress.chunks > 0) return status;
  if (rows->regular) status = check_there(rows, options->restart || there, state.st_size, message);
  return status == TP_OK ? begin(rows, message) : status;
}

static void prepare(tp_rows *rows, const tp_study *study, const tp_study_options *options) {
  *rows = (tp_rows){.study = study,
                    .path = options->rows,
                    .descriptor = -1,
                    .progress = {.shard = options->shard, .shards = options->shards}};
}

tp_status tp_rows_open(tp_rows *rows, const tp_study *study, const tp_study_options *options,
                       tp_message *message) {
  prepare(rows, study, options);
  if (rows->path == NULL) return TP_OK;
  tp_status status = tp_progress_check(rows->path, message);
  if (status == TP_OK) status = tp_file_open_to_add(&rows->descriptor, rows->path, message);
  if (status == TP_OK) status = begin_or_go_on(rows, options, message);
  if (status != TP_OK) tp_rows_close(rows);
  return status;
}

tp_status tp_rows_join(tp_rows *rows, const tp_study *study, const tp_study_options *options,
                       bool regular, tp_message *message) {
  prepare(rows, study, options);
  rows->regular = regular;
  if (rows->path == NULL || !regular) return TP_OK;
  rows->descriptor = open(rows->path, O_WRONLY | O_CLOEXEC | O_NOCTTY);
  if (rows->descriptor >= 0) return TP_OK;
  const int why = errno;
  const tp_status status =
      tp_fail(message, TP_SYSTEM_FAILED, (tp_place){rows->path, 0, 0},
              "cannot be written by all ranks: %s; name a file on a file system that all machines "
              "share",
              strerror(why));
  return tp_fail_because(message, status, why);
}

void tp_rows_close(tp_rows *rows) {
  if (rows->descriptor >= 0) close(rows->descriptor);
  rows->descriptor = -1;
}
