/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "stability/varied.h"

#include <stdio.h>

tp_status tp_varied_solve(tp_solution **solution, const tp_varied *scene, const double *values,
                          tp_message *message) {
  char texts[TP_VARIED_MAX][40];
  char *held[TP_VARIED_MAX];
  for (size_t k = 0; k < scene->count; k++) {
    snprintf(texts[k], sizeof texts[k], "%.17g", values[k]);
    held[k] = scene->numbers[k]->text;
    scene->numbers[k]->text = texts[k];
  }
  tp_scene *read = NULL;
  tp_status status = tp_scene_from_nodes(&read, scene->path, scene->root, message);
  if (status == TP_OK) status = tp_solve(solution, read, &scene->options, message);
  tp_scene_free(read);
  for (size_t k = 0; k < scene->count; k++) scene->numbers[k]->text = held[k];
  return status;
}

tp_status tp_varied_check(double *own, const tp_varied *scene, tp_message *message) {
  tp_scene *read = NULL;
  tp_status status = tp_scene_from_nodes(&read, scene->path, scene->root, message);
  if (status != TP_OK) return status;
  fmpq_t value;
  fmpq_init(value);
  tp_place place = tp_node_place(scene->numbers[0], scene->path);
  place.column += scene->numbers[0]->text_offset;
  if (read->towards_left && read->towards_right && read->frame != TP_FRAME_WORLD) {
    status = tp_fail(message, TP_BAD_INPUT, (tp_place){scene->path, 0, 0},
                     "this scene tilts both ways; say which, 'tilt: {towards: left}'");
  } else {
    status =
        tp_expression_evaluate(value, scene->numbers[0]->text, place, &read->parameters, message);
  }
  if (status == TP_OK) *own = fmpq_get_d(value);
  fmpq_clear(value);
  tp_scene_free(read);
  return status;
}

bool tp_varied_has_friction(const tp_varied *scene) {
  return tp_node_get(scene->root, "friction_angle_deg") != NULL ||
         tp_node_get(scene->root, "friction") != NULL;
}
