/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "example_scene.h"

#include "suite.h"

tp_scene *example_scene(void) {
  tp_message message;
  tp_scene *scene = NULL;
  ck_assert_int_eq(tp_scene_read(&scene, TP_EXAMPLES "/slab_left.yaml", &message), TP_OK);
  return scene;
}

tp_solution *example_solution(const tp_scene *scene) {
  tp_message message;
  tp_solution *solution = NULL;
  const tp_solve_options options = tp_solve_options_default();
  ck_assert_int_eq(tp_solve(&solution, scene, &options, &message), TP_OK);
  return solution;
}
