/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What the calls on studies say: run whole and in shards, merged, and stopped before it begins. */

#include "sayings.h"

#include <stdio.h>
#include <stdlib.h>

#define SAY(call) note_status(s, call, &message)

static void say_charts(sayings *s, const tp_study_result *result) {
  tp_message message = {.text = ""};
  tp_chart *charts[2] = {NULL, NULL};
  SAY(tp_chart_study(charts, result, &message));
  SAY(tp_chart_study_scatter(charts + 1, result, &message));
  for (int k = 0; k < 2; k++) {
    if (charts[k] == NULL) continue;
    if (tp_report_chart_csv(next_saying(s), charts[k]) != TP_OK) s->count--;
    tp_chart_free(charts[k]);
  }
}

static void say_result(sayings *s, tp_study_result *result) {
  if (result == NULL) return;
  if (tp_report_study(next_saying(s), result) != TP_OK) s->count--;
  if (tp_report_study_json(next_saying(s), result) != TP_OK) s->count--;
  say_charts(s, result);
  tp_study_result_free(result);
}

static bool stop_at_once(void *context) {
  (void)context;
  return true;
}

static void say_shards(sayings *s, const tp_study *study) {
  tp_message message = {.text = ""};
  char paths[3][400];
  const char *const shards[] = {paths[1], paths[0]};
  tp_study_result *result = NULL;
  tp_study_options options = tp_study_options_default();
  for (size_t k = 0; k < 3; k++) snprintf(paths[k], sizeof paths[k], "%s/%zu.csv", s->folder, k);
  options.restart = true;
  options.shards = 2;
  for (size_t k = 0; k < 2; k++) {
    options.shard = k + 1;
    options.rows = paths[k];
    result = NULL;
    SAY(tp_study_run(&result, study, &options, &message));
    tp_study_result_free(result);
  }
  options = tp_study_options_default();
  options.restart = true;
  options.rows = paths[2];
  result = NULL;
  SAY(tp_study_merge(&result, study, shards, 2, &options, &message));
  say_result(s, result);
  say_file(s, paths[2]);
}

static void say_sheet(sayings *s, const tp_study *study, const tp_study_result *result) {
  tp_message message = {.text = ""};
  char path[400];
  tp_sheet_options options = tp_sheet_options_default();
  options.times = 0;
  snprintf(path, sizeof path, "%s/study.html", s->folder);
  SAY(tp_report_sheet_study(path, study, result, &options, &message));
  say_file(s, path);
}

void say_studies(sayings *s) {
  tp_message message = {.text = ""};
  tp_study *study = NULL;
  tp_study_result *result = NULL;
  tp_study_options options = tp_study_options_default();
  SAY(tp_study_read(&study, TP_EXAMPLES "/studies/none.yaml", &message));
  SAY(tp_study_read_text(&study, "topple_study: 2\n", "two.yaml", &message));
  SAY(tp_study_read(&study, TP_EXAMPLES "/studies/slab_study.yaml", &message));
  if (study == NULL) return;
  options.threads = 2;
  SAY(tp_study_run(&result, study, &options, &message));
  if (result != NULL) say_sheet(s, study, result);
  say_result(s, result);
  result = NULL;
  options.stop = stop_at_once;
  SAY(tp_study_run(&result, study, &options, &message));
  say_result(s, result);
  say_shards(s, study);
  tp_study_free(study);
}
