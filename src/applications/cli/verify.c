/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* topple verify CLAIMS: options, the verification and its report (docs/verify.md). */

#include "cli/cli.h"

#include <argp.h>

typedef struct arguments {
  const char *claims;
  bool json, markdown;
} arguments;

static const struct argp_option options[] = {
    {"json", 'j', NULL, 0, "Print the verdicts as JSON", 0},
    {"markdown", 'm', NULL, 0, "Print the verdicts as a page in Markdown", 0},
    {0}};

static error_t parse(int key, char *argument, struct argp_state *state) {
  arguments *a = state->input;
  switch (key) {
  case 'j':
    a->json = true;
    return 0;
  case 'm':
    a->markdown = true;
    return 0;
  case ARGP_KEY_ARG:
    tp_cli_take_file(&a->claims, argument, "claims file", state);
    return 0;
  case ARGP_KEY_NO_ARGS:
    tp_cli_refuse(state, "a claims file is missing, for example examples/paper/claims.yaml");
    return 0;
  case ARGP_KEY_END:
    if (a->json && a->markdown) tp_cli_refuse(state, "JSON or Markdown, not both");
    return 0;
  default:
    return ARGP_ERR_UNKNOWN;
  }
}

static const struct argp parser = {
    .options = options,
    .parser = parse,
    .args_doc = "CLAIMS",
    .doc = "Verdicts on printed formulas and numbers: proven, refuted, agrees, truncated, "
           "disagrees, undecided.\v"
           "CLAIMS is a YAML file; docs/verify.md explains how to write one. Exit status: 0 done, "
           "1 done and something is refuted or disagrees, 2 wrong usage, 3 bad input, 5 system "
           "failed."};

static tp_status verify(const void *words, int *ended, tp_message *message) {
  const arguments *a = words;
  tp_verification *verification = NULL;
  char *report = NULL;
  tp_status status = tp_verify(&verification, a->claims, message);
  if (status == TP_OK) {
    status = a->json       ? tp_report_verification_json(&report, verification)
             : a->markdown ? tp_report_verification_markdown(&report, verification)
                           : tp_report_verification(&report, verification);
  }
  status = tp_cli_print_report(status, report, ended);
  if (status == TP_OK && *ended == 0 && tp_verification_objects(verification)) {
    *ended = TP_EXIT_REFUTED;
  }
  tp_verification_free(verification);
  return status;
}

int tp_cli_verify(int argc, char **argv) {
  arguments a = {0};
  return tp_cli_run(&parser, &a, verify, argc, argv);
}
