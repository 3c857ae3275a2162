/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a summary takes of the rows: what is counted of all; the columns of the first TP_STUDY_KEPT,
 * 8 bytes for each number; which samples are invalid, of the first TP_STUDY_BAD. Memory does not
 * grow with the samples beyond. */

#ifndef TP_STUDY_TALLY_H
#define TP_STUDY_TALLY_H

#include "study/outcome.h"
#include "study/row_counts.h"

enum { TP_STUDY_BAD = 5 };

/* Samples that are invalid, each its number and 1: so many of them add up like counts, with 0
 * in the places of those that another rank knows. */
typedef struct tp_invalid {
  uint64_t places[TP_STUDY_BAD];
} tp_invalid;

typedef struct tp_tally {
  const tp_study *study;
  uint64_t first; /* the sample with which the study, or a shard of it, begins */
  tp_row_counts counts;
  tp_invalid invalid;
  size_t column_count, room;
  double **columns; /* the variables, the quantities, outcomes at each tilt, the definition, the
                       factors by moments and of sliding, what is measured */
} tp_tally;

/* Of the samples from `first` to before `past`. */
TP_MUST_USE tp_status tp_tally_init(tp_tally *tally, const tp_study *study, uint64_t first,
                                    uint64_t past, tp_message *message);
void tp_tally_clear(tp_tally *tally);

/* How many rows the columns have, of all that are counted. */
size_t tp_tally_kept(const tp_tally *tally);

/* The numbers of a row into the columns, where it is one of those. */
void tp_tally_keep(tp_tally *tally, const tp_study_row *row);

/* The text of an invalid sample is found again by solving it: this is the sample that comes after
 * so many invalid ones. */
void tp_tally_note_invalid(tp_invalid *invalid, uint64_t before, uint64_t sample);

/* A row that was read, which is counted, kept and noted; what told it is found again, a matter of
 * its numbers alone. */
void tp_tally_read(tp_tally *tally, tp_study_row *row, tp_study_at *scratch);

/* Where the columns of a tally are. */
static inline size_t tp_tally_definitions(const tp_study *study) {
  return study->variable_count + tp_study_quantity_count(study) + study->tilt_count + 1;
}
static inline size_t tp_tally_factors(const tp_study *study) {
  return tp_tally_definitions(study) + 1;
}
static inline size_t tp_tally_measures(const tp_study *study) {
  return tp_tally_factors(study) + 2;
}

/* All of it as a result; what is the caller's to know (planned samples, shard, end) is left as it
 * is. The columns go over to the result. */
TP_MUST_USE tp_status tp_tally_finish(tp_study_result *result, tp_tally *tally,
                                      tp_message *message);

#endif
