/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The rows of all shards as those of one run: read one file after another in the order of the
 * shards, counted as a run counts them, written anew chunk by chunk. Where a study is to end once
 * its intervals are narrow, so it does here, at the chunk where one run would have ended. */

#include "common/host.h"
#include "common/options.h"
#include "study/result.h"
#include "study/rows.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

/* A shard's file. */
typedef struct part {
  const char *path;
  tp_progress progress;
} part;

typedef struct merging {
  const tp_study *study;
  tp_tally tally;
  tp_rows rows;
  tp_text chunk;
  bool certain;
} merging;

static uint64_t first_chunk(const tp_study *study, size_t shard, size_t shards) {
  return tp_study_chunks(study) * shard / shards;
}

static tp_status check_part(const part *own, const tp_study *study, size_t count,
                            tp_message *message) {
  const tp_progress *p = &own->progress;
  const tp_place place = {own->path, 0, 0};
  if (p->shards != count) {
    return tp_refuse(message, TP_FAULT_FORMAT, place,
                     "this is shard %zu of %zu, but %zu files are given; give those of all shards",
                     p->shard, p->shards, count);
  }
  const uint64_t whole =
      first_chunk(study, p->shard, count) - first_chunk(study, p->shard - 1, count);
  if (p->chunks == whole) return TP_OK;
  return tp_refuse(message, TP_FAULT_FORMAT, place,
                   "this shard is not whole: %zu of %zu chunks; run it to its end",
                   (size_t)p->chunks, (size_t)whole);
}

/* Its progress is not there. */
static tp_status fail_missing(const char *path, tp_message *message) {
  struct stat state;
  const tp_place place = {path, 0, 0};
  if (stat(path, &state) != 0) return tp_fail_file(message, path, "opened", errno);
  return tp_refuse(message, TP_FAULT_KEY, place,
                   "there is no '%.300s.progress' beside it, which identifies the rows of a shard; "
                   "copy both files",
                   path);
}

/* Each into the place of its shard. */
static tp_status sort_parts(part *parts, const tp_study *study, const char *const *shards,
                            size_t count, tp_message *message) {
  if (count == 0) {
    return tp_refuse(message, TP_FAULT_FORMAT, (tp_place){0}, "give the files of all shards");
  }
  for (size_t k = 0; k < count; k++) {
    part own = {.path = shards[k]};
    bool there = false;
    tp_status status = tp_progress_read(&own.progress, &there, own.path, study, message);
    if (status == TP_OK && !there) status = fail_missing(own.path, message);
    if (status == TP_OK) status = check_part(&own, study, count, message);
    if (status != TP_OK) return status;
    part *place = parts + own.progress.shard - 1;
    if (place->path != NULL) {
      return tp_refuse(message, TP_FAULT_KEY, (tp_place){own.path, 0, 0},
                       "shard %zu is given twice", own.progress.shard);
    }
    *place = own;
  }
  return TP_OK;
}

/* After the last row of a chunk. */
static tp_status end_chunk(merging *m, tp_message *message) {
  const tp_status status = tp_rows_add(&m->rows, &m->chunk, message);
  tp_text_drop(&m->chunk);
  m->certain = tp_tally_is_certain(&m->tally);
  return status;
}

static tp_status take_row(void *context, tp_study_row *row, bool *enough, tp_message *message) {
  merging *m = context;
  if (row->sample != m->tally.samples) {
    return tp_refuse(message, TP_FAULT_FORMAT, (tp_place){0},
                     "the rows of a shard are out of order");
  }
  if (m->rows.path != NULL) tp_text_append(&m->chunk, row->line, strlen(row->line));
  if (m->rows.path != NULL) tp_text_add(&m->chunk, "\n");
  tp_status status = tp_tally_add(&m->tally, row, message);
  const uint64_t samples = m->tally.samples;
  const bool ends = samples % m->study->chunk == 0 || samples == m->study->samples;
  if (status == TP_OK && ends) status = end_chunk(m, message);
  *enough = m->certain;
  return status;
}

static tp_status merge(merging *m, const part *parts, size_t count, tp_message *message) {
  tp_status status = TP_OK;
  for (size_t k = 0; k < count && status == TP_OK && !m->certain; k++) {
    tp_sha256_state hash;
    status = tp_rows_read(&hash, parts[k].path, m->study, &parts[k].progress, take_row, m, message);
  }
  return status;
}

/* What is merged is no shard itself. */
static tp_status check_output(const char *rows, const part *parts, size_t count,
                              tp_message *message) {
  struct stat own, other;
  if (rows == NULL || stat(rows, &own) != 0) return TP_OK;
  for (size_t k = 0; k < count; k++) {
    if (stat(parts[k].path, &other) != 0 || own.st_dev != other.st_dev ||
        own.st_ino != other.st_ino) {
      continue;
    }
    return tp_refuse(message, TP_FAULT_ARGUMENT, (tp_place){rows, 0, 0},
                     "this is a shard that is read here, and would be lost; write to another name");
  }
  return TP_OK;
}

static tp_status start(merging *m, const part *parts, size_t count, const tp_study_options *options,
                       tp_message *message) {
  tp_status status = check_output(options->rows, parts, count, message);
  if (status == TP_OK) status = tp_tally_init(&m->tally, m->study, message);
  if (status == TP_OK) status = tp_rows_open(&m->rows, m->study, options, message);
  if (status != TP_OK || m->rows.progress.chunks == 0) return status;
  return tp_refuse(message, TP_FAULT_ARGUMENT, (tp_place){options->rows, 0, 0},
                   "rows of this study are there already; restart to write over them, or name "
                   "another file");
}

tp_status tp_study_merge(tp_study_result **result, const tp_study *study, const char *const *shards,
                         size_t count, const tp_study_options *options, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, result);
  TP_REFUSE_NULL(message, study);
  TP_REFUSE_NULL(message, shards);
  for (size_t k = 0; k < count; k++) TP_REFUSE_NULL(message, shards[k]);
  TP_REFUSE_NULL(message, options);
  tp_study_options taken = tp_study_options_default();
  TP_TAKE_OPTIONS(message, taken, options);
  taken.shard = taken.shards = 1;
  merging m = {.study = study, .rows = {.descriptor = -1}};
  part *parts = calloc(count + 1, sizeof *parts);
  if (parts == NULL) return tp_fail_memory(message, "the shards");
  tp_status status = sort_parts(parts, study, shards, count, message);
  if (status == TP_OK) status = start(&m, parts, count, &taken, message);
  if (status == TP_OK) status = merge(&m, parts, count, message);
  if (status == TP_OK) {
    const bool whole = m.tally.samples == study->samples;
    status = tp_study_sum_up(result, &m.tally, whole ? TP_STUDY_COMPLETE : TP_STUDY_CERTAIN, &taken,
                             message);
  }
  for (size_t k = 0; k < count && status == TP_OK; k++) {
    status = tp_study_add_source(*result, shards[k], message);
    if (status == TP_OK) continue;
    tp_study_result_free(*result);
    *result = NULL;
  }
  tp_rows_close(&m.rows);
  tp_text_drop(&m.chunk);
  tp_tally_clear(&m.tally);
  free(parts);
  return status;
}
