/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A scene in memory: friction of its contact, one angle or a law, and what facets have of their
 * own. */

#include "common/host.h"
#include "scene_building/build.h"

/* The angle is the first number of the call; a law that was set before is dropped. */
static tp_friction_description *put_angle(tp_build *build) {
  tp_friction_description *law = &build->scene->friction;
  law->load_dependent = law->basic_angle_deg.given = false;
  law->jrc.given = law->jcs_mpa.given = law->roughness_angle_deg.given = false;
  law->test_angle_deg.given = law->test_stress_kpa.given = false;
  tp_build_put(build, &build->scene->friction_angle_deg, 0);
  return law;
}

static tp_status begin(tp_build *build, tp_scene *scene, const char *call, const tp_given *given,
                       long count, tp_message *message) {
  const tp_status status = tp_build_begin(build, scene, call, message);
  return status == TP_OK ? tp_build_read(build, given, count) : status;
}

tp_status tp_scene_set_friction_angle_deg(tp_scene *scene, tp_exact angle_deg,
                                          tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  const tp_given given = {"angle_deg", angle_deg, TP_RULE_ANGLE_BELOW_90};
  tp_build build;
  const tp_status status = begin(&build, scene, __func__, &given, 1, message);
  if (status == TP_OK) (void)put_angle(&build);
  tp_build_end(&build);
  return status;
}

tp_status tp_scene_set_friction_patton(tp_scene *scene, tp_exact basic_angle_deg,
                                       tp_exact roughness_angle_deg, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  const tp_given given[] = {{"basic_angle_deg", basic_angle_deg, TP_RULE_ANGLE_BELOW_90},
                            {"roughness_angle_deg", roughness_angle_deg, TP_RULE_ANGLE_BELOW_90},
                            {"basic_angle_deg", basic_angle_deg, TP_RULE_ANGLE_BELOW_90}};
  tp_build build;
  tp_status status = begin(&build, scene, __func__, given, 3, message);
  if (status == TP_OK) {
    fmpq_add(build.values, build.values, build.values + 1);
    status = tp_check_patton(build.values, build.place, message);
  }
  if (status == TP_OK) {
    tp_friction_description *law = put_angle(&build);
    tp_build_put(&build, &law->roughness_angle_deg, 1);
    tp_build_put(&build, &law->basic_angle_deg, 2);
  }
  tp_build_end(&build);
  return status;
}

/* JCS is the second number of the call. */
static tp_friction_description *put_barton(tp_build *build) {
  tp_friction_description *law = put_angle(build);
  law->load_dependent = true;
  tp_build_put(build, &law->jcs_mpa, 1);
  return law;
}

tp_status tp_scene_set_friction_barton(tp_scene *scene, tp_exact residual_angle_deg, tp_exact jrc,
                                       tp_exact jcs_mpa, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  const tp_given given[] = {{"residual_angle_deg", residual_angle_deg, TP_RULE_ANGLE_BELOW_90},
                            {"jcs_mpa", jcs_mpa, TP_RULE_ABOVE_ZERO},
                            {"jrc", jrc, TP_RULE_JRC}};
  tp_build build;
  const tp_status status = begin(&build, scene, __func__, given, 3, message);
  if (status == TP_OK) tp_build_put(&build, &put_barton(&build)->jrc, 2);
  tp_build_end(&build);
  return status;
}

tp_status tp_scene_set_friction_barton_test(tp_scene *scene, tp_exact residual_angle_deg,
                                            tp_exact test_angle_deg,
                                            tp_exact test_normal_stress_kpa, tp_exact jcs_mpa,
                                            tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  const tp_given given[] = {{"residual_angle_deg", residual_angle_deg, TP_RULE_ANGLE_BELOW_90},
                            {"jcs_mpa", jcs_mpa, TP_RULE_ABOVE_ZERO},
                            {"test_angle_deg", test_angle_deg, TP_RULE_ANGLE_BELOW_90},
                            {"test_normal_stress_kpa", test_normal_stress_kpa, TP_RULE_ABOVE_ZERO}};
  tp_build build;
  tp_status status = begin(&build, scene, __func__, given, 4, message);
  if (status == TP_OK) {
    status = tp_check_tilt_test(build.values + 2, build.values + 3, build.values, build.values + 1,
                                build.place, message);
  }
  if (status == TP_OK) {
    tp_friction_description *law = put_barton(&build);
    tp_build_put(&build, &law->test_angle_deg, 2);
    tp_build_put(&build, &law->test_stress_kpa, 3);
  }
  tp_build_end(&build);
  return status;
}

tp_status tp_scene_set_friction_barton_roughness(tp_scene *scene, tp_exact residual_angle_deg,
                                                 tp_exact roughness_angle_deg, tp_exact jcs_mpa,
                                                 tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  const tp_given given[] = {{"residual_angle_deg", residual_angle_deg, TP_RULE_ANGLE_BELOW_90},
                            {"jcs_mpa", jcs_mpa, TP_RULE_ABOVE_ZERO},
                            {"roughness_angle_deg", roughness_angle_deg, TP_RULE_ANGLE_BELOW_90}};
  tp_build build;
  const tp_status status = begin(&build, scene, __func__, given, 3, message);
  if (status == TP_OK) tp_build_put(&build, &put_barton(&build)->roughness_angle_deg, 2);
  tp_build_end(&build);
  return status;
}

/* What a call gives facets, from number `first` to `last`; or where the numbers of the build begin
 * with two abscissas, between these. The angle is the last number. */
static tp_status add_facets(tp_build *build, const tp_facet_friction_description *given) {
  tp_friction_description *law = &build->scene->friction;
  void *items = law->facets;
  tp_status status = tp_build_grow(build, &items, law->facet_count, sizeof *law->facets);
  law->facets = items;
  if (status != TP_OK) return status;
  tp_facet_friction_description *own = law->facets + law->facet_count;
  tp_facet_friction_description_init(own);
  own->place = build->place;
  own->first = given->first;
  own->last = given->last;
  tp_build_put(build, &own->angle_deg, build->count - 1);
  if (build->count > 1) {
    tp_build_put(build, &own->x0, 0);
    tp_build_put(build, &own->x1, 1);
  }
  status = tp_check_facet_range(own, build->message);
  if (status == TP_OK) {
    law->facet_count++;
  } else {
    fmpq_clear(own->x0.value);
    fmpq_clear(own->x1.value);
    fmpq_clear(own->angle_deg.value);
  }
  return status;
}

tp_status tp_build_facet_number(const tp_build *build, long *number, size_t facet) {
  fmpq_t value;
  fmpq_init(value);
  fmpz_set_ui(fmpq_numref(value), facet);
  const tp_status status = tp_check_facet_number(number, value, build->place, build->message);
  fmpq_clear(value);
  return status;
}

tp_status tp_scene_add_friction_facets(tp_scene *scene, size_t first, size_t last,
                                       tp_exact angle_deg, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  const tp_given given = {"angle_deg", angle_deg, TP_RULE_ANGLE_BELOW_90};
  tp_facet_friction_description facets = {.first = 0};
  tp_build build;
  tp_status status = begin(&build, scene, __func__, &given, 1, message);
  if (status == TP_OK) status = tp_build_facet_number(&build, &facets.first, first);
  if (status == TP_OK) status = tp_build_facet_number(&build, &facets.last, last);
  if (status == TP_OK) status = add_facets(&build, &facets);
  tp_build_end(&build);
  return status;
}

tp_status tp_scene_add_friction_between(tp_scene *scene, tp_exact x0, tp_exact x1,
                                        tp_exact angle_deg, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  const tp_given given[] = {{"x0", x0, TP_RULE_ANY},
                            {"x1", x1, TP_RULE_ANY},
                            {"angle_deg", angle_deg, TP_RULE_ANGLE_BELOW_90}};
  const tp_facet_friction_description facets = {.first = 0};
  tp_build build;
  tp_status status = begin(&build, scene, __func__, given, 3, message);
  if (status == TP_OK) status = add_facets(&build, &facets);
  tp_build_end(&build);
  return status;
}

tp_status tp_scene_set_friction_is_apparent(tp_scene *scene, bool apparent, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  tp_build build;
  const tp_status status = tp_build_begin(&build, scene, __func__, message);
  if (status == TP_OK) {
    scene->friction_is_apparent = apparent;
    scene->friction_is_basic = !apparent;
    scene->friction_is_place = build.place;
  }
  tp_build_end(&build);
  return status;
}
