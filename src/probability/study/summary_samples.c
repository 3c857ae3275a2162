/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The convergence from counts by octaves; invalid samples drawn and solved once more for the reason
 * that they have. */

#include "study/summary_samples.h"

#include "study/row_csv.h"
#include "study/sample.h"

#include <stdlib.h>

bool tp_summary_convergence(tp_study_result *result, const tp_tally *tally) {
  enum { FIRST_STEP = 4 };
  const tp_row_counts *counts = &tally->counts;
  const uint64_t *moved = tally->first == 0 ? counts->moved : counts->moved_of_shard;
  const uint64_t samples = counts->samples;
  uint64_t count = 0;
  result->convergence = calloc(TP_STUDY_OCTAVES + 1, sizeof *result->convergence);
  if (result->convergence == NULL) return false;
  for (int k = 0; k < TP_STUDY_OCTAVES && UINT64_C(1) << k <= samples; k++) {
    const uint64_t first = UINT64_C(1) << k;
    count += moved[k];
    if (k < FIRST_STEP || first == samples) continue;
    result->convergence[result->convergence_count++] =
        (tp_study_step){first, tp_row_counts_share(count, first)};
  }
  if (samples == 0) return true;
  result->convergence[result->convergence_count++] =
      (tp_study_step){samples, tp_row_counts_share(tp_row_counts_moves(counts, 0), samples)};
  return true;
}

/* The sample once more: its numbers, and why they make no scene. */
static tp_status explain(tp_study_bad *bad, const tp_study *study, uint64_t sample,
                         tp_message *message) {
  tp_text settings = {0};
  tp_study_row row = {.values = calloc(study->variable_count, sizeof *row.values),
                      .at = calloc(study->tilt_count + 1, sizeof *row.at)};
  tp_status status = row.values != NULL && row.at != NULL
                         ? tp_study_draw(row.values, study, sample, 1, message)
                         : tp_fail_memory(message, "the summary of a study");
  if (status == TP_OK) status = tp_study_solve(&row, study, 0, message);
  if (status == TP_OK) {
    tp_study_write_settings(&settings, study, row.values);
    *bad = (tp_study_bad){.sample = sample, .why = row.why};
    row.why = NULL;
    if (tp_text_finish(&settings, &bad->settings) != TP_OK || bad->why == NULL) {
      status = tp_fail_memory(message, "the summary of a study");
    }
  }
  free(row.why);
  free(row.values);
  free(row.at);
  return status;
}

tp_status tp_summary_invalid(tp_study_result *result, const tp_tally *tally, tp_message *message) {
  const uint64_t *places = tally->invalid.places;
  tp_status status = TP_OK;
  result->invalid = calloc(TP_STUDY_BAD, sizeof *result->invalid);
  if (result->invalid == NULL) return tp_fail_memory(message, "the summary of a study");
  for (size_t k = 0; k < TP_STUDY_BAD && places[k] > 0 && status == TP_OK; k++) {
    result->invalid_count++;
    status = explain(result->invalid + k, tally->study, places[k] - 1, message);
  }
  return status;
}
