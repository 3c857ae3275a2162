/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* topple sweep SCENE: options, the sweep over one number or two, and its table written as points
 * are solved (docs/sweep.md). */

#include "cli/settings.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>

typedef struct arguments {
  const char *scene;
  const char *output; /* NULL: the standard output */
  tp_sweep_format format;
  bool json;
  tp_cli_settings settings;
  tp_sweep_options sweep;
} arguments;

enum { KEY_X = 256, KEY_Y, KEY_THREADS, KEY_LEVEL };

static const struct argp_option options[] = {
    {"x", KEY_X, "KEY=FIRST:LAST:STEP", 0,
     "Sweep the number at KEY, as friction_angle_deg=20:40:0.5, or a list, b=60,90,120", 0},
    {"y", KEY_Y, "KEY=FIRST:LAST:STEP", 0, "A second number; x is swept at each of its values", 0},
    {"json", 'j', NULL, 0, "Print JSON instead of CSV", 0},
    {"output", 'o', "FILE", 0, "Write FILE, .csv or .json, whole or not at all", 0},
    {"digits", 'd', "N", 0, "Make every number certain to N digits, 1 to 1000 (9 unless given)", 0},
    {"level", KEY_LEVEL, "LEVEL", 0,
     "Allow no arithmetic costlier than double, compensated, ball or exact (exact unless "
     "given)",
     0},
    {"threads", KEY_THREADS, "N", 0,
     "Number of threads (default: as many as the process may run on)", 0},
    {0}};

static long read_count(const char *text, long most, const char *option,
                       const struct argp_state *state) {
  char *end = NULL;
  const long count = strtol(text, &end, 10);
  if (end == text || *end != '\0' || count < 1 || count > most) {
    tp_cli_refuse(state, "%s takes a whole number from 1 to %ld, not '%s'", option, most, text);
    return 1;
  }
  return count;
}

static void read_output(arguments *a, const char *path, const struct argp_state *state) {
  const char *ending = strrchr(path, '.');
  const bool json = ending != NULL && strcasecmp(ending, ".json") == 0;
  if (!json && (ending == NULL || strcasecmp(ending, ".csv") != 0)) {
    tp_cli_refuse(state, "--output takes a file that ends in .csv or .json, not '%s'", path);
  }
  a->output = path;
  a->format = json ? TP_SWEEP_JSON : TP_SWEEP_CSV;
}

static void check(arguments *a, const struct argp_state *state) {
  if (a->sweep.x == NULL && a->sweep.y == NULL) {
    tp_cli_refuse(state,
                  "the number to sweep is missing, for example --x friction_angle_deg=20:40:0.5");
  } else if (a->sweep.x == NULL) {
    tp_cli_refuse(state, "--y comes beside --x");
  }
  if (a->output != NULL && a->json) {
    tp_cli_refuse(state, "the ending of --output selects the format; drop --json");
  }
  if (a->json) a->format = TP_SWEEP_JSON;
}

static error_t parse(int key, char *argument, struct argp_state *state) {
  arguments *a = state->input;
  switch (key) {
  case KEY_X:
    tp_cli_take_file(&a->sweep.x, argument, "--x", state);
    return 0;
  case KEY_Y:
    tp_cli_take_file(&a->sweep.y, argument, "--y", state);
    return 0;
  case ARGP_KEY_INIT:
    state->child_inputs[0] = &a->settings;
    return 0;
  case 'j':
    a->json = true;
    return 0;
  case 'o':
    read_output(a, argument, state);
    return 0;
  case 'd':
    a->sweep.digits = (int)read_count(argument, TP_DIGITS_MAX, "--digits", state);
    return 0;
  case KEY_LEVEL:
    if (!tp_level_read(&a->sweep.level, argument)) {
      tp_cli_refuse(state, "--level takes double, compensated, ball or exact, not '%s'", argument);
    }
    return 0;
  case KEY_THREADS:
    a->sweep.threads = (size_t)read_count(argument, 1024, "--threads", state);
    return 0;
  case ARGP_KEY_ARG:
    tp_cli_take_file(&a->scene, argument, "scene", state);
    return 0;
  case ARGP_KEY_NO_ARGS:
    tp_cli_refuse(state, "a scene file is missing, for example examples/block_e_valley.yaml");
    return 0;
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
    .children = tp_cli_settings_child,
    .args_doc = "SCENE",
    .doc =
        "Solve a scene at each point of a range of one or two of its numbers, and print a table: "
        "the numbers set, status, verdict, factor and angles, each with its proven bound.\v"
        "Values are exact: 0:1:0.1 goes by 0.3. Each row equals the output of 'topple solve --csv "
        "--set' there. A point that fails is a row with its message, and the exit status reports "
        "it. "
        "Exit status: 0 done, 2 wrong usage, 3 bad input or points of it, 4 points undecided, 5 "
        "system failed."};

static bool print(void *context, const char *text) {
  int *ended = context;
  *ended = tp_cli_print(text);
  return *ended == 0;
}

/* What the table says of single points, once more for all. */
static void tell(const arguments *a, const tp_sweep_summary *s, int *ended) {
  const size_t failed = s->bad + s->without;
  if (failed > 0) {
    tp_cli_complain("%s: %zu of %zu points could not be solved; their rows say why", a->scene,
                    failed, s->count);
    *ended = tp_cli_graver(*ended, tp_status_exit(TP_BAD_INPUT));
  }
  if (s->undecided > 0) {
    tp_cli_complain("%s: %zu of %zu points are undecided, in whole or in part", a->scene,
                    s->undecided, s->count);
    *ended = tp_cli_graver(*ended, tp_status_exit(TP_UNDECIDED));
  }
}

static tp_status sweep(const void *words, int *ended, tp_message *message) {
  const arguments *a = words;
  tp_scene *scene = NULL;
  tp_sweep_summary summary = {.count = 0};
  tp_status status = tp_cli_read_scene(&scene, a->scene, &a->settings, message);
  if (status == TP_OK) {
    status = a->output != NULL
                 ? tp_sweep_write_file(&summary, a->output, scene, &a->sweep, a->format, message)
                 : tp_sweep_write(&summary, scene, &a->sweep, a->format,
                                  (tp_text_sink){print, ended}, message);
  }
  if (status == TP_OK) tell(a, &summary, ended);
  tp_scene_free(scene);
  return status;
}

int tp_cli_sweep(int argc, char **argv) {
  arguments a = {.sweep = tp_sweep_options_default()};
  return tp_cli_run(&parser, &a, sweep, argc, argv);
}
