/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The file of rows of a study: begun, gone on with, read back. */

#ifndef TP_STUDY_ROWS_H
#define TP_STUDY_ROWS_H

#include "output/text.h"
#include "study/progress.h"
#include "study/row.h"

typedef struct tp_rows {
  const tp_study *study;
  const char *path; /* NULL: there are none, and all calls do nothing */
  int descriptor;
  bool regular; /* not a pipe or a device, which takes one chunk after another, of one process */
  tp_progress progress;
} tp_rows;

/* Open the file for the shard: where `restart`, or there is none, with the header alone; else to be
 * gone on with, once what its progress tells of was read. A file that is there and is no such file
 * is bad input, and so is one that the study reads. */
TP_MUST_USE tp_status tp_rows_open(tp_rows *rows, const tp_study *study,
                                   const tp_study_options *options, tp_message *message);
/* The same file by another process, after the first has opened it and found whether it is regular:
 * otherwise the first alone writes. */
TP_MUST_USE tp_status tp_rows_join(tp_rows *rows, const tp_study *study,
                                   const tp_study_options *options, bool regular,
                                   tp_message *message);

/* So many bytes at their place. Several processes may do so at once, each at its own; of what is no
 * regular file the next bytes. */
TP_MUST_USE tp_status tp_rows_put(const tp_rows *rows, const tp_text *text, uint64_t at,
                                  tp_message *message);
/* Tell of the progress, once all of it is in the file. */
TP_MUST_USE tp_status tp_rows_record(const tp_rows *rows, tp_message *message);
/* Cut off what lies beyond the progress. */
TP_MUST_USE tp_status tp_rows_cut(const tp_rows *rows, tp_message *message);
void tp_rows_close(tp_rows *rows);

/* ---- read back ---------------------------------------------------------------------------------
 */

/* Rows of a file as far as its progress tells: those of chunks of the study from `first` to before
 * `past`, and with the first one the header. */
typedef struct tp_rows_stretch {
  const char *path;
  const tp_study *study;
  const tp_progress *progress;
  uint64_t first, past;
} tp_rows_stretch;

/* The text of a chunk, which may be changed. Anything but TP_OK ends the reading. */
typedef tp_status tp_rows_take_chunk(void *context, uint64_t chunk, tp_text *text,
                                     tp_message *message);

/* Each chunk of the stretch; what is counted of their text is added to `seen`. Where a stretch
 * begins is found by halving the file, so that it takes no longer the further on it is. */
TP_MUST_USE tp_status tp_rows_read(tp_row_counts *seen, const tp_rows_stretch *stretch,
                                   tp_rows_take_chunk *take, void *context, tp_message *message);

/* Bad input where the text that was seen is not all that was written. */
TP_MUST_USE tp_status tp_rows_check(const tp_row_counts *seen, const tp_rows_stretch *stretch,
                                    tp_message *message);

/* A row as it was read. */
typedef tp_status tp_rows_take(void *context, tp_study_row *row, tp_message *message);

/* Each row of the text of a chunk, which is changed; `most` at most. */
TP_MUST_USE tp_status tp_rows_parse(const tp_rows_stretch *stretch, uint64_t chunk, tp_text *text,
                                    uint64_t most, tp_rows_take *take, void *context,
                                    tp_message *message);

#endif
