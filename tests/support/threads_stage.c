/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "threads_stage.h"

#include "suite.h"

sayings *of_thread[THREADS + 1];

void expect_same_sayings(const sayings *alone, const sayings *among, const char *what) {
  ck_assert_msg(alone->count == among->count, "%s: %zu texts, alone %zu", what, among->count,
                alone->count);
  for (size_t k = 0; k < alone->count; k++) {
    const char *one = alone->texts[k], *other = among->texts[k];
    ck_assert(one != NULL && other != NULL);
    size_t same = 0;
    while (one[same] != '\0' && one[same] == other[same]) same++;
    ck_assert_msg(one[same] == other[same], "%s, text %zu:\n%.120s\nand alone\n%.120s", what, k,
                  other + same, one + same);
  }
}

tp_scene *built(tp_scene *scene, tp_status status) {
  if (status == TP_OK) return scene;
  tp_scene_free(scene);
  return NULL;
}

tp_scene *build_square(double friction_angle_deg) {
  static const double square[] = {0, 0, 4, 0, 4, 6, 0, 6};
  tp_scene *scene = NULL;
  tp_status status = tp_scene_new(&scene, "m", NULL);
  if (status == TP_OK) status = tp_scene_set_outline(scene, tp_coordinates_of(square, 4), NULL);
  if (status == TP_OK) status = tp_scene_set_unit_weight_kn_m3(scene, tp_exact_of(25), NULL);
  if (status == TP_OK) {
    status = tp_scene_set_friction_angle_deg(scene, tp_exact_of(friction_angle_deg), NULL);
  }
  if (status == TP_OK)
    status = tp_scene_set_number(scene, "loads.bond_kpa", tp_exact_text("1.1"), NULL);
  if (status == TP_OK) status = tp_scene_set_tilt_angle_deg(scene, tp_exact_of(12.5), NULL);
  return built(scene, status);
}

tp_solution *solve_in_thread(const tp_scene *scene) {
  tp_solution *solution = NULL;
  const tp_solve_options options = tp_solve_options_default();
  if (scene != NULL) (void)!tp_solve(&solution, scene, &options, NULL);
  if (solution != NULL) same_times(solution);
  return solution;
}
