/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "study/rows.h"

#include "study/row_csv.h"
#include "study/sources.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

static tp_status fail_writing(const tp_rows *rows, tp_message *message) {
  return tp_fail(message, TP_SYSTEM_FAILED, (tp_place){rows->path, 0, 0},
                 "cannot be written: %s; what is there stays, and the study goes on from it once "
                 "there is room",
                 strerror(errno));
}

static tp_status write_all(const tp_rows *rows, const char *bytes, size_t left,
                           tp_message *message) {
  while (left > 0) {
    const ssize_t written = write(rows->descriptor, bytes, left);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return fail_writing(rows, message);
    bytes += written;
    left -= (size_t)written;
  }
  return TP_OK;
}

static tp_status append(tp_rows *rows, const tp_text *text, tp_message *message) {
  if (text->failed) return tp_fail_memory(message, "the rows");
  const tp_status status = write_all(rows, text->data, text->length, message);
  if (status == TP_OK) rows->progress.bytes += text->length;
  return status;
}

/* ---- begin, or go on ---------------------------------------------------------------------------
 */

static tp_status check_sources(const tp_rows *rows, const struct stat *own, tp_message *message) {
  if (!tp_study_reads(rows->study, own)) return TP_OK;
  return tp_fail(message, TP_BAD_INPUT, (tp_place){rows->path, 0, 0},
                 "this is a file that the study reads, and would be lost; write to another name");
}

/* The header alone. */
static tp_status begin(tp_rows *rows, tp_message *message) {
  tp_text text = {0};
  if (rows->regular && ftruncate(rows->descriptor, 0) != 0) return fail_writing(rows, message);
  tp_study_write_header(&text, rows->study);
  const tp_status status = append(rows, &text, message);
  tp_text_drop(&text);
  if (status != TP_OK || !rows->regular) return status;
  return tp_progress_write(&rows->progress, rows->path, rows->study, message);
}

/* Of a run that was ended before it could tell of its progress: the header, or some of it. */
static tp_status is_begun(bool *begun, const tp_rows *rows, off_t size, tp_message *message) {
  tp_text header = {0};
  tp_study_write_header(&header, rows->study);
  *begun = size == 0;
  FILE *file = size > 0 && size <= (off_t)header.length ? fopen(rows->path, "rb") : NULL;
  char *there = file != NULL ? malloc((size_t)size) : NULL;
  if (there != NULL && fread(there, (size_t)size, 1, file) == 1) {
    *begun = memcmp(there, header.data, (size_t)size) == 0;
  }
  const bool failed = header.failed || (file != NULL && there == NULL);
  if (file != NULL) fclose(file);
  free(there);
  tp_text_drop(&header);
  return failed ? tp_fail_memory(message, "the rows") : TP_OK;
}

/* What lies beyond the last whole chunk is cut off. */
static tp_status go_on(const tp_rows *rows, const tp_study_options *options, off_t size,
                       tp_message *message) {
  const tp_progress *progress = &rows->progress;
  const tp_place place = {rows->path, 0, 0};
  if (progress->shard != options->shard || progress->shards != options->shards) {
    return tp_fail(message, TP_BAD_INPUT, place,
                   "these are the rows of shard %zu of %zu; restart, or name another file",
                   progress->shard, progress->shards);
  }
  if (size < (off_t)progress->bytes) {
    return tp_fail(message, TP_BAD_INPUT, place,
                   "rows that were written are missing; restart, or name another file");
  }
  return ftruncate(rows->descriptor, (off_t)progress->bytes) == 0 ? TP_OK
                                                                  : fail_writing(rows, message);
}

/* One run at a time: another one is told, on the same machine and where the file system can. */
static tp_status lock(const tp_rows *rows, tp_message *message) {
  if (flock(rows->descriptor, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return TP_OK;
  return tp_fail(message, TP_BAD_INPUT, (tp_place){rows->path, 0, 0},
                 "another run is writing these rows; wait for it, or name another file");
}

/* What HDF5 is made of is CSV: a name that promises otherwise is a mistake. */
static tp_status check_name(const char *path, tp_message *message) {
  const char *ending = strrchr(path, '.');
  if (ending == NULL || (strcasecmp(ending, ".h5") != 0 && strcasecmp(ending, ".hdf5") != 0)) {
    return TP_OK;
  }
  return tp_fail(
      message, TP_BAD_INPUT, (tp_place){path, 0, 0},
      "the rows are CSV; name a file that ends in .csv, or let 'topple study --rows' make "
      "HDF5");
}

static tp_status begin_or_go_on(tp_rows *rows, const tp_study_options *options,
                                tp_message *message) {
  struct stat state;
  bool there = false, begun = true;
  if (fstat(rows->descriptor, &state) != 0) return fail_writing(rows, message);
  rows->regular = S_ISREG(state.st_mode);
  tp_status status = check_sources(rows, &state, message);
  if (status == TP_OK && rows->regular) status = lock(rows, message);
  if (status == TP_OK && rows->regular && !options->restart) {
    status = tp_progress_read(&rows->progress, &there, rows->path, rows->study, message);
  }
  if (status != TP_OK) return status;
  if (there) return go_on(rows, options, state.st_size, message);
  if (rows->regular && !options->restart) {
    status = is_begun(&begun, rows, state.st_size, message);
  }
  if (status != TP_OK) return status;
  if (!begun) {
    return tp_fail(message, TP_BAD_INPUT, (tp_place){rows->path, 0, 0},
                   "this file is there, and is not the rows of a study to go on with; restart to "
                   "write over it, or name another file");
  }
  return begin(rows, message);
}

tp_status tp_rows_open(tp_rows *rows, const tp_study *study, const tp_study_options *options,
                       tp_message *message) {
  *rows = (tp_rows){.study = study,
                    .path = options->rows,
                    .descriptor = -1,
                    .progress = {.shard = options->shard, .shards = options->shards}};
  if (rows->path == NULL) return TP_OK;
  const tp_status named = check_name(rows->path, message);
  if (named != TP_OK) return named;
  rows->descriptor = open(rows->path, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC | O_NOCTTY, 0666);
  if (rows->descriptor < 0) return fail_writing(rows, message);
  const tp_status status = begin_or_go_on(rows, options, message);
  if (status != TP_OK) tp_rows_close(rows);
  return status;
}

tp_status tp_rows_add(tp_rows *rows, const tp_text *text, tp_message *message) {
  if (rows->path == NULL) return TP_OK;
  const tp_status status = append(rows, text, message);
  if (status != TP_OK) return status;
  rows->progress.chunks++;
  return rows->regular ? tp_progress_write(&rows->progress, rows->path, rows->study, message)
                       : TP_OK;
}

void tp_rows_close(tp_rows *rows) {
  if (rows->descriptor >= 0) close(rows->descriptor);
  rows->descriptor = -1;
}
