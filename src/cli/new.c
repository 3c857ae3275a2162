/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* topple new [FILE] */

#include "cli/cli.h"
#include "cli/files.h"
#include "cli/manner.h"
#include "cli/new_scene.h"

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

enum { KEY_SLAB = 256, KEY_UNIT, KEY_UNIT_WEIGHT, KEY_FRICTION, KEY_TILT, KEY_TOWARDS, KEY_FRAME };

static const struct argp_option options[] = {
    {"output", 'o', "FILE", 0, "Write the scene into FILE (scene.yaml unless given), - for stdout",
     0},
    {"slab", KEY_SLAB, "WxH", 0, "A rectangle of this width and height, as 2x4", 1},
    {"unit", KEY_UNIT, "UNIT", 0, "The length unit: mm, cm, m, km, in or ft (m unless given)", 1},
    {"title", 't', "TEXT", 0, "What the scene is of", 1},
    {"unit-weight", KEY_UNIT_WEIGHT, "NUMBER", 0, "Of the rock, kN/m3, as 26", 1},
    {"friction", KEY_FRICTION, "DEGREES", 0, "Friction angle of the contact", 1},
    {"tilt", KEY_TILT, "DEGREES", 0, "Tilt of the base today", 1},
    {"towards", KEY_TOWARDS, "SIDE", 0, "The side that is lowered: left, right or both", 1},
    {"frame", KEY_FRAME, "FRAME", 0,
     "Of the outline: base (x along its mean plane) or world (y upwards)", 1},
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

static const char *wrong_frame(const char *text) {
  return strcmp(text, "base") == 0 || strcmp(text, "world") == 0 ? NULL
                                                                 : "a frame is base or world";
}

static void check(const arguments *a, struct argp_state *state) {
  if (a->file != NULL && a->scene.block[0] != '\0') {
    tp_cli_refuse(state, "a block is either a slab or the outline of '%s'", a->file);
  }
  const bool has_block = a->file != NULL || a->scene.block[0] != '\0';
  if (a->given && !has_block) {
    tp_cli_refuse(state, "which block? Give --slab WxH, or the file of an outline");
  }
  if (!a->given && !has_block && isatty(STDIN_FILENO) == 0) {
    tp_cli_refuse(state, "questions are asked on a terminal alone; here give --slab WxH, or the "
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
    .doc = "Begin a scene: of a slab, or of the outline in FILE; without either by five questions, "
           "on a terminal.\v"
           "The scene is solved once before it is written, and says in comments what each key "
           "means and which defaults are cautious. What is there is never overwritten. Exit "
           "status: 0 done, 2 wrong usage, 3 bad input or a file in the way, 4 undecided, 5 system "
           "failed."};

/* ---- questions ---------------------------------------------------------------------------------
 */

/* A line of the standard input without its end, into an answer of that size; false: there is none,
 * or memory is exhausted. A longer one is cut, and then refused by what is asked. */
static bool read_answer(char answer[TP_CLI_ANSWER]) {
  char *line = NULL;
  size_t size = 0;
  const ssize_t length = getline(&line, &size, stdin);
  if (length >= 0) {
    const char *text = line + strspn(line, " \t");
    size_t own = strcspn(text, "\r\n");
    while (own > 0 && (text[own - 1] == ' ' || text[own - 1] == '\t')) own--;
    snprintf(answer, TP_CLI_ANSWER, "%.*s", (int)(own < TP_CLI_ANSWER ? own : TP_CLI_ANSWER), text);
  }
  free(line);
  return length >= 0;
}

/* Until it is answered; false: the input ended. */
static bool ask(const char *question, char answer[TP_CLI_ANSWER], const char *unless_given,
                const char *(*wrong)(const char *)) {
  for (;;) {
    tp_cli_ask(question);
    if (!read_answer(answer)) return false;
    if (answer[0] == '\0') strcpy(answer, unless_given);
    const char *complaint = wrong != NULL ? wrong(answer) : NULL;
    if (complaint == NULL) return true;
    tp_cli_complain("%s", complaint);
  }
}

/* A size, or a file that can be read. */
static const char *wrong_block(const char *text) {
  return access(text, R_OK) == 0 || tp_cli_wrong_size(text) == NULL
             ? NULL
             : "a block is its width and height, as 2x4, or the name of a file that is there";
}

/* "20", "20 left", or nothing. */
static const char *wrong_tilt(const char *text) {
  char angle[TP_CLI_ANSWER];
  strcpy(angle, text);
  char *blank = strchr(angle, ' ');
  if (blank != NULL) *blank = '\0';
  if (tp_cli_wrong_number(angle) != NULL || (blank != NULL && angle[0] == '\0') ||
      (blank != NULL && tp_cli_wrong_towards(blank + 1 + strspn(blank + 1, " ")) != NULL)) {
    return "a tilt is an angle, and may name the lowered side, as 20 or 20 left";
  }
  return NULL;
}

static bool ask_all(arguments *a) {
  tp_cli_new_scene *s = &a->scene;
  char block[TP_CLI_ANSWER], tilt[TP_CLI_ANSWER];
  if (!ask("1 of 5. Length unit (mm, cm, m, km, in, ft) [m]? ", s->length_unit, "m",
           tp_cli_wrong_unit) ||
      !ask("2 of 5. The block: width and height, as 2x4, or the file of its outline? ", block, "",
           wrong_block) ||
      !ask("3 of 5. Unit weight of the rock in kN/m3 [not known]? ", s->unit_weight, "",
           tp_cli_wrong_number) ||
      !ask("4 of 5. Friction angle of the contact in degrees [not known: sliding is not judged]? ",
           s->friction, "", tp_cli_wrong_number) ||
      !ask("5 of 5. Tilt of the base in degrees, and the lowered side, as 20 left [both]? ", tilt,
           "", wrong_tilt)) {
    return false;
  }
  strcpy(tp_cli_wrong_size(block) == NULL ? s->block : s->outline, block);
  char *blank = strchr(tilt, ' ');
  if (blank != NULL) {
    strcpy(s->towards, blank + 1 + strspn(blank + 1, " "));
    *blank = '\0';
  }
  strcpy(s->tilt, tilt);
  return true;
}

/* ---- the scene ---------------------------------------------------------------------------------
 */

/* The outline's file as the scene names it: from the scene's folder. */
static bool name_outline(arguments *a, const char *file, const char *output) {
  char whole[PATH_MAX];
  const size_t folder = tp_cli_folder_length(output);
  const char *name = file;
  if (folder > 0 && strncmp(file, output, folder) == 0) {
    name = file + folder;
  } else if (folder > 0 && realpath(file, whole) != NULL) {
    name = whole;
  }
  if (strlen(name) >= TP_CLI_ANSWER) return false;
  strcpy(a->scene.outline, name);
  return true;
}

/* Does it solve? What it comes to is for `topple solve` to tell. */
static tp_status try_scene(const char *text, const char *name, tp_message *message) {
  tp_scene *scene = NULL;
  tp_solution *solution = NULL;
  const tp_solve_options solve = tp_solve_options_default();
  tp_status status = tp_scene_read_text(&scene, text, name, message);
  if (status == TP_OK) status = tp_solve(&solution, scene, &solve, message);
  tp_solution_free(solution);
  tp_scene_free(scene);
  if (status == TP_BAD_INPUT) {
    tp_message own = *message;
    snprintf(message->text, sizeof message->text,
             "nothing is written, as it would not solve: %.900s", own.text);
  }
  return status;
}

static tp_status write_scene(const char *text, const char *output, int *ended,
                             tp_message *message) {
  if (strcmp(output, "-") == 0) {
    *ended = tp_cli_print(text);
    return TP_OK;
  }
  bool created = false;
  const tp_status status = tp_cli_create_file(output, text, strlen(text), false, &created, message);
  if (status != TP_OK) return status;
  char plain[PATH_MAX];
  tp_plain_text(plain, sizeof plain, output);
  if (!tp_cli_is_quiet()) printf("Wrote %s\nNext: topple solve %s\n", plain, plain);
  return TP_OK;
}

static tp_status run(const void *words, int *ended, tp_message *message) {
  arguments a = *(const arguments *)words;
  const char *output = a.output != NULL ? a.output : "scene.yaml";
  const bool to_file = strcmp(output, "-") != 0;
  tp_status status = to_file ? tp_cli_may_create(output, "", 0, false, message) : TP_OK;
  if (status != TP_OK) return status;
  if (a.file == NULL && a.scene.block[0] == '\0' && !ask_all(&a)) {
    snprintf(message->text, sizeof message->text,
             "the answers ended before the scene was known; nothing is written");
    return TP_BAD_INPUT;
  }
  const char *file = a.file != NULL ? a.file : a.scene.outline;
  char own[TP_CLI_ANSWER];
  if (*file != '\0') {
    snprintf(own, sizeof own, "%s", file);
    if (strlen(file) >= sizeof own || !name_outline(&a, own, output)) {
      snprintf(message->text, sizeof message->text, "the name of the outline's file is too long");
      return TP_BAD_INPUT;
    }
  }
  if (a.scene.length_unit[0] == '\0') strcpy(a.scene.length_unit, "m");
  char *text = NULL;
  status = tp_cli_new_scene_text(&text, &a.scene);
  if (status == TP_OK) status = try_scene(text, to_file ? output : "scene.yaml", message);
  if (status == TP_OK) status = write_scene(text, output, ended, message);
  free(text);
  return status;
}

int tp_cli_new(int argc, char **argv) {
  arguments a = {0};
  return tp_cli_run(&parser, &a, run, argc, argv);
}
