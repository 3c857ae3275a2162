/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* topple solid FILE: the mesh of a rock. */

#include "cli/drawn_report.h"

#include <argp.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct arguments {
  const char *file, *figure;
  bool json, csv, cuts;
  double section_deg;
  tp_solid_options options;
  double bands[TP_SOLID_BANDS];
} arguments;

enum {
  KEY_UNIT = 256,
  KEY_OBJECT,
  KEY_WEIGHT,
  KEY_FRICTION,
  KEY_UP,
  KEY_BAND,
  KEY_BELOW,
  KEY_AZIMUTHS,
  KEY_FIGURE,
  KEY_SECTION,
  KEY_REPAIR,
  KEY_MERGE,
  KEY_DROP,
  KEY_THIN,
  KEY_CSV
};

static const struct argp_option options[] = {
    {"unit", KEY_UNIT, "UNIT", 0, "Unit of the lengths of the mesh: mm, cm, m, km, in or ft", 0},
    {"object", KEY_OBJECT, "NAME", 0, "One solid, o or g of the file; default: all of it", 0},
    {"unit-weight", KEY_WEIGHT, "KN_M3", 0, "Unit weight, for the weight", 0},
    {"friction", KEY_FRICTION, "DEG", 0, "Friction angle on the base", 0},
    {"up", KEY_UP, "X,Y,Z", 0, "Upwards, across the base; default 0,0,1", 0},
    {"band", KEY_BAND, "LENGTH[,...]", 0,
     "Take all for touching that is no higher than this over the lowest point, in lengths of the "
     "mesh: the noise of the survey",
     0},
    {"below", KEY_BELOW, "LENGTH", 0,
     "Instead: cut the rock by a plane so high over its lowest point, in lengths of the mesh; what "
     "lies below is ground, and what lies above rests on the section",
     0},
    {"azimuths", KEY_AZIMUTHS, "COUNT", 0, "Azimuths of the rose; default 72", 0},
    {"repair", KEY_REPAIR, NULL, 0,
     "Mend a mesh that is not closed: triangles given twice or without area, turned ones, gaps; "
     "and "
     "say what was done",
     0},
    {"merge-within", KEY_MERGE, "LENGTH", 0,
     "With --repair: merge points as near as this, in lengths of the mesh", 0},
    {"drop-below", KEY_DROP, "SHARE", 0,
     "With --repair: drop pieces of less than this share of the area", 0},
    {"thin", KEY_THIN, "LENGTH", 0,
     "Thin the mesh to one that is nowhere farther from it than this, in lengths of the mesh, nor "
     "it "
     "from that",
     0},
    {"figure", KEY_FIGURE, "FILE", 0,
     "Draw the rock, what of it touches, and the rose into FILE: .svg, .pdf or .png; as "
     ".glb the rock as a model",
     0},
    {"section", KEY_SECTION, "DEG", 0,
     "Print the section through the centroid at this azimuth as a scene of a block, and how far "
     "off "
     "that is",
     0},
    {"json", 'j', NULL, 0, "Print the numbers as JSON", 0},
    {"csv", KEY_CSV, NULL, 0, "Print the tilt towards each azimuth as CSV", 0},
    {0}};

static size_t read_numbers(double *numbers, int most, const char *name, const char *text,
                           struct argp_state *state) {
  const int count = tp_cli_numbers(numbers, most, text);
  if (count < 0)
    tp_cli_refuse(state, "--%s takes numbers with commas between, not '%s'", name, text);
  if (count > most) tp_cli_refuse(state, "--%s takes at most %d numbers", name, most);
  return (size_t)count;
}

static double read_number(const char *name, const char *text, struct argp_state *state) {
  char *end = NULL;
  const double value = strtod(text, &end);
  if (end == text || *end != '\0' || !isfinite(value) || value < 0) {
    tp_cli_refuse(state, "--%s takes a number of 0 or more, not '%s'", name, text);
  }
  return value;
}

static void read_bands(arguments *a, const char *text, struct argp_state *state) {
  a->options.bands = a->bands;
  a->options.band_count = read_numbers(a->bands, TP_SOLID_BANDS, "band", text, state);
  for (size_t k = 0; k < a->options.band_count; k++) {
    if (a->bands[k] < 0) tp_cli_refuse(state, "--band takes lengths of 0 or more, not '%s'", text);
  }
}

static void read_azimuths(arguments *a, const char *text, struct argp_state *state) {
  const double count = read_number("azimuths", text, state);
  if (count < 1 || count > TP_SOLID_AZIMUTHS || count != floor(count)) {
    tp_cli_refuse(state, "--azimuths takes a count from 1 to %d, not '%s'", TP_SOLID_AZIMUTHS,
                  text);
  }
  a->options.azimuths = (size_t)count;
}

/* What may be done to the mesh. */
static error_t parse_repair(int key, char *argument, struct argp_state *state) {
  arguments *a = state->input;
  switch (key) {
  case KEY_REPAIR:
    a->options.repair = true;
    return 0;
  case KEY_MERGE:
    a->options.repair_merge_within = read_number("merge-within", argument, state);
    return 0;
  case KEY_DROP:
    a->options.repair_drop_below = read_number("drop-below", argument, state);
    return 0;
  case KEY_THIN:
    a->options.thin = read_number("thin", argument, state);
    if (a->options.thin == 0) tp_cli_refuse(state, "--thin takes a length above 0");
    return 0;
  default:
    return ARGP_ERR_UNKNOWN;
  }
}

/* What the solid is. */
static error_t parse_solid(int key, char *argument, struct argp_state *state) {
  arguments *a = state->input;
  switch (key) {
  case KEY_UNIT:
    a->options.length_unit = argument;
    return 0;
  case KEY_OBJECT:
    a->options.object = argument;
    return 0;
  case KEY_WEIGHT:
    a->options.unit_weight_kn_m3 = read_number("unit-weight", argument, state);
    return 0;
  case KEY_FRICTION:
    a->options.friction_angle_deg = read_number("friction", argument, state);
    return 0;
  case KEY_UP:
    if (read_numbers(a->options.up, 3, "up", argument, state) != 3) {
      tp_cli_refuse(state, "--up takes three numbers, x,y,z, not '%s'", argument);
    }
    return 0;
  case KEY_BAND:
    read_bands(a, argument, state);
    return 0;
  case KEY_BELOW:
    a->options.below = read_number("below", argument, state);
    return 0;
  case KEY_AZIMUTHS:
    read_azimuths(a, argument, state);
    return 0;
  default:
    return parse_repair(key, argument, state);
  }
}

static error_t parse(int key, char *argument, struct argp_state *state) {
  arguments *a = state->input;
  switch (key) {
  case 'j':
    a->json = true;
    return 0;
  case KEY_CSV:
    a->csv = true;
    return 0;
  case KEY_SECTION:
    a->cuts = true;
    a->section_deg = read_number("section", argument, state);
    return 0;
  case KEY_FIGURE:
    a->figure = argument;
    return 0;
  case ARGP_KEY_ARG:
    tp_cli_take_file(&a->file, argument, "file", state);
    return 0;
  case ARGP_KEY_END:
    if (a->file == NULL) {
      tp_cli_refuse(state, "give a mesh, for example examples/solids/balanced_rock.obj");
    }
    if (!a->options.repair &&
        (a->options.repair_merge_within > 0 || a->options.repair_drop_below > 0)) {
      tp_cli_refuse(state, "--merge-within and --drop-below go with --repair");
    }
    if (a->options.repair_drop_below >= 1) {
      tp_cli_refuse(state, "--drop-below takes a share of the area below 1");
    }
    if (a->json && a->csv) tp_cli_refuse(state, "one of --json and --csv");
    if (a->cuts && (a->json || a->csv || a->figure != NULL)) {
      tp_cli_refuse(state, "--section prints a scene, and goes with no other output");
    }
    return 0;
  default:
    return parse_solid(key, argument, state);
  }
}

static const struct argp parser = {
    .options = options,
    .parser = parse,
    .args_doc = "FILE",
    .doc = "How a solid rock can rest on a plane, and the tilt at which it topples or slides in "
           "each direction\v"
           "FILE is a closed mesh: STL, PLY or OBJ. Azimuths run clockwise from y (north) to x "
           "(east). docs/solids.md explains each number."};

typedef struct solved {
  const tp_solid *solid;
  const arguments *words;
} solved;

static tp_status tell(const void *of, int *ended, tp_message *message) {
  const solved *own = of;
  char *text = NULL;
  (void)message;
  const tp_status status = own->words->json  ? tp_report_solid_json(&text, own->solid)
                           : own->words->csv ? tp_report_solid_csv(&text, own->solid)
                                             : tp_report_solid(&text, own->solid);
  return tp_cli_print_report(status, text, ended);
}

static tp_status tell_and_draw(const solved *own, int *ended, tp_message *message) {
  tp_cli_drawn_report report = {.print = tell, .of = own, .ended = ended};
  const tp_status drawn = tp_cli_draw_solid(own->words->figure, own->solid,
                                            tp_cli_drawn_report_consent(&report), message);
  return tp_cli_drawn_report_end(&report, drawn, message);
}

static tp_status solve_and_tell(const void *words, int *ended, tp_message *message) {
  const arguments *a = words;
  tp_solid *solid = NULL;
  tp_status status = tp_solid_of_file(&solid, a->file, &a->options, message);
  if (status == TP_OK && a->cuts) {
    char *scene = NULL;
    status = tp_report_solid_section(&scene, solid, a->section_deg, message);
    if (status == TP_OK) status = tp_cli_print_report(status, scene, ended);
  } else if (status == TP_OK) {
    const solved own = {solid, a};
    status = a->figure != NULL ? tell_and_draw(&own, ended, message) : tell(&own, ended, message);
  }
  tp_solid_free(solid);
  return status;
}

int tp_cli_solid(int argc, char **argv) {
  arguments a = {.options = tp_solid_options_default()};
  return tp_cli_run(&parser, &a, solve_and_tell, argc, argv);
}
