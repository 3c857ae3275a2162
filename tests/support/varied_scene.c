/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "varied_scene.h"

tp_scene *read_text(const char *text) {
  tp_scene *scene = NULL;
  DO(tp_scene_read_text(&scene, text, "scene in memory", &message));
  return scene;
}

tp_scene *with(const tp_scene *scene, const char *key, tp_exact value) {
  tp_scene *varied = NULL;
  DO(tp_scene_with(&varied, scene, key, value, &message));
  return varied;
}

char *solved(tp_scene *scene) {
  char *json = solve(scene, 9);
  tp_scene_free(scene);
  return json;
}

tp_scene *slab(double width) {
  const double outline[] = {0, 0, width, 0, width, 6, 0, 6};
  tp_scene *scene = new_scene("m");
  DO(tp_scene_set_outline(scene, tp_coordinates_of(outline, 4), &message));
  DO(tp_scene_set_friction_angle_deg(scene, E(30), &message));
  DO(tp_scene_set_tilt_towards(scene, true, false, &message));
  DO(tp_scene_set_tilt_angle_deg(scene, E(10), &message));
  return scene;
}
