/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Table of argp options of topple solve, and their readers. */

#include "cli/solve_words.h"

#include "cli/sheet.h"
#include "cli/solve_check.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
  KEY_FIGURE = 256,
  KEY_LEVEL,
  KEY_FIND,
  KEY_FOR,
  KEY_FROM,
  KEY_TO,
  KEY_CSV,
  KEY_FAIL_BELOW,
  KEY_PIVOTS,
  KEY_WRITE_PROFILE,
  KEY_WATCH,
  KEY_REPORT,
  KEY_LANGUAGE,
  KEY_OUTLINES,
  KEY_LEAST_FORCE,
  KEY_ANIMATION
};

static const struct argp_option options[] = {
    {"json", 'j', NULL, 0, "Print the solution as JSON", 0},
    {"table", 't', NULL, 0, "Print a table (Markdown) of several scenes, a row a case", 0},
    {"csv", KEY_CSV, NULL, 0, "The same table as CSV, each number with its error bound", 0},
    {"fail-below", KEY_FAIL_BELOW, "FOS", 0,
     "Return exit status 1 if a case does not certainly reach this design factor of safety, or a "
     "motion can begin; also without a tilt or a friction angle",
     0},
    {"pivots", KEY_PIVOTS, "WHICH", 0,
     "List in JSON all pivots, or those that can govern or hold the block (governing); "
     "default: all, "
     "up to 300",
     0},
    {"outlines", KEY_OUTLINES, NULL, 0,
     "Add the geometry of everything to the JSON, for programs that draw it", 0},
    {"verbose", 'v', NULL, 0,
     "List the effects computed, the input that required them, and their time", 0},
    {"elements", 'e', NULL, 0, "Also print the account of moments by elements", 0},
    {"figure", KEY_FIGURE, "FILE", 0,
     "Draw the solution into FILE, which ends in .svg, .pdf, .png or .dxf, of a solid also in .glb",
     0},
    {"animation", KEY_ANIMATION, "FILE", 0,
     "Draw how many blocks begin to move, magnified, into FILE, which ends in .svg", 0},
    {"report", KEY_REPORT, "FILE", 0,
     "Write a calculation sheet to check and sign into FILE, which ends in .html, .md or .pdf", 0},
    {"language", KEY_LANGUAGE, "CODE", 0,
     "Write the calculation sheet in this language: en, es or de (that of the scene's report, or "
     "en, unless given)",
     0},
    {"write-profile", KEY_WRITE_PROFILE, "FILE", 0,
     "Write the profile of the base into FILE as CSV, with all digits", 0},
    {"digits", 'd', "N", 0, "Make every number certain to N digits, 1 to 1000 (9 unless given)", 0},
    {"level", KEY_LEVEL, "LEVEL", 0,
     "Allow no arithmetic costlier than double, compensated, ball or exact (exact unless "
     "given); exit status 4 where it is not enough",
     0},
    {"watch", KEY_WATCH, NULL, 0,
     "Solve again whenever the scene, or a file that it names, changes; ctrl-C ends", 0},
    {"find", KEY_FIND, "KEY", 0, "Find the number at KEY, as block.rounded.corners.1.radius", 1},
    {"for", KEY_FOR, "RESULT=VALUE", 0,
     "so that critical_angle, fos, sliding_angle, sliding_fos, limit_angle, limit_fos, "
     "onset_angle or governing_fos has the value; of many blocks fos, limit_fos, limit_angle, "
     "fos_goodman_bray or critical_acceleration",
     1},
    {"from", KEY_FROM, "LOW", 0,
     "Begin of the search range (default 0, or ten times its present value if that is below 0)", 1},
    {"to", KEY_TO, "HIGH", 0,
     "End of the search range (default ten times its present value, or 0 if that is below 0)", 1},
    {"least-force", KEY_LEAST_FORCE, NULL, 0,
     "With --find loads.anchors.N.force_kn: turn the anchor or bolt until the force is least", 1},
    TP_CLI_BATCH_OPTIONS(2),
    {0}};

static double read_number(const char *text, struct argp_state *state) {
  char *end = NULL;
  const double value = strtod(text, &end);
  if (end == text || *end != '\0' || !isfinite(value)) {
    tp_cli_refuse(state, "'%s' is not a number", text);
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
static void read_target(tp_solve_words *a, const char *text, struct argp_state *state) {
  char name[40] = "";
  const char *equals = strchr(text, '=');
  const size_t length = equals != NULL ? (size_t)(equals - text) : 0;
  if (length < sizeof name) memcpy(name, text, length);
  if (equals == NULL || !tp_find_target_read(&a->find.target, name)) {
    tp_cli_refuse(state,
                  "--for takes RESULT=VALUE, RESULT one of critical_angle, fos, sliding_angle, "
                  "sliding_fos, limit_angle, limit_fos, onset_angle, governing_fos, of many blocks "
                  "also fos_goodman_bray, critical_acceleration; not '%s'",
                  text);
    return;
  }
  a->find.value = read_number(equals + 1, state);
  a->has_target = true;
}

static void read_figure(tp_solve_words *a, const char *path, struct argp_state *state) {
  if (!tp_figure_is_file_name(path)) {
    tp_cli_refuse(state,
                  "--figure takes a file that ends in .svg, .pdf, .png or .dxf, of a solid .glb, "
                  "not '%s'",
                  path);
  }
  a->figure = path;
}

static void read_pivots(tp_solve_words *a, const char *which, struct argp_state *state) {
  if (strcmp(which, "all") == 0) {
    a->pivots = TP_PIVOTS_ALL;
  } else if (strcmp(which, "governing") == 0) {
    a->pivots = TP_PIVOTS_GOVERNING;
  } else {
    tp_cli_refuse(state, "--pivots takes all or governing, not '%s'", which);
  }
}

static void read_design_fos(tp_solve_words *a, const char *text, struct argp_state *state) {
  a->design_fos = read_number(text, state);
  a->has_design_fos = true;
  if (!(a->design_fos > 0)) {
    tp_cli_refuse(state, "--fail-below takes a factor of safety above 0, not '%s'", text);
  }
}

static error_t parse(int key, char *argument, struct argp_state *state) {
  tp_solve_words *a = state->input;
  if (tp_cli_batch_take(&a->batch, key, argument, state)) return 0;
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
  case KEY_CSV:
    a->csv = true;
    return 0;
  case ARGP_KEY_INIT:
    state->child_inputs[0] = &a->settings;
    return 0;
  case 'v':
    a->verbose = true;
    return 0;
  case KEY_LEAST_FORCE:
    a->least_force = true;
    return 0;
  case KEY_OUTLINES:
    a->outlines = true;
    return 0;
  case KEY_PIVOTS:
    read_pivots(a, argument, state);
    return 0;
  case KEY_FAIL_BELOW:
    read_design_fos(a, argument, state);
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
  case KEY_ANIMATION:
    tp_cli_take_file(&a->animation, argument, "--animation", state);
    return 0;
  case KEY_REPORT:
    tp_cli_take_sheet(&a->report, argument, state);
    return 0;
  case KEY_LANGUAGE:
    tp_cli_take_language(&a->language, argument, state);
    return 0;
  case KEY_WRITE_PROFILE:
    a->profile = argument;
    return 0;
  case KEY_WATCH:
    a->watch = true;
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
    tp_solve_words_check(a, state);
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

const struct argp tp_solve_parser = {
    .options = options,
    .parser = parse,
    .children = tp_cli_settings_child,
    .args_doc = "SCENE…",
    .doc = "Does the block of a scene stand, slide or topple, and at which tilt?\v"
           "SCENE is a YAML file; README.md shows one, docs/scene.md lists every key. Every "
           "solved number is certain to all digits printed, for the model as given; --json gives "
           "each with its proven error bound. The method of Goodman and Bray has no such bound. "
           "Exit status: 0 done, 1 below the design FoS, 2 wrong usage, 3 bad input, 4 undecided, "
           "5 system failed."};

tp_solve_words tp_solve_words_default(void) {
  const tp_solve_options solve = tp_solve_options_default();
  return (tp_solve_words){.digits = solve.digits,
                          .level = solve.level,
                          .find = tp_find_options_default(),
                          .batch = {.options = tp_batch_options_default()}};
}
