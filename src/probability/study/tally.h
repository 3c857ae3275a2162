/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a summary takes of the rows, one after another in their order: counts of outcomes at each
 * tilt, of all rows; the columns of the first TP_STUDY_KEPT, 8 bytes for each number. Memory does
 * not grow with the samples beyond. */

#ifndef TP_STUDY_TALLY_H
#define TP_STUDY_TALLY_H

#include "study/row.h"

/* Counts of outcomes. */
typedef struct tp_outcome_counts {
  size_t of[TP_STUDY_OUTCOMES];
} tp_outcome_counts;

typedef struct tp_tally {
  const tp_study *study;
  uint64_t samples;
  size_t open, by_doubles;
  double doubles_seconds, ladder_seconds; /* of those solved here */
  tp_study_at *scratch;                   /* of a row that is told again */
  tp_outcome_counts *tilts;               /* the scene's, and those of the study */
  size_t definitions[TP_FOS_DEFINITIONS],
      below[TP_FOS_DEFINITIONS]; /* factors by each, and below 1 */
  size_t column_count;
  long kept, room;
  double **columns; /* the variables, the quantities, outcomes at each tilt, the definition, the
                       factors by moments and of sliding, what is measured */
  long step_count, step_room;
  tp_study_step *steps;
  size_t bad_count;
  tp_study_bad *bad;
} tp_tally;

enum { TP_STUDY_BAD = 5 };

TP_MUST_USE tp_status tp_tally_init(tp_tally *tally, const tp_study *study, tp_message *message);
void tp_tally_clear(tp_tally *tally);

TP_MUST_USE tp_status tp_tally_add(tp_tally *tally, const tp_study_row *row, tp_message *message);

/* Wilson's interval of 95 %, and those of what becomes of samples. */
tp_study_share tp_tally_share(size_t count, uint64_t samples);
size_t tp_tally_stands(const tp_outcome_counts *counts);
size_t tp_tally_moves(const tp_outcome_counts *counts);

/* Is every interval, of every outcome at every tilt, as narrow as the study wants it? */
bool tp_tally_is_certain(const tp_tally *tally);

/* The convergence ends with the last sample. False when memory is exhausted. */
TP_MUST_USE bool tp_tally_end_steps(tp_tally *tally);

/* Where the columns of a tally are. */
static inline size_t tp_tally_definitions(const tp_study *study) {
  return study->variable_count + TP_STUDY_QUANTITIES + study->tilt_count + 1;
}
static inline size_t tp_tally_factors(const tp_study *study) {
  return tp_tally_definitions(study) + 1;
}
static inline size_t tp_tally_measures(const tp_study *study) {
  return tp_tally_factors(study) + 2;
}

/* All of it as a result; what is the caller's to know (planned samples, shard, end) is left as it
 * is. The columns, steps and bad samples go over to the result. */
TP_MUST_USE tp_status tp_tally_finish(tp_study_result *result, tp_tally *tally,
                                      tp_message *message);

#endif
