/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Names the files as seen from the scene's folder, writes the scene's text, solves it as a trial,
 * and writes it to a new file only where that succeeds. */

#define _GNU_SOURCE /* asprintf */
#include "cli/new_begin.h"

#include "cli/cli.h"
#include "cli/files.h"
#include "cli/manner.h"
#include "cli/new_drawing.h"
#include "cli/new_scene.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A file as the scene names it: from the scene's folder. */
static bool name_file(char name[TP_CLI_ANSWER], const char *file, const char *output) {
  char whole[PATH_MAX];
  const size_t folder = tp_cli_folder_length(output);
  const char *own = file;
  if (folder > 0 && strncmp(file, output, folder) == 0) {
    own = file + folder;
  } else if (folder > 0 && realpath(file, whole) != NULL) {
    own = whole;
  }
  if (strlen(own) >= TP_CLI_ANSWER) return false;
  strcpy(name, own);
  return true;
}

/* What became of the objects of a drawing, and what is to be known of it; to be freed. */
static tp_status tell_drawing(char **told, const tp_scene *scene, const tp_solution *solution) {
  char *objects = NULL, *notes = NULL;
  tp_status status = tp_report_drawing(&objects, scene);
  if (status == TP_OK) status = tp_report_notes(&notes, solution);
  if (status == TP_OK && asprintf(told, "%s%s\n", objects + strspn(objects, "\n"), notes) < 0) {
    *told = NULL;
    status = TP_OUT_OF_MEMORY;
  }
  free(objects);
  free(notes);
  return status;
}

/* Does it solve? What it comes to is for `topple solve` to tell. Of a drawing, what became of it,
 * and whether the base is its own. */
static tp_status try_scene(const char *text, const char *name, tp_cli_new_scene *begun, char **told,
                           tp_message *message) {
  tp_scene *scene = NULL;
  tp_solution *solution = NULL;
  const tp_solve_options solve = tp_solve_options_default();
  tp_status status = tp_scene_read_text(&scene, text, name, message);
  if (status == TP_OK) status = tp_solve(&solution, scene, &solve, message);
  if (status == TP_OK && begun->drawing[0] != '\0') {
    begun->drawn_base = !solution->contact.mated;
    status = tell_drawing(told, scene, solution);
  }
  tp_solution_free(solution);
  tp_scene_free(scene);
  if (status == TP_BAD_INPUT) {
    tp_message own = *message;
    snprintf(message->text, sizeof message->text,
             "nothing is written, as it would not solve: %.900s", own.text);
  }
  return status;
}

static tp_status write_scene(const char *text, const char *told, const char *output, int *ended,
                             tp_message *message) {
  if (strcmp(output, "-") == 0) {
    *ended = tp_cli_print(text);
    return TP_OK;
  }
  bool created = false;
  const tp_status status = tp_cli_create_file(output, text, strlen(text), false, &created, message);
  if (status != TP_OK) return status;
  if (told != NULL) *ended = tp_cli_print(told);
  char plain[PATH_MAX];
  tp_plain_text(plain, sizeof plain, output);
  if (!tp_cli_is_quiet()) printf("Wrote %s\nNext: topple solve %s\n", plain, plain);
  return TP_OK;
}

tp_status tp_cli_new_scene_of(tp_cli_new_scene *scene, const char *file, const char *output,
                              tp_message *message) {
  char name[TP_CLI_ANSWER];
  if (!name_file(name, file, output)) {
    snprintf(message->text, sizeof message->text, "the name of the outline's file is too long");
    return TP_BAD_INPUT;
  }
  const bool drawing = tp_cli_is_drawing(file);
  if (!drawing && tp_cli_says_of_drawing(scene)) {
    snprintf(
        message->text, sizeof message->text,
        "layers, parts, a reference and a gap apply to drawings, and this is an outline: leave "
        "these options out, or name its columns, layer,name,x,y, which makes a CSV a drawing");
    return TP_BAD_INPUT;
  }
  strcpy(drawing ? scene->drawing : scene->outline, name);
  if (drawing) scene->outline[0] = '\0';
  if (drawing && scene->title[0] == '\0') {
    const char *slash = strrchr(name, '/');
    char drawn_in[TP_CLI_ANSWER];
    snprintf(drawn_in, sizeof drawn_in, "Drawn in %.200s", slash != NULL ? slash + 1 : name);
    memcpy(scene->title, drawn_in, sizeof drawn_in);
  }
  return TP_OK;
}

tp_status tp_cli_begin_scene(tp_cli_new_scene *scene, const char *output, int *ended,
                             tp_message *message) {
  const char *name = strcmp(output, "-") != 0 ? output : "scene.yaml";
  tp_status status = TP_OK;
  char *text = NULL, *told = NULL;
  scene->drawn_base = scene->drawing[0] != '\0';
  for (bool again = true; again && status == TP_OK;) {
    const bool drawn_base = scene->drawn_base;
    free(text);
    free(told);
    text = told = NULL;
    status = tp_cli_new_scene_text(&text, scene);
    if (status == TP_OK) status = try_scene(text, name, scene, &told, message);
    again = scene->drawn_base != drawn_base;
  }
  if (status == TP_OK) status = write_scene(text, told, output, ended, message);
  free(text);
  free(told);
  return status;
}
