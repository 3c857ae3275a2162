/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Chunks of a study that one rank computes in one go: each drawn, its samples shared out to
 * threads, every one filling its own row; then text, counts and columns of the rows in their
 * order. So what a chunk comes to does not depend on who computes it. */

#ifndef TP_STUDY_BLOCK_H
#define TP_STUDY_BLOCK_H

#include "output/text.h"
#include "study/tally.h"

#include <stdatomic.h>

/* Chunks in a block. */
enum { TP_BLOCK_CHUNKS = 64 };

typedef struct tp_block {
  const tp_study *study;
  const tp_study_options *options;
  tp_tally *tally;    /* whose columns it fills */
  tp_study_row *rows; /* room for a chunk */
  double *values;
  tp_study_at *at;
  atomic_bool stopped; /* options.stop said so: the chunk in which it did is not in the block */
  double began; /* the run, by the clock, and how many samples this rank has to solve in it */
  uint64_t planned;
  atomic_size_t solved; /* of them, until options.forecast was called */
  atomic_bool foretold; /* it was */
  size_t count;         /* chunks in it, each with its counts, and where its text ends */
  tp_row_counts *chunk_counts;
  size_t ends[TP_BLOCK_CHUNKS];
  tp_text text;
  uint64_t invalid[TP_STUDY_BAD]; /* the first invalid samples in it */
  size_t invalid_count;
} tp_block;

/* To be cleared on failure, too. `chunks`: most that it will have. */
TP_MUST_USE tp_status tp_block_init(tp_block *block, const tp_study *study,
                                    const tp_study_options *options, tp_tally *tally, size_t chunks,
                                    tp_message *message);
void tp_block_clear(tp_block *block);

/* Empty, and with a chunk more. */
void tp_block_begin(tp_block *block);
TP_MUST_USE tp_status tp_block_compute(tp_block *block, uint64_t chunk, tp_message *message);

/* The counts of its first chunks, and it with no more than these. */
void tp_block_counts(tp_row_counts *counts, const tp_block *block, size_t count);
void tp_block_cut(tp_block *block, size_t count, uint64_t past_sample);

#endif
