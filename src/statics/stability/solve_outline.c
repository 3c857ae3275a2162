/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The block of one outline in an array: a scene made of it, solved and given back. */

#include "common/host.h"
#include "topple_solve.h"

static tp_status describe(tp_scene *scene, tp_coordinates outline, double friction_angle_deg,
                          double tilt_angle_deg, tp_message *message) {
  tp_status status = tp_scene_set_outline(scene, outline, message);
  if (status == TP_OK) {
    status = tp_scene_set_friction_angle_deg(scene, tp_exact_of(friction_angle_deg), message);
  }
  if (status == TP_OK) {
    status = tp_scene_set_tilt_angle_deg(scene, tp_exact_of(tilt_angle_deg), message);
  }
  return status;
}

tp_status tp_solve_outline(tp_solution **solution, const double *outline, size_t vertices,
                           const char *length_unit, double friction_angle_deg,
                           double tilt_angle_deg, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, solution);
  TP_REFUSE_NULL(message, length_unit);
  TP_REFUSE_NULL(message, outline);
  const tp_solve_options options = tp_solve_options_default();
  tp_scene *scene = NULL;
  tp_status status = tp_scene_new(&scene, length_unit, message);
  if (status == TP_OK) {
    status = describe(scene, tp_coordinates_of(outline, vertices), friction_angle_deg,
                      tilt_angle_deg, message);
  }
  if (status == TP_OK) status = tp_solve(solution, scene, &options, message);
  tp_scene_free(scene);
  return status;
}
