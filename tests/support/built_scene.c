/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "built_scene.h"

#include <stdlib.h>
#include <string.h>

tp_message message;

tp_scene *new_scene(const char *unit) {
  tp_scene *scene = NULL;
  DO(tp_scene_new(&scene, unit, &message));
  return scene;
}

static char *report_blocks(const tp_scene *scene, const tp_solve_options *options) {
  tp_block_system *system = NULL;
  char *json = NULL;
  DO(tp_solve_block_system(&system, scene, options, &message));
  DO(tp_report_block_system_json(&json, system));
  tp_block_system_free(system);
  return json;
}

static char *report_block(const tp_scene *scene, const tp_solve_options *options) {
  tp_solution *solution = NULL;
  char *json = NULL;
  DO(tp_solve(&solution, scene, options, &message));
  DO(tp_report_json(&json, solution));
  tp_solution_free(solution);
  return json;
}

/* The report of a solution, with what ran cut off; the caller's to free. */
char *solve(const tp_scene *scene, int digits) {
  tp_solve_options options = tp_solve_options_default();
  options.digits = digits;
  options.motion_ranges = true;
  char *json = tp_scene_block_count(scene) > 0 ? report_blocks(scene, &options)
                                               : report_block(scene, &options);
  for (char *effects = json; (effects = strstr(effects, "\"effects\"")) != NULL;) {
    char *end = strchr(effects, ']');
    ck_assert_ptr_nonnull(end);
    memmove(effects, end + 1, strlen(end + 1) + 1);
  }
  static const char *const named[] = {"\"called_for_by\": \"",
                                      "\"place\": \""}; /* of a load, a note */
  for (size_t k = 0; k < sizeof named / sizeof named[0]; k++) {
    for (char *of = json; (of = strstr(of, named[k])) != NULL;) {
      of += strlen(named[k]);
      char *end = strchr(of, '"');
      ck_assert_ptr_nonnull(end);
      memmove(of, end, strlen(end) + 1);
    }
  }
  return json;
}

/* Frees both. */
void expect_equal(char *one, char *other) {
  size_t at = 0;
  while (one[at] == other[at] && one[at] != '\0') at++;
  ck_assert_msg(one[at] == other[at], "built: %.200s\nread: %.200s", one + at, other + at);
  free(one);
  free(other);
}

/* Frees the scene. */
void expect_same(tp_scene *built, const char *text) {
  tp_scene *read = NULL;
  DO(tp_scene_read_text(&read, text, "scene in memory", &message));
  for (int digits = 9; digits <= 30; digits += 21) {
    expect_equal(solve(built, digits), solve(read, digits));
  }
  tp_scene_free(read);
  tp_scene_free(built);
}
