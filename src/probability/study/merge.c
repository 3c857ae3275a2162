/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The rows of all shards as those of one run: their text put one after another as it is, and hashed
 * on the way, their chunk_counts added, and only as many rows parsed as the summary keeps. Where a
 * study is to end once its intervals are narrow, all are parsed, as it may end within a shard: at
 * the chunk where one run would have ended. */

#include "common/host.h"
#include "common/options.h"
#include "study/hdf5_rows.h"
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
  tp_rows_stretch stretch; /* of the shard that is read */
  tp_study_at *scratch;
  uint64_t chunks;
  tp_row_counts text; /* of what was written: its header, and the chunks */
  bool by_rows, certain;
} merging;

static uint64_t first_chunk(const tp_study *study, size_t shard, size_t shards) {
  return tp_shard_chunk(study, shard + 1, shards);
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

static tp_status keep_row(void *context, tp_study_row *row, tp_message *message) {
  merging *m = context;
  (void)message;
  if (m->by_rows) {
    tp_tally_read(&m->tally, row, m->scratch);
  } else {
    tp_tally_keep(&m->tally, row);
  }
  return TP_OK;
}

static tp_status take_chunk(void *context, uint64_t chunk, tp_text *text, tp_message *message) {
  merging *m = context;
  const uint64_t first = tp_chunk_sample(m->study, chunk), all = m->study->samples;
  const uint64_t wanted = m->by_rows ? all : m->tally.room;
  if (m->certain) return TP_OK;
  if (m->rows.path != NULL) {
    const tp_status status = tp_rows_put(&m->rows, text, m->text.bytes, message);
    if (status != TP_OK) return status;
    tp_row_counts_text(&m->text, chunk + 1, text->data, text->length);
  }
  m->chunks++;
  const tp_status status =
      first < wanted ? tp_rows_parse(&m->stretch, chunk, text, wanted - first, keep_row, m, message)
                     : TP_OK;
  m->certain = m->by_rows && tp_row_counts_is_certain(&m->tally.counts, m->study);
  return status;
}

/* The counts of a shard, but for its text; its first invalid samples come after those before. */
static void add_counts(merging *m, const tp_progress *progress) {
  const uint64_t before = m->tally.counts.outcomes[0][TP_STUDY_INVALID];
  for (size_t k = 0; k < TP_STUDY_BAD && progress->invalid.places[k] > 0; k++) {
    tp_tally_note_invalid(&m->tally.invalid, before + k, progress->invalid.places[k] - 1);
  }
  tp_row_counts_add(&m->tally.counts, &progress->counts, m->study);
}

/* Told after each shard, as its counts are known then. */
static tp_status record(merging *m, tp_message *message) {
  tp_progress *progress = &m->rows.progress;
  m->tally.counts.bytes = m->text.bytes;
  memcpy(m->tally.counts.hash, m->text.hash, sizeof m->text.hash);
  progress->chunks = m->chunks;
  progress->counts = m->tally.counts;
  progress->invalid = m->tally.invalid;
  return tp_rows_record(&m->rows, message);
}

static tp_status merge_part(merging *m, const part *own, tp_message *message) {
  const tp_progress *progress = &own->progress;
  const uint64_t first = tp_shard_chunk(m->study, progress->shard, progress->shards);
  tp_row_counts seen;
  tp_row_counts_begin(&seen, m->study);
  m->stretch = (tp_rows_stretch){own->path, m->study, progress, first, first + progress->chunks};
  tp_status status = tp_rows_read(&seen, &m->stretch, take_chunk, m, message);
  if (status == TP_OK) status = tp_rows_check(&seen, &m->stretch, message);
  if (status != TP_OK) return status;
  if (!m->by_rows) add_counts(m, progress);
  return record(m, message);
}

static tp_status merge(merging *m, const part *parts, size_t count, tp_message *message) {
  tp_status status = TP_OK;
  m->text = m->rows.progress.counts; /* the header, where rows are written */
  for (size_t k = 0; k < count && status == TP_OK && !m->certain; k++) {
    status = merge_part(m, parts + k, message);
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
  if (status == TP_OK) {
    status = tp_tally_init(&m->tally, m->study, 0, m->study->samples, message);
  }
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
  merging m = {.study = study,
               .rows = {.descriptor = -1},
               .scratch = calloc(study->tilt_count + 1, sizeof *m.scratch),
               .by_rows = study->half_width > 0};
  tp_study_result *own = NULL;
  part *parts = calloc(count + 1, sizeof *parts);
  tp_status status =
      parts != NULL && m.scratch != NULL ? TP_OK : tp_fail_memory(message, "the shards");
  tp_hdf5_rows hdf5;
  const tp_status begun =
      tp_hdf5_rows_begin(&hdf5, &taken, study, status == TP_OK ? message : NULL);
  if (status == TP_OK) status = begun;
  if (status == TP_OK) status = sort_parts(parts, study, shards, count, message);
  if (status == TP_OK) status = start(&m, parts, count, &taken, message);
  if (status == TP_OK) status = merge(&m, parts, count, message);
  if (status == TP_OK) {
    const bool whole = m.tally.counts.samples == study->samples;
    status = tp_study_sum_up(&own, &m.tally, whole ? TP_STUDY_COMPLETE : TP_STUDY_CERTAIN, &taken,
                             message);
  }
  for (size_t k = 0; k < count && status == TP_OK; k++) {
    status = tp_study_add_source(own, shards[k], message);
  }
  if (status == TP_OK) status = tp_hdf5_rows_make(&hdf5, own, study, &taken, message);
  if (status == TP_OK) {
    *result = own;
  } else {
    tp_study_result_free(own);
  }
  tp_rows_close(&m.rows);
  tp_tally_clear(&m.tally);
  tp_hdf5_rows_end(&hdf5);
  free(m.scratch);
  free(parts);
  return status;
}
