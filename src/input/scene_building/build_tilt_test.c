/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Calls that set the engine, protocol and numbers of a simulated tilt test in a scene in memory. */

#include "common/host.h"
#include "scene_building/build.h"

tp_status tp_scene_set_tilt_test(tp_scene *scene, tp_tilt_engine engine, tp_tilt_protocol protocol,
                                 bool set_down, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  tp_build build;
  const tp_status status = tp_build_begin(&build, scene, __func__, message);
  if (status != TP_OK) return status;
  if ((int)engine < TP_TILT_PATH || (int)engine > TP_TILT_SPRINGS) {
    return tp_refuse(message, TP_FAULT_ARGUMENT, build.place,
                     "'engine' must be one of tp_tilt_engine");
  }
  if ((int)protocol < TP_TILT_RAMP || (int)protocol > TP_TILT_RELEASE) {
    return tp_refuse(message, TP_FAULT_ARGUMENT, build.place,
                     "'protocol' must be one of tp_tilt_protocol");
  }
  tp_tilt_test_description *test = &scene->tilt_test;
  test->place = test->engine_place = test->protocol_place = test->start_place = build.place;
  test->engine = engine;
  test->protocol = protocol;
  test->set_down = set_down;
  return TP_OK;
}

tp_status tp_scene_set_tilt_test_stiffness_gpa_m(tp_scene *scene, tp_exact normal_gpa_m,
                                                 tp_exact shear_gpa_m, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  const tp_given given[] = {{"normal_gpa_m", normal_gpa_m, TP_RULE_ABOVE_ZERO},
                            {"shear_gpa_m", shear_gpa_m, TP_RULE_ABOVE_ZERO}};
  tp_build build;
  tp_status status = tp_build_begin(&build, scene, __func__, message);
  if (status == TP_OK) status = tp_build_read(&build, given, 2);
  if (status == TP_OK) {
    tp_tilt_test_description *test = &scene->tilt_test;
    tp_build_put(&build, &test->normal_stiffness_gpa_m, 0);
    tp_build_put(&build, &test->shear_stiffness_gpa_m, 1);
    if (test->place.file == NULL) test->place = build.place;
  }
  tp_build_end(&build);
  return status;
}

tp_status tp_scene_add_tilt_test_traction(tp_scene *scene, size_t facet, tp_exact first_kpa,
                                          tp_exact last_kpa, tp_exact shear_kpa,
                                          tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  const tp_given given[] = {{"first_kpa", first_kpa, TP_RULE_ANY},
                            {"last_kpa", last_kpa, TP_RULE_ANY},
                            {"shear_kpa", shear_kpa, TP_RULE_ANY}};
  long number = 0;
  tp_build build;
  tp_status status = tp_build_begin(&build, scene, __func__, message);
  if (status == TP_OK) status = tp_build_read(&build, given, 3);
  if (status == TP_OK) status = tp_build_facet_number(&build, &number, facet);
  tp_tilt_test_description *test = &scene->tilt_test;
  if (status == TP_OK) {
    void *items = test->tractions;
    status = tp_build_grow(&build, &items, test->traction_count, sizeof *test->tractions);
    test->tractions = items;
  }
  if (status == TP_OK) {
    tp_traction_description *own = test->tractions + test->traction_count++;
    tp_traction_description_init(own);
    own->place = build.place;
    own->facet = number;
    tp_build_put(&build, &own->first_kpa, 0);
    tp_build_put(&build, &own->last_kpa, 1);
    tp_build_put(&build, &own->shear_kpa, 2);
    if (test->place.file == NULL) test->place = build.place;
  }
  tp_build_end(&build);
  return status;
}
