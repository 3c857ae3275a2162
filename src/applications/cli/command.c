/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What all commands share: to read their words, print their reports and end with their status. */

#include "cli/cli.h"
#include "cli/manner.h"

#include <errno.h>
#include <stdio.h>
#include <stdio_ext.h>
#include <stdlib.h>
#include <string.h>

int tp_cli_print(const char *text) {
  if (tp_cli_is_quiet()) return 0;
  if (fputs(text, stdout) != EOF && fflush(stdout) == 0) return 0;
  tp_cli_complain("cannot write the report: %s", strerror(errno));
  /* what is left is not tried again at the end */
  __fpurge(stdout);
  clearerr(stdout);
  return TP_EXIT_SYSTEM;
}

tp_status tp_cli_print_report(tp_status status, char *report, int *ended) {
  if (status == TP_OK && *ended == 0) *ended = tp_cli_print(report);
  tp_text_free(report);
  return status;
}

/* ---- options of every command ------------------------------------------------------------------
 */

enum { KEY_COLOUR = 1000, GROUP = 50 };

static const struct argp_option manner_options[] = {
    {"quiet", 'q', NULL, 0, "Write nothing to the standard output, and show no progress", GROUP},
    {"color", KEY_COLOUR, "WHEN", 0,
     "Colour the report: auto (on a terminal, unless NO_COLOR is set), always or never", GROUP},
    {0}};

static error_t parse_manner(int key, char *argument, struct argp_state *state) {
  if (key != 'q' && key != KEY_COLOUR) return ARGP_ERR_UNKNOWN;
  if (key == 'q') {
    tp_cli_be_quiet();
  } else if (!tp_cli_colour_when(argument)) {
    tp_cli_refuse(state, "--color takes auto, always or never, not '%s'", argument);
  }
  return 0;
}

static const struct argp manner = {.options = manner_options, .parser = parse_manner};

/* 0, or the exit status, complained about. */
static int parse(const struct argp *own, void *words, int argc, char **argv) {
  struct argp_child children[3] = {{.argp = NULL}}; /* the command's, and those of all */
  struct argp whole = *own;
  const struct argp *parser = &whole;
  if (own->children != NULL) children[0] = own->children[0];
  children[own->children != NULL ? 1 : 0].argp = &manner;
  whole.children = children;
  const char *strange = tp_cli_strange_option(parser, argc, argv);
  if (strange != NULL) {
    char option[80];
    tp_plain_text(option, sizeof option, strange);
    tp_cli_complain("there is no option '%s'; '%s --help' lists the options", option, argv[0]);
    return TP_EXIT_USAGE;
  }
  argp_err_exit_status = TP_EXIT_USAGE;
  argp_program_version = "topple " TP_VERSION;
  const error_t failed = argp_parse(parser, argc, argv, 0, NULL, words);
  if (failed == 0) return 0;
  tp_cli_complain("the options cannot be read: %s",
                  failed == ENOMEM ? "out of memory" : strerror(failed));
  return TP_EXIT_SYSTEM;
}

int tp_cli_end(tp_status status, const tp_message *message, int ended) {
  if (status == TP_OK) return ended;
  tp_cli_complain("%s", message->text[0] != '\0' ? message->text : tp_status_meaning(status));
  return tp_status_exit(status);
}

int tp_cli_graver(int one, int other) {
  static const int order[] = {TP_EXIT_SYSTEM, 3, TP_EXIT_REFUTED, 4, 0};
  for (size_t k = 0; k < sizeof order / sizeof order[0]; k++) {
    if (one == order[k] || other == order[k]) return order[k];
  }
  return one;
}

int tp_cli_run(const struct argp *parser, void *words, tp_cli_work *work, int argc, char **argv) {
  const int refused = parse(parser, words, argc, argv);
  if (refused != 0) return refused;
  tp_message message = {.text = ""};
  int ended = 0;
  const tp_status status = work(words, &ended, &message);
  return tp_cli_end(status, &message, ended);
}
