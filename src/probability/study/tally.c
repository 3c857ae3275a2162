/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Counters of outcomes by tilt, columns of the first samples, bad samples and shares at powers of
 * two, with the test for a certain enough result. */

#include "study/tally.h"

#include "common/grow.h"
#include "statistics/proportion.h"
#include "study/row_csv.h"
#include "study/sample_filter.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { FIRST_STEP = 16 };

tp_status tp_tally_init(tp_tally *tally, const tp_study *study, tp_message *message) {
  const size_t tilts = study->tilt_count + 1;
  *tally =
      (tp_tally){.study = study, .column_count = tp_tally_measures(study) + study->measure_count};
  tally->tilts = calloc(tilts, sizeof *tally->tilts);
  tally->columns = calloc(tally->column_count, sizeof *tally->columns);
  tally->bad = calloc(TP_STUDY_BAD, sizeof *tally->bad);
  tally->scratch = calloc(tilts, sizeof *tally->scratch);
  if (tally->tilts != NULL && tally->columns != NULL && tally->bad != NULL &&
      tally->scratch != NULL) {
    return TP_OK;
  }
  tp_tally_clear(tally);
  return tp_fail_memory(message, "the summary of a study");
}

void tp_tally_clear(tp_tally *tally) {
  for (size_t k = 0; tally->columns != NULL && k < tally->column_count; k++) {
    free(tally->columns[k]);
  }
  for (size_t k = 0; tally->bad != NULL && k < tally->bad_count; k++) {
    free(tally->bad[k].settings);
    free(tally->bad[k].why);
  }
  free(tally->columns);
  free(tally->bad);
  free(tally->tilts);
  free(tally->scratch);
  free(tally->steps);
  *tally = (tp_tally){.study = tally->study};
}

/* ---- shares ------------------------------------------------------------------------------------
 */

tp_study_share tp_tally_share(size_t count, uint64_t samples) {
  const tp_estimate own = tp_proportion(count, samples, 0.95);
  return (tp_study_share){count, own.value, own.low, own.high};
}

size_t tp_tally_stands(const tp_outcome_counts *counts) {
  return counts->of[TP_STUDY_STANDS] + counts->of[TP_STUDY_INTERLOCKED];
}

size_t tp_tally_moves(const tp_outcome_counts *counts) {
  return counts->of[TP_STUDY_SLIDES] + counts->of[TP_STUDY_TOPPLES] +
         counts->of[TP_STUDY_SLIDES_AND_TOPPLES] + counts->of[TP_STUDY_LEAVES_BASE];
}

static bool is_narrow(const tp_tally *tally, size_t count) {
  const tp_study_share share = tp_tally_share(count, tally->samples);
  return share.high - share.low <= 2 * tally->study->half_width;
}

bool tp_tally_is_certain(const tp_tally *tally) {
  if (!(tally->study->half_width > 0) || tally->samples == 0) return false;
  for (size_t k = 0; k <= tally->study->tilt_count; k++) {
    const tp_outcome_counts *counts = tally->tilts + k;
    for (int j = 0; j < TP_STUDY_OUTCOMES; j++) {
      if (!is_narrow(tally, counts->of[j])) return false;
    }
    if (!is_narrow(tally, tp_tally_stands(counts)) || !is_narrow(tally, tp_tally_moves(counts))) {
      return false;
    }
  }
  return true;
}

/* ---- rows --------------------------------------------------------------------------------------
 */

/* Room for one more of each column. */
static bool make_room(tp_tally *tally) {
  long room = tally->room;
  if (tally->kept < tally->room) return true;
  for (size_t k = 0; k < tally->column_count; k++) {
    room = tally->room;
    double *grown = tp_grow(tally->columns[k], tally->kept, &room, sizeof *grown);
    if (grown == NULL) return false;
    tally->columns[k] = grown;
  }
  tally->room = room;
  return true;
}

static bool keep(tp_tally *tally, const tp_study_row *row) {
  if (tally->kept == TP_STUDY_KEPT) return true;
  if (!make_room(tally)) return false;
  double **column = tally->columns;
  const long at = tally->kept++;
  for (size_t k = 0; k < tally->study->variable_count; k++) (*column++)[at] = row->values[k];
  for (size_t k = 0; k < TP_STUDY_QUANTITIES; k++) (*column++)[at] = row->quantities[k];
  for (size_t k = 0; k <= tally->study->tilt_count; k++) (*column++)[at] = row->at[k].outcome;
  (*column++)[at] = row->fos_definition < 0 ? (double)NAN : (double)row->fos_definition;
  (*column++)[at] = row->fos_moments;
  (*column++)[at] = row->fos_sliding;
  for (size_t k = 0; k < tally->study->measure_count; k++) (*column++)[at] = row->measures[k];
  return true;
}

static bool note_bad(tp_tally *tally, const tp_study_row *row) {
  if (row->at[0].outcome != TP_STUDY_INVALID || tally->bad_count == TP_STUDY_BAD) return true;
  tp_study_bad *bad = tally->bad + tally->bad_count;
  tp_text settings = {0};
  tp_study_write_settings(&settings, tally->study, row->values);
  *bad = (tp_study_bad){.sample = row->sample, .why = strdup(row->why)};
  if (tp_text_finish(&settings, &bad->settings) != TP_OK) bad->settings = NULL;
  tally->bad_count++;
  return bad->settings != NULL && bad->why != NULL;
}

static bool is_power_of_two(uint64_t n) {
  return (n & (n - 1)) == 0;
}

/* The share so far, unless it is there already. */
static bool note_step(tp_tally *tally) {
  if (tally->step_count > 0 && tally->steps[tally->step_count - 1].of_samples == tally->samples) {
    return true;
  }
  tp_study_step *grown = tp_grow(tally->steps, tally->step_count, &tally->step_room, sizeof *grown);
  if (grown == NULL) return false;
  tally->steps = grown;
  grown[tally->step_count++] =
      (tp_study_step){tally->samples, tp_tally_share(tp_tally_moves(tally->tilts), tally->samples)};
  return true;
}

bool tp_tally_end_steps(tp_tally *tally) {
  return tally->samples == 0 || note_step(tally);
}

static void count_factor(tp_tally *tally, const tp_study_row *row) {
  const int definition = row->fos_definition;
  if (definition < 0) return;
  tally->definitions[definition]++;
  tally->below[definition] += row->quantities[TP_STUDY_FOS] < 1;
}

/* Of a row that was read, what tells it is found again: it is a matter of its numbers alone. */
static void count_teller(tp_tally *tally, const tp_study_row *row) {
  tp_study_row again = {.values = row->values, .at = tally->scratch};
  const bool unknown = row->told_by == TP_TOLD_UNKNOWN;
  const bool by_doubles =
      unknown ? tp_sample_filter_tell(&again, tally->study, tally->study->tilt_count)
              : row->told_by == TP_TOLD_BY_DOUBLES;
  tally->by_doubles += by_doubles;
  if (unknown) return;
  *(by_doubles ? &tally->doubles_seconds : &tally->ladder_seconds) += row->seconds;
}

tp_status tp_tally_add(tp_tally *tally, const tp_study_row *row, tp_message *message) {
  tally->samples++;
  tally->open += row->open;
  for (size_t k = 0; k <= tally->study->tilt_count; k++) tally->tilts[k].of[row->at[k].outcome]++;
  count_factor(tally, row);
  count_teller(tally, row);
  const bool step = tally->samples >= FIRST_STEP && is_power_of_two(tally->samples);
  const bool taken = keep(tally, row) && note_bad(tally, row) && (!step || note_step(tally));
  return taken ? TP_OK : tp_fail_memory(message, "the summary of a study");
}
