/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Table of argp options of topple chart, readers of numbers, lists, ranges and axes, and the checks
 * of what goes together. */

#include "cli/chart_options.h"

#include "cli/words.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

const char *const tp_chart_kinds[TP_CHART_KINDS] = {"fos", "mechanisms", "ranges", "map"};

enum {
  KEY_SLENDERNESS = 256,
  KEY_AMPLITUDE,
  KEY_COUNTS,
  KEY_TILT,
  KEY_FRICTION,
  KEY_ROUGHNESS,
  KEY_CONTOURS,
  KEY_ANY_TILT
};

static const struct argp_option options[] = {
    {"output", 'o', "FILE", 0, "Write FILE: .svg, .pdf, .png, or .csv", 0},
    {"json", 'j', NULL, 0, "Print the numbers as JSON", 0},
    {NULL, 0, NULL, 0, "For fos:", 1},
    {"inverse-slenderness", KEY_SLENDERNESS, "LIST", 0, "Δx/y, as 0.5,0.75,1", 1},
    {"amplitude", KEY_AMPLITUDE, "LIST", 0, "A/y, as 0.05,0.1; for mechanisms: one number", 1},
    {"sub-blocks", KEY_COUNTS, "LIST", 0, "N, as 2,3: exact blocks instead of Eqs. (15) to (17)",
     1},
    {"tilt", KEY_TILT, "FROM:TO", 0, "Tilt angles, degrees", 1},
    {NULL, 0, NULL, 0, "For mechanisms:", 2},
    {"friction", KEY_FRICTION, "DEGREES", 0, "φ_b (30)", 2},
    {"roughness-angle", KEY_ROUGHNESS, "DEGREES", 0, "i (10)", 2},
    {NULL, 0, NULL, 0, "For map:", 3},
    {"x", 'x', "KEY=FROM:TO", 0, "A number of the scene, as block.slab.width, or tilt", 3},
    {"y", 'y', "KEY=FROM:TO", 0, "The same for the vertical axis (tilt=0:90)", 3},
    {"contours", KEY_CONTOURS, "WHAT[=LIST]", 0,
     "Contours of critical_angle or governing_fos; levels as 1,1.3,1.5", 3},
    {"any-tilt", KEY_ANY_TILT, NULL, 0, "The first motion, whatever the scene's tilt", 3},
    {0}};

/* A decimal or a quotient of two, up to the first character that belongs to none. */
static double read_number(const char **text, struct argp_state *state) {
  char *end = NULL;
  const char *begin = *text;
  double value = strtod(begin, &end);
  bool good = end != begin;
  if (good && *end == '/') {
    const char *divisor = end + 1;
    value /= strtod(divisor, &end);
    good = end != divisor;
  }
  if (!good || !isfinite(value)) tp_cli_refuse(state, "'%s' does not begin with a number", begin);
  *text = end;
  return value;
}

static double read_whole(const char *text, struct argp_state *state) {
  const char *end = text;
  const double value = read_number(&end, state);
  if (*end != '\0') tp_cli_refuse(state, "'%s' is not a number", text);
  return value;
}

static void read_list(tp_chart_list *list, double values[TP_CHART_LIST_MAX], const char *text,
                      struct argp_state *state) {
  const char *at = text;
  list->values = values;
  for (list->count = 0; list->count < TP_CHART_LIST_MAX; at++) {
    values[list->count++] = read_number(&at, state);
    if (*at == '\0') return;
    if (*at != ',') break;
  }
  tp_cli_refuse(state, "'%s' is not a list of up to %d numbers, as 0.5,0.75,1", text,
                TP_CHART_LIST_MAX);
}

static void read_range(tp_chart_range *range, const char *text, struct argp_state *state) {
  const char *at = text;
  range->from = read_number(&at, state);
  const bool two = *at == ':';
  if (two) {
    at++;
    range->to = read_number(&at, state);
  }
  if (!two || *at != '\0') tp_cli_refuse(state, "'%s' is not a range, as 10:60", text);
  if (!(range->from < range->to)) {
    tp_cli_refuse(state, "the range '%s' must rise: write the lesser end first", text);
  }
}

static void read_axis(tp_chart_axis *axis, char key[TP_CHART_KEY_SIZE], const char *text,
                      struct argp_state *state) {
  const char *equals = strchr(text, '=');
  const size_t length = equals != NULL ? (size_t)(equals - text) : 0;
  if (length >= TP_CHART_KEY_SIZE) {
    tp_cli_refuse(state, "the key in '%s' is longer than %d bytes; give a parameter a shorter name",
                  text, TP_CHART_KEY_SIZE - 1);
    return;
  }
  if (length == 0) {
    tp_cli_refuse(state, "'%s' is not KEY=FROM:TO, as block.slab.width=0.2:1.5", text);
    return;
  }
  memcpy(key, text, length);
  key[length] = '\0';
  axis->key = key;
  read_range(&axis->range, equals + 1, state);
}

static void read_contours(tp_chart_arguments *a, const char *text, struct argp_state *state) {
  static const char fos[] = "governing_fos", angle[] = "critical_angle";
  const size_t length = strcspn(text, "=");
  a->map.governing_fos = length == strlen(fos) && strncmp(text, fos, length) == 0;
  if (!a->map.governing_fos && (length != strlen(angle) || strncmp(text, angle, length) != 0)) {
    tp_cli_refuse(state, "'%s' has no contours; known are %s and %s", text, angle, fos);
  }
  a->map.levels.count = 0;
  if (text[length] == '=') read_list(&a->map.levels, a->lists[3], text + length + 1, state);
}

static void read_output(tp_chart_arguments *a, const char *path, struct argp_state *state) {
  a->output = path;
  if (!tp_chart_format_read(&a->format, path)) {
    tp_cli_refuse(state, "'%s' must end in .svg, .pdf, .png or .csv", path);
  }
}

static void read_argument(tp_chart_arguments *a, const char *text, struct argp_state *state) {
  if (a->has_kind && a->kind == TP_CHART_KIND_MAP && a->scene == NULL) {
    a->scene = text;
    return;
  }
  if (a->has_kind) tp_cli_refuse(state, "'%s' is one too many", text);
  for (int k = 0; k < TP_CHART_KINDS; k++) {
    if (strcmp(text, tp_chart_kinds[k]) != 0) continue;
    a->kind = (tp_chart_kind)k;
    a->has_kind = true;
    return;
  }
  tp_cli_refuse(state, "'%s' is not a kind of chart; known are fos, mechanisms, ranges and map",
                text);
}

static void check(tp_chart_arguments *a, struct argp_state *state) {
  const tp_chart_list *amplitude = &a->fos.amplitude;
  if (tp_cli_settings_given(&a->settings)) a->given |= 1U << TP_CHART_KIND_MAP;
  if (a->has_amplitude && a->kind == TP_CHART_KIND_MECHANISMS) {
    if (amplitude->count > 1) tp_cli_refuse(state, "a map of mechanisms takes one amplitude");
    a->mechanisms.amplitude = amplitude->values[0];
  } else if (a->has_amplitude) {
    a->given |= 1U << TP_CHART_KIND_FOS;
  }
  if ((a->given & ~(1U << a->kind)) != 0) {
    tp_cli_refuse(state, "an option for another kind of chart was given to '%s'",
                  tp_chart_kinds[a->kind]);
  }
  if (a->json && a->output != NULL) tp_cli_refuse(state, "--json prints; drop --output");
  if (a->kind != TP_CHART_KIND_MAP) return;
  if (a->scene == NULL) {
    tp_cli_refuse(state, "a scene file is missing, for example examples/slab.yaml");
  }
  if (a->map.x.key == NULL) {
    tp_cli_refuse(state, "a map takes --x KEY=FROM:TO, as --x block.slab.width=20:150");
  }
}

static error_t parse(int key, char *argument, struct argp_state *state) {
  tp_chart_arguments *a = state->input;
  const unsigned fos = 1U << TP_CHART_KIND_FOS, mechanisms = 1U << TP_CHART_KIND_MECHANISMS,
                 map = 1U << TP_CHART_KIND_MAP;
  switch (key) {
  case 'o':
    read_output(a, argument, state);
    return 0;
  case 'j':
    a->json = true;
    return 0;
  case KEY_SLENDERNESS:
    a->given |= fos;
    read_list(&a->fos.inverse_slenderness, a->lists[0], argument, state);
    return 0;
  case KEY_AMPLITUDE:
    read_list(&a->fos.amplitude, a->lists[1], argument, state);
    a->has_amplitude = true;
    return 0;
  case KEY_COUNTS:
    a->given |= fos;
    read_list(&a->fos.sub_blocks, a->lists[2], argument, state);
    return 0;
  case KEY_TILT:
    a->given |= fos;
    read_range(&a->fos.tilt_deg, argument, state);
    return 0;
  case KEY_FRICTION:
    a->given |= mechanisms;
    a->mechanisms.friction_deg = read_whole(argument, state);
    return 0;
  case KEY_ROUGHNESS:
    a->given |= mechanisms;
    a->mechanisms.roughness_angle_deg = read_whole(argument, state);
    return 0;
  case 'x':
    a->given |= map;
    read_axis(&a->map.x, a->keys[0], argument, state);
    return 0;
  case 'y':
    a->given |= map;
    read_axis(&a->map.y, a->keys[1], argument, state);
    return 0;
  case KEY_CONTOURS:
    a->given |= map;
    read_contours(a, argument, state);
    return 0;
  case KEY_ANY_TILT:
    a->given |= map;
    a->map.any_tilt = true;
    return 0;
  case ARGP_KEY_INIT:
    state->child_inputs[0] = &a->settings;
    return 0;
  case ARGP_KEY_ARG:
    read_argument(a, argument, state);
    return 0;
  case ARGP_KEY_NO_ARGS:
    tp_cli_refuse(state, "the kind of chart is missing: fos, mechanisms, ranges or map");
    return 0;
  case ARGP_KEY_END:
    check(a, state);
    return 0;
  default:
    return ARGP_ERR_UNKNOWN;
  }
}

const struct argp tp_chart_parser = {
    .options = options,
    .parser = parse,
    .children = tp_cli_settings_child,
    .args_doc = "fos\nmechanisms\nranges\nmap SCENE --x KEY=FROM:TO [--y KEY=FROM:TO]",
    .doc =
        "Charts as figures of a journal, and the numbers behind them.\v"
        "fos: factor of safety against tilt about planar, peak and valley axes. mechanisms: "
        "stable, slides, topples, for a planar and a rough base. ranges: critical angles "
        "against the amplitude of roughness. map: the mechanism map of a scene along one or two "
        "of its numbers, with certified borders. docs/chart.md shows them. Without --output the "
        "numbers go to stdout as CSV; figures are drawn by gnuplot. Exit status: 0 done, 2 wrong "
        "usage, 3 bad input, 4 undecided, 5 system failed."};
