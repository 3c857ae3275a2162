/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* topple tilt SCENE: options, the simulated test, its report, drawings, charts and sheet
 * (docs/tilt.md). */

#include "cli/settings.h"
#include "cli/sheet.h"
#include "cli/signals.h"
#include "cli/tilt_charts.h"
#include "cli/tilt_converge.h"

#include <stdlib.h>
#include <unistd.h>

typedef struct arguments {
  const char *scene;
  const char *figure, *animation, *report; /* NULL: none */
  const char *language;                    /* of the report; NULL: the scene's, or English */
  tp_tilt_charts charts;
  bool json, csv, converge;
  tp_chart_format format; /* of the figure of --converge */
  tp_cli_settings settings;
  tp_tilt_options tilt;
} arguments;

enum {
  KEY_CSV = 256,
  KEY_FIGURE,
  KEY_ANIMATION,
  KEY_REACTIONS,
  KEY_PHASE,
  KEY_SPECTRUM,
  KEY_FREQUENCIES,
  KEY_MOMENTS,
  KEY_OVERTURNING,
  KEY_FACTORS,
  KEY_SMALLER,
  KEY_CONVERGE,
  KEY_REPORT,
  KEY_LANGUAGE
};

static const struct argp_option options[] = {
    {"json", 'j', NULL, 0, "Print JSON instead of text", 0},
    {"csv", KEY_CSV, NULL, 0, "Print the moments of the motion as CSV instead of text", 0},
    {"figure", KEY_FIGURE, "FILE", 0, "Write FILE, .svg, with the block at some moments", 0},
    {"animation", KEY_ANIMATION, "FILE", 0,
     "Write FILE, .svg, .webm or .gif, in which the block moves", 0},
    {"reactions", KEY_REACTIONS, "FILE", 0,
     "Write FILE, .svg, .pdf, .png or .csv, with the reactions of the facets against the tilt", 0},
    {"phase", KEY_PHASE, "FILE", 0,
     "Write FILE likewise, with the phase portraits of what moves: turn against angular velocity",
     0},
    {"spectrum", KEY_SPECTRUM, "FILE", 0,
     "Write FILE likewise, with the overturning spectrum: the least PGA that overturns the block, "
     "against frequency and PGV",
     0},
    {"frequencies", KEY_FREQUENCIES, "FROM:TO:COUNT", 0,
     "Frequencies of the spectrum, in hertz; for a record, factors on its speed (an eighth "
     "to eight times the scene's, 25)",
     0},
    {"report", KEY_REPORT, "FILE", 0,
     "Write a calculation sheet to check and sign into FILE, which ends in .html, .md or .pdf", 0},
    {"language", KEY_LANGUAGE, "CODE", 0,
     "Write the calculation sheet in this language: en, es or de (that of the scene's report, or "
     "English)",
     0},
    {"moments", KEY_MOMENTS, "N", 0, "Number of moments of the motion to keep (default 400)", 0},
    {"overturning", KEY_OVERTURNING, NULL, 0,
     "Scan factors on the shaking of the scene for those that overturn the block", 0},
    {"factors", KEY_FACTORS, "FROM:TO:COUNT", 0,
     "Factors for --overturning, evenly on a logarithmic axis (65 from 1/16 to 16, then by 0.5 % "
     "the octave below the least that overturns)",
     0},
    {"smaller", KEY_SMALLER, "N", 0,
     "Number of smaller factors on the shaking that are tried, over the octave below 1, where it "
     "does not overturn the block (default 128; 0: none)",
     0},
    {"converge", KEY_CONVERGE, NULL, 0,
     "Run the test over stiffness, time step, damping and tolerance instead, each with its cost; "
     "with --figure FILE, .svg, .pdf, .png or .csv, the answer against cost",
     0},
    {0}};

static void read_moments(arguments *a, const char *text, const struct argp_state *state) {
  char *end = NULL;
  const long count = strtol(text, &end, 10);
  if (end == text || *end != '\0' || count < 2 || count > 1000000) {
    tp_cli_refuse(state, "--moments takes a whole number from 2 to 1000000, not '%s'", text);
    return;
  }
  a->tilt.moments = (size_t)count;
}

static void read_smaller(arguments *a, const char *text, const struct argp_state *state) {
  char *end = NULL;
  const long count = strtol(text, &end, 10);
  if (end == text || *end != '\0' || count < 0 || count > 100000) {
    tp_cli_refuse(state, "--smaller takes a whole number from 0 to 100000, not '%s'", text);
    return;
  }
  a->tilt.smaller_count = (size_t)count;
}

static void check_converge(arguments *a, const struct argp_state *state) {
  const tp_tilt_charts *charts = &a->charts;
  if (a->csv || a->report != NULL || a->animation != NULL || a->tilt.overturning ||
      charts->reactions.path != NULL || charts->phase.path != NULL ||
      charts->spectrum.path != NULL) {
    tp_cli_refuse(state,
                  "--converge runs many tests: --csv, --report, --animation, --reactions, --phase, "
                  "--spectrum and --overturning apply to a single test");
  } else if (a->figure != NULL && !tp_chart_format_read(&a->format, a->figure)) {
    tp_cli_refuse(state,
                  "the figure of --converge is a file that ends in .svg, .pdf, .png or "
                  ".csv, not '%s'",
                  a->figure);
  }
}

static void refuse_same_files(const arguments *a, const struct argp_state *state) {
  const tp_cli_written files[] = {
      {"--figure", a->figure}, {"--animation", a->animation}, {"--report", a->report}};
  tp_cli_check_language(a->language, a->report, state);
  tp_cli_refuse_same_files(files, sizeof files / sizeof files[0], state);
}

static error_t parse(int key, char *argument, struct argp_state *state) {
  arguments *a = state->input;
  switch (key) {
  case ARGP_KEY_INIT:
    state->child_inputs[0] = &a->settings;
    return 0;
  case 'j':
    a->json = true;
    return 0;
  case KEY_CSV:
    a->csv = true;
    return 0;
  case KEY_FIGURE:
    tp_cli_take_file(&a->figure, argument, "--figure", state);
    return 0;
  case KEY_ANIMATION:
    tp_cli_take_file(&a->animation, argument, "--animation", state);
    return 0;
  case KEY_REACTIONS:
    tp_tilt_charts_take(&a->charts.reactions, argument, "--reactions", state);
    return 0;
  case KEY_PHASE:
    tp_tilt_charts_take(&a->charts.phase, argument, "--phase", state);
    return 0;
  case KEY_SPECTRUM:
    tp_tilt_charts_take(&a->charts.spectrum, argument, "--spectrum", state);
    return 0;
  case KEY_FREQUENCIES:
    tp_tilt_charts_frequencies(&a->charts, argument, state);
    return 0;
  case KEY_REPORT:
    tp_cli_take_sheet(&a->report, argument, state);
    return 0;
  case KEY_LANGUAGE:
    tp_cli_take_language(&a->language, argument, state);
    return 0;
  case KEY_MOMENTS:
    read_moments(a, argument, state);
    return 0;
  case KEY_OVERTURNING:
    a->tilt.overturning = true;
    return 0;
  case KEY_FACTORS:
    tp_tilt_charts_factors(&a->tilt, argument, state);
    return 0;
  case KEY_SMALLER:
    read_smaller(a, argument, state);
    return 0;
  case KEY_CONVERGE:
    a->converge = true;
    return 0;
  case ARGP_KEY_ARG:
    tp_cli_take_file(&a->scene, argument, "scene", state);
    return 0;
  case ARGP_KEY_NO_ARGS:
    tp_cli_refuse(state, "a scene file is missing, for example examples/tilt_block_e_valley.yaml");
    return 0;
  case ARGP_KEY_END:
    if (a->json && a->csv) tp_cli_refuse(state, "--json and --csv are one or the other");
    if (a->tilt.overturning_count > 0 && !a->tilt.overturning) {
      tp_cli_refuse(state, "--factors belongs to --overturning, which is missing");
    }
    if (a->converge) check_converge(a, state);
    refuse_same_files(a, state);
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
    .doc = "Simulate the tilt test, or the shaking of the base, that a scene specifies by "
           "'tilt_test' or 'shaking': at which tilt the block begins to move and how, what its "
           "contacts do meanwhile, and where it ends.\v"
           "Simulated numbers have no proven bound; the tilts of statics, which have one, are "
           "given beside them. An interrupted test reports the results so far. Exit status: 0 "
           "done, 2 wrong "
           "usage, 3 bad input, 4 undecided or not converged, 5 system failed."};

/* What is undecided, told once more. */
static void tell_open(const arguments *a, const tp_tilt_test *test, int *ended) {
  for (size_t k = 0; k < test->case_count; k++) {
    const tp_tilt_case *own = test->cases + k;
    if (own->converged && own->end != TP_TILT_OPEN && own->end != TP_TILT_STOPPED) continue;
    tp_cli_complain("%s: tilted towards the %s, the test is %s", a->scene,
                    own->towards == TP_TOWARDS_LEFT ? "left" : "right",
                    own->end == TP_TILT_STOPPED ? "interrupted"
                    : own->converged            ? "undecided at its end"
                                                : "not converged to the tolerance");
    *ended = tp_cli_graver(*ended, tp_status_exit(TP_UNDECIDED));
  }
}

static tp_status write_sheet(const arguments *a, const tp_scene *scene, const tp_tilt_test *test,
                             tp_message *message) {
  tp_sheet_options sheet;
  tp_cli_date date;
  const tp_status status = tp_cli_sheet_options(&sheet, &date, message);
  sheet.language = a->language;
  return status == TP_OK ? tp_cli_write_tilt_sheet(a->report, scene, test, &sheet, message)
                         : status;
}

static tp_status tell(const arguments *a, const tp_scene *scene, const tp_tilt_test *test,
                      int *ended, tp_message *message) {
  char *report = NULL;
  tp_status status = a->json  ? tp_report_tilt_json(&report, test)
                     : a->csv ? tp_report_tilt_csv(&report, test)
                              : tp_report_tilt(&report, test);
  status = tp_cli_print_report(status, report, ended);
  if (status == TP_OK && *ended == 0 && a->figure != NULL) {
    status = tp_report_tilt_file(a->figure, test, false, message);
  }
  if (status == TP_OK && *ended == 0 && a->animation != NULL) {
    status = tp_report_tilt_file(a->animation, test, true, message);
  }
  if (status == TP_OK && *ended == 0) status = tp_tilt_charts_write(&a->charts, test, message);
  if (status == TP_OK && *ended == 0 && a->report != NULL) {
    status = write_sheet(a, scene, test, message);
  }
  if (status == TP_OK && *ended == 0) tell_open(a, test, ended);
  return status;
}

static void tell_progress(void *context, size_t runs, double least_deg, double most_deg) {
  (void)context;
  tp_cli_tell_bracket(runs, least_deg, most_deg);
}

static tp_status tilt(const void *words, int *ended, tp_message *message) {
  const arguments *a = words;
  const bool terminal = isatty(STDERR_FILENO) == 1;
  tp_tilt_options own = a->tilt;
  tp_scene *scene = NULL;
  tp_tilt_test *test = NULL;
  own.stop = tp_cli_is_interrupted;
  own.progress = terminal ? tell_progress : NULL;
  tp_status status = tp_cli_read_scene(&scene, a->scene, &a->settings, message);
  if (status == TP_OK) {
    tp_cli_catch_signals();
    if (a->converge) {
      const tp_cli_converge asked = {a->scene, a->figure, a->format, a->json};
      status = tp_cli_tilt_converge(&asked, scene, &own, ended, message);
    } else {
      status = tp_tilt_test_run(&test, scene, &own, message);
      if (terminal) tp_cli_clear_progress();
      if (status == TP_OK) status = tell(a, scene, test, ended, message);
      if (status == TP_OK) {
        status = tp_tilt_charts_spectrum(&a->charts, scene, a->scene, ended, message);
      }
    }
  }
  tp_tilt_test_free(test);
  tp_scene_free(scene);
  return status;
}

int tp_cli_tilt(int argc, char **argv) {
  arguments a = {.tilt = tp_tilt_options_default(),
                 .charts = {.overturning = tp_overturning_options_default()}};
  const int status = tp_cli_run(&parser, &a, tilt, argc, argv);
  tp_cli_end_by_signal();
  return status;
}
