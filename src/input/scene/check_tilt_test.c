/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Defaults of engine, protocol and start, and the settings that each engine and protocol admits
 * (docs/tilt.md). */

#include "scene/check_tilt_test.h"

bool tp_scene_is_shaken(const tp_scene *scene) {
  return scene->shaking_place.file != NULL;
}

bool tp_scene_is_simulated(const tp_scene *scene) {
  return scene->tilt_test.place.file != NULL || tp_scene_is_shaken(scene);
}

tp_tilt_engine tp_scene_tilt_engine(const tp_scene *scene) {
  if (scene->tilt_test.engine_place.file != NULL) return scene->tilt_test.engine;
  return tp_scene_is_shaken(scene) ? TP_TILT_RIGID : TP_TILT_PATH;
}

tp_tilt_protocol tp_scene_tilt_protocol(const tp_scene *scene) {
  if (scene->tilt_test.protocol_place.file != NULL) return scene->tilt_test.protocol;
  return tp_scene_is_shaken(scene) ? TP_TILT_RELEASE : TP_TILT_RAMP;
}

bool tp_scene_tilt_set_down(const tp_scene *scene) {
  if (scene->tilt_test.start_place.file != NULL) return scene->tilt_test.set_down;
  return tp_scene_tilt_protocol(scene) != TP_TILT_RAMP;
}

/* A setting that only some engines have. */
static tp_status check_own(const tp_quantity *quantity, bool own, const char *key,
                           const char *whose, tp_message *message) {
  if (!quantity->given || own) return TP_OK;
  return tp_refuse(message, TP_FAULT_KEY, quantity->place,
                   "'%s' belongs to %s; leave it out, or choose that", key, whose);
}

static tp_status check_settings(const tp_scene *scene, tp_tilt_engine engine,
                                tp_tilt_protocol protocol, tp_message *message) {
  const tp_tilt_test_description *t = &scene->tilt_test;
  const bool ramps = !tp_scene_tilt_set_down(scene);
  const bool springs = engine == TP_TILT_SPRINGS, rigid = engine == TP_TILT_RIGID;
  static const char of_springs[] = "'engine: dynamics' by 'method: springs'",
                    of_rigid[] = "'engine: dynamics' by 'method: events'";
  const struct {
    const tp_quantity *quantity;
    bool own;
    const char *key, *whose;
  } all[] = {{&t->damping, springs, "damping", of_springs},
             {&t->rounding, springs, "rounding", of_springs},
             {&t->time_step_s, springs, "time_step_s", of_springs},
             {&t->restitution, rigid, "restitution", of_rigid},
             {&t->normal_stiffness_gpa_m, !rigid, "normal_stiffness_gpa_m",
              "contacts that are springs: 'engine: path' or 'method: springs'"},
             {&t->shear_stiffness_gpa_m, !rigid, "shear_stiffness_gpa_m",
              "contacts that are springs: 'engine: path' or 'method: springs'"},
             {&t->speed_deg_min, ramps && engine != TP_TILT_PATH, "speed_deg_min",
              "a table that moves in time, 'engine: dynamics' with 'start: level'; the path is "
              "quasi-static"},
             {&t->until_deg, protocol != TP_TILT_RELEASE, "until_deg",
              "a table that is tilted, 'protocol: ramp' or 'steps'"},
             {&t->duration_s, engine != TP_TILT_PATH, "duration_s", "'engine: dynamics'"}};
  tp_status status = TP_OK;
  for (size_t k = 0; k < sizeof all / sizeof all[0] && status == TP_OK; k++) {
    status = check_own(all[k].quantity, all[k].own, all[k].key, all[k].whose, message);
  }
  return status;
}

/* Either stiffness without the other; none, where springs need them. */
static tp_status check_stiffness(const tp_tilt_test_description *t, tp_tilt_engine engine,
                                 tp_message *message) {
  const bool normal = t->normal_stiffness_gpa_m.given, shear = t->shear_stiffness_gpa_m.given;
  if (normal == shear && (normal || engine != TP_TILT_SPRINGS)) return TP_OK;
  return tp_refuse(message, TP_FAULT_KEY, t->place,
                   "the springs of the contact need both 'normal_stiffness_gpa_m' and "
                   "'shear_stiffness_gpa_m'; no stiffness is assumed; the paper's tests have "
                   "1000 and 10");
}

static tp_status check_tractions(const tp_tilt_test_description *t, tp_tilt_engine engine,
                                 tp_message *message) {
  if (t->traction_count > 0 && engine != TP_TILT_PATH) {
    return tp_refuse(
        message, TP_FAULT_KEY, t->tractions[0].place,
        "stress locked in before the start belongs to 'engine: path'; leave 'tractions' "
        "out, or choose that");
  }
  for (long k = 0; k < t->traction_count; k++) {
    for (long j = 0; j < k; j++) {
      if (t->tractions[j].facet != t->tractions[k].facet) continue;
      return tp_refuse(message, TP_FAULT_KEY, t->tractions[k].place,
                       "the stress locked in on facet %ld is given twice", t->tractions[k].facet);
    }
  }
  return TP_OK;
}

static tp_status check_protocol(const tp_scene *scene, tp_tilt_engine engine,
                                tp_tilt_protocol protocol, tp_message *message) {
  const tp_tilt_test_description *t = &scene->tilt_test;
  const tp_place place = t->protocol_place.file != NULL ? t->protocol_place : t->place;
  if (tp_scene_is_shaken(scene)) {
    if (engine == TP_TILT_PATH) {
      return tp_refuse(
          message, TP_FAULT_KEY, t->engine_place,
          "the path is quasi-static and does not model shaking; say 'engine: dynamics'");
    }
    if (protocol != TP_TILT_RELEASE) {
      return tp_refuse(message, TP_FAULT_KEY, place,
                       "the table is held at its tilt while its base shakes: say 'protocol: "
                       "release', with 'tilt: {angle_deg: …}' where it is not level");
    }
    return TP_OK;
  }
  if (protocol == TP_TILT_RELEASE) {
    if (engine == TP_TILT_PATH) {
      return tp_refuse(message, TP_FAULT_KEY, place,
                       "a released block moves in time: a release needs 'engine: dynamics'");
    }
    if (!scene->tilt_angle_deg.given) {
      return tp_refuse(
          message, TP_FAULT_KEY, place,
          "a release needs the tilt at which the block is released: 'tilt: {angle_deg: "
          "…}'");
    }
  }
  const bool set_down = tp_scene_tilt_set_down(scene);
  if (protocol == TP_TILT_STEPS && engine == TP_TILT_PATH && !set_down) {
    return tp_refuse(message, TP_FAULT_KEY, t->start_place,
                     "the path of a block that is placed level is one ramp to all angles: say "
                     "'protocol: ramp', or 'start: set_down'");
  }
  if (protocol == TP_TILT_RAMP && set_down) {
    if (engine == TP_TILT_PATH && scene->tilt_angle_deg.given) return TP_OK;
    return tp_refuse(message, TP_FAULT_KEY, t->start_place,
                     "a ramp starts level, or by 'engine: path' set down at the scene's 'tilt: "
                     "{angle_deg: …}'; a block that is set down at each angle goes with 'protocol: "
                     "steps'");
  }
  if (protocol == TP_TILT_RELEASE && !set_down) {
    return tp_refuse(
        message, TP_FAULT_KEY, t->start_place,
        "a release begins at its tilt, where the block is set down; leave 'start' out");
  }
  return TP_OK;
}

tp_status tp_check_simulation(const tp_scene *scene, tp_message *message) {
  if (!tp_scene_is_simulated(scene)) return TP_OK;
  const tp_tilt_engine engine = tp_scene_tilt_engine(scene);
  const tp_tilt_protocol protocol = tp_scene_tilt_protocol(scene);
  tp_status status = check_protocol(scene, engine, protocol, message);
  if (status == TP_OK) status = check_stiffness(&scene->tilt_test, engine, message);
  if (status == TP_OK) status = check_settings(scene, engine, protocol, message);
  if (status == TP_OK) status = check_tractions(&scene->tilt_test, engine, message);
  return status;
}
