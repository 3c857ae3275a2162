/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* How far a file of rows is: a small file beside it, replaced as a whole after each chunk, so that
 * a run killed at any moment goes on from the last chunk that it tells of. What the rows hold
 * beyond is cut off. */

#ifndef TP_STUDY_PROGRESS_H
#define TP_STUDY_PROGRESS_H

#include "output/sha256.h"
#include "study/study.h"

typedef struct tp_progress {
  size_t shard, shards;
  uint64_t chunks;              /* that are whole, from the first of the shard on */
  uint64_t bytes;               /* of the rows with them, */
  uint8_t hash[TP_SHA256_SIZE]; /* and their SHA-256 */
} tp_progress;

/* The file's name, to be freed; NULL when memory is exhausted. */
char *tp_progress_path(const char *rows);

/* `*there`: is there one? Bad input where it is of another study, of files that have changed, or of
 * another version of the program. */
TP_MUST_USE tp_status tp_progress_read(tp_progress *progress, bool *there, const char *rows,
                                       const tp_study *study, tp_message *message);
/* May it be written over? Only a file that tells of some study's rows may, and no link: nobody
 * named this file. */
TP_MUST_USE tp_status tp_progress_check(const char *rows, tp_message *message);
TP_MUST_USE tp_status tp_progress_write(const tp_progress *progress, const char *rows,
                                        const tp_study *study, tp_message *message);

#endif
