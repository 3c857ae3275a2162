/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Assembles the result: description, sources, shares and statistics of the tally, then sensitivity,
 * reliability and design values of a complete study. */

#include "study/result.h"

#include "study/analyses.h"
#include "study/progress.h"
#include "study/sources.h"

#include <stdlib.h>
#include <string.h>

/* What the study itself says. */
static bool fill(tp_study_result *result, const tp_study *study) {
  const tp_node *title = tp_node_get(study->root, "title");
  const char *own = title != NULL ? title->text : study->scene->title;
  result->title = own != NULL ? strdup(own) : NULL;
  result->scene = strdup(study->scene_path);
  result->method = study->drawn > 0 ? tp_draw_method_name(study->method) : "none";
  result->seed = study->seed;
  result->planned = study->samples;
  result->half_width = study->half_width;
  return result->scene != NULL && (own == NULL || result->title != NULL);
}

tp_status tp_study_add_source(tp_study_result *result, const char *path, tp_message *message) {
  char *own = strdup(path);
  char **grown = realloc(result->sources, (result->source_count + 1) * sizeof *grown);
  if (grown != NULL) result->sources = grown;
  if (own != NULL && grown != NULL) {
    grown[result->source_count++] = own;
    return TP_OK;
  }
  free(own);
  return tp_fail_memory(message, "the result of a study");
}

/* What it was read from, and its rows with their progress. */
static tp_status add_sources(tp_study_result *result, const tp_study *study, const char *rows,
                             tp_message *message) {
  const size_t count = tp_study_source_count(study);
  tp_status status = TP_OK;
  for (size_t k = 0; k < count && status == TP_OK; k++) {
    status = tp_study_add_source(result, tp_study_source(study, k), message);
  }
  if (rows == NULL || status != TP_OK) return status;
  char *progress = tp_progress_path(rows);
  status = progress != NULL ? tp_study_add_source(result, progress, message)
                            : tp_fail_memory(message, "the result of a study");
  free(progress);
  return status == TP_OK ? tp_study_add_source(result, rows, message) : status;
}

/* What is asked for besides, of a whole study. */
static tp_status analyse(tp_study_result *result, const tp_study *study,
                         const tp_study_options *options, tp_message *message) {
  bool stopped = false;
  if (result->end != TP_STUDY_COMPLETE && result->end != TP_STUDY_CERTAIN) return TP_OK;
  tp_status status = tp_study_sense(result, study, options, &stopped, message);
  if (status == TP_OK && !stopped) {
    status = tp_study_rely(result, study, options, &stopped, message);
  }
  if (status == TP_OK && !stopped) {
    status = tp_study_design_values(result, study, options, &stopped, message);
  }
  if (stopped) result->end = TP_STUDY_INTERRUPTED;
  return status;
}

tp_status tp_study_sum_up(tp_study_result **result, tp_tally *tally, tp_study_end end,
                          const tp_study_options *options, tp_message *message) {
  tp_study_result *own = calloc(1, sizeof *own);
  if (own == NULL) return tp_fail_memory(message, "the result of a study");
  own->size = sizeof *own;
  own->end = end;
  own->shard = options->shard;
  own->shards = options->shards;
  tp_status status =
      fill(own, tally->study) ? TP_OK : tp_fail_memory(message, "the result of a study");
  if (status == TP_OK) status = add_sources(own, tally->study, options->rows, message);
  if (status == TP_OK) status = tp_tally_finish(own, tally, message);
  if (status == TP_OK) status = analyse(own, tally->study, options, message);
  if (status == TP_OK) {
    *result = own;
  } else {
    tp_study_result_free(own);
  }
  return status;
}
