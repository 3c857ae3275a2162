/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Rows read back, line by line, as far as the progress beside them tells. */

#define _GNU_SOURCE /* getline */
#include "study/row_csv.h"
#include "study/rows.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct reading {
  const char *path;
  const tp_study *study;
  uint64_t bytes_left;
  tp_sha256_state *hash; /* of the bytes so far */
  int line;
  tp_rows_take *take;
  void *context;
  tp_message *message;
} reading;

static tp_status fail_line(const reading *r) {
  return tp_refuse(r->message, TP_FAULT_FORMAT, (tp_place){r->path, r->line, 0},
                   "this is not a row of the study; the file was changed since it was written");
}

/* The header is what this study would write. */
static tp_status check_header(const reading *r, const char *line) {
  tp_text text = {0};
  tp_study_write_header(&text, r->study);
  const bool failed = text.failed;
  const bool same = !failed && strcmp(line, text.data) == 0;
  tp_text_drop(&text);
  return failed ? tp_fail_memory(r->message, "the rows") : same ? TP_OK : fail_line(r);
}

static tp_status take_line(const reading *r, tp_study_row *row, char *line, size_t length,
                           bool *enough) {
  bool no_memory = false;
  if (r->line == 1) return check_header(r, line);
  if (length == 0 || line[length - 1] != '\n' || strlen(line) < length) return fail_line(r);
  line[length - 1] = '\0';
  row->line = line;
  const bool read = tp_study_read_row(row, &no_memory, r->study, line);
  tp_status status = no_memory ? tp_fail_memory(r->message, "the rows")
                     : read    ? TP_OK
                               : fail_line(r);
  if (status == TP_OK) status = r->take(r->context, row, enough, r->message);
  free(row->why);
  row->why = NULL;
  return status;
}

/* The bytes that are no longer needed as rows count, too. */
static tp_status check_hash(reading *r, const tp_progress *progress, FILE *file) {
  char bytes[1 << 14];
  uint8_t hash[TP_SHA256_SIZE];
  size_t count = 1;
  while (r->bytes_left > 0 && count > 0) {
    count =
        fread(bytes, 1, r->bytes_left < sizeof bytes ? (size_t)r->bytes_left : sizeof bytes, file);
    for (size_t k = 0; k < count; k++) r->line += bytes[k] == '\n';
    tp_sha256_add(r->hash, bytes, count);
    r->bytes_left -= count;
  }
  tp_sha256_tell(hash, r->hash);
  if (r->bytes_left == 0 && memcmp(hash, progress->hash, sizeof hash) == 0) return TP_OK;
  return tp_refuse(r->message, TP_FAULT_FORMAT, (tp_place){r->path, 0, 0},
                   "lines 1 to %d are not those that the study wrote: a row was changed since, or "
                   "lost, or moved; put the file back as it was, restart, or name another file",
                   r->line);
}

static tp_status read_lines(reading *r, tp_study_row *row, FILE *file) {
  char *line = NULL;
  size_t room = 0;
  bool enough = false;
  tp_status status = TP_OK;
  while (status == TP_OK && !enough && r->bytes_left > 0) {
    errno = 0;
    const ssize_t length = getline(&line, &room, file);
    r->line++;
    if (length < 0 && errno == ENOMEM) {
      status = tp_fail_memory(r->message, "the rows");
    } else if (length < 0 || (uint64_t)length > r->bytes_left) {
      status = fail_line(r);
    } else {
      r->bytes_left -= (uint64_t)length;
      tp_sha256_add(r->hash, line, (size_t)length);
      status = take_line(r, row, line, (size_t)length, &enough);
    }
  }
  free(line);
  return status;
}

tp_status tp_rows_read(tp_sha256_state *hash, const char *path, const tp_study *study,
                       const tp_progress *progress, tp_rows_take *take, void *context,
                       tp_message *message) {
  reading r = {.path = path,
               .study = study,
               .bytes_left = progress->bytes,
               .hash = hash,
               .take = take,
               .context = context,
               .message = message};
  FILE *file = fopen(path, "rb");
  if (file == NULL) return tp_fail_file(message, path, "opened", errno);
  tp_sha256_begin(hash);
  tp_study_row row = {.values = calloc(study->variable_count, sizeof *row.values),
                      .at = calloc(study->tilt_count + 1, sizeof *row.at)};
  tp_status status = row.values != NULL && row.at != NULL ? read_lines(&r, &row, file)
                                                          : tp_fail_memory(message, "the rows");
  if (status == TP_OK) status = check_hash(&r, progress, file);
  free(row.values);
  free(row.at);
  fclose(file);
  return status;
}
