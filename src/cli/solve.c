/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* topple solve SCENE */

#include "cli/cli.h"

#include <argp.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct arguments {
  const char *scene; /* the first of `scenes` */
  char **scenes;     /* those of --table */
  int scene_count;
  const char *figure; /* file to draw into; NULL: none */
  bool json, elements, table;
  int digits;
  tp_level level;
  bool has_target;
  tp_find_options find; /* key NULL: nothing is to be found */
} arguments;

enum { KEY_FIGURE = 256, KEY_LEVEL, KEY_FIND, KEY_FOR, KEY_FROM, KEY_TO };

static const struct argp_option options[] = {
    {"json", 'j', NULL, 0, "Print the solution as JSON", 0},
    {"table", 't', NULL, 0, "Print a table (Markdown) of several scenes, a row a case", 0},
    {"elements", 'e', NULL, 0, "Print the account of moments by elements too", 0},
    {"figure", KEY_FIGURE, "FILE", 0,
     "Draw the solution into FILE, which ends in .svg, .pdf or .png", 0},
    {"digits", 'd', "N", 0, "Make every number certain to N digits, 1 to 1000 (9 unless given)", 0},
    {"level", KEY_LEVEL, "LEVEL", 0,
     "Let no arithmetic run that is dearer than double, compensated, ball or exact (exact unless "
     "given); exit status 4 where it is not enough",
     0},
    {"find", KEY_FIND, "KEY", 0, "Find the number at KEY, as block.rounded.corners.1.radius", 1},
    {"for", KEY_FOR, "RESULT=VALUE", 0,
     "for which critical_angle, fos, sliding_angle, sliding_fos, limit_angle or limit_fos has the "
     "value",
     1},
    {"from", KEY_FROM, "LOW", 0,
     "Look for it from here (else 0, or ten times what it is where that is below 0)", 1},
    {"to", KEY_TO, "HIGH", 0, "to here (else ten times what it is, or 0 where that is below 0)", 1},
    {0}};

static double read_number(const char *text, struct argp_state *state) {
  char *end = NULL;
  const double value = strtod(text, &end);
  if (end == text || *end != '\0' || !isfinite(value)) {
    tp_cli_refuse(state, "'%s' is no number", text);
  }
  return value;
}

static int read_digits(const char *text, struct argp_state *state) {
  const double digits = read_number(text, state);
  if (!(digits >= 1 && digits <= TP_DIGITS_MAX && digits == floor(digits))) {
    tp_cli_refuse(state, "--digits takes a whole number from 1 to %d, not '%s'", TP_DIGITS_MAX,
                  text);
    return 1;
  }
  return (int)digits;
}

/* RESULT=VALUE */
static void read_target(arguments *a, const char *text, struct argp_state *state) {
  char name[40] = "";
  const char *equals = strchr(text, '=');
  const size_t length = equals != NULL ? (size_t)(equals - text) : 0;
  if (length < sizeof name) memcpy(name, text, length);
  if (equals == NULL || !tp_find_target_read(&a->find.target, name)) {
    tp_cli_refuse(state,
                  "--for takes RESULT=VALUE, RESULT one of critical_angle, fos, sliding_angle, "
                  "sliding_fos, limit_angle, limit_fos; not '%s'",
                  text);
    return;
  }
  a->find.value = read_number(equals + 1, state);
  a->has_target = true;
}

static void read_figure(arguments *a, const char *path, struct argp_state *state) {
  if (!tp_figure_is_file_name(path)) {
    tp_cli_refuse(state, "--figure takes a file that ends in .svg, .pdf or .png, not '%s'", path);
  }
  a->figure = path;
}

static void check_find(arguments *a, struct argp_state *state) {
  const bool named = a->find.key != NULL;
  if (named != a->has_target) tp_cli_refuse(state, "--find KEY and --for RESULT=VALUE go together");
  if ((a->find.has_low || a->find.has_high) && !named)
    tp_cli_refuse(state, "--from and --to go with --find");
  if (named && a->figure != NULL) {
    tp_cli_refuse(state, "--figure draws a solution as the scene has it; leave out --find");
  }
}

static error_t parse(int key, char *argument, struct argp_state *state) {
  arguments *a = state->input;
  switch (key) {
  case 'j':
    a->json = true;
    return 0;
  case 'e':
    a->elements = true;
    return 0;
  case 't':
    a->table = true;
    return 0;
  case 'd':
    a->digits = read_digits(argument, state);
    return 0;
  case KEY_LEVEL:
    if (!tp_level_read(&a->level, argument)) {
      tp_cli_refuse(state, "--level takes double, compensated, ball or exact, not '%s'", argument);
    }
    return 0;
  case KEY_FIGURE:
    read_figure(a, argument, state);
    return 0;
  case KEY_FIND:
    a->find.key = argument;
    return 0;
  case KEY_FOR:
    read_target(a, argument, state);
    return 0;
  case KEY_FROM:
    a->find.low = read_number(argument, state);
    a->find.has_low = true;
    return 0;
  case KEY_TO:
    a->find.high = read_number(argument, state);
    a->find.has_high = true;
    return 0;
  case ARGP_KEY_END:
    check_find(a, state);
    if (a->scene_count > 1 && !a->table) {
      tp_cli_refuse(state, "one scene at a time, or several with --table; '%s' is one too many",
                    a->scenes[1]);
    }
    if (a->table && (a->json || a->elements || a->figure != NULL || a->find.key != NULL)) {
      tp_cli_refuse(state,
                    "--table prints a table alone; drop --json, --elements, --figure and --find");
    }
    return 0;
  case ARGP_KEY_ARGS: /* all that are left */
    a->scenes = state->argv + state->next;
    a->scene_count = state->argc - state->next;
    a->scene = a->scenes[0];
    return 0;
  case ARGP_KEY_NO_ARGS:
    tp_cli_refuse(state, "a scene file is missing, for example examples/block_e_valley.yaml");
    return 0;
  default:
    return ARGP_ERR_UNKNOWN;
  }
}

static const struct argp parser = {
    .options = options,
    .parser = parse,
    .args_doc = "SCENE…",
    .doc = "Does the block of a scene stand, slide or topple, and at which tilt?\v"
           "SCENE is a YAML file; README.md shows one, docs/scene.md lists every key. Every "
           "number is certain to all digits printed; --json gives each with its proven error "
           "bound. Exit status: 0 done, 2 wrong usage, 3 bad input, 4 undecided, 5 system failed."};

/* What a case leaves open, why, and what would help. */
static void print_open(const tp_case *c, const tp_solution *solution, const char *scene) {
  const bool factor = c->limit.fos.state == TP_FOS_UNDECIDED;
  const char *what = c->limit.kind == TP_LIMIT_UNDECIDED ? "the limit by contact forces"
                     : factor                            ? "the factor of safety by contact forces"
                                                         : "the mechanism";
  if (c->mechanism != TP_MECHANISM_UNDECIDED && c->first != TP_MECHANISM_UNDECIDED && !factor) {
    return;
  }
  tp_cli_complain(
      "%s: undecided at %ld bits: %s, tilted towards the %s; %s", scene, solution->bits, what,
      c->towards == TP_TOWARDS_LEFT ? "left" : "right",
      c->limit.too_dear
          ? "its proof takes more work than is allowed: coordinates and loads of fewer digits "
            "help, or a tilt farther from where the block lets go"
          : "what decides it is nearer to a tie than these bits tell, or holds at single tilts "
            "only: a little friction or cohesion, or another tilt, decides it");
}

/* After the report: what it leaves open is a failure of its own. */
static int end_undecided(const tp_solution *solution, const char *scene, int written) {
  if (written != 0 || !tp_solution_is_undecided(solution)) return written;
  for (size_t k = 0; k < solution->case_count; k++) {
    print_open(solution->cases + k, solution, scene);
  }
  return tp_status_exit(TP_UNDECIDED);
}

static tp_status print_solution(const tp_solution *solution, const arguments *a, int *written) {
  char *report = NULL, *account = NULL;
  tp_status status =
      a->json ? tp_report_json(&report, solution) : tp_report_text(&report, solution);
  if (status == TP_OK && a->elements && !a->json) status = tp_report_elements(&account, solution);
  if (status == TP_OK) *written = tp_cli_print(report);
  if (status == TP_OK && *written == 0 && account != NULL) *written = tp_cli_print(account);
  if (status == TP_OK) *written = end_undecided(solution, a->scene, *written);
  free(report);
  free(account);
  return status;
}

static tp_status print_found(const tp_solution *solution, const arguments *a, int *written,
                             tp_message *message) {
  tp_found *found = NULL;
  char *report = NULL;
  tp_status status = tp_find(&found, a->scene, &a->find, message);
  if (status == TP_OK) {
    status = a->json ? tp_report_found_json(&report, found, solution)
                     : tp_report_found(&report, found, &a->find);
  }
  if (status == TP_OK) *written = tp_cli_print(report);
  free(report);
  tp_found_free(found);
  return status;
}

static tp_status solve_scene(tp_solution **solution, const char *path, const arguments *a,
                             tp_message *message) {
  tp_scene *scene = NULL;
  tp_solve_options solve = tp_solve_options_default();
  solve.elements = a->elements;
  solve.digits = a->digits;
  solve.level = a->level;
  tp_status status = tp_scene_read(&scene, path, message);
  if (status == TP_OK) status = tp_solve(solution, scene, &solve, message);
  if (status == TP_OK && a->figure != NULL) {
    status = tp_cli_draw(a->figure, scene, *solution, message);
  }
  tp_scene_free(scene);
  return status;
}

static tp_status print_table(const arguments *a, int *written, tp_message *message) {
  const size_t count = (size_t)a->scene_count;
  char *report = NULL;
  tp_solution **solutions = calloc(count, sizeof *solutions);
  tp_status status = solutions != NULL ? TP_OK : TP_OUT_OF_MEMORY;
  for (size_t k = 0; k < count && status == TP_OK; k++) {
    status = solve_scene(solutions + k, a->scenes[k], a, message);
  }
  if (status == TP_OK) {
    status = tp_report_table(&report, (const tp_solution *const *)solutions, count);
  }
  if (status == TP_OK) *written = tp_cli_print(report);
  for (size_t k = 0; k < count && status == TP_OK; k++) {
    *written = end_undecided(solutions[k], a->scenes[k], *written);
  }
  free(report);
  for (size_t k = 0; solutions != NULL && k < count; k++) tp_solution_free(solutions[k]);
  free(solutions);
  return status;
}

static tp_status print_one(const arguments *a, int *written, tp_message *message) {
  tp_solution *solution = NULL;
  tp_status status = solve_scene(&solution, a->scene, a, message);
  if (status == TP_OK) {
    status = a->find.key != NULL ? print_found(solution, a, written, message)
                                 : print_solution(solution, a, written);
  }
  tp_solution_free(solution);
  return status;
}

int tp_cli_solve(int argc, char **argv) {
  const tp_solve_options unless_given = tp_solve_options_default();
  arguments a = {.digits = unless_given.digits, .level = unless_given.level};
  const int refused = tp_cli_parse(&parser, argc, argv, &a);
  if (refused != 0) return refused;
  tp_message message = {""};
  int written = 0;
  const tp_status status =
      a.table ? print_table(&a, &written, &message) : print_one(&a, &written, &message);
  return tp_cli_end(status, &message, written);
}
