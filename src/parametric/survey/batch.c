/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A survey solved: rows are shared out to threads, each row a scene of its own, read, solved and
 * judged by itself, those that make the same scene once; then they are put in order, by what is
 * found of them alone. */

#include "batch/share.h"
#include "common/clock.h"
#include "common/host.h"
#include "common/options.h"
#include "common/outside.h"
#include "common/threads.h"
#include "survey/faults.h"
#include "survey/judge.h"
#include "survey/same_rows.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

TP_OPTIONS_END(tp_batch_options, forecast);

void tp_batch_options_init(tp_batch_options *options, size_t size) {
  const tp_solve_options solve = tp_solve_options_default();
  const tp_batch_options defaults = {
      .size = sizeof defaults, .digits = solve.digits, .level = solve.level};
  tp_options_fill(options, size, &defaults);
}

typedef struct work {
  const tp_survey *survey;
  tp_solve_options solve;
  tp_batch *batch;
  tp_row_faults *faults; /* of each row */
  tp_same_rows rows;
  size_t begun; /* of the rows that differ: solved before those that are being shared out */
} work;

/* ---- one row -----------------------------------------------------------------------------------
 */

static tp_status solve_text(tp_batch_row *own, const work *w, size_t row, const tp_scene_text *text,
                            char failed[TP_FAILED_CASE], tp_message *message) {
  tp_scene *scene = NULL;
  tp_status status = tp_scene_read_text(&scene, text->text, text->name, message);
  if (status == TP_OK) {
    status = tp_batch_solve_scene(own, scene, tp_survey_cell(w->survey, row, TP_COLUMN_CASE),
                                  failed, &w->solve, message);
  }
  tp_scene_free(scene);
  return status;
}

/* A row that was not solved: a file of it that is not there stops the others as little as a number
 * that is wrong. */
static tp_status note_failure(tp_batch_row *own, tp_status status, const work *w, size_t row,
                              const tp_scene_text *text, const char *load_case,
                              tp_message *message) {
  tp_row_faults *faults = w->faults + (row - 1);
  if (status == TP_OUT_OF_MEMORY || status == TP_DEPENDENCY_FAILED) return status;
  if (faults->count == 0) {
    const tp_status located = tp_row_faults_locate(
        faults, w->survey, text, load_case[0] != '\0' ? load_case : NULL, message);
    if (located != TP_OK) return located;
  }
  own->standing = status == TP_UNDECIDED ? TP_BATCH_UNDECIDED : TP_BATCH_UNSOLVED;
  own->status = status;
  free(own->remark);
  own->remark = tp_row_faults_remark(faults, w->survey, row);
  return own->remark != NULL ? TP_BAD_INPUT : tp_fail_memory(message, "a table");
}

static char *make_name(const tp_survey *survey, size_t row) {
  const char *name = tp_survey_cell(survey, row, TP_COLUMN_NAME);
  char own[40];
  if (name != NULL) return strdup(name);
  snprintf(own, sizeof own, "row %zu", survey->cells.rows[row].line);
  return strdup(own);
}

/* What is found of the scene of another row, which is the same. */
static tp_status take_same(tp_batch_row *own, const tp_batch_row *solved, tp_message *message) {
  tp_batch_row row = *solved;
  row.line = own->line;
  row.name = own->name;
  row.scene = row.scene_name = NULL;
  row.remark = strdup(solved->remark);
  row.load_case = solved->load_case != NULL ? strdup(solved->load_case) : NULL;
  if (row.remark == NULL || (row.load_case == NULL) != (solved->load_case == NULL)) {
    free(row.remark);
    free(row.load_case);
    return tp_fail_memory(message, "a table");
  }
  *own = row;
  return TP_OK;
}

/* Of a row that is the same as one that was solved; one that was not complains by its own place. */
static const tp_batch_row *same_as(const work *w, size_t number) {
  const size_t first = w->rows.first[number];
  const tp_batch_row *row = w->batch->rows + first;
  return first != number && row->has_case ? row : NULL;
}

static tp_status solve_row(const work *w, size_t number, tp_message *told) {
  const size_t row = number + 1; /* behind the head */
  tp_batch_row *own = w->batch->rows + number;
  const tp_batch_row *same = same_as(w, number);
  tp_scene_text text = {0};
  tp_message message = {.text = ""};
  char load_case[TP_FAILED_CASE] = "";
  own->line = w->survey->cells.rows[row].line;
  own->name = make_name(w->survey, row);
  if (own->name == NULL) return tp_fail_memory(told, "a table");
  tp_status status = tp_survey_scene(&text, w->faults + number, w->survey, row, &message);
  if (status == TP_OK && same != NULL) {
    status = take_same(own, same, &message);
  } else if (status == TP_OK) {
    status = solve_text(own, w, row, &text, load_case, &message);
  }
  if (status != TP_OK) status = note_failure(own, status, w, row, &text, load_case, &message);
  own->scene = text.text;
  own->scene_name = text.name;
  text.text = text.name = NULL;
  tp_scene_text_clear(&text);
  if (own->scene_name == NULL) own->scene_name = strdup(w->survey->path);
  if (own->scene_name == NULL) return tp_fail_memory(told, "a table");
  if (status != TP_OK && told != NULL) *told = message;
  return status;
}

/* ---- rows --------------------------------------------------------------------------------------
 */

static tp_status solve_different(tp_workspace *workspace, const void *task, size_t number,
                                 tp_message *message) {
  const work *w = task;
  (void)workspace;
  return solve_row(w, w->rows.different[w->begun + number], message);
}

static tp_status solve_same(tp_workspace *workspace, const void *task, size_t number,
                            tp_message *message) {
  const work *w = task;
  (void)workspace;
  return solve_row(w, w->rows.same[number], message);
}

static tp_status solve_next(work *w, size_t count, size_t threads, tp_message *message) {
  enum { CHUNK = 1 };
  tp_blocks_summary summary;
  const tp_status status =
      tp_share_out(&summary, solve_different, w, count, CHUNK, threads, message);
  w->begun += count;
  return status;
}

/* Brings `count` rows from all over the table to the front: a table that is sorted begins with its
 * quickest or its slowest. */
static void spread(size_t *rows, size_t all, size_t count) {
  for (size_t k = 0; k < count; k++) {
    const size_t at = k + (all - count) / count * k, row = rows[at];
    rows[at] = rows[k];
    rows[k] = row;
  }
}

static double bytes_of_scenes(const work *w) {
  double bytes = 0;
  for (size_t k = 0; k < w->begun; k++) {
    const char *scene = w->batch->rows[w->rows.different[k]].scene;
    bytes += scene != NULL ? (double)strlen(scene) : 0;
  }
  return bytes / (double)w->begun * (double)w->batch->row_count;
}

/* By a row for each thread, and where these are quick by some more. */
static tp_status forecast(work *w, const tp_batch_options *options, tp_message *message) {
  enum { MORE = 15 };
  static const double quick = 0.02; /* seconds */
  const size_t threads = options->threads > 0 ? options->threads : tp_threads_present();
  const size_t count = w->rows.different_count;
  if (options->forecast == NULL || count / 2 < threads) return TP_OK;
  const size_t more = count / (1 + MORE) > threads ? MORE * threads : 0;
  spread(w->rows.different, count, threads + more);
  const double began = tp_clock_now();
  tp_status status = solve_next(w, threads, options->threads, message);
  if (status == TP_OK && tp_clock_now() - began < quick) {
    status = solve_next(w, more, options->threads, message);
  }
  if (status != TP_OK) return status;
  const double each = (tp_clock_now() - began) / (double)w->begun;
  const size_t left = count - w->begun;
  options->forecast(options->context, left, each * (double)left, bytes_of_scenes(w));
  return TP_OK;
}

static tp_status solve_rows(work *w, const tp_batch_options *options, tp_message *message) {
  enum { SAME_CHUNK = 64 };
  const size_t threads = options->threads;
  tp_blocks_summary summary;
  if (!tp_same_rows_find(&w->rows, w->survey)) return tp_fail_memory(message, "a table");
  tp_status status = forecast(w, options, message);
  if (status == TP_OK) {
    status = solve_next(w, w->rows.different_count - w->begun, threads, message);
  }
  if (status == TP_OK) {
    status =
        tp_share_out(&summary, solve_same, w, w->rows.same_count, SAME_CHUNK, threads, message);
  }
  tp_same_rows_clear(&w->rows);
  return status;
}

/* ---- all of it ---------------------------------------------------------------------------------
 */

static tp_status add_source(tp_batch *batch, const char *path, tp_message *message) {
  for (size_t k = 0; k < batch->source_count; k++) {
    if (strcmp(batch->sources[k], path) == 0) return TP_OK;
  }
  char **sources = realloc(batch->sources, (batch->source_count + 1) * sizeof *sources);
  if (sources == NULL) return tp_fail_memory(message, "a table");
  batch->sources = sources;
  sources[batch->source_count] = strdup(path);
  if (sources[batch->source_count] == NULL) return tp_fail_memory(message, "a table");
  batch->source_count++;
  return TP_OK;
}

/* The table, and the files that its rows name, as far as they are many. */
static tp_status add_sources(tp_batch *batch, const tp_survey *survey, tp_message *message) {
  enum { MOST = 1000 }; /* of which each is compared with all others */
  tp_status status = add_source(batch, survey->path, message);
  for (size_t k = 0; k < batch->row_count && status == TP_OK; k++) {
    if (batch->source_count < MOST) {
      status = add_source(batch, batch->rows[k].scene_name, message);
    }
  }
  return status;
}

static void count_rows(tp_batch *batch) {
  for (size_t k = 0; k < batch->row_count; k++) {
    const tp_batch_row *own = batch->rows + k;
    batch->counts[own->standing]++;
    batch->short_of += own->has_required_fos && own->meets_required == TP_DESIGN_NOT_MET;
  }
}

static tp_status solve_all(tp_batch *batch, const tp_survey *survey,
                           const tp_batch_options *options, tp_message *message) {
  const size_t count = survey->cells.row_count - 1;
  work w = {.survey = survey, .solve = tp_solve_options_default(), .batch = batch};
  w.solve.digits = options->digits;
  w.solve.level = options->level;
  w.solve.pivots = TP_PIVOTS_GOVERNING;
  w.solve.threads = 1;
  batch->size = sizeof *batch;
  batch->file = strdup(survey->path);
  batch->rows = calloc(count, sizeof *batch->rows);
  w.faults = calloc(count, sizeof *w.faults);
  if (batch->file == NULL || batch->rows == NULL || w.faults == NULL) {
    free(w.faults);
    return tp_fail_memory(message, "a table");
  }
  batch->row_count = count;
  tp_status status = solve_rows(&w, options, message);
  if (status == TP_OK) status = add_sources(batch, survey, message);
  if (status == TP_OK) status = tp_batch_group_faults(batch, w.faults, survey, message);
  for (size_t k = 0; k < count; k++) tp_row_faults_clear(w.faults + k);
  free(w.faults);
  if (status != TP_OK) return status;
  count_rows(batch);
  qsort(batch->rows, count, sizeof *batch->rows, tp_batch_compare);
  return TP_OK;
}

/* Of the text, or where that is NULL of the file. */
static tp_status solve(tp_batch **batch, const char *path, const char *text,
                       const tp_batch_options *options, tp_message *message) {
  tp_survey survey = {.scene = options->scene};
  tp_batch *own = calloc(1, sizeof *own);
  tp_status status = own != NULL ? tp_survey_read(&survey, path, text, message)
                                 : tp_fail_memory(message, "a table");
  if (status == TP_OK) status = solve_all(own, &survey, options, message);
  tp_survey_clear(&survey);
  if (status == TP_OK) {
    *batch = own;
  } else {
    tp_batch_free(own);
  }
  return status;
}

tp_status tp_batch_solve(tp_batch **batch, const char *path, const tp_batch_options *options,
                         tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, batch);
  TP_REFUSE_NULL(message, path);
  TP_REFUSE_NULL(message, options);
  tp_batch_options taken = tp_batch_options_default();
  TP_TAKE_OPTIONS(message, taken, options);
  return solve(batch, path, NULL, options, message);
}

tp_status tp_batch_solve_text(tp_batch **batch, const char *text, const char *name,
                              const tp_batch_options *options, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, batch);
  TP_REFUSE_NULL(message, text);
  TP_REFUSE_NULL(message, name);
  TP_REFUSE_NULL(message, options);
  tp_batch_options taken = tp_batch_options_default();
  TP_TAKE_OPTIONS(message, taken, options);
  return solve(batch, name, text, options, message);
}

void tp_batch_free(tp_batch *batch) {
  if (batch == NULL) return;
  for (size_t k = 0; k < batch->row_count; k++) tp_batch_row_clear(batch->rows + k);
  for (size_t k = 0; k < batch->source_count; k++) free(batch->sources[k]);
  for (size_t k = 0; k < batch->fault_count; k++) free(batch->faults[k].text);
  free(batch->rows);
  free(batch->faults);
  free(batch->sources);
  free(batch->file);
  free(batch);
}
