/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* topple solve --batch: options of the table, the table solved, printed and written, and the exit
 * status by what is found. */

#include "cli/batch.h"

#include "cli/batch_xlsx.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>

/* ---- options -----------------------------------------------------------------------------------
 */

static void take_output(tp_cli_batch *b, const char *path, const struct argp_state *state) {
  if (!tp_batch_is_file_name(path) && !tp_cli_is_xlsx(path)) {
    tp_cli_refuse(state,
                  "--output takes a file that ends in .csv, .html, .json, .md or .xlsx, not '%s'",
                  path);
  } else if (b->output_count == TP_CLI_OUTPUTS) {
    tp_cli_refuse(state, "--output is given at most %d times", TP_CLI_OUTPUTS);
  } else {
    b->outputs[b->output_count++] = path;
  }
}

static void take_threads(tp_cli_batch *b, const char *text, const struct argp_state *state) {
  enum { MOST = 1024 };
  char *end = NULL;
  const long count = strtol(text, &end, 10);
  if (end == text || *end != '\0' || count < 1 || count > MOST) {
    tp_cli_refuse(state, "--threads takes a whole number from 1 to %d, not '%s'", MOST, text);
  }
  b->options.threads = (size_t)count;
}

bool tp_cli_batch_take(tp_cli_batch *b, int key, const char *argument,
                       const struct argp_state *state) {
  switch (key) {
  case TP_CLI_BATCH:
    b->asked = true;
    return true;
  case TP_CLI_BATCH_TEMPLATE:
    tp_cli_take_file(&b->options.scene, argument, "--template", state);
    return true;
  case TP_CLI_BATCH_OUTPUT:
    take_output(b, argument, state);
    return true;
  case TP_CLI_BATCH_FIGURES:
    b->figures = argument;
    return true;
  case TP_CLI_BATCH_THREADS:
    take_threads(b, argument, state);
    return true;
  default:
    return false;
  }
}

void tp_cli_batch_check(const tp_cli_batch *b, const struct argp_state *state) {
  const bool given = b->options.scene != NULL || b->output_count > 0 || b->figures != NULL ||
                     b->options.threads > 0;
  if (!b->asked && given) {
    tp_cli_refuse(state, "--template, --output, --figures and --threads go with --batch");
  }
  tp_cli_written files[TP_CLI_OUTPUTS];
  for (int k = 0; k < b->output_count; k++) {
    files[k] = (tp_cli_written){"--output", b->outputs[k]};
  }
  tp_cli_refuse_same_files(files, b->output_count, state);
}

/* ---- what is written ---------------------------------------------------------------------------
 */

/* A page shows figures of so many blocks, the worst: some megabytes. */
enum { FIGURES_OF_PAGE = 60 };

static bool is_page(const char *path) {
  const char *ending = strrchr(path, '.');
  return ending != NULL && strncasecmp(ending, ".htm", strlen(".htm")) == 0;
}

static tp_status write_all(const tp_cli_batch *b, const tp_batch *batch, tp_message *message) {
  tp_status status = TP_OK;
  for (int k = 0; k < b->output_count && status == TP_OK; k++) {
    const char *path = b->outputs[k];
    status = is_page(path)          ? tp_cli_write_batch_page(path, batch, FIGURES_OF_PAGE, message)
             : tp_cli_is_xlsx(path) ? tp_cli_write_xlsx(path, batch, message)
                                    : tp_batch_write_file(path, batch, message);
  }
  if (status == TP_OK && b->figures != NULL) {
    status = tp_cli_write_batch_figures(b->figures, ".svg", batch, message);
  }
  return status;
}

static tp_status print(const tp_batch *batch, tp_cli_batch_as as, int *ended) {
  char *text = NULL;
  const tp_status status = as == TP_CLI_BATCH_CSV        ? tp_report_batch_csv(&text, batch)
                           : as == TP_CLI_BATCH_JSON     ? tp_report_batch_json(&text, batch)
                           : as == TP_CLI_BATCH_MARKDOWN ? tp_report_batch_markdown(&text, batch)
                                                         : tp_report_batch(&text, batch);
  return tp_cli_print_report(status, text, ended);
}

/* ---- what it ends with -------------------------------------------------------------------------
 */

/* The first of what is wrong with rows, in full. */
static void tell_unsolved(const tp_batch *batch) {
  enum { MOST = 20 };
  for (size_t k = 0; k < batch->fault_count && k < MOST; k++) {
    tp_cli_complain("%s", batch->faults[k].text);
  }
  if (batch->fault_count > MOST) {
    tp_cli_complain("%s: %zu more faults; --csv tells those of each row", batch->file,
                    batch->fault_count - MOST);
  }
}

static void tell(const tp_batch *batch, int *ended) {
  const size_t undecided = batch->counts[TP_BATCH_UNDECIDED];
  tell_unsolved(batch);
  if (batch->counts[TP_BATCH_UNSOLVED] > 0) {
    *ended = tp_cli_graver(*ended, tp_status_exit(TP_BAD_INPUT));
  }
  if (batch->short_of > 0) {
    tp_cli_complain("%s: %zu of %zu blocks do not have the factor of safety that is required",
                    batch->file, batch->short_of, batch->row_count);
    *ended = tp_cli_graver(*ended, TP_EXIT_REFUTED);
  }
  if (undecided > 0) {
    tp_cli_complain("%s: of %zu of %zu blocks it is undecided whether they stand", batch->file,
                    undecided, batch->row_count);
    *ended = tp_cli_graver(*ended, tp_status_exit(TP_UNDECIDED));
  }
}

static void tell_forecast(void *context, size_t rows, double seconds, double bytes) {
  (void)context;
  tp_cli_tell_forecast(rows, "rows", seconds, bytes);
}

static tp_status solve(tp_batch **batch, const tp_cli_batch *b, const char *table,
                       tp_message *message) {
  char *csv = NULL;
  tp_batch_options options = b->options;
  options.forecast = tell_forecast;
  if (!tp_cli_is_xlsx(table)) return tp_batch_solve(batch, table, &options, message);
  tp_status status = tp_cli_read_xlsx(&csv, table, message);
  if (status == TP_OK) status = tp_batch_solve_text(batch, csv, table, &options, message);
  tp_text_free(csv);
  return status;
}

tp_status tp_cli_solve_batch(const tp_cli_batch *b, const char *table, tp_cli_batch_as as,
                             int *ended, tp_message *message) {
  tp_batch *batch = NULL;
  tp_status status = TP_OK;
  for (int k = 0; k < b->output_count && status == TP_OK; k++) {
    if (tp_cli_is_xlsx(b->outputs[k])) status = tp_cli_may_write_xlsx(message);
  }
  if (status == TP_OK) status = solve(&batch, b, table, message);
  if (status == TP_OK) status = print(batch, as, ended);
  if (status == TP_OK && *ended == 0) status = write_all(b, batch, message);
  if (status == TP_OK) tell(batch, ended);
  tp_batch_free(batch);
  return status;
}
