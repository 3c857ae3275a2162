/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Rows read back, chunk by chunk, as far as the progress beside them tells. A chunk is so many
 * lines; its text is hashed as it was when it was written, and parsed only for whoever wants its
 * numbers. A row begins with the number of its sample, by which a chunk is found in the file. */

#define _GNU_SOURCE /* getline */
#include "common/input_file.h"
#include "study/row_csv.h"
#include "study/rows.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct reading {
  const tp_rows_stretch *stretch;
  FILE *file;
  uint64_t at; /* bytes before what is read next */
  char *line;
  size_t room;
  tp_message *message;
} reading;

static uint64_t first_sample(const tp_rows_stretch *stretch) {
  const tp_progress *progress = stretch->progress;
  return tp_chunk_sample(stretch->study,
                         tp_shard_chunk(stretch->study, progress->shard, progress->shards));
}

static tp_status fail_changed(const tp_rows_stretch *stretch, tp_message *message) {
  const tp_progress *progress = stretch->progress;
  const uint64_t first = tp_shard_chunk(stretch->study, progress->shard, progress->shards);
  const uint64_t rows = tp_chunk_sample(stretch->study, first + progress->chunks) -
                        tp_chunk_sample(stretch->study, first);
  return tp_refuse(message, TP_FAULT_FORMAT, (tp_place){stretch->path, 0, 0},
                   "lines 1 to %zu are not those that the study wrote: a row was changed since, or "
                   "lost, or moved; put the file back as it was, restart, or name another file",
                   (size_t)rows + 1);
}

/* A line of what the progress tells of: its length, 0 where there is none. */
static tp_status read_line(size_t *length, reading *r) {
  *length = 0;
  errno = 0;
  const ssize_t own = getline(&r->line, &r->room, r->file);
  if (own < 0 && errno == ENOMEM) return tp_fail_memory(r->message, "the rows");
  if (own <= 0 || r->at + (uint64_t)own > r->stretch->progress->counts.bytes) return TP_OK;
  r->at += (uint64_t)own;
  *length = r->line[own - 1] == '\n' ? (size_t)own : 0;
  return TP_OK;
}

static bool seek(reading *r, uint64_t at) {
  r->at = at;
  return fseeko(r->file, (off_t)at, SEEK_SET) == 0;
}

/* ---- where a chunk begins ----------------------------------------------------------------------
 */

/* The first line that begins after `from`: where, and the number of its sample. */
static tp_status next_line(bool *found, uint64_t *at, uint64_t *sample, reading *r, uint64_t from) {
  size_t length = 0;
  *found = false;
  if (!seek(r, from)) return TP_OK;
  tp_status status = read_line(&length, r);
  if (status != TP_OK || length == 0) return status;
  *at = r->at;
  status = read_line(&length, r);
  if (status != TP_OK || length == 0) return status;
  char *end = NULL;
  *sample = strtoull(r->line, &end, 10);
  *found = end != r->line && *end == ',';
  return TP_OK;
}

/* Lines begin at rising samples: the last place after which a line begins that comes before the
 * wanted one is just before it. */
static tp_status find(reading *r, uint64_t wanted, tp_message *message) {
  uint64_t low = 0, high = r->stretch->progress->counts.bytes;
  while (low < high) {
    const uint64_t middle = low + (high - low) / 2;
    uint64_t at = 0, sample = 0;
    bool found = false;
    const tp_status status = next_line(&found, &at, &sample, r, middle);
    if (status != TP_OK) return status;
    if (found && sample == wanted) {
      return seek(r, at) ? TP_OK : fail_changed(r->stretch, message);
    }
    if (found && sample < wanted) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return fail_changed(r->stretch, message);
}

/* ---- chunks ------------------------------------------------------------------------------------
 */

/* The header is what this study would write. */
static tp_status read_header(tp_row_counts *seen, reading *r) {
  size_t length = 0;
  tp_text text = {0};
  tp_status status = read_line(&length, r);
  if (status != TP_OK) return status;
  tp_study_write_header(&text, r->stretch->study);
  const bool failed = text.failed;
  const bool same =
      !failed && length == text.length && memcmp(r->line, text.data, text.length) == 0;
  if (same) tp_row_counts_text(seen, 0, text.data, text.length);
  tp_text_drop(&text);
  if (failed) return tp_fail_memory(r->message, "the rows");
  return same ? TP_OK : fail_changed(r->stretch, r->message);
}

static tp_status read_chunk(tp_text *text, reading *r, uint64_t chunk) {
  const size_t lines = tp_study_chunk_size(r->stretch->study, chunk);
  for (size_t k = 0; k < lines; k++) {
    size_t length = 0;
    const tp_status status = read_line(&length, r);
    if (status != TP_OK) return status;
    if (length == 0) return fail_changed(r->stretch, r->message);
    tp_text_append(text, r->line, length);
  }
  return text->failed ? tp_fail_memory(r->message, "the rows") : TP_OK;
}

static tp_status read_all(tp_row_counts *seen, reading *r, tp_rows_take_chunk *take,
                          void *context) {
  const tp_rows_stretch *own = r->stretch;
  const tp_progress *progress = own->progress;
  const bool begins = own->first == tp_shard_chunk(own->study, progress->shard, progress->shards);
  tp_status status =
      begins ? read_header(seen, r) : find(r, tp_chunk_sample(own->study, own->first), r->message);
  for (uint64_t chunk = own->first; chunk < own->past && status == TP_OK; chunk++) {
    tp_text text = {0};
    status = read_chunk(&text, r, chunk);
    if (status == TP_OK) tp_row_counts_text(seen, chunk + 1, text.data, text.length);
    if (status == TP_OK && take != NULL) status = take(context, chunk, &text, r->message);
    tp_text_drop(&text);
  }
  return status;
}

tp_status tp_rows_read(tp_row_counts *seen, const tp_rows_stretch *stretch,
                       tp_rows_take_chunk *take, void *context, tp_message *message) {
  reading r = {.stretch = stretch, .message = message};
  const tp_progress *progress = stretch->progress;
  if (stretch->first >= stretch->past && progress->chunks > 0) return TP_OK;
  tp_status status = tp_input_open(&r.file, stretch->path, message);
  if (status != TP_OK) return status;
  status = read_all(seen, &r, take, context);
  free(r.line);
  fclose(r.file);
  return status;
}

tp_status tp_rows_check(const tp_row_counts *seen, const tp_rows_stretch *stretch,
                        tp_message *message) {
  return tp_row_counts_same_text(seen, &stretch->progress->counts) ? TP_OK
                                                                   : fail_changed(stretch, message);
}

/* ---- rows --------------------------------------------------------------------------------------
 */

static tp_status parse_line(tp_study_row *row, const tp_rows_stretch *stretch, char *line,
                            uint64_t sample, tp_rows_take *take, void *context,
                            tp_message *message) {
  bool no_memory = false;
  const bool read = tp_study_read_row(row, &no_memory, stretch->study, line);
  const int number = (int)(sample - first_sample(stretch)) + 2;
  tp_status status = TP_OK;
  if (no_memory) {
    status = tp_fail_memory(message, "the rows");
  } else if (!read || row->sample != sample) {
    status = tp_refuse(message, TP_FAULT_FORMAT, (tp_place){stretch->path, number, 0},
                       "%s; the file was changed since it was written",
                       read ? "the rows are out of order" : "this is not a row of the study");
  }
  if (status == TP_OK) status = take(context, row, message);
  free(row->why);
  row->why = NULL;
  return status;
}

tp_status tp_rows_parse(const tp_rows_stretch *stretch, uint64_t chunk, tp_text *text,
                        uint64_t most, tp_rows_take *take, void *context, tp_message *message) {
  const tp_study *study = stretch->study;
  tp_study_row row = {.values = calloc(study->variable_count, sizeof *row.values),
                      .at = calloc(study->tilt_count + 1, sizeof *row.at)};
  uint64_t sample = tp_chunk_sample(study, chunk);
  const uint64_t past = sample + most;
  tp_status status =
      row.values != NULL && row.at != NULL ? TP_OK : tp_fail_memory(message, "the rows");
  for (char *line = text->data, *end = NULL;
       status == TP_OK && sample < past && line < text->data + text->length; line = end + 1) {
    end = strchr(line, '\n');
    if (end == NULL) { /* a byte 0, which no row has */
      status = fail_changed(stretch, message);
      break;
    }
    *end = '\0';
    status = parse_line(&row, stretch, line, sample++, take, context, message);
  }
  free(row.values);
  free(row.at);
  return status;
}
