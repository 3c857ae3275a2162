/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A study in rounds. In each, rank r of R computes as many chunks as every other, those after the
 * ones of rank r - 1; then the sums over the ranks before it tell where its text belongs in the
 * file of rows, and those over all what is known of the study so far. Each writes its own text at
 * its place, and the first the progress. So nothing is parsed, copied or sent that grows with the
 * samples, a run can go on by any number of ranks from what any other left, and a study that ends
 * where it is certain ends for all of them after the round in which it is.
 *
 * A rank adds some hundred whole numbers a round, of a quarter of a second, for each of two sums;
 * at the end it sends to the first the columns of those of the first TP_STUDY_KEPT samples that it
 * has. One process makes rounds of one chunk. */

#ifndef TP_STUDY_ROUNDS_H
#define TP_STUDY_ROUNDS_H

#include "study/block.h"
#include "study/rows.h"
#include "study/together.h"

/* Samples of which a rank has the columns. */
typedef struct tp_rows_span {
  uint64_t first, count;
} tp_rows_span;

typedef struct tp_rounds {
  const tp_study *study;
  const tp_study_options *options;
  tp_rows rows;
  tp_tally tally; /* of all ranks, but for the columns */
  tp_block block;
  uint64_t next, past; /* chunks of the study that are to come */
  size_t size;         /* chunks of a rank in a round, most */
  tp_rows_span *spans;
  long span_count, span_room;
  tp_status recorded;   /* how the progress of the last round was told: said in the next one */
  tp_message complaint; /* of that */
  bool over;            /* a rank failed: the first has the status, and nothing more is said */
} tp_rounds;

/* Note that this rank has the columns of a chunk. */
TP_MUST_USE tp_status tp_rounds_note_span(tp_rounds *r, uint64_t chunk, tp_message *message);

/* Open the rows by all ranks, and read what is there: each its part. */
TP_MUST_USE tp_status tp_rounds_go_on(tp_rounds *r, tp_message *message);

/* A round: `*ended` where it was the last, since the study is certain, or was stopped. */
TP_MUST_USE tp_status tp_rounds_next(tp_rounds *r, bool *ended, tp_message *message);

/* After the last: the columns of all ranks into those of the first. */
TP_MUST_USE tp_status tp_rounds_gather(tp_rounds *r, tp_message *message);

#endif
