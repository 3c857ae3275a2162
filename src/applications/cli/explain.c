/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* topple explain [WORD...]: terms, keys and results that a word names (docs/explain.md). */

#include "cli/cli.h"

#include <stdlib.h>
#include <string.h>

typedef struct arguments {
  char word[512]; /* all words of the command line, with blanks between them */
} arguments;

static const struct argp_option options[] = {{0}};

static error_t parse(int key, char *argument, struct argp_state *state) {
  arguments *a = state->input;
  if (key != ARGP_KEY_ARG) return ARGP_ERR_UNKNOWN;
  const size_t used = strlen(a->word);
  if (used + strlen(argument) + 2 > sizeof a->word) {
    tp_cli_refuse(state, "one term or key at a time");
    return 0;
  }
  if (used > 0) strcat(a->word, " ");
  strcat(a->word, argument);
  return 0;
}

static const struct argp parser = {
    .options = options,
    .parser = parse,
    .args_doc = "[WORD…]",
    .doc = "Explain a word of a scene or of a report: a term of rock mechanics, a symbol, "
           "a key of a scene, a study or a result, with its unit, formula and source. Without a "
           "WORD list all terms.\v"
           "Keys may be given with their path, as block.slab.width. Exit status: 0 done, 2 "
           "wrong usage, 3 no such word, 5 system failed."};

static tp_status explain(const void *words, int *ended, tp_message *message) {
  const arguments *a = words;
  char *report = NULL;
  const tp_status status = a->word[0] != '\0' ? tp_report_explained(&report, a->word, message)
                                              : tp_report_terms(&report);
  return tp_cli_print_report(status, report, ended);
}

int tp_cli_explain(int argc, char **argv) {
  arguments a = {""};
  return tp_cli_run(&parser, &a, explain, argc, argv);
}
