/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Calls that put water about the block of a scene in memory: a level, a surface, a filled crack,
 * and ice on it. */

#include "common/host.h"
#include "scene_building/build.h"

static tp_status check_words(const tp_build *build, tp_water_faces faces, tp_water_uplift uplift) {
  if ((int)faces < 0 || faces > TP_WATER_ON_BOTH) {
    return tp_refuse(build->message, TP_FAULT_ARGUMENT, build->place, "there are no such faces");
  }
  if ((int)uplift < 0 || uplift > TP_WATER_UPLIFT_FULL) {
    return tp_refuse(build->message, TP_FAULT_ARGUMENT, build->place, "there is no such uplift");
  }
  return TP_OK;
}

/* It stands about the block, and no longer behind it to a height. */
static void put_water(tp_build *build) {
  enum { GAMMA_W = 981, PER_UNIT = 100 };
  tp_water_description *water = &build->scene->loads.water;
  tp_build_note_load(build);
  if (!water->given) {
    fmpq_set_si(water->unit_weight_kn_m3.value, GAMMA_W, PER_UNIT);
    water->uplift = true;
  }
  if (water->height.given) water->uplift = true;
  water->given = true;
  water->place = build->place;
  water->height.given = water->stays_level = false;
  fmpq_zero(water->height.value);
}

static void put_words(tp_build *build, tp_water_faces faces, tp_water_uplift uplift) {
  tp_water_description *water = &build->scene->loads.water;
  water->faces = faces;
  water->shape = uplift;
  water->uplift = uplift != TP_WATER_UPLIFT_NONE;
}

tp_status tp_scene_set_water_level(tp_scene *scene, tp_exact level, tp_exact unit_weight_kn_m3,
                                   tp_water_faces faces, tp_water_uplift uplift,
                                   tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  const tp_given given[] = {{"level", level, TP_RULE_ANY},
                            {"unit_weight_kn_m3", unit_weight_kn_m3, TP_RULE_NOT_NEGATIVE}};
  tp_build build;
  tp_status status = tp_build_begin(&build, scene, __func__, message);
  if (status == TP_OK) status = check_words(&build, faces, uplift);
  if (status == TP_OK) status = tp_build_read(&build, given, 2);
  if (status == TP_OK) {
    tp_water_description *water = &scene->loads.water;
    put_water(&build);
    put_words(&build, faces, uplift);
    tp_polyline_clear(&water->surface);
    tp_build_put(&build, &water->level, 0);
    tp_build_put(&build, &water->unit_weight_kn_m3, 1);
  }
  tp_build_end(&build);
  return status;
}

tp_status tp_scene_set_water_surface(tp_scene *scene, tp_coordinates points,
                                     tp_exact unit_weight_kn_m3, tp_water_faces faces,
                                     tp_water_uplift uplift, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  const tp_given given = {"unit_weight_kn_m3", unit_weight_kn_m3, TP_RULE_NOT_NEGATIVE};
  tp_build build;
  tp_polyline surface = {0};
  tp_status status = tp_build_begin(&build, scene, __func__, message);
  if (status == TP_OK) status = check_words(&build, faces, uplift);
  if (status == TP_OK) status = tp_build_read(&build, &given, 1);
  if (status == TP_OK && points.count < 2) {
    status = tp_refuse(message, TP_FAULT_ARGUMENT, build.place,
                       "the surface of the water needs two points at least, not %zu", points.count);
  }
  if (status == TP_OK) {
    status = tp_coordinates_read(&surface, points, false, "points", build.place.file, 0, message);
  }
  if (status == TP_OK) {
    tp_water_description *water = &scene->loads.water;
    put_water(&build);
    put_words(&build, faces, uplift);
    tp_polyline_clear(&water->surface);
    water->surface = surface;
    water->level.given = false;
    tp_build_put(&build, &water->unit_weight_kn_m3, 0);
  } else {
    tp_polyline_clear(&surface);
  }
  tp_build_end(&build);
  return status;
}

tp_status tp_scene_set_tension_crack_level(tp_scene *scene, tp_exact level, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  const tp_given given = {"level", level, TP_RULE_ANY};
  tp_build build;
  tp_status status = tp_build_begin(&build, scene, __func__, message);
  if (status == TP_OK) status = tp_build_read(&build, &given, 1);
  if (status == TP_OK) {
    tp_water_description *water = &scene->loads.water;
    put_water(&build);
    water->cracked = true;
    water->crack_height.given = water->crack_distance.given = false;
    tp_build_put(&build, &water->crack_level, 0);
  }
  tp_build_end(&build);
  return status;
}

tp_status tp_scene_set_tension_crack_height(tp_scene *scene, tp_exact height, tp_exact distance,
                                            tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  const tp_given given[] = {{"height", height, TP_RULE_NOT_NEGATIVE},
                            {"distance", distance, TP_RULE_NOT_NEGATIVE}};
  tp_build build;
  tp_status status = tp_build_begin(&build, scene, __func__, message);
  if (status == TP_OK) status = tp_build_read(&build, given, 2);
  if (status == TP_OK) {
    tp_water_description *water = &scene->loads.water;
    put_water(&build);
    water->cracked = true;
    water->crack_level.given = false;
    tp_build_put(&build, &water->crack_height, 0);
    tp_build_put(&build, &water->crack_distance, 1);
  }
  tp_build_end(&build);
  return status;
}

tp_status tp_scene_set_ice(tp_scene *scene, tp_exact ice_kpa, tp_exact ice_thickness,
                           tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  const tp_given given[] = {{"ice_kpa", ice_kpa, TP_RULE_NOT_NEGATIVE},
                            {"ice_thickness", ice_thickness, TP_RULE_NOT_NEGATIVE}};
  tp_build build;
  tp_status status = tp_build_begin(&build, scene, __func__, message);
  if (status == TP_OK && !tp_water_is_sited(&scene->loads.water)) {
    status = tp_refuse(message, TP_FAULT_ARGUMENT, build.place,
                       "ice lies on water that has a level: set that before");
  }
  if (status == TP_OK) status = tp_build_read(&build, given, 2);
  if (status == TP_OK) {
    tp_build_put(&build, &scene->loads.water.ice_kpa, 0);
    tp_build_put(&build, &scene->loads.water.ice_thickness, 1);
  }
  tp_build_end(&build);
  return status;
}
