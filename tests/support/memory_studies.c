/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "memory_studies.h"

#include "memory_expect.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

/* The rows of this process. */
static const char *rows_path(char path[100], const char *end) {
  snprintf(path, 100, "/tmp/topple_memory_%ld.csv%s", (long)getpid(), end);
  return path;
}

static void forget_rows(void) {
  char path[100];
  (void)unlink(rows_path(path, ""));
  (void)unlink(rows_path(path, ".progress"));
}

static void draw(const tp_study_result *result) {
  tp_chart *chart = NULL, *scatter = NULL;
  tp_message message = {.text = ""};
  (void)DONE(tp_chart_study(&chart, result, &message), chart);
  (void)DONE(tp_chart_study_scatter(&scatter, result, &message), scatter);
  tp_chart_free(chart);
  tp_chart_free(scatter);
}

static void report(const tp_study_result *result) {
  char *text = NULL, *json = NULL;
  tp_status status = tp_report_study(&text, result);
  expect_report(status, text);
  status = tp_report_study_json(&json, result);
  expect_report(status, json);
  draw(result);
}

/* Where a file is written that memory runs out for is the system's failure. */
static bool ran(tp_status status, const tp_study_result *result, const tp_message *message) {
  if (status == TP_SYSTEM_FAILED && strstr(message->text, "Cannot allocate memory") != NULL) {
    return false;
  }
  return done(status, result, message);
}

static bool run_into(const tp_study *study, const char *rows, bool restart) {
  tp_study_result *result = NULL;
  tp_message message = {.text = ""};
  tp_study_options options = tp_study_options_default();
  options.threads = 1;
  options.rows = rows;
  options.restart = restart;
  const tp_status status = tp_study_run(&result, study, &options, &message);
  const bool whole = ran(status, result, &message);
  if (whole) report(result);
  tp_study_result_free(result);
  return whole;
}

static tp_study *read_study(void) {
  tp_study *study = NULL;
  tp_message message = {.text = ""};
  (void)DONE(tp_study_read(&study, EXAMPLE("../tests/data/study_four.yaml"), &message), study);
  return study;
}

void run_study(void) {
  char path[100];
  tp_study *study = read_study();
  if (study != NULL && run_into(study, rows_path(path, ""), true)) {
    (void)run_into(study, path, false); /* the rows are read back */
  }
  tp_study_free(study);
  forget_rows();
}

void merge_study(void) {
  char path[100];
  tp_study_result *result = NULL;
  tp_message message = {.text = ""};
  tp_study_options options = tp_study_options_default();
  tp_study *study = read_study();
  options.rows = "/dev/null";
  if (study != NULL && run_into(study, rows_path(path, ""), true)) {
    const char *const parts[] = {path};
    if (DONE(tp_study_merge(&result, study, parts, 1, &options, &message), result)) report(result);
  }
  tp_study_result_free(result);
  tp_study_free(study);
  forget_rows();
}
