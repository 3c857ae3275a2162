/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Study files: read, drawn from, run for a few samples, gone on with, reported. The folder has a
 * scene, slab.yaml, and a table of numbers, table.csv; no other folder is read. */

#include "fuzz.h"
#include "study/study.h"
#include "study_folder.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_ASKED = 12, DRAWN = 3 };

static void check_share(tp_study_share share) {
  FUZZ_EXPECT(share.low <= share.share && share.share <= share.high);
  FUZZ_EXPECT(share.low >= 0 && share.high <= 1);
}

static void check(const tp_study_result *result) {
  for (size_t k = 0; k < result->tilt_count && result->samples > 0; k++) {
    size_t counted = 0;
    for (int j = 0; j < TP_STUDY_OUTCOMES; j++) {
      counted += result->tilts[k].outcomes[j].samples;
      check_share(result->tilts[k].outcomes[j]);
    }
    FUZZ_EXPECT(counted == result->samples);
    check_share(result->tilts[k].certain_to_stand);
    check_share(result->tilts[k].certain_to_move);
  }
  char *text = NULL;
  FUZZ_EXPECT(tp_report_study(&text, result) == TP_OK);
  free(text);
  FUZZ_EXPECT(tp_report_study_json(&text, result) == TP_OK);
  fuzz_judge_json(text);
  free(text);
}

/* Any samples, far from the first too: numbers, at worst infinite. */
static void draw(const tp_study *study) {
  const uint64_t last = study->samples > DRAWN ? study->samples - DRAWN : 0;
  const size_t count = study->samples < DRAWN ? (size_t)study->samples : DRAWN;
  double *values = calloc(DRAWN * study->variable_count, sizeof *values);
  tp_message message = {.text = ""};
  FUZZ_EXPECT(values != NULL);
  for (int part = 0; part <= 2; part++) {
    FUZZ_EXPECT(tp_study_draw(values, study, last / 2 * (uint64_t)part, count, &message) == TP_OK);
    for (size_t k = 0; k < count * study->variable_count; k++) FUZZ_EXPECT(!isnan(values[k]));
  }
  free(values);
}

static bool is_enough(void *context) {
  int *asked = context;
  return ++*asked > MOST_ASKED;
}

/* The number of samples, 0 where it is refused. */
static size_t run(const tp_study *study, bool restart) {
  char path[200];
  int asked = 0;
  tp_study_result *result = NULL;
  tp_message message = {.text = ""};
  tp_study_options options = tp_study_options_default();
  options.rows = fuzz_study_path(path, "rows.csv");
  options.restart = restart;
  options.threads = 1;
  options.context = &asked;
  options.stop = is_enough;
  const tp_status status = tp_study_run(&result, study, &options, &message);
  fuzz_judge(status, result, &message);
  const size_t samples = result != NULL ? result->samples : 0;
  if (result != NULL) check(result);
  tp_study_result_free(result);
  return samples;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  if (memchr(data, '/', size) != NULL) return -1;
  char path[200];
  tp_study *study = NULL;
  tp_message message = {.text = ""};
  fuzz_study_write("study.yaml", (const char *)data, size);
  const tp_status status = tp_study_read(&study, fuzz_study_path(path, "study.yaml"), &message);
  fuzz_judge(status, study, &message);
  /* of a chunk that is stopped nothing is kept */
  if (status == TP_OK && study->chunk > DRAWN) study->chunk = DRAWN;
  if (status == TP_OK) {
    draw(study);
    const size_t first = run(study, true);
    FUZZ_EXPECT(run(study, false) >= first);
  }
  tp_study_free(study);
  return 0;
}
