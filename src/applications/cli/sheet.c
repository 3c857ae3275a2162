/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Date of a sheet from SOURCE_DATE_EPOCH or the clock, and the solve with all pivots and elements
 * that a sheet needs. */

#include "cli/sheet.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

/* The time that SOURCE_DATE_EPOCH gives, in seconds since 1970; false where it is not set. */
static bool read_epoch(time_t *when, tp_status *status, tp_message *message) {
  const char *text = getenv("SOURCE_DATE_EPOCH");
  char *end = NULL;
  if (text == NULL || *text == '\0') return false;
  errno = 0;
  const long long seconds = strtoll(text, &end, 10);
  const long long last = 253402300799LL; /* of the year 9999 */
  if (errno != 0 || *end != '\0' || seconds < 0 || seconds > last) {
    char plain[64];
    tp_plain_text(plain, sizeof plain, text);
    snprintf(message->text, sizeof message->text,
             "SOURCE_DATE_EPOCH is to be seconds since 1970, 0 to %lld, not '%s'", last, plain);
    *status = TP_BAD_INPUT;
  }
  *when = (time_t)seconds;
  return true;
}

tp_status tp_cli_sheet_options(tp_sheet_options *options, tp_cli_date *date, tp_message *message) {
  time_t when = time(NULL);
  tp_status status = TP_OK;
  struct tm parts;
  *options = tp_sheet_options_default();
  if (read_epoch(&when, &status, message)) options->times = 0;
  if (status == TP_OK && gmtime_r(&when, &parts) != NULL &&
      strftime(date->text, sizeof date->text, "%Y-%m-%d %H:%M UTC", &parts) > 0) {
    options->date = date->text;
  }
  return status;
}

tp_status tp_cli_solve_for_sheet(tp_solution **solution, const tp_scene *scene,
                                 const tp_solve_options *options, tp_message *message) {
  tp_solve_options own = *options;
  own.pivots = TP_PIVOTS_ALL;
  own.elements = true;
  tp_status status = tp_solve(solution, scene, &own, message);
  if (status != TP_BAD_INPUT) return status;
  own.elements = false;
  return tp_solve(solution, scene, &own, message);
}

void tp_cli_take_sheet(const char **path, const char *word, struct argp_state *state) {
  if (!tp_sheet_is_file_name(word)) {
    tp_cli_refuse(state, "--report takes a file that ends in .html, .md or .pdf, not '%s'", word);
  }
  *path = word;
}

void tp_cli_take_language(const char **language, const char *word, const struct argp_state *state) {
  if (!tp_sheet_is_language(word)) {
    tp_cli_refuse(state, "--language takes one of %s, not '%s'", tp_sheet_languages(), word);
  }
  *language = word;
}

void tp_cli_check_language(const char *language, const char *report,
                           const struct argp_state *state) {
  if (language != NULL && report == NULL) {
    tp_cli_refuse(state, "--language is of the calculation sheet; add --report FILE");
  }
}
