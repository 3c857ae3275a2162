/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Runs a study in this process, or this rank, and prints its progress twice a second. */

#include "cli/study_run.h"

#include "cli/signals.h"
#include "cli/words.h"

#include <string.h>
#include <strings.h>
#include <time.h>
#include <unistd.h>

/* When it began, and with how many. */
typedef struct clock_line {
  double began, told;
  size_t first;
  bool begun;
} clock_line;

static double seconds_now(void) {
  struct timespec now;
  (void)clock_gettime(CLOCK_MONOTONIC, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* Twice a second, over the line before. */
static void tell_progress(void *context, size_t done, size_t of) {
  clock_line *line = context;
  const double now = seconds_now();
  if (!line->begun) {
    *line = (clock_line){now, now, done, true};
    return;
  }
  if (now - line->told < 0.5) return;
  line->told = now;
  tp_cli_tell_progress(done, of, (double)(done - line->first) / (now - line->began));
}

static void tell_forecast(void *context, size_t samples, double seconds) {
  (void)context;
  tp_cli_tell_forecast(samples, "samples", seconds, 0);
}

bool tp_cli_is_hdf5(const char *rows) {
  const char *ending = rows != NULL ? strrchr(rows, '.') : NULL;
  return ending != NULL && (strcasecmp(ending, ".h5") == 0 || strcasecmp(ending, ".hdf5") == 0);
}

/* HDF5 is made of whole studies alone. */
static void tell_where_rows_are(const tp_study_options *options, const tp_study_result *result) {
  if (result->end != TP_STUDY_INTERRUPTED || !tp_cli_is_hdf5(options->rows)) return;
  tp_cli_complain("interrupted: the rows so far are in '%s.csv', and '%s' is made from them once "
                  "the same command has been run to the end",
                  options->rows, options->rows);
}

tp_status tp_cli_study_run(tp_study_result **result, const tp_study *study,
                           const tp_study_options *options, tp_message *message) {
  const bool first = options->ranks == NULL || options->ranks->rank == 0;
  const bool terminal = first && isatty(STDERR_FILENO) == 1;
  clock_line line = {.begun = false};
  tp_study_options own = *options;
  own.context = &line;
  own.stop = tp_cli_is_interrupted;
  own.progress = terminal ? tell_progress : NULL;
  own.forecast = first ? tell_forecast : NULL;
  tp_cli_catch_signals();
  const tp_status status = tp_study_run(result, study, &own, message);
  if (terminal) tp_cli_clear_progress();
  if (terminal && status == TP_OK && *result != NULL) {
    tp_cli_tell_cost((*result)->doubles_seconds, (*result)->ladder_seconds);
  }
  if (status == TP_OK && *result != NULL) tell_where_rows_are(options, *result);
  return status;
}
