/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Rows of a study as a file has them: the first byte says whether the rest is the progress beside
 * them, or rows, of which all that are read are written, and read again. */

#include "fuzz.h"
#include "study/row_csv.h"
#include "study/rows.h"
#include "study/tally.h"
#include "study_folder.h"

#include <stdlib.h>
#include <string.h>

static const char study_text[] = "topple_study: 1\nscene: slab.yaml\nsamples: 100\nvary:\n"
                                 "  friction_angle_deg: {normal: {mean: 30, deviation: 2}}\n"
                                 "  h: {uniform: {low: -1, high: 4}}\ntilts_deg: [20, 30]\n";

static const tp_study *the_study(void) {
  static tp_study *study; /* lives as long as the process */
  char path[200];
  tp_message message = {.text = ""};
  if (study != NULL) return study;
  fuzz_study_write("study.yaml", study_text, strlen(study_text));
  FUZZ_EXPECT(tp_study_read(&study, fuzz_study_path(path, "study.yaml"), &message) == TP_OK);
  return study;
}

typedef struct written {
  const tp_study *study;
  tp_tally tally;
  tp_text first;
} written;

static tp_status take(void *context, tp_study_row *row, tp_message *message) {
  written *w = context;
  tp_study_at at[3]; /* the scene's tilt, and two */
  (void)message;
  tp_study_write_row(&w->first, w->study, row);
  tp_tally_read(&w->tally, row, at);
  return TP_OK;
}

static tp_status take_chunk(void *context, uint64_t chunk, tp_text *text, tp_message *message) {
  const tp_rows_stretch *stretch = context;
  (void)chunk;
  FUZZ_EXPECT(text->length <= stretch->progress->counts.bytes);
  FUZZ_EXPECT(message != NULL);
  return TP_OK;
}

/* What is written of rows that were read is read as the same rows. */
static void read_again(const written *w) {
  const tp_study *study = w->study;
  tp_text again = {0};
  double *values = calloc(study->variable_count, sizeof *values);
  tp_study_at *at = calloc(study->tilt_count + 1, sizeof *at);
  tp_study_row row = {.values = values, .at = at};
  char *text = strdup(w->first.data != NULL ? w->first.data : "");
  FUZZ_EXPECT(values != NULL && at != NULL && text != NULL);
  for (char *line = text; *line != '\0';) {
    char *end = strchr(line, '\n');
    bool no_memory = false;
    FUZZ_EXPECT(end != NULL);
    *end = '\0';
    FUZZ_EXPECT(tp_study_read_row(&row, &no_memory, study, line));
    tp_study_write_row(&again, study, &row);
    free(row.why);
    line = end + 1;
  }
  FUZZ_EXPECT(again.length == w->first.length);
  FUZZ_EXPECT(again.length == 0 || memcmp(again.data, w->first.data, again.length) == 0);
  tp_text_drop(&again);
  free(text);
  free(values);
  free(at);
}

/* As a file, of which a chunk is so many lines, and as the text of a chunk. */
static void read_rows(const tp_study *study, const uint8_t *data, size_t size) {
  char path[200];
  tp_text text = {0};
  tp_message message = {.text = ""};
  written w = {.study = study};
  tp_progress progress = {.shard = 1, .shards = 1, .chunks = 1};
  tp_row_counts seen;
  tp_study_write_header(&text, study);
  const size_t header = text.length;
  tp_text_append(&text, (const char *)data, size);
  fuzz_study_write("rows.csv", text.data, text.length);
  progress.counts.bytes = text.length;
  const tp_rows_stretch stretch = {fuzz_study_path(path, "rows.csv"), study, &progress, 0, 1};
  tp_row_counts_begin(&seen, study);
  tp_status status = tp_rows_read(&seen, &stretch, take_chunk, (void *)&stretch, &message);
  FUZZ_EXPECT(status == TP_OK || message.text[0] != '\0');
  FUZZ_EXPECT(tp_tally_init(&w.tally, study, 0, study->samples, &message) == TP_OK);
  tp_text rows = {0};
  tp_text_append(&rows, text.data + header, size);
  message.text[0] = '\0';
  status = TP_OK;
  if (size > 0) status = tp_rows_parse(&stretch, 0, &rows, study->samples, take, &w, &message);
  FUZZ_EXPECT(status == TP_OK || message.text[0] != '\0');
  read_again(&w);
  tp_tally_clear(&w.tally);
  tp_text_drop(&w.first);
  tp_text_drop(&rows);
  tp_text_drop(&text);
}

static void read_progress(const tp_study *study, const uint8_t *data, size_t size) {
  char path[200];
  tp_progress progress = {0};
  tp_message message = {.text = ""};
  bool there = false;
  fuzz_study_write("rows.csv.progress", (const char *)data, size);
  const tp_status status =
      tp_progress_read(&progress, &there, fuzz_study_path(path, "rows.csv"), study, &message);
  FUZZ_EXPECT(there);
  FUZZ_EXPECT(status == TP_OK ? progress.shard >= 1 && progress.shard <= progress.shards
                              : message.text[0] != '\0');
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  if (size == 0) return -1;
  (data[0] % 2 == 0 ? read_rows : read_progress)(the_study(), data + 1, size - 1);
  return 0;
}
