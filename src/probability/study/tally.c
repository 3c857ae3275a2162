/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Columns of the first samples, each at the place of its number; the first invalid ones; rows that
 * are read back. */

#include "study/tally.h"

#include "study/sample_filter.h"

#include <math.h>
#include <stdlib.h>

tp_status tp_tally_init(tp_tally *tally, const tp_study *study, uint64_t first, uint64_t past,
                        tp_message *message) {
  const uint64_t samples = past > first ? past - first : 0;
  *tally = (tp_tally){.study = study,
                      .first = first,
                      .room = samples < TP_STUDY_KEPT ? (size_t)samples : TP_STUDY_KEPT,
                      .column_count = tp_tally_measures(study) + study->measure_count};
  tally->columns = calloc(tally->column_count, sizeof *tally->columns);
  bool made = tally->columns != NULL;
  for (size_t k = 0; k < tally->column_count && made; k++) {
    tally->columns[k] = calloc(tally->room + 1, sizeof *tally->columns[k]);
    made = tally->columns[k] != NULL;
  }
  if (made) return TP_OK;
  tp_tally_clear(tally);
  return tp_fail_memory(message, "the summary of a study");
}

void tp_tally_clear(tp_tally *tally) {
  for (size_t k = 0; tally->columns != NULL && k < tally->column_count; k++) {
    free(tally->columns[k]);
  }
  free(tally->columns);
  tally->columns = NULL;
}

size_t tp_tally_kept(const tp_tally *tally) {
  return tally->counts.samples < tally->room ? (size_t)tally->counts.samples : tally->room;
}

void tp_tally_keep(tp_tally *tally, const tp_study_row *row) {
  const uint64_t at = row->sample - tally->first;
  const size_t quantities = tp_study_quantity_count(tally->study);
  double **column = tally->columns;
  if (at >= tally->room) return;
  for (size_t k = 0; k < tally->study->variable_count; k++) (*column++)[at] = row->values[k];
  for (size_t k = 0; k < quantities; k++) (*column++)[at] = row->quantities[k];
  for (size_t k = 0; k <= tally->study->tilt_count; k++) (*column++)[at] = row->at[k].outcome;
  (*column++)[at] = row->fos_definition < 0 ? (double)NAN : (double)row->fos_definition;
  (*column++)[at] = row->fos_moments;
  (*column++)[at] = row->fos_sliding;
  for (size_t k = 0; k < tally->study->measure_count; k++) (*column++)[at] = row->measures[k];
}

void tp_tally_note_invalid(tp_invalid *invalid, uint64_t before, uint64_t sample) {
  if (before < TP_STUDY_BAD) invalid->places[before] = sample + 1;
}

void tp_tally_read(tp_tally *tally, tp_study_row *row, tp_study_at *scratch) {
  const tp_study *study = tally->study;
  tp_study_row again = {.values = row->values, .at = scratch};
  const bool by_doubles = tp_sample_filter_tell(&again, study, study->tilt_count);
  row->told_by = by_doubles ? TP_TOLD_BY_DOUBLES : TP_TOLD_BY_LADDER;
  row->seconds = 0;
  if (row->at[0].outcome == TP_STUDY_INVALID) {
    tp_tally_note_invalid(&tally->invalid, tally->counts.outcomes[0][TP_STUDY_INVALID],
                          row->sample);
  }
  tp_row_counts_row(&tally->counts, study, row, tally->first);
  tp_tally_keep(tally, row);
}
