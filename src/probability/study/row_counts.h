/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What is counted of a stretch of rows, in whole numbers alone: those of two stretches add up to
 * that of both, in any order and to the last bit. So the summary of a study is the same however its
 * rows were shared out to threads, ranks and shards, or read back.
 *
 * The rows themselves are known by `hash`: of their header, as piece 0, and of the text of each
 * chunk c, as piece c + 1, the SHA-256 of the piece's number (8 bytes, the lowest first) and its
 * text, as four numbers (likewise), added modulo 2^64 each. A piece that is changed, lost or moved
 * to another place makes another sum. */

#ifndef TP_STUDY_ROW_COUNTS_H
#define TP_STUDY_ROW_COUNTS_H

#include "study/row.h"

/* Sample s is in octave 0 where s is 0, else in that of its highest bit: the first 2^k samples are
 * those of octaves 0 to k. */
enum { TP_STUDY_OCTAVES = 41, TP_ROWS_HASH = 4 };

typedef struct tp_row_counts {
  uint64_t samples, open, by_doubles;
  uint64_t bytes, hash[TP_ROWS_HASH];        /* of the text of the rows */
  uint64_t definitions[TP_FOS_DEFINITIONS];  /* factors by each definition, */
  uint64_t below[TP_FOS_DEFINITIONS];        /* and below 1 */
  uint64_t below_required, meets_required;   /* certainly, of many blocks and of solids */
  uint64_t moved[TP_STUDY_OCTAVES];          /* certain to move at the first tilt, by octave, */
  uint64_t moved_of_shard[TP_STUDY_OCTAVES]; /* and by that of a shard that begins with 0 */
  uint64_t doubles_nanoseconds;              /* of computing, of what was solved here: */
  uint64_t ladder_nanoseconds;               /* from here on not kept with the rows */
  uint64_t outcomes[TP_STUDY_TILTS + 1][TP_STUDY_OUTCOMES]; /* at the scene's tilt, and others */
} tp_row_counts;

/* It is so many numbers one after another, of which a study without all tilts has the first. */
size_t tp_row_counts_numbers(const tp_study *study);

/* All 0; the sum of both into `own`. */
void tp_row_counts_begin(tp_row_counts *own, const tp_study *study);
void tp_row_counts_add(tp_row_counts *own, const tp_row_counts *other, const tp_study *study);

/* A row more, of a shard that begins with the sample `first`; and the text of a piece. */
void tp_row_counts_row(tp_row_counts *own, const tp_study *study, const tp_study_row *row,
                       uint64_t first);
void tp_row_counts_text(tp_row_counts *own, uint64_t piece, const char *text, size_t length);

/* Have both the same text? */
bool tp_row_counts_same_text(const tp_row_counts *own, const tp_row_counts *other);

/* Wilson's interval of 95 %, and those of what becomes of samples at a tilt. */
tp_study_share tp_row_counts_share(uint64_t count, uint64_t samples);
uint64_t tp_row_counts_stands(const tp_row_counts *own, size_t tilt);
uint64_t tp_row_counts_moves(const tp_row_counts *own, size_t tilt);

/* Valid samples of which neither is certain; and neither that they have the factor required nor
 * that they lack it. */
uint64_t tp_row_counts_open(const tp_row_counts *own, size_t tilt);
uint64_t tp_row_counts_open_required(const tp_row_counts *own);

/* Is every interval, of every outcome at every tilt, as narrow as the study wants it? */
bool tp_row_counts_is_certain(const tp_row_counts *own, const tp_study *study);

#endif
