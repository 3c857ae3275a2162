/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Calculation sheets of studies and of tilt tests written to files, with their charts. */

#include "common/host.h"
#include "common/message.h"
#include "common/options.h"
#include "figure/sheet_file.h"
#include "figure/tilt_frames.h"
#include "figure/version.h"
#include "report/tilt_svg.h"
#include "scene/scene.h"
#include "study/sources.h"
#include "study/study.h"

#include <stdlib.h>
#include <string.h>

enum { CHARTS = 2 };

static void free_charts(tp_sheet_picture charts[CHARTS]) {
  for (size_t k = 0; k < CHARTS; k++) {
    free(charts[k].picture.svg);
    free(charts[k].picture.png);
  }
}

static tp_status study_sources(tp_file_sources *sources, const tp_study *study,
                               tp_message *message) {
  const size_t count = tp_study_source_count(study);
  const char **paths = calloc(count + 1, sizeof *paths);
  if (paths == NULL) return tp_fail_memory(message, "the names of files");
  for (size_t k = 0; k < count; k++) paths[k] = tp_study_source(study, k);
  *sources = (tp_file_sources){count, paths};
  return TP_OK;
}

static tp_status make_head(tp_sheet_head *head, const tp_letterhead *letterhead,
                           const tp_sheet_options *options, const char *path, tp_message *message) {
  const bool paper = tp_sheet_kind_of(path) == TP_SHEET_PDF;
  return tp_sheet_head_make(head, letterhead, options, paper, message);
}

static tp_status study_charts(tp_sheet_picture charts[CHARTS], const char *path,
                              const tp_sheet_head *head, const tp_study_result *result,
                              tp_message *message) {
  tp_chart *chart = NULL;
  tp_status status = tp_chart_study(&chart, result, message);
  status = tp_sheet_chart(&charts[0].picture, chart, status, path, head, message);
  if (status != TP_OK) return status;
  chart = NULL;
  status = tp_chart_study_scatter(&chart, result, message);
  return tp_sheet_chart(&charts[1].picture, chart, status, path, head, message);
}

tp_status tp_report_sheet_study(const char *path, const tp_study *study,
                                const tp_study_result *result, const tp_sheet_options *options,
                                tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, path);
  TP_REFUSE_NULL(message, study);
  TP_REFUSE_NULL(message, result);
  TP_REFUSE_NULL(message, options);
  TP_REFUSE_OTHER_VERSION(message);
  tp_sheet_options taken = tp_sheet_options_default();
  TP_TAKE_OPTIONS(message, taken, options);
  tp_sheet_picture charts[CHARTS] = {
      {{0},
       "Probability against tilt, distribution of the angle, its rank correlations, and "
       "convergence of the estimate.",
       "Charts of the study. Its shares, quantiles and correlations are in the tables of this "
       "page."},
      {{0},
       "The angle of each sample against each variable.",
       "Scatter of the samples. Their quantiles and correlations are in the tables of this page."}};
  const tp_vector_picture none = {0};
  tp_file_sources sources = {0};
  tp_sheet_files files = {0};
  tp_sheet_head head = {0};
  const tp_letterhead *letterhead = study->scene != NULL ? &study->scene->letterhead : NULL;
  tp_status status = tp_sheet_check(path, message);
  if (status == TP_OK) status = make_head(&head, letterhead, options, path, message);
  if (status == TP_OK) status = study_sources(&sources, study, message);
  if (status == TP_OK) status = tp_sheet_files_read(&files, sources.paths, sources.count, message);
  files.logo = letterhead != NULL ? letterhead->logo : NULL;
  if (status == TP_OK) status = study_charts(charts, path, &head, result, message);
  if (status == TP_OK) {
    tp_document document = {0};
    tp_sheet_build_study(&document, result, &files, options, &head, charts, CHARTS);
    status = tp_sheet_write(path, &document, &none, sources, message);
    tp_document_clear(&document);
  } else {
    free_charts(charts);
  }
  tp_logo_clear(&head.logo);
  tp_sheet_files_clear(&files);
  free((void *)sources.paths);
  return status;
}

/* ---- tilt tests --------------------------------------------------------------------------------
 */

static tp_status tilt_charts(tp_sheet_picture charts[CHARTS], const char *path,
                             const tp_sheet_head *head, const tp_tilt_test *test,
                             tp_message *message) {
  tp_chart *chart = NULL;
  tp_status status = tp_chart_tilt_reactions(&chart, test, message);
  status = tp_sheet_chart(&charts[0].picture, chart, status, path, head, message);
  if (status != TP_OK || test->settings.engine == TP_TILT_PATH) return status;
  chart = NULL;
  status = tp_chart_tilt_phase(&chart, test, message);
  return tp_sheet_chart(&charts[1].picture, chart, status, path, head, message);
}

tp_status tp_report_sheet_tilt(const char *path, const tp_scene *scene, const tp_tilt_test *test,
                               const tp_sheet_options *options, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, path);
  TP_REFUSE_NULL(message, scene);
  TP_REFUSE_NULL(message, test);
  TP_REFUSE_NULL(message, options);
  TP_REFUSE_OTHER_VERSION(message);
  tp_sheet_options taken = tp_sheet_options_default();
  TP_TAKE_OPTIONS(message, taken, options);
  tp_sheet_picture charts[CHARTS] = {
      {{0},
       "Reactions of the facets against the tilt, normal and along each.",
       "Chart of the reactions; topple tilt --json has their numbers."},
      {{0},
       "Phase portraits: turn against angular velocity, displacement against speed.",
       "Chart of the motion; topple tilt --csv has its numbers."}};
  tp_file_sources sources = {0};
  tp_sheet_files files = {0};
  tp_picture frames = {0};
  tp_sheet_head head = {0};
  tp_status status = tp_sheet_check(path, message);
  if (status == TP_OK) status = make_head(&head, &scene->letterhead, options, path, message);
  if (status == TP_OK) status = tp_sheet_sources(&sources, scene, message);
  if (status == TP_OK) status = tp_sheet_files_read(&files, sources.paths, sources.count, message);
  files.logo = scene->letterhead.logo;
  if (status == TP_OK) status = tilt_charts(charts, path, &head, test, message);
  if (status == TP_OK && tp_sheet_kind_of(path) != TP_SHEET_PDF) {
    if (tp_tilt_frames_svg(&frames.svg, test, head.language, head.comma) == TP_OK) {
      frames.svg_length = strlen(frames.svg);
    } else {
      status = tp_fail_memory(message, "the drawing");
    }
  }
  if (status == TP_OK) {
    tp_document document = {0};
    const tp_tilt_drawing words = {test, head.language, head.comma};
    const tp_vector_picture drawing = tp_tilt_frames_drawing(&words);
    tp_sheet_build_tilt(&document, test, &files, options, &head, frames, charts, CHARTS);
    status = tp_sheet_write(path, &document, &drawing, sources, message);
    tp_document_clear(&document);
  } else {
    free_charts(charts);
  }
  tp_logo_clear(&head.logo);
  tp_sheet_files_clear(&files);
  free((void *)sources.paths);
  return status;
}
