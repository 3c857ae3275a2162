/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* topple solve SCENE */

#include "cli/cli.h"

#include <argp.h>
#include <stdlib.h>

typedef struct arguments {
  const char *scene;
  bool json, elements;
} arguments;

static const struct argp_option options[] = {
    {"json", 'j', NULL, 0, "Print the solution as JSON", 0},
    {"elements", 'e', NULL, 0, "Print the account of moments by elements too", 0},
    {0}};

static error_t parse(int key, char *argument, struct argp_state *state) {
  arguments *a = state->input;
  switch (key) {
  case 'j':
    a->json = true;
    return 0;
  case 'e':
    a->elements = true;
    return 0;
  case ARGP_KEY_ARG:
    if (a->scene != NULL) argp_error(state, "one scene at a time; '%s' is one too many", argument);
    a->scene = argument;
    return 0;
  case ARGP_KEY_NO_ARGS:
    argp_error(state, "a scene file is missing, for example examples/block_e_valley.yaml");
    return 0;
  default:
    return ARGP_ERR_UNKNOWN;
  }
}

static const struct argp parser = {
    .options = options,
    .parser = parse,
    .args_doc = "SCENE",
    .doc = "Does the block of a scene stand, slide or topple, and at which tilt?\v"
           "SCENE is a YAML file; README.md shows one, docs/scene.md lists every key. Every "
           "number is certain to all digits printed; --json gives each with its proven error "
           "bound. Exit status: 0 done, 2 wrong usage, 3 bad input, 4 undecided, 5 system failed."};

static tp_status print_solution(const tp_solution *solution, const arguments *a, int *written) {
  char *report = NULL, *account = NULL;
  tp_status status =
      a->json ? tp_report_json(&report, solution) : tp_report_text(&report, solution);
  if (status == TP_OK && a->elements && !a->json) status = tp_report_elements(&account, solution);
  if (status == TP_OK) *written = tp_cli_print(report);
  if (status == TP_OK && *written == 0 && account != NULL) *written = tp_cli_print(account);
  free(report);
  free(account);
  return status;
}

int tp_cli_solve(int argc, char **argv) {
  arguments a = {0};
  argp_err_exit_status = TP_EXIT_USAGE;
  argp_program_version = "topple " TP_VERSION;
  if (argp_parse(&parser, argc, argv, 0, NULL, &a) != 0) return TP_EXIT_USAGE;
  tp_scene *scene = NULL;
  tp_solution *solution = NULL;
  tp_message message = {""};
  tp_solve_options solve = tp_solve_options_default();
  solve.elements = a.elements;
  int written = 0;
  tp_status status = tp_scene_read(&scene, a.scene, &message);
  if (status == TP_OK) status = tp_solve(&solution, scene, &solve, &message);
  if (status == TP_OK) status = print_solution(solution, &a, &written);
  tp_solution_free(solution);
  tp_scene_free(scene);
  return tp_cli_end(status, &message, written);
}
