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
  bool regular; /* not a pipe or a device, which cannot be gone on with */
  tp_progress progress;
  tp_sha256_state hash; /* of the bytes that the progress tells of */
} tp_rows;

/* Open the file for the shard: where `restart`, or there is none, with the header alone; else to be
 * gone on with, once tp_rows_go_on has read what its progress tells of. A file that is there and is
 * no such file is bad input, and so is one that the study reads. */
TP_MUST_USE tp_status tp_rows_open(tp_rows *rows, const tp_study *study,
                                   const tp_study_options *options, tp_message *message);
/* Add the text of one chunk. */
TP_MUST_USE tp_status tp_rows_add(tp_rows *rows, const tp_text *text, tp_message *message);
void tp_rows_close(tp_rows *rows);

/* A row as it was read, and its line. Anything but TP_OK ends the reading; `*enough` does, too. */
typedef tp_status tp_rows_take(void *context, tp_study_row *row, bool *enough, tp_message *message);

/* All rows of a file, as far as its progress tells; bad input where these bytes are not those that
 * were written, by their hash, which it leaves to be gone on with. */
TP_MUST_USE tp_status tp_rows_read(tp_sha256_state *hash, const char *path, const tp_study *study,
                                   const tp_progress *progress, tp_rows_take *take, void *context,
                                   tp_message *message);

/* The same of a file that was opened, after which rows can be added: what lies beyond its last
 * whole chunk is cut off. */
TP_MUST_USE tp_status tp_rows_go_on(tp_rows *rows, tp_rows_take *take, void *context,
                                    tp_message *message);

#endif
