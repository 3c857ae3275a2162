/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* topple accuracy SCENE, or --sweep: options, the measurement, its report and its chart
 * (docs/accuracy.md). */

#include "cli/settings.h"

#include <argp.h>
#include <stdlib.h>
#include <string.h>

typedef struct arguments {
  const char *scene;
  bool json, sweep;
  size_t least, most;
  const char *output; /* NULL: the page */
  tp_chart_format format;
  tp_cli_settings settings;
} arguments;

enum { KEY_SWEEP = 256 };

static const struct argp_option options[] = {
    {"json", 'j', NULL, 0, "Print the measurements as JSON", 0},
    {"output", 'o', "FILE", 0, "Write a figure, or a table where FILE ends in .csv", 0},
    {"sweep", KEY_SWEEP, "FROM:TO", OPTION_ARG_OPTIONAL,
     "Measure rough blocks of FROM to TO vertices (10:10000000 unless given) instead of a scene",
     0},
    {0}};

static void read_sweep(arguments *a, const char *text, struct argp_state *state) {
  a->sweep = true;
  if (text == NULL) return;
  char *end = NULL;
  const unsigned long least = strtoul(text, &end, 10);
  const bool colon = end != text && *end == ':';
  const char *second = colon ? end + 1 : end;
  const unsigned long most = strtoul(second, &end, 10);
  if (!colon || end == second || *end != '\0' || strchr(text, '-') != NULL) {
    tp_cli_refuse(state, "--sweep takes FROM:TO in vertices, not '%s'", text);
  }
  a->least = least;
  a->most = most;
}

static error_t parse(int key, char *argument, struct argp_state *state) {
  arguments *a = state->input;
  switch (key) {
  case 'j':
    a->json = true;
    return 0;
  case 'o':
    a->output = argument;
    if (!tp_chart_format_read(&a->format, argument)) {
      tp_cli_refuse(state, "--output takes a file that ends in .svg, .pdf, .png or .csv, not '%s'",
                    argument);
    }
    return 0;
  case KEY_SWEEP:
    read_sweep(a, argument, state);
    return 0;
  case ARGP_KEY_INIT:
    state->child_inputs[0] = &a->settings;
    return 0;
  case ARGP_KEY_ARG:
    tp_cli_take_file(&a->scene, argument, "scene", state);
    return 0;
  case ARGP_KEY_END:
    if (a->sweep == (a->scene != NULL)) {
      tp_cli_refuse(state, "give a scene, for example examples/block_a_worn.yaml, or --sweep");
    }
    if (a->sweep && tp_cli_settings_given(&a->settings)) {
      tp_cli_refuse(state, "--set and --unit apply to a scene, and --sweep generates its own "
                           "blocks; not both");
    }
    if (a->json && a->output != NULL) tp_cli_refuse(state, "--json or --output, not both");
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
    .doc = "Cost of accuracy: time, proven bound and true error of every arithmetic\v"
           "Every method for the critical angle, the static limit and the onset of motion that "
           "SCENE requires is evaluated in doubles, in compensated doubles, in balls of 53 to 4096 "
           "bits and exactly; angles are compared with their values at 6144 bits. docs/accuracy.md "
           "explains how to read it."};

static tp_status measure(tp_accuracy **accuracy, const arguments *a, tp_message *message) {
  if (a->sweep) return tp_accuracy_sweep(accuracy, a->least, a->most, message);
  tp_scene *scene = NULL;
  tp_status status = tp_cli_read_scene(&scene, a->scene, &a->settings, message);
  if (status == TP_OK) status = tp_accuracy_of_scene(accuracy, scene, message);
  tp_scene_free(scene);
  return status;
}

static tp_status draw(const tp_accuracy *accuracy, const arguments *a, tp_message *message) {
  tp_chart *chart = NULL;
  tp_status status = tp_chart_accuracy(&chart, accuracy, message);
  if (status == TP_OK) status = tp_report_chart_file(a->output, chart, a->format, message);
  tp_chart_free(chart);
  return status;
}

static tp_status print(const tp_accuracy *accuracy, const arguments *a, int *ended) {
  char *text = NULL;
  const tp_status status =
      a->json ? tp_report_accuracy_json(&text, accuracy) : tp_report_accuracy(&text, accuracy);
  return tp_cli_print_report(status, text, ended);
}

static tp_status measure_and_tell(const void *words, int *ended, tp_message *message) {
  const arguments *a = words;
  tp_accuracy *accuracy = NULL;
  tp_status status = measure(&accuracy, a, message);
  if (status == TP_OK) {
    status = a->output != NULL ? draw(accuracy, a, message) : print(accuracy, a, ended);
  }
  tp_accuracy_free(accuracy);
  return status;
}

int tp_cli_accuracy(int argc, char **argv) {
  arguments a = {.least = 10, .most = 10000000};
  return tp_cli_run(&parser, &a, measure_and_tell, argc, argv);
}
