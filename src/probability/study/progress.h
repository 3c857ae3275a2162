/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* How far a file of rows is: a small file beside it, replaced as a whole after each chunk, so that
 * a run killed at any moment goes on from the last chunk that it tells of. What the rows hold
 * beyond is cut off. It has what is counted of the rows, so that they are read again to see that
 * they are those, but not solved, nor counted. */

#ifndef TP_STUDY_PROGRESS_H
#define TP_STUDY_PROGRESS_H

#include "study/tally.h"

typedef struct tp_progress {
  size_t shard, shards;
  uint64_t chunks;      /* that are whole, from the first of the shard on */
  tp_row_counts counts; /* of the rows in them, and of the text of all, with the header */
  tp_invalid invalid;   /* the first of them */
} tp_progress;

/* The file's name, to be freed; NULL when memory is exhausted. */
char *tp_progress_path(const char *rows);

/* `*there`: is there one? Bad input where it is of another study, of files that have changed, or of
 * another version of the program. */
TP_MUST_USE tp_status tp_progress_read(tp_progress *progress, bool *there, const char *rows,
                                       const tp_study *study, tp_message *message);
/* Is there one? False, too, when memory is exhausted. */
bool tp_progress_is_there(const char *rows);
/* May it be written over? Only a file that tells of some study's rows may, and no link: nobody
 * named this file. */
TP_MUST_USE tp_status tp_progress_check(const char *rows, tp_message *message);
TP_MUST_USE tp_status tp_progress_write(const tp_progress *progress, const char *rows,
                                        const tp_study *study, tp_message *message);

#endif
