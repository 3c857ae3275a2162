/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Scenes with other numbers: of a file with parameters, and built in memory. What a key holds has
 * decimals, which a program whose decimals have a comma reads with a point, too. */

#define _GNU_SOURCE
#include "sayings.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define SAY(call) note_status(s, call, &message)

static const char text[] =
    "topple: 1\nlength_unit: m\nparameters: {a: 3.1, b: 2*a, c: 1/3}\n"
    "block: {outline: [[0, 0], [a, 0], [a, b], [c, b]], unit_weight_kn_m3: 25.5}\n"
    "friction_angle_deg: 30.5\ntilt: {towards: left, angle_deg: 10.25}\n";

static void say_number(sayings *s, const tp_scene *scene, const char *key) {
  tp_message message = {.text = ""};
  tp_bounded number = {0};
  SAY(tp_scene_number(&number, scene, key, &message));
  if (tp_scene_number_text(next_saying(s), scene, key, &message) != TP_OK) s->count--;
}

static void say_set(sayings *s, const tp_scene *scene, const char *key) {
  tp_message message = {.text = ""};
  tp_scene *set = NULL;
  char setting[80];
  const char *const settings[] = {setting, "tilt.angle_deg=7.5+1/3"};
  snprintf(setting, sizeof setting, "%s=3.25", key);
  SAY(tp_scene_with_settings(&set, scene, settings, 2, &message));
  if (set != NULL) say_solved(s, set, false, 9, false);
  tp_scene_free(set);
}

/* The load cases of a scene, one of them by itself, and one that there is not. */
static void say_load_cases(sayings *s) {
  static const char *const setting = "friction_angle_deg=33+1/3";
  tp_message message = {.text = ""};
  tp_scene *scene = NULL, *own = NULL;
  tp_load_cases *cases = NULL;
  const tp_solve_options options = tp_solve_options_default();
  SAY(tp_scene_read(&scene, TP_EXAMPLES "/slope/design_cases.yaml", &message));
  if (scene == NULL) return;
  note_number(s, (long)tp_scene_load_case_count(scene));
  char **name = next_saying(s);
  *name = strdup(tp_scene_load_case_name(scene, 1));
  if (*name == NULL) s->count--;
  SAY(tp_scene_load_case(&own, scene, "dry", &message));
  SAY(tp_scene_load_case(&own, scene, "DA1-2", &message));
  if (own != NULL) say_solved(s, own, false, 9, false);
  SAY(tp_solve_load_cases(&cases, scene, &setting, 1, &options, &message));
  if (cases != NULL) {
    for (size_t k = 0; k < cases->count; k++) same_times(cases->cases[k].solution);
    note_number(s, (long)tp_load_cases_meet(cases));
    if (tp_report_load_cases(next_saying(s), cases) != TP_OK) s->count--;
    if (tp_report_load_cases_json(next_saying(s), cases, TP_PIVOTS_ALL) != TP_OK) s->count--;
  }
  tp_load_cases_free(cases);
  tp_scene_free(own);
  tp_scene_free(scene);
}

static bool consent(void *context) {
  ++*(int *)context;
  return true;
}

static void say_block_figures(sayings *s, const tp_scene *scene, const tp_block_system *system) {
  tp_message message = {.text = ""};
  char path[100];
  int asked = 0;
  const tp_figure_consent ask = {consent, &asked};
  snprintf(path, sizeof path, "%s/blocks.svg", s->folder);
  SAY(tp_report_figure_block_system(path, scene, system, &message));
  say_file(s, path);
  SAY(tp_report_figure_block_system_if(path, scene, system, ask, &message));
  note_number(s, asked);
  tp_sheet_options options = tp_sheet_options_default();
  options.times = 0;
  snprintf(path, sizeof path, "%s/blocks.md", s->folder);
  SAY(tp_report_sheet_block_system(path, scene, system, &options, &message));
  say_file(s, path);
  snprintf(path, sizeof path, "%s/moving.svg", s->folder);
  SAY(tp_report_block_system_animation_file(path, scene, system, &message));
  say_file(s, path);
}

/* For which friction have they a factor by Goodman and Bray? */
static void say_found_blocks(sayings *s, const tp_scene *scene, const tp_block_system *system) {
  tp_message message = {.text = ""};
  tp_found *found = NULL;
  tp_find_options options = tp_find_options_default();
  options.key = "friction_angle_deg";
  options.target = TP_FIND_FOS_GOODMAN_BRAY;
  options.value = 1;
  options.low = 38.1;
  options.high = 38.2;
  options.has_low = options.has_high = true;
  SAY(tp_find(&found, scene, &options, &message));
  if (found != NULL && tp_report_found_block_system_json(next_saying(s), found, system) != TP_OK) {
    s->count--;
  }
  tp_found_free(found);
}

/* Many blocks in contact. */
static void say_block_system(sayings *s) {
  tp_message message = {.text = ""};
  tp_scene *scene = NULL;
  tp_block_system *system = NULL;
  const tp_solve_options options = tp_solve_options_default();
  SAY(tp_scene_read(&scene, TP_EXAMPLES "/blocks/toppling_slope.yaml", &message));
  if (scene == NULL) return;
  note_number(s, (long)tp_scene_block_count(scene));
  SAY(tp_solve_block_system(&system, scene, &options, &message));
  if (system != NULL) {
    note_number(s, tp_block_system_is_undecided(system));
    note_number(s, tp_block_system_meets(system, 1.15));
    note_number(s, tp_system_case_meets(system->cases, 1.25));
    if (tp_report_block_system(next_saying(s), system) != TP_OK) s->count--;
    if (tp_report_block_system_json(next_saying(s), system) != TP_OK) s->count--;
    if (tp_report_block_system_csv(next_saying(s), system) != TP_OK) s->count--;
    const tp_block_system *const both[] = {system, system};
    if (tp_report_block_systems_csv(next_saying(s), both, 2) != TP_OK) s->count--;
    if (tp_report_block_systems_table(next_saying(s), both, 2) != TP_OK) s->count--;
    SAY(tp_report_block_system_json_outlines(next_saying(s), scene, system, &message));
    SAY(tp_report_block_system_animation(next_saying(s), scene, system, &message));
    say_block_figures(s, scene, system);
    say_found_blocks(s, scene, system);
  }
  tp_block_system_free(system);
  tp_scene_free(scene);
}

/* What became of a drawing, of a scene that has none and of one that is a drawing. */
static void say_drawing(sayings *s, const tp_scene *scene) {
  static const char *const setting = "friction_angle_deg=30+1/3";
  tp_message message = {.text = ""};
  tp_scene *drawn = NULL;
  if (tp_report_drawing(next_saying(s), scene) != TP_OK) s->count--;
  SAY(tp_scene_read_with(&drawn, TP_EXAMPLES "/section_arcs.dxf", "ft", &setting, 1, &message));
  if (drawn == NULL) return;
  if (tp_report_drawing(next_saying(s), drawn) != TP_OK) s->count--;
  say_solved(s, drawn, false, 9, false);
  tp_scene_free(drawn);
}

static bool say_text(void *context, const char *piece) {
  sayings *s = context;
  char **own = next_saying(s);
  *own = strdup(piece);
  if (*own == NULL) s->count--;
  return true;
}

static bool say_point(void *context, const tp_sweep_point *point) {
  note_number(context, (long)point->status);
  return true;
}

/* By as many threads as there are, one of whose points is wrong. */
static void say_sweep(sayings *s, const tp_scene *scene) {
  tp_message message = {.text = ""};
  tp_sweep_summary summary;
  tp_sweep_options options = tp_sweep_options_default();
  options.x = "friction_angle_deg=29.5,30+1/7,99";
  options.y = "tilt.angle_deg=5:6:0.5";
  SAY(tp_sweep(&summary, scene, &options, (tp_sweep_sink){say_point, s}, &message));
  SAY(tp_sweep_write(&summary, scene, &options, TP_SWEEP_CSV, (tp_text_sink){say_text, s},
                     &message));
  SAY(tp_sweep_write_file(&summary, "/nowhere/at/all.json", scene, &options, TP_SWEEP_JSON,
                          &message));
}

typedef tp_status report_of_batch(char **text, const tp_batch *batch);

/* A survey of blocks, one of whose rows is wrong. */
static void say_batch(sayings *s) {
  tp_message message = {.text = ""};
  tp_batch *batch = NULL;
  tp_batch_options options = tp_batch_options_default();
  report_of_batch *const reports[] = {tp_report_batch, tp_report_batch_markdown,
                                      tp_report_batch_csv, tp_report_batch_json};
  options.scene = TP_EXAMPLES "/slope/survey_block.yaml";
  SAY(tp_batch_solve(&batch, TP_EXAMPLES "/slope/survey.csv", &options, &message));
  if (batch == NULL) return;
  tp_batch *of_text = NULL;
  SAY(tp_batch_solve_text(&of_text, "name,width (m)\nno height,1.5\n", "table", &options,
                          &message));
  if (of_text != NULL && tp_report_batch_csv(next_saying(s), of_text) != TP_OK) s->count--;
  tp_batch_free(of_text);
  for (size_t k = 0; k < sizeof reports / sizeof reports[0]; k++) {
    if (reports[k](next_saying(s), batch) != TP_OK) s->count--;
  }
  note_number(s, tp_batch_is_file_name("a.csv"));
  SAY(tp_batch_write_file("/nowhere/at/all.csv", batch, &message));
  SAY(tp_report_sheet_batch("/nowhere/at/all.html", batch, 1, &message));
  SAY(tp_report_figures_batch("/nowhere/at/all", ".svg", batch, &message));
  tp_batch_free(batch);
}

static void say_with(sayings *s, const tp_scene *scene, const char *const keys[2]) {
  tp_message message = {.text = ""};
  tp_scene *once = NULL, *twice = NULL;
  const tp_exact values[2] = {tp_exact_text("4.7"), tp_exact_of(0.1)};
  say_number(s, scene, keys[0]);
  SAY(tp_scene_with(&once, scene, keys[0], tp_exact_of(3.7), &message));
  SAY(tp_scene_with_numbers(&twice, scene, keys, values, 2, &message));
  if (once != NULL) say_solved(s, once, false, 9, false);
  say_set(s, scene, keys[0]);
  if (twice != NULL) {
    say_number(s, twice, keys[1]);
    say_solved(s, twice, false, 30, false);
  }
  tp_scene_free(once);
  tp_scene_free(twice);
}

void say_varied(sayings *s) {
  static const double square[] = {0, 0, 4, 0, 4, 6, 0, 6};
  static const char *const of_file[2] = {"a", "tilt.angle_deg"};
  static const char *const built[2] = {"block.outline.3.1", "tilt.angle_deg"};
  tp_message message = {.text = ""};
  tp_scene *scene = NULL;
  say_load_cases(s);
  say_block_system(s);
  SAY(tp_scene_read_text(&scene, text, "varied", &message));
  if (scene == NULL) return;
  say_with(s, scene, of_file);
  say_sweep(s, scene);
  say_batch(s);
  say_drawing(s, scene);
  say_number(s, scene, "c");
  say_number(s, scene, "none");
  tp_scene_free(scene);
  scene = NULL;
  SAY(tp_scene_new(&scene, "m", &message));
  if (scene == NULL) return;
  SAY(tp_scene_set_outline(scene, tp_coordinates_of(square, 4), &message));
  SAY(tp_scene_set_friction_angle_deg(scene, tp_exact_text("100/3"), &message));
  SAY(tp_scene_set_tilt_angle_deg(scene, tp_exact_text("10.5"), &message));
  say_with(s, scene, built);
  say_number(s, scene, "none");
  tp_scene_free(scene);
}
