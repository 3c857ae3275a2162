/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* topple derive SCENE: options, the derivation or a family over the number of teeth, and its report
 * (docs/derive.md). */

#include "cli/settings.h"

#include <argp.h>
#include <string.h>

typedef struct arguments {
  const char *scene;
  bool json, for_all_counts;
  tp_derive_options derive;
  tp_cli_settings settings;
} arguments;

enum { KEY_LATEX = 256, KEY_C, KEY_FOR_ALL, KEY_UNCHECKED };

static const struct argp_option options[] = {
    {"json", 'j', NULL, 0, "Print the formulas as JSON", 0},
    {"latex", KEY_LATEX, NULL, 0, "Print LaTeX", 0},
    {"c", KEY_C, NULL, 0, "Print C functions", 0},
    {"elements", 'e', NULL, 0, "Also derive the factor of safety by elements, and list them", 0},
    {"rounded", 'r', NULL, 0, "Also round the corners at the governing pivots", 0},
    {"limit", 'l', NULL, 0, "Also derive the static limit and the onset of motion, in tan(phi)", 0},
    {"unchecked", KEY_UNCHECKED, NULL, 0,
     "Skip the numerical check on both sides of its conditions", 0},
    {"for-all", KEY_FOR_ALL, "count", 0, "One formula for every number of teeth", 0},
    {0}};

static error_t parse(int key, char *argument, struct argp_state *state) {
  arguments *a = state->input;
  switch (key) {
  case 'j':
    a->json = true;
    return 0;
  case 'e':
    a->derive.elements = true;
    return 0;
  case 'r':
    a->derive.rounded = true;
    return 0;
  case 'l':
    a->derive.limit = true;
    return 0;
  case KEY_UNCHECKED:
    a->derive.checked = false;
    return 0;
  case KEY_LATEX:
    a->derive.notation = TP_NOTATION_LATEX;
    return 0;
  case KEY_C:
    a->derive.notation = TP_NOTATION_C;
    return 0;
  case KEY_FOR_ALL:
    if (strcmp(argument, "count") != 0) {
      tp_cli_refuse(state, "--for-all takes 'count', the number of teeth; not '%s'", argument);
    }
    a->for_all_counts = true;
    return 0;
  case ARGP_KEY_INIT:
    state->child_inputs[0] = &a->settings;
    return 0;
  case ARGP_KEY_ARG:
    tp_cli_take_file(&a->scene, argument, "scene", state);
    return 0;
  case ARGP_KEY_NO_ARGS:
    tp_cli_refuse(state, "a scene file is missing, for example examples/block_e_valley.yaml");
    return 0;
  case ARGP_KEY_END:
    if (a->json && a->derive.notation != TP_NOTATION_TEXT) {
      tp_cli_refuse(state, "--json writes its polynomials as text; drop --latex or --c");
    }
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
    .doc = "The closed formulas of a scene in its parameters: area, moments, and for every pivot "
           "the tangent of the critical angle in lowest terms.\v"
           "A parameter that the scene gives by a number is a symbol; one that it gives by an "
           "expression in others is replaced by it. The formulas are exact identities. Exit "
           "status: 0 done, 2 wrong usage, 3 bad input, 4 undecided, 5 system failed."};

static tp_status report_formulas(char **report, const tp_scene *scene, const arguments *a,
                                 tp_message *message) {
  tp_derivation *derivation = NULL;
  tp_status status = tp_derive(&derivation, scene, &a->derive, message);
  if (status == TP_OK) {
    status = a->json ? tp_report_derivation_json(report, derivation)
                     : tp_report_derivation(report, derivation);
  }
  tp_derivation_free(derivation);
  return status;
}

static tp_status report_family(char **report, const tp_scene *scene, const arguments *a,
                               tp_message *message) {
  tp_family *family = NULL;
  tp_status status = tp_derive_family(&family, scene, a->derive.notation, message);
  if (status == TP_OK) {
    status = a->json ? tp_report_family_json(report, family) : tp_report_family(report, family);
  }
  tp_family_free(family);
  return status;
}

static tp_status derive(const void *words, int *ended, tp_message *message) {
  const arguments *a = words;
  tp_scene *scene = NULL;
  char *report = NULL;
  tp_status status = tp_cli_read_scene(&scene, a->scene, &a->settings, message);
  if (status == TP_OK) {
    status = a->for_all_counts ? report_family(&report, scene, a, message)
                               : report_formulas(&report, scene, a, message);
  }
  tp_scene_free(scene);
  return tp_cli_print_report(status, report, ended);
}

int tp_cli_derive(int argc, char **argv) {
  arguments a = {.derive = tp_derive_options_default()};
  return tp_cli_run(&parser, &a, derive, argc, argv);
}
