/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* topple new [FILE]: options, questions on a terminal for what they leave unanswered, and the scene
 * written (docs/new.md). */

#include "cli/cli.h"
#include "cli/files.h"
#include "cli/new_ask.h"
#include "cli/new_begin.h"
#include "cli/new_drawing.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

typedef struct arguments {
  tp_cli_new_scene scene;
  const char *file;   /* the outline as named on the command line; NULL: none */
  const char *output; /* the scene's file; NULL: scene.yaml */
  bool given;         /* anything of the scene */
} arguments;

enum {
  KEY_SLAB = 256,
  KEY_UNIT,
  KEY_UNIT_WEIGHT,
  KEY_FRICTION,
  KEY_TILT,
  KEY_TOWARDS,
  KEY_FRAME,
  KEY_BLOCK,
  KEY_BASE,
  KEY_HOLE,
  KEY_PART,
  KEY_REFERENCE,
  KEY_GAP
};

static const struct argp_option options[] = {
    {"output", 'o', "FILE", 0, "Write the scene into FILE (scene.yaml unless given), - for stdout",
     0},
    {"slab", KEY_SLAB, "WxH", 0, "A rectangle of this width and height, as 2x4", 1},
    {"unit", KEY_UNIT, "UNIT", 0,
     "The length unit: mm, cm, m, km, in or ft (m unless given, or as stated in a drawing)", 1},
    {"title", 't', "TEXT", 0, "Title of the scene", 1},
    {"unit-weight", KEY_UNIT_WEIGHT, "NUMBER", 0, "Unit weight of the rock, kN/m3, as 26", 1},
    {"friction", KEY_FRICTION, "DEGREES", 0, "Friction angle of the contact", 1},
    {"tilt", KEY_TILT, "DEGREES", 0, "Tilt of the base today", 1},
    {"towards", KEY_TOWARDS, "SIDE", 0, "The side that is lowered: left, right or both", 1},
    {"frame", KEY_FRAME, "FRAME", 0,
     "Frame of the outline: base (x along its mean plane) or world (y upwards)", 1},
    {NULL, 0, NULL, 0, "For a drawing:", 2},
    {"block", KEY_BLOCK, "LAYER", 0, "Layer or name of the outline (BLOCK unless given)", 2},
    {"base", KEY_BASE, "LAYER", 0, "Layer or name of the profile of the base (BASE)", 2},
    {"hole", KEY_HOLE, "LAYER", 0, "Layer or name of holes (HOLE)", 2},
    {"part", KEY_PART, "LAYER=NUMBER", 0,
     "A layer of parts of the block and their unit weight, kN/m3; may be given again", 2},
    {"reference", KEY_REFERENCE, "NAME=LENGTH", 0,
     "An object and its true length, to which the drawing is scaled", 2},
    {"gap", KEY_GAP, "LENGTH", 0, "Largest gap between ends of pieces that are joined (0)", 2},
    {0}};

static void keep(char answer[TP_CLI_ANSWER], const char *text, const char *option,
                 const char *(*wrong)(const char *), arguments *a, struct argp_state *state) {
  const char *complaint = wrong != NULL ? wrong(text) : NULL;
  if (strlen(text) >= TP_CLI_ANSWER) {
    tp_cli_refuse(state, "%s takes at most %d bytes", option, TP_CLI_ANSWER - 1);
    return;
  }
  if (complaint != NULL || *text == '\0') {
    tp_cli_refuse(state, "%s: %s, not '%s'", option, complaint != NULL ? complaint : "say what",
                  text);
  }
  strcpy(answer, text);
  a->given = true;
}

static void keep_part(const char *text, arguments *a, struct argp_state *state) {
  if (a->scene.part_count == TP_CLI_PARTS) {
    tp_cli_refuse(state, "--part is given at most %d times", TP_CLI_PARTS);
    return;
  }
  keep(a->scene.parts[a->scene.part_count++], text, "--part", tp_cli_wrong_part, a, state);
}

static const char *wrong_frame(const char *text) {
  return strcmp(text, "base") == 0 || strcmp(text, "world") == 0 ? NULL
                                                                 : "a frame is base or world";
}

static void check(const arguments *a, struct argp_state *state) {
  if (a->file != NULL && a->scene.block[0] != '\0') {
    tp_cli_refuse(state, "a block is either a slab or the outline of '%s'", a->file);
  }
  if (a->file == NULL && tp_cli_says_of_drawing(&a->scene)) {
    tp_cli_refuse(state, "which drawing? Layers, parts, a reference and a gap need its FILE");
  }
  const bool has_block = a->file != NULL || a->scene.block[0] != '\0';
  if (a->given && !has_block) {
    tp_cli_refuse(state, "which block? Give --slab WxH, or the file of an outline");
  }
  if (!a->given && !has_block && isatty(STDIN_FILENO) == 0) {
    tp_cli_refuse(state, "questions are asked only on a terminal; here give --slab WxH, or the "
                         "file of an outline");
  }
}

static error_t parse(int key, char *argument, struct argp_state *state) {
  arguments *a = state->input;
  switch (key) {
  case 'o':
    tp_cli_take_file(&a->output, argument, "--output", state);
    return 0;
  case 't':
    keep(a->scene.title, argument, "--title", NULL, a, state);
    return 0;
  case KEY_SLAB:
    keep(a->scene.block, argument, "--slab", tp_cli_wrong_size, a, state);
    return 0;
  case KEY_UNIT:
    keep(a->scene.length_unit, argument, "--unit", tp_cli_wrong_unit, a, state);
    return 0;
  case KEY_UNIT_WEIGHT:
    keep(a->scene.unit_weight, argument, "--unit-weight", tp_cli_wrong_number, a, state);
    return 0;
  case KEY_FRICTION:
    keep(a->scene.friction, argument, "--friction", tp_cli_wrong_number, a, state);
    return 0;
  case KEY_TILT:
    keep(a->scene.tilt, argument, "--tilt", tp_cli_wrong_number, a, state);
    return 0;
  case KEY_TOWARDS:
    keep(a->scene.towards, argument, "--towards", tp_cli_wrong_towards, a, state);
    return 0;
  case KEY_FRAME:
    keep(a->scene.frame, argument, "--frame", wrong_frame, a, state);
    return 0;
  case KEY_BLOCK:
    keep(a->scene.block_layer, argument, "--block", NULL, a, state);
    return 0;
  case KEY_BASE:
    keep(a->scene.base_layer, argument, "--base", NULL, a, state);
    return 0;
  case KEY_HOLE:
    keep(a->scene.hole_layer, argument, "--hole", NULL, a, state);
    return 0;
  case KEY_PART:
    keep_part(argument, a, state);
    return 0;
  case KEY_REFERENCE:
    keep(a->scene.reference, argument, "--reference", tp_cli_wrong_reference, a, state);
    return 0;
  case KEY_GAP:
    keep(a->scene.gap, argument, "--gap", tp_cli_wrong_number, a, state);
    return 0;
  case ARGP_KEY_ARG:
    tp_cli_take_file(&a->file, argument, "outline", state);
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
    .args_doc = "[FILE]",
    .doc = "Begin a scene: of a slab, of the outline in FILE, or of a drawing (DXF, SVG, WKT, "
           "GeoJSON, CSV with layers); what is not given is asked for on a terminal.\v"
           "The scene is solved once before it is written, and explains each key in comments, "
           "and which defaults are conservative. Existing files are never overwritten. Exit "
           "status: 0 done, 2 wrong usage, 3 bad input or a file in the way, 4 undecided, 5 system "
           "failed."};

/* What the options leave open, on a terminal; false: the answers ended. */
static bool ask(arguments *a) {
  if (a->file == NULL && a->scene.block[0] == '\0') return tp_cli_ask_scene(&a->scene);
  if (a->file == NULL || a->given || isatty(STDIN_FILENO) == 0) return true;
  return tp_cli_ask_of_file(&a->scene, tp_cli_is_drawing(a->file));
}

static tp_status run(const void *words, int *ended, tp_message *message) {
  arguments a = *(const arguments *)words;
  const char *output = a.output != NULL ? a.output : "scene.yaml";
  tp_status status =
      strcmp(output, "-") != 0 ? tp_cli_may_create(output, "", 0, false, message) : TP_OK;
  if (status != TP_OK) return status;
  if (!ask(&a)) {
    snprintf(message->text, sizeof message->text,
             "the answers ended before the scene was complete; nothing is written");
    return TP_BAD_INPUT;
  }
  const char *file = a.file != NULL ? a.file : a.scene.outline;
  char own[PATH_MAX];
  snprintf(own, sizeof own, "%s", file);
  if (*own != '\0') status = tp_cli_new_scene_of(&a.scene, own, output, message);
  if (status != TP_OK) return status;
  if (a.scene.length_unit[0] == '\0' && a.scene.drawing[0] == '\0') {
    strcpy(a.scene.length_unit, "m");
  }
  return tp_cli_begin_scene(&a.scene, output, ended, message);
}

int tp_cli_new(int argc, char **argv) {
  arguments a = {0};
  return tp_cli_run(&parser, &a, run, argc, argv);
}
