/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* topple profile FILE: a scene, or a drawing, by its name, else a CSV file of x, y. */

#include "cli/settings.h"

#include <argp.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct arguments {
  const char *file;
  bool json, csv, all;
  const char *output; /* NULL: the page */
  tp_chart_format format;
  tp_profile_options options;
  tp_cli_settings settings; /* of a scene; the unit of a CSV file too */
} arguments;

enum {
  KEY_STEP = 256,
  KEY_RESAMPLE,
  KEY_DETREND,
  KEY_WINDOW,
  KEY_MIRROR,
  KEY_SCALE,
  KEY_JCS,
  KEY_STRESS,
  KEY_CSV,
  KEY_ALL
};

static const struct argp_option options[] = {
    {"step", KEY_STEP, "LENGTH", 0, "Sample the profile anew at this distance", 0},
    {"resample", KEY_RESAMPLE, "HOW", 0, "Between the points: linear or spline", 0},
    {"detrend", KEY_DETREND, "LINE", 0,
     "Subtract a line: none, line (of least squares) or ends (through both); or turn the profile "
     "onto "
     "its mean plane: turn",
     0},
    {"window", KEY_WINDOW, "WINDOW", 0, "Window of the spectrum: hann or none", 0},
    {"mirror", KEY_MIRROR, NULL, 0, "Exchange left and right", 0},
    {"scale", KEY_SCALE, "FACTOR", 0, "Multiply all lengths", 0},
    {"jcs", KEY_JCS, "MPA", 0, "Joint wall compressive strength, for JRC by Eq. (10)", 0},
    {"stress", KEY_STRESS, "KPA", 0,
     "Normal stress, for JRC by Eq. (10); default for a scene: that of the block", 0},
    {"json", 'j', NULL, 0, "Print the numbers as JSON", 0},
    {"all", KEY_ALL, NULL, 0, "With --json: every facet and every ordinate of the spectrum", 0},
    {"csv", KEY_CSV, NULL, 0, "Print the facets as CSV", 0},
    {"output", 'o', "FILE", 0, "Write a figure, or its numbers where FILE ends in .csv", 0},
    {0}};

static double read_above_zero(const char *name, const char *text, struct argp_state *state) {
  char *end = NULL;
  const double value = strtod(text, &end);
  if (end == text || *end != '\0' || !isfinite(value) || value <= 0) {
    tp_cli_refuse(state, "--%s takes a number above 0, not '%s'", name, text);
  }
  return value;
}

static void read_output(arguments *a, const char *path, struct argp_state *state) {
  a->output = path;
  if (tp_chart_format_read(&a->format, path)) return;
  tp_cli_refuse(state, "--output takes a file that ends in .svg, .pdf, .png or .csv, not '%s'",
                path);
}

static void check(const arguments *a, struct argp_state *state) {
  if (a->file == NULL) {
    tp_cli_refuse(state, "give a CSV file of x, y or a scene, for example "
                         "examples/joint_profile.csv");
  }
  if (a->json + a->csv + (a->output != NULL) > 1) {
    tp_cli_refuse(state, "one of --json, --csv and --output");
  }
  if (a->settings.count > 0 && a->file != NULL && !tp_cli_is_scene(a->file)) {
    tp_cli_refuse(state, "--set changes a scene, and '%s' is a file of points", a->file);
  }
  if (a->all && !a->json) tp_cli_refuse(state, "--all goes with --json");
}

/* What the profile is made of, and JRC by Eq. (10). */
static error_t parse_measure(int key, char *argument, struct argp_state *state) {
  arguments *a = state->input;
  tp_profile_options *o = &a->options;
  switch (key) {
  case KEY_STEP:
    o->step = read_above_zero("step", argument, state);
    return 0;
  case KEY_RESAMPLE:
    if (!tp_profile_resampling_read(&o->resampling, argument)) {
      tp_cli_refuse(state, "--resample takes linear or spline, not '%s'", argument);
    }
    return 0;
  case KEY_DETREND:
    if (!tp_profile_detrend_read(&o->detrend, argument)) {
      tp_cli_refuse(state, "--detrend takes none, line, ends or turn, not '%s'", argument);
    }
    return 0;
  case KEY_WINDOW:
    if (!tp_profile_window_read(&o->window, argument)) {
      tp_cli_refuse(state, "--window takes hann or none, not '%s'", argument);
    }
    return 0;
  case KEY_MIRROR:
    o->mirrored = true;
    return 0;
  case KEY_SCALE:
    o->scale = read_above_zero("scale", argument, state);
    return 0;
  case KEY_JCS:
    o->jcs_mpa = read_above_zero("jcs", argument, state);
    return 0;
  case KEY_STRESS:
    o->normal_stress_kpa = read_above_zero("stress", argument, state);
    return 0;
  default:
    return ARGP_ERR_UNKNOWN;
  }
}

static error_t parse(int key, char *argument, struct argp_state *state) {
  arguments *a = state->input;
  switch (key) {
  case 'j':
    a->json = true;
    return 0;
  case KEY_ALL:
    a->all = true;
    return 0;
  case KEY_CSV:
    a->csv = true;
    return 0;
  case 'o':
    read_output(a, argument, state);
    return 0;
  case ARGP_KEY_INIT:
    state->child_inputs[0] = &a->settings;
    return 0;
  case ARGP_KEY_ARG:
    tp_cli_take_file(&a->file, argument, "file", state);
    return 0;
  case ARGP_KEY_END:
    check(a, state);
    return 0;
  default:
    return parse_measure(key, argument, state);
  }
}

static const struct argp parser = {
    .options = options,
    .parser = parse,
    .children = tp_cli_settings_child,
    .args_doc = "FILE",
    .doc = "The roughness of a profile, and the JRC that follows from it\v"
           "FILE is a CSV file of x, y from left to right, or a scene or a drawing, whose base is "
           "measured. Lengths are in the file's unit; --unit gives that of a CSV file, too "
           "(default mm). docs/profile.md explains each number."};

static tp_status measure(tp_profile **profile, const arguments *a, tp_message *message) {
  const char *unit = a->settings.unit;
  if (!tp_cli_is_scene(a->file)) {
    return tp_profile_of_file(profile, a->file, unit != NULL ? unit : "mm", &a->options, message);
  }
  tp_scene *scene = NULL;
  tp_status status = tp_cli_read_scene(&scene, a->file, &a->settings, message);
  if (status == TP_OK) status = tp_profile_of_scene(profile, scene, &a->options, message);
  tp_scene_free(scene);
  return status;
}

static tp_status draw(const tp_profile *profile, const arguments *a, tp_message *message) {
  tp_chart *chart = NULL;
  tp_status status = tp_chart_profile(&chart, profile, message);
  if (status == TP_OK) status = tp_report_chart_file(a->output, chart, a->format, message);
  tp_chart_free(chart);
  return status;
}

static tp_status print(const tp_profile *profile, const arguments *a, int *ended) {
  char *text = NULL;
  const tp_status status = a->json  ? tp_report_profile_json(&text, profile, a->all)
                           : a->csv ? tp_report_profile_csv(&text, profile)
                                    : tp_report_profile(&text, profile);
  return tp_cli_print_report(status, text, ended);
}

static tp_status measure_and_tell(const void *words, int *ended, tp_message *message) {
  const arguments *a = words;
  tp_profile *profile = NULL;
  tp_status status = measure(&profile, a, message);
  if (status == TP_OK) {
    status = a->output != NULL ? draw(profile, a, message) : print(profile, a, ended);
  }
  tp_profile_free(profile);
  return status;
}

int tp_cli_profile(int argc, char **argv) {
  arguments a = {.options = tp_profile_options_default()};
  return tp_cli_run(&parser, &a, measure_and_tell, argc, argv);
}
