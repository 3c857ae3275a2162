/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* topple study STUDY: options, the run in one process, by shards or by ranks, its summary, charts
 * and sheet (docs/study.md). */

#include "cli/cli.h"
#include "cli/sheet.h"
#include "cli/signals.h"
#include "cli/study_run.h"

#include <argp.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct arguments {
  const char *study;
  const char **shards; /* of --merge: the files after the study */
  size_t shard_count;
  bool json, merge;
  const char *report;           /* file for a calculation sheet; NULL: none */
  const char *language;         /* of that; NULL: the scene's, or English */
  const char *figure, *scatter; /* files to draw into; NULL: none */
  tp_chart_format figure_format, scatter_format;
  tp_study_options options;
} arguments;

enum {
  KEY_ROWS = 256,
  KEY_THREADS,
  KEY_SHARD,
  KEY_MERGE,
  KEY_RESTART,
  KEY_FIGURE,
  KEY_SCATTER,
  KEY_REPORT,
  KEY_LANGUAGE
};

static const struct argp_option options[] = {
    {"json", 'j', NULL, 0, "Print the summary as JSON", 0},
    {"rows", KEY_ROWS, "FILE", 0,
     "Write a row for each sample into FILE; an interrupted study continues from it. CSV; HDF5 "
     "where "
     "FILE ends in .h5 or .hdf5",
     0},
    {"csv", KEY_ROWS, NULL, OPTION_ALIAS, NULL, 0},
    {"restart", KEY_RESTART, NULL, 0, "With --rows: begin anew, over the rows that are in FILE", 0},
    {"figure", KEY_FIGURE, "FILE", 0,
     "Draw probability against tilt, distribution, rank correlations, and convergence into FILE, "
     ".svg, .pdf or .png, or write their numbers into a .csv",
     0},
    {"scatter", KEY_SCATTER, "FILE", 0, "Draw each sample's angle against each variable, likewise",
     0},
    {"report", KEY_REPORT, "FILE", 0,
     "Write a calculation sheet to check and sign into FILE, which ends in .html, .md or .pdf", 0},
    {"language", KEY_LANGUAGE, "CODE", 0,
     "Write the calculation sheet in this language: en, es or de (that of the scene's report, or "
     "English)",
     0},
    {"threads", KEY_THREADS, "N", 0, "Number of threads; the output does not depend on it", 0},
    {"shard", KEY_SHARD, "I/N", 0, "The I-th of N parts of the study alone, with --rows", 0},
    {"merge", KEY_MERGE, NULL, 0, "Put the files of all shards together", 0},
    {0}};

/* ---- words -------------------------------------------------------------------------------------
 */

static size_t read_count(const char **text, size_t most) {
  char *end = NULL;
  errno = 0;
  if (**text < '0' || **text > '9') return 0;
  const unsigned long long count = strtoull(*text, &end, 10);
  *text = end;
  return errno == 0 && count <= most ? (size_t)count : 0;
}

static void read_threads(arguments *a, const char *text, struct argp_state *state) {
  const char *at = text;
  a->options.threads = read_count(&at, 1024);
  if (a->options.threads == 0 || *at != '\0') {
    tp_cli_refuse(state, "--threads takes a number from 1 to 1024, not '%s'", text);
  }
}

static void read_shard(arguments *a, const char *text, struct argp_state *state) {
  enum { MOST = 1000000 };
  const char *at = text;
  a->options.shard = read_count(&at, MOST);
  const bool parted = *at == '/';
  if (parted) at++;
  a->options.shards = parted ? read_count(&at, MOST) : 0;
  if (a->options.shard == 0 || a->options.shards < a->options.shard || *at != '\0') {
    tp_cli_refuse(state, "--shard takes a part and of how many, as 2/5, not '%s'", text);
  }
}

static void read_figure(const char **file, tp_chart_format *format, const char *path,
                        const char *option, struct argp_state *state) {
  if (!tp_chart_format_read(format, path)) {
    tp_cli_refuse(state, "%s takes a file that ends in .svg, .pdf, .png or .csv, not '%s'", option,
                  path);
  }
  *file = path;
}

/* The study, and then the files of shards. */
static error_t take_file(arguments *a, const char *file) {
  if (a->study == NULL) {
    a->study = file;
    return 0;
  }
  const char **grown = realloc(a->shards, (a->shard_count + 1) * sizeof *grown);
  if (grown == NULL) return ENOMEM;
  a->shards = grown;
  a->shards[a->shard_count++] = file;
  return 0;
}

static void check(const arguments *a, struct argp_state *state) {
  if (a->study == NULL) tp_cli_refuse(state, "give a study, for example examples/study_slab.yaml");
  if (a->merge && a->shard_count == 0) {
    tp_cli_refuse(state, "--merge takes the study, and then the files of its shards");
  }
  if (!a->merge && a->shard_count > 0) {
    tp_cli_refuse(state, "one study at a time; '%s' is one too many", a->shards[0]);
  }
  if (a->options.shards > 1 && a->merge) tp_cli_refuse(state, "one of --shard and --merge");
  if (a->options.shards > 1 && a->options.rows == NULL) {
    tp_cli_refuse(state, "a shard needs a file for its rows; say --rows FILE");
  }
  if (a->options.shards > 1 && tp_cli_is_hdf5(a->options.rows)) {
    tp_cli_refuse(state, "a shard writes CSV, as '%s.csv'; --merge makes HDF5 of all",
                  a->options.rows);
  }
  const tp_cli_written files[] = {{"--rows", a->options.rows},
                                  {"--figure", a->figure},
                                  {"--scatter", a->scatter},
                                  {"--report", a->report}};
  tp_cli_check_language(a->language, a->report, state);
  tp_cli_refuse_same_files(files, sizeof files / sizeof files[0], state);
  if (a->options.restart && a->options.rows == NULL) {
    tp_cli_refuse(state, "--restart goes with --rows");
  }
}

static error_t parse(int key, char *argument, struct argp_state *state) {
  arguments *a = state->input;
  switch (key) {
  case 'j':
    a->json = true;
    return 0;
  case KEY_ROWS:
    a->options.rows = argument;
    return 0;
  case KEY_RESTART:
    a->options.restart = true;
    return 0;
  case KEY_FIGURE:
    read_figure(&a->figure, &a->figure_format, argument, "--figure", state);
    return 0;
  case KEY_SCATTER:
    read_figure(&a->scatter, &a->scatter_format, argument, "--scatter", state);
    return 0;
  case KEY_REPORT:
    tp_cli_take_sheet(&a->report, argument, state);
    return 0;
  case KEY_LANGUAGE:
    tp_cli_take_language(&a->language, argument, state);
    return 0;
  case KEY_THREADS:
    read_threads(a, argument, state);
    return 0;
  case KEY_SHARD:
    read_shard(a, argument, state);
    return 0;
  case KEY_MERGE:
    a->merge = true;
    return 0;
  case ARGP_KEY_ARG:
    return take_file(a, argument);
  case ARGP_KEY_END:
    check(a, state);
    return 0;
  default:
    return ARGP_ERR_UNKNOWN;
  }
}

static const struct argp parser = {
    .options = options,
    .parser = parse,
    .args_doc = "STUDY\n--merge STUDY FILE...",
    .doc = "The probability that a block stands, slides or topples\v"
           "STUDY names a scene and what varies in it: docs/study.md. If interrupted (Ctrl-C) it "
           "reports the samples so far; with --rows it continues when run again."};

/* ---- the work ----------------------------------------------------------------------------------
 */

/* One process reads the study, and runs or merges it. */
static tp_status run(tp_study_result **result, const arguments *a, tp_message *message) {
  tp_study *study = NULL;
  tp_status status = tp_study_read(&study, a->study, message);
  if (status == TP_OK) {
    status = a->merge
                 ? tp_study_merge(result, study, a->shards, a->shard_count, &a->options, message)
                 : tp_cli_study_run(result, study, &a->options, message);
  }
  tp_study_free(study);
  return status;
}

/* Whoever shares a study out by --shard, or merges it, does so under mpirun as well. */
static tp_status run_by_ranks(tp_study_result **result, const arguments *a, tp_message *message) {
  tp_ranks ranks = {.own = {.count = 1}};
  if (!a->merge && a->options.shards == 1) {
    const tp_status status = tp_cli_ranks_begin(&ranks, message);
    if (status != TP_OK) return ranks.own.rank == 0 ? status : TP_OK; /* one complains */
  }
  if (ranks.own.count == 1) {
    const tp_status status = run(result, a, message);
    tp_cli_ranks_end(&ranks);
    return status;
  }
  const tp_status status = tp_cli_study_by_ranks(result, &ranks, a->study, &a->options, message);
  tp_cli_ranks_end(&ranks);
  return status;
}

typedef tp_status chart_of(tp_chart **chart, const tp_study_result *result, tp_message *message);

static tp_status draw(chart_of *make, const tp_study_result *result, const char *path,
                      tp_chart_format format, tp_message *message) {
  tp_chart *chart = NULL;
  tp_status status = make(&chart, result, message);
  if (status == TP_OK) status = tp_report_chart_file(path, chart, format, message);
  tp_chart_free(chart);
  return status;
}

/* The study once more, by which the sheet names all files that it rests on. */
static tp_status write_sheet(const tp_study_result *result, const arguments *a,
                             tp_message *message) {
  tp_sheet_options sheet;
  tp_cli_date date;
  tp_study *study = NULL;
  tp_status status = tp_cli_sheet_options(&sheet, &date, message);
  sheet.language = a->language;
  if (status == TP_OK) status = tp_study_read(&study, a->study, message);
  if (status == TP_OK) {
    status = tp_cli_write_study_sheet(a->report, study, result, &sheet, message);
  }
  tp_study_free(study);
  return status;
}

static tp_status tell(const tp_study_result *result, const arguments *a, int *ended,
                      tp_message *message) {
  char *report = NULL;
  tp_status status =
      a->json ? tp_report_study_json(&report, result) : tp_report_study(&report, result);
  status = tp_cli_print_report(status, report, ended);
  if (status == TP_OK && *ended == 0 && a->figure != NULL) {
    status = draw(tp_chart_study, result, a->figure, a->figure_format, message);
  }
  if (status == TP_OK && *ended == 0 && a->scatter != NULL) {
    status = draw(tp_chart_study_scatter, result, a->scatter, a->scatter_format, message);
  }
  if (status == TP_OK && *ended == 0 && a->report != NULL) {
    status = write_sheet(result, a, message);
  }
  return status;
}

static tp_status study_and_tell(const void *words, int *ended, tp_message *message) {
  const arguments *a = words;
  tp_study_result *result = NULL;
  tp_status status = run_by_ranks(&result, a, message);
  if (status == TP_OK && result != NULL) status = tell(result, a, ended, message);
  tp_study_result_free(result);
  free(a->shards);
  return status;
}

int tp_cli_study(int argc, char **argv) {
  arguments a = {.options = tp_study_options_default()};
  const int status = tp_cli_run(&parser, &a, study_and_tell, argc, argv);
  tp_cli_end_by_signal();
  return status;
}
