/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Reads doubles as the exact decimals of 17 digits, varies the scene by its keys
 * (scene_varying/vary.h) and solves it. */

#include "stability/varied.h"
#include "stability/tilts.h"

#include "number/ratio.h"
#include "scene_varying/load_case.h"

#include <stdio.h>
#include <string.h>

/* Decimals have fewer digits than the doubles that they name. */
static tp_status read_values(fmpq *numbers, const tp_varied *varied, const double *values,
                             tp_message *message) {
  for (size_t k = 0; k < varied->count; k++) {
    char text[40];
    const char *problem = NULL;
    snprintf(text, sizeof text, "%.17g", values[k]);
    if (tp_ratio_read_field(numbers + k, text, strlen(text), &problem)) continue;
    return tp_refuse(message, TP_FAULT_KEY, tp_scene_key_place(varied->keys + k, varied->scene),
                     "'%s' %s", text, problem);
  }
  return TP_OK;
}

tp_status tp_varied_scene(tp_scene **scene, const tp_varied *varied, const double *values,
                          tp_message *message) {
  fmpq numbers[TP_VARIED_MAX];
  for (size_t k = 0; k < TP_VARIED_MAX; k++) fmpq_init(numbers + k);
  tp_status status = read_values(numbers, varied, values, message);
  if (status == TP_OK) {
    status = tp_scene_vary(scene, varied->scene, varied->keys, numbers, varied->count, message);
  }
  for (size_t k = 0; k < TP_VARIED_MAX; k++) fmpq_clear(numbers + k);
  return status;
}

tp_status tp_varied_solve(tp_solution **solution, const tp_varied *varied, const double *values,
                          tp_message *message) {
  tp_scene *scene = NULL;
  tp_status status = tp_varied_scene(&scene, varied, values, message);
  if (status == TP_OK) {
    scene->base.all_poses = false; /* of one number after another nobody reads them */
    status = tp_solve_numbers(solution, scene, &varied->options, message);
  }
  tp_scene_free(scene);
  return status;
}

tp_status tp_varied_check(double *own, const tp_varied *varied, tp_message *message) {
  const tp_scene *scene = varied->scene;
  const tp_status chosen = tp_check_load_case(scene, message);
  if (chosen != TP_OK) return chosen;
  if (scene->towards_left && scene->towards_right && !tp_scene_lies_in_place(scene)) {
    return tp_refuse(message, TP_FAULT_KEY, (tp_place){scene->path, 0, 0},
                     "this scene tilts both ways; choose one, 'tilt: {towards: left}'");
  }
  fmpq_t value;
  fmpq_init(value);
  const tp_status status = tp_scene_key_value(value, varied->keys, scene, message);
  if (status == TP_OK) *own = fmpq_get_d(value);
  fmpq_clear(value);
  return status;
}
