/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Settings in SI units from the scene, with the defaults of engine, protocol, stiffness, damping
 * and duration. */

#include "tilt/settings.h"

#include "common/message.h"
#include "scene/check.h"
#include "scene/check_tilt_test.h"

#include <math.h>

static const double pa_per_gpa = 1e9;

static double number(const tp_quantity *given, double otherwise) {
  return given->given ? fmpq_get_d(given->value) : otherwise;
}

tp_tilt_settings tp_tilt_settings_of(const tp_scene *asks, const tp_scene *prepared) {
  const tp_tilt_test_description *test = &asks->tilt_test;
  tp_tilt_settings s = {.engine = tp_scene_tilt_engine(asks),
                        .protocol = tp_scene_tilt_protocol(asks),
                        .set_down = tp_scene_tilt_set_down(asks),
                        .stiffness_given = test->normal_stiffness_gpa_m.given};
  const bool release = s.protocol == TP_TILT_RELEASE, springs = s.engine == TP_TILT_SPRINGS;
  if (release) {
    s.release_deg = fmpq_get_d(prepared->tilt_angle_deg.value);
  } else {
    if (s.protocol == TP_TILT_RAMP && s.set_down) {
      s.from_deg = fmpq_get_d(prepared->tilt_angle_deg.value);
    }
    s.until_deg = number(&test->until_deg, 90);
    s.tolerance_deg = number(&test->tolerance_deg, 0.01);
  }
  if (!s.set_down && s.engine != TP_TILT_PATH) s.speed_deg_min = number(&test->speed_deg_min, 20);
  s.duration_s = number(&test->duration_s, 0);
  if (s.engine != TP_TILT_RIGID) {
    s.normal_stiffness_pa_m = pa_per_gpa * number(&test->normal_stiffness_gpa_m, 1000);
    s.shear_stiffness_pa_m = pa_per_gpa * number(&test->shear_stiffness_gpa_m, 10);
  }
  if (springs) {
    s.damping = number(&test->damping, 0.8);
    s.rounding_m = test->rounding.given
                       ? fmpq_get_d(test->rounding.value) * fmpq_get_d(asks->metres_per_unit)
                       : 1e-7;
    s.time_step_s = number(&test->time_step_s, 0);
  }
  s.traction_count = (size_t)test->traction_count;
  if (s.engine == TP_TILT_RIGID) s.restitution = number(&test->restitution, 0);
  return s;
}

tp_status tp_tilt_check_scene(const tp_scene *scene, tp_message *message) {
  const tp_status status = tp_check_one_block(&scene->block, message);
  if (status != TP_OK) return status;
  if (!tp_scene_is_simulated(scene)) {
    return tp_refuse(message, TP_FAULT_KEY, (tp_place){scene->path, 0, 0},
                     "the scene calls for no simulation: add 'tilt_test: {engine: path}', or "
                     "'shaking: …'");
  }
  if (scene->friction_angle_deg.given) return TP_OK;
  return tp_refuse(message, TP_FAULT_KEY, (tp_place){scene->path, 0, 0},
                   "'friction_angle_deg' is missing: without it no contact can be simulated");
}

double tp_tilt_time_scale(const tp_rigid_body *body) {
  return sqrt(body->extent_m / TP_GRAVITY_M_S2);
}

double tp_tilt_duration(const tp_tilt_settings *settings, const tp_rigid_body *body) {
  return settings->duration_s > 0 ? settings->duration_s
                                  : TP_TILT_SCALES * tp_tilt_time_scale(body);
}
