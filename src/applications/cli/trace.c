/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* topple trace IMAGE: by a library that is loaded for it, as OpenCV takes long to load. */

#include "cli/cli.h"
#include "cli/library.h"
#include "cli/new_answers.h"
#include "cli/sheet.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* tp_trace_run of src/applications/trace/trace.h. */
typedef tp_status (*trace_function)(char **report, const char *image, const double *around,
                                    size_t corners, const double *outline, size_t clicks,
                                    const char *outline_file, const double scale[5],
                                    const double *plumb, const double *between, double tolerance,
                                    const char *unit, const char *const rock[4], const char *scene,
                                    const char *figure, bool json, tp_message *message);

enum {
  MOST_POINTS = 200,
  KEY_AROUND = 256,
  KEY_OUTLINE,
  KEY_SCALE,
  KEY_PLUMB,
  KEY_TOLERANCE,
  KEY_FIGURE,
  KEY_REPORT,
  KEY_BETWEEN,
  KEY_UNIT_WEIGHT,
  KEY_THICKNESS,
  KEY_FRICTION
};

/* What no picture shows, in the order in which tp_trace_run takes it. */
enum { TITLE, UNIT_WEIGHT, THICKNESS, FRICTION, OF_ROCK };

typedef struct arguments {
  const char *image, *scene, *figure, *report, *unit, *rock[OF_ROCK];
  const char *outline_file;
  double around[2 * MOST_POINTS], outline[2 * MOST_POINTS], scale[5], plumb[4], between[4],
      tolerance;
  size_t corners, clicks;
  bool scaled, plumbed, ended, json;
} arguments;

static const struct argp_option options[] = {
    {"around", KEY_AROUND, "X,Y,X,Y,...", 0,
     "Two opposite corners of a rectangle around the block, or the corners of a rough polygon "
     "around it, in pixels from the upper left corner of the picture; all of the block lies in it",
     0},
    {"outline", KEY_OUTLINE, "X,Y,X,Y,...|FILE", 0,
     "In place of --around: the outline itself as it was clicked, in the same pixels, from 3 to "
     "200 "
     "points or a CSV file of them, taken as it is",
     0},
    {"scale", KEY_SCALE, "X,Y,X,Y,LENGTH", 0,
     "Two points of the picture in the plane of the outline, and how far apart they are", 0},
    {"unit", 'u', "UNIT", 0, "Unit of that length and of the scene, mm, cm, m, km, in or ft (m)",
     0},
    {"plumb", KEY_PLUMB, "X,Y,X,Y", 0,
     "Two points of a line that hangs down; without it down is that of the picture", 0},
    {"between", KEY_BETWEEN, "X,Y,X,Y", 0,
     "Where the contact with the base begins and ends: two points of the picture, each near to a "
     "vertex of the outline; without it the contact goes on to where sides begin, steeper than 45 "
     "degrees",
     0},
    {"tolerance", KEY_TOLERANCE, "LENGTH", 0,
     "Omit points nearer to the outline than this (default: half of the standard deviation across "
     "its edge)",
     0},
    {"title", 't', "TEXT", 0, "Title of the scene (default: that it was traced)", 0},
    {"unit-weight", KEY_UNIT_WEIGHT, "NUMBER", 0,
     "Unit weight of the rock, kN/m3, as 26; without it the scene has none, and no forces are "
     "reported",
     0},
    {"thickness", KEY_THICKNESS, "LENGTH", 0,
     "Thickness of the section, in the unit of the scene (1 m)", 0},
    {"friction", KEY_FRICTION, "DEGREES", 0,
     "Friction angle of the contact; without it the scene has none, and sliding is not judged", 0},
    {"output", 'o', "FILE", 0, "Write the scene to FILE and print what was found", 0},
    {"figure", KEY_FIGURE, "FILE", 0, "Lay the outline and its band over the picture, in a .png",
     0},
    {"report", KEY_REPORT, "FILE", 0,
     "Solve the scene, too, and write a calculation sheet to check and sign into FILE, .html, .pdf "
     "or .md; with --output",
     0},
    {"json", 'j', NULL, 0, "Print what was found as JSON", 0},
    {0}};

/* ---- words -------------------------------------------------------------------------------------
 */

static void read_around(arguments *a, const char *text, const struct argp_state *state) {
  double *p = a->around;
  const int count = tp_cli_numbers(p, 2 * MOST_POINTS, text);
  a->corners = (size_t)(count < 0 ? 0 : count / 2);
  if (count < 4 || count % 2 != 0 || count > 2 * MOST_POINTS) {
    tp_cli_refuse(state, "--around takes from 2 to 200 points, X,Y,X,Y,..., not '%s'", text);
    return;
  }
  if (count > 4) return;
  const double corners[] = {p[0], p[1], p[2], p[1], p[2], p[3], p[0], p[3]};
  memcpy(p, corners, sizeof corners);
  a->corners = 4;
}

/* Points, where it begins as a number does; else a file. */
static void read_outline(arguments *a, const char *text, const struct argp_state *state) {
  const int count = tp_cli_numbers(a->outline, 2 * MOST_POINTS, text);
  a->outline_file = NULL;
  a->clicks = 0;
  if (count < 0 && strchr(text, ',') == NULL) {
    tp_cli_take_file(&a->outline_file, text, "--outline", state);
  } else if (count < 6 || count % 2 != 0 || count > 2 * MOST_POINTS) {
    tp_cli_refuse(
        state, "--outline takes from 3 to 200 points, X,Y,X,Y,..., or a CSV file, not '%s'", text);
  } else {
    a->clicks = (size_t)count / 2;
  }
}

/* Two points that are not one, and what may follow them. */
static bool read_pair(double *numbers, int count, const char *text) {
  if (tp_cli_numbers(numbers, count, text) != count) return false;
  return numbers[0] != numbers[2] || numbers[1] != numbers[3];
}

static void read_scale(arguments *a, const char *text, const struct argp_state *state) {
  a->scaled = read_pair(a->scale, 5, text) && a->scale[4] > 0;
  if (a->scaled) return;
  tp_cli_refuse(state,
                "--scale takes two different points and their distance above 0, "
                "X,Y,X,Y,LENGTH, not '%s'",
                text);
}

static void read_plumb(arguments *a, const char *text, const struct argp_state *state) {
  a->plumbed = read_pair(a->plumb, 4, text);
  if (a->plumbed) return;
  tp_cli_refuse(state, "--plumb takes two different points, X,Y,X,Y, not '%s'", text);
}

static void read_between(arguments *a, const char *text, const struct argp_state *state) {
  a->ended = read_pair(a->between, 4, text);
  if (a->ended) return;
  tp_cli_refuse(state, "--between takes two different points, X,Y,X,Y, not '%s'", text);
}

static void read_unit(arguments *a, const char *text, const struct argp_state *state) {
  static const char *const units[] = {"mm", "cm", "m", "km", "in", "ft"};
  for (size_t k = 0; k < sizeof units / sizeof units[0]; k++) {
    if (strcmp(text, units[k]) != 0) continue;
    a->unit = units[k];
    return;
  }
  tp_cli_refuse(state, "--unit is one of mm, cm, m, km, in, ft, not '%s'", text);
}

static void read_tolerance(arguments *a, const char *text, const struct argp_state *state) {
  if (tp_cli_numbers(&a->tolerance, 1, text) == 1 && a->tolerance > 0) return;
  tp_cli_refuse(state, "--tolerance takes a length above 0, not '%s'", text);
}

static void read_number(arguments *a, int which, const char *option, const char *text,
                        const struct argp_state *state) {
  const char *complaint = *text != '\0' ? tp_cli_wrong_number(text) : "say what";
  if (complaint != NULL) tp_cli_refuse(state, "%s: %s, not '%s'", option, complaint, text);
  a->rock[which] = text;
}

static void check(const arguments *a, const struct argp_state *state) {
  const char *figure = a->figure;
  const size_t length = figure != NULL ? strlen(figure) : 0;
  if (a->image == NULL) return; /* that it is missing was told */
  const bool clicked = a->clicks > 0 || a->outline_file != NULL;
  if (a->corners == 0 && !clicked) {
    tp_cli_refuse(state, "--around is missing: say where the block is, --around=120,80,900,640, or "
                         "its outline by --outline");
  } else if (a->corners > 0 && clicked) {
    tp_cli_refuse(state, "--around looks for an outline, --outline is one: give one of them");
  } else if (!a->scaled) {
    tp_cli_refuse(state, "--scale is missing: two points and how far apart they are, "
                         "--scale=100,700,400,700,1.5");
  } else if (figure != NULL && (length < 5 || strcmp(figure + length - 4, ".png") != 0)) {
    tp_cli_refuse(state, "--figure takes a file whose name ends in .png, not '%s'", figure);
  } else if (a->json && a->scene == NULL) {
    tp_cli_refuse(state, "--json prints in place of the scene: name a file for that by --output");
  } else if (a->report != NULL && a->scene == NULL) {
    tp_cli_refuse(state, "a report needs a scene in a file: name one by --output");
  }
  const tp_cli_written files[] = {
      {"--output", a->scene}, {"--figure", figure}, {"--report", a->report}};
  tp_cli_refuse_same_files(files, sizeof files / sizeof files[0], state);
}

static error_t parse(int key, char *argument, struct argp_state *state) {
  arguments *a = state->input;
  switch (key) {
  case KEY_AROUND:
    read_around(a, argument, state);
    return 0;
  case KEY_OUTLINE:
    read_outline(a, argument, state);
    return 0;
  case KEY_SCALE:
    read_scale(a, argument, state);
    return 0;
  case KEY_PLUMB:
    read_plumb(a, argument, state);
    return 0;
  case KEY_BETWEEN:
    read_between(a, argument, state);
    return 0;
  case KEY_TOLERANCE:
    read_tolerance(a, argument, state);
    return 0;
  case KEY_REPORT:
    tp_cli_take_sheet(&a->report, argument, state);
    return 0;
  case 't':
    a->rock[TITLE] = argument;
    return 0;
  case KEY_UNIT_WEIGHT:
    read_number(a, UNIT_WEIGHT, "--unit-weight", argument, state);
    return 0;
  case KEY_THICKNESS:
    read_number(a, THICKNESS, "--thickness", argument, state);
    return 0;
  case KEY_FRICTION:
    read_number(a, FRICTION, "--friction", argument, state);
    return 0;
  case KEY_FIGURE:
    tp_cli_take_file(&a->figure, argument, "--figure", state);
    return 0;
  case 'u':
    read_unit(a, argument, state);
    return 0;
  case 'o':
    tp_cli_take_file(&a->scene, argument, "--output", state);
    return 0;
  case 'j':
    a->json = true;
    return 0;
  case ARGP_KEY_ARG:
    tp_cli_take_file(&a->image, argument, "picture", state);
    return 0;
  case ARGP_KEY_NO_ARGS:
    tp_cli_refuse(state, "a picture is missing, a .png or a .jpg");
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
    .args_doc = "IMAGE",
    .doc =
        "Trace the outline of a boulder or a block in a photograph, a PNG or a JPEG, and write "
        "it as a scene.\vThe scene has a number, outline_offset, that moves the outline in and "
        "out, and says its standard deviation, which topple study takes. Check the outline "
        "with --figure: no program can see what shadow, soil or moss hides. Exit status: 0 done, 2 "
        "wrong usage, 3 bad input or no outline, 5 system failed."};

/* ---- work --------------------------------------------------------------------------------------
 */

static tp_status write_report(const arguments *a, tp_message *message) {
  tp_scene *scene = NULL;
  tp_solution *solution = NULL;
  tp_sheet_options sheet;
  tp_cli_date date;
  const tp_solve_options solve = tp_solve_options_default();
  tp_status status = tp_cli_sheet_options(&sheet, &date, message);
  if (status == TP_OK) status = tp_scene_read(&scene, a->scene, message);
  if (status == TP_OK) status = tp_cli_solve_for_sheet(&solution, scene, &solve, message);
  if (status == TP_OK) {
    status = tp_cli_write_sheet(a->report, scene, solution, &sheet, message);
  }
  tp_solution_free(solution);
  tp_scene_free(scene);
  return status;
}

static tp_status trace(const void *words, int *ended, tp_message *message) {
  const arguments *a = words;
  trace_function run = NULL;
  char *report = NULL;
  tp_cli_why why;
  *(void **)&run = tp_cli_load_call(TP_TRACE_LIBRARY, "tp_trace_run", &why);
  if (run == NULL) {
    snprintf(message->text, sizeof message->text,
             "pictures are traced by " TP_TRACE_LIBRARY
             ", which does not load (%s); './run --with trace' in Topple's folder installs OpenCV, "
             "libpng and libjpeg "
             "(libopencv-imgproc-dev libpng-dev libjpeg-dev) and builds it",
             why.text);
    return TP_DEPENDENCY_FAILED;
  }
  tp_status status =
      run(&report, a->image, a->around, a->corners, a->outline, a->clicks, a->outline_file,
          a->scale, a->plumbed ? a->plumb : NULL, a->ended ? a->between : NULL, a->tolerance,
          a->unit, a->rock, a->scene, a->figure, a->json, message);
  status = tp_cli_print_report(status, report, ended);
  return status == TP_OK && *ended == 0 && a->report != NULL ? write_report(a, message) : status;
}

int tp_cli_trace(int argc, char **argv) {
  arguments a = {.unit = "m"};
  return tp_cli_run(&parser, &a, trace, argc, argv);
}
