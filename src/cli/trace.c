/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* topple trace IMAGE: by a library that is loaded for it, as OpenCV takes long to load. */

#include "cli/cli.h"
#include "cli/library.h"

#include <dlfcn.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Those of src/trace/trace.h and region.h. */
typedef struct trace_point {
  double x, y;
} trace_point;
typedef struct trace_ring {
  long count, room;
  trace_point *points;
} trace_ring;
typedef struct trace_options {
  const char *image;
  trace_ring rough;
  trace_point scale[2];
  double length;
  const char *unit;
  bool plumb_given;
  trace_point plumb[2];
  double tolerance;
  const char *scene, *figure;
  bool json;
} trace_options;
typedef tp_status (*trace_function)(char **report, const trace_options *options,
                                    tp_message *message);

enum { MOST_POINTS = 200, KEY_AROUND = 256, KEY_SCALE, KEY_PLUMB, KEY_TOLERANCE, KEY_FIGURE };

typedef struct arguments {
  trace_options trace;
  trace_point points[MOST_POINTS];
  bool scaled;
} arguments;

static const struct argp_option options[] = {
    {"around", KEY_AROUND, "X,Y,X,Y,...", 0,
     "Two opposite corners of a rectangle around the block, or the corners of a rough polygon "
     "around it, in pixels from the upper left corner of the picture; all of the block lies in it",
     0},
    {"scale", KEY_SCALE, "X,Y,X,Y,LENGTH", 0,
     "Two points of the picture in the plane of the outline, and how far apart they are", 0},
    {"unit", 'u', "UNIT", 0, "Unit of that length and of the scene, mm, cm, m, km, in or ft (m)",
     0},
    {"plumb", KEY_PLUMB, "X,Y,X,Y", 0,
     "Two points of a line that hangs down; without it down is that of the picture", 0},
    {"tolerance", KEY_TOLERANCE, "LENGTH", 0,
     "Leave out points nearer to the outline than this (half of its standard deviation)", 0},
    {"output", 'o', "FILE", 0, "Write the scene to FILE and print what was found", 0},
    {"figure", KEY_FIGURE, "FILE", 0, "Lay the outline and its band over the picture, in a .png",
     0},
    {"json", 'j', NULL, 0, "Print what was found as JSON", 0},
    {0}};

/* ---- words -------------------------------------------------------------------------------------
 */

/* Numbers between commas; how many, or one more than `most`. -1: one is none. */
static int read_numbers(double *numbers, int most, const char *text) {
  int count = 0;
  for (;;) {
    char *end = NULL;
    const double number = strtod(text, &end);
    if (end == text || !isfinite(number)) return -1;
    if (count == most) return most + 1;
    numbers[count++] = number;
    if (*end == '\0') return count;
    if (*end != ',') return -1;
    text = end + 1;
  }
}

static void read_around(arguments *a, const char *text, const struct argp_state *state) {
  double numbers[2 * MOST_POINTS];
  const int count = read_numbers(numbers, 2 * MOST_POINTS, text);
  if (count < 4 || count % 2 != 0 || count > 2 * MOST_POINTS) {
    tp_cli_refuse(state, "--around takes from 2 to 200 points, X,Y,X,Y,…, not '%s'", text);
    return;
  }
  trace_ring *rough = &a->trace.rough;
  rough->points = a->points;
  rough->count = count / 2;
  for (int k = 0; k < count / 2; k++)
    a->points[k] = (trace_point){numbers[2 * k], numbers[2 * k + 1]};
  if (count == 4) {
    const trace_point p = a->points[0], q = a->points[1];
    a->points[1] = (trace_point){q.x, p.y};
    a->points[2] = q;
    a->points[3] = (trace_point){p.x, q.y};
    rough->count = 4;
  }
}

/* Two points that are not one, and what follows them. */
static bool read_pair(trace_point pair[2], double *last, const char *text) {
  double numbers[5];
  if (read_numbers(numbers, 5, text) != (last != NULL ? 5 : 4)) return false;
  for (int k = 0; k < 2; k++) pair[k] = (trace_point){numbers[2 * k], numbers[2 * k + 1]};
  if (last != NULL) *last = numbers[4];
  return pair[0].x != pair[1].x || pair[0].y != pair[1].y;
}

static void read_scale(arguments *a, const char *text, const struct argp_state *state) {
  a->scaled = read_pair(a->trace.scale, &a->trace.length, text) && a->trace.length > 0;
  if (a->scaled) return;
  tp_cli_refuse(state,
                "--scale takes two different points and their distance above 0, "
                "X,Y,X,Y,LENGTH, not '%s'",
                text);
}

static void read_unit(arguments *a, const char *text, const struct argp_state *state) {
  static const char *const units[] = {"mm", "cm", "m", "km", "in", "ft"};
  for (size_t k = 0; k < sizeof units / sizeof units[0]; k++) {
    if (strcmp(text, units[k]) != 0) continue;
    a->trace.unit = units[k];
    return;
  }
  tp_cli_refuse(state, "--unit is one of mm, cm, m, km, in, ft, not '%s'", text);
}

static void read_tolerance(arguments *a, const char *text, const struct argp_state *state) {
  if (read_numbers(&a->trace.tolerance, 1, text) == 1 && a->trace.tolerance > 0) return;
  tp_cli_refuse(state, "--tolerance takes a length above 0, not '%s'", text);
}

static void check(const arguments *a, const struct argp_state *state) {
  const char *figure = a->trace.figure;
  const size_t length = figure != NULL ? strlen(figure) : 0;
  if (a->trace.image == NULL) return; /* that it is missing was told */
  if (a->trace.rough.count == 0) {
    tp_cli_refuse(state, "--around is missing: say where the block is, --around=120,80,900,640");
  } else if (!a->scaled) {
    tp_cli_refuse(state, "--scale is missing: two points and how far apart they are, "
                         "--scale=100,700,400,700,1.5");
  } else if (figure != NULL && (length < 5 || strcmp(figure + length - 4, ".png") != 0)) {
    tp_cli_refuse(state, "--figure takes a file whose name ends in .png, not '%s'", figure);
  } else if (a->trace.json && a->trace.scene == NULL) {
    tp_cli_refuse(state, "--json prints in place of the scene: name a file for that by --output");
  }
}

static error_t parse(int key, char *argument, struct argp_state *state) {
  arguments *a = state->input;
  switch (key) {
  case KEY_AROUND:
    read_around(a, argument, state);
    return 0;
  case KEY_SCALE:
    read_scale(a, argument, state);
    return 0;
  case KEY_PLUMB:
    a->trace.plumb_given = read_pair(a->trace.plumb, NULL, argument);
    if (!a->trace.plumb_given) {
      tp_cli_refuse(state, "--plumb takes two different points, X,Y,X,Y, not '%s'", argument);
    }
    return 0;
  case KEY_TOLERANCE:
    read_tolerance(a, argument, state);
    return 0;
  case KEY_FIGURE:
    tp_cli_take_file(&a->trace.figure, argument, "--figure", state);
    return 0;
  case 'u':
    read_unit(a, argument, state);
    return 0;
  case 'o':
    tp_cli_take_file(&a->trace.scene, argument, "--output", state);
    return 0;
  case 'j':
    a->trace.json = true;
    return 0;
  case ARGP_KEY_ARG:
    tp_cli_take_file(&a->trace.image, argument, "picture", state);
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
    .doc = "Trace the outline of a boulder or a block in a photograph, a PNG or a JPEG, and write "
           "it as a scene.\vThe scene has a number, outline_offset, that moves the outline in and "
           "out, and says its standard deviation, which topple study takes. Look at the outline "
           "by --figure: what shadow, soil or moss hides no program knows. Exit status: 0 done, 2 "
           "wrong usage, 3 bad input or no outline, 5 system failed."};

/* ---- work --------------------------------------------------------------------------------------
 */

static tp_status trace(const void *words, int *ended, tp_message *message) {
  const arguments *a = words;
  trace_function run = NULL;
  char *report = NULL;
  void *library = tp_cli_load_library(TP_TRACE_LIBRARY);
  if (library != NULL) *(void **)&run = dlsym(library, "tp_trace_run");
  if (run == NULL) {
    const char *why = dlerror();
    snprintf(message->text, sizeof message->text,
             "pictures are traced by " TP_TRACE_LIBRARY
             ", which does not load (%s); install OpenCV, libpng and libjpeg (apt-get install "
             "libopencv-imgproc-dev libpng-dev libjpeg-dev) and build Topple again",
             why != NULL ? why : "no reason is given");
    return TP_DEPENDENCY_FAILED;
  }
  const tp_status status = run(&report, &a->trace, message);
  return tp_cli_print_report(status, report, ended);
}

int tp_cli_trace(int argc, char **argv) {
  arguments a = {.trace = {.unit = "m"}};
  return tp_cli_run(&parser, &a, trace, argc, argv);
}
