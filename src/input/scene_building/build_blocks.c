/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Calls that give a scene in memory many blocks, and their joints strength of their own. */

#include "common/host.h"
#include "scene_building/build.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- blocks ------------------------------------------------------------------------------------
 */

/* Its number where it has none. */
static tp_status make_name(char **name, const tp_build *build, const char *given) {
  enum { SIZE = 24 };
  char number[SIZE];
  snprintf(number, sizeof number, "%d", build->place.line);
  if (given != NULL && (given[0] == '\0' || strlen(given) > TP_MOST_BLOCK_NAME)) {
    return tp_refuse(build->message, TP_FAULT_ARGUMENT, build->place,
                     "the name of a block is a text of 1 to %d bytes, or NULL: its number",
                     TP_MOST_BLOCK_NAME);
  }
  *name = strdup(given != NULL ? given : number);
  return *name != NULL ? TP_OK : tp_fail_memory(build->message, "the scene");
}

tp_status tp_scene_add_block(tp_scene *scene, tp_coordinates outline, const char *name, bool ground,
                             tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  tp_build build;
  char *own_name = NULL;
  tp_polyline line = {0};
  tp_status status = tp_build_begin(&build, scene, __func__, message);
  if (status != TP_OK) return status;
  tp_block_list *many = &scene->many;
  void *blocks = many->blocks;
  status = tp_build_grow(&build, &blocks, many->count, sizeof *many->blocks);
  many->blocks = blocks;
  if (status == TP_OK) status = make_name(&own_name, &build, name);
  if (status == TP_OK) {
    status =
        tp_coordinates_read(&line, outline, true, "outline", __func__, many->count + 1, message);
  }
  if (status != TP_OK) {
    free(own_name);
    return status;
  }
  tp_listed_block *own = many->blocks + many->count++;
  tp_listed_block_init(own, build.place);
  own->name = own_name;
  own->fixed = ground;
  own->shape.outline = line;
  if (many->count == 1) many->place = (tp_place){__func__, 0, 0};
  if (scene->block.place.file == NULL) {
    scene->block.form = TP_OUTLINE_OF_EACH;
    scene->block.place = many->place;
  }
  return TP_OK;
}

/* One that was added, which the call gives more. */
static tp_status begin_block(tp_build *build, tp_listed_block **block, tp_scene *scene,
                             const char *call, size_t number, tp_message *message) {
  tp_status status = tp_build_begin(build, scene, call, message);
  if (status == TP_OK) status = tp_build_find(build, number, scene->many.count, "block");
  if (status != TP_OK) return status;
  *block = scene->many.blocks + (number - 1);
  build->place.line = (int)number;
  return TP_OK;
}

tp_status tp_scene_set_block_unit_weight_kn_m3(tp_scene *scene, size_t number,
                                               tp_exact unit_weight_kn_m3, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  const tp_given given = {"unit_weight_kn_m3", unit_weight_kn_m3, TP_RULE_UNIT_WEIGHT};
  tp_build build;
  tp_listed_block *block = NULL;
  tp_status status = begin_block(&build, &block, scene, __func__, number, message);
  if (status == TP_OK) status = tp_build_read(&build, &given, 1);
  if (status == TP_OK) tp_build_put(&build, &block->shape.unit_weight_kn_m3, 0);
  tp_build_end(&build);
  return status;
}

tp_status tp_scene_add_block_hole(tp_scene *scene, size_t number, tp_coordinates outline,
                                  tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  tp_build build;
  tp_listed_block *block = NULL;
  tp_status status = begin_block(&build, &block, scene, __func__, number, message);
  return status == TP_OK ? tp_build_hole(&build, &block->shape, outline) : status;
}

tp_status tp_scene_add_block_part(tp_scene *scene, size_t number, tp_coordinates outline,
                                  tp_exact unit_weight_kn_m3, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  tp_build build;
  tp_listed_block *block = NULL;
  tp_status status = begin_block(&build, &block, scene, __func__, number, message);
  return status == TP_OK ? tp_build_part(&build, &block->shape, outline, unit_weight_kn_m3)
                         : status;
}

/* ---- joints ------------------------------------------------------------------------------------
 */

tp_status tp_scene_add_joint(tp_scene *scene, size_t first, size_t second, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  tp_build build;
  tp_status status = tp_build_begin(&build, scene, __func__, message);
  if (status == TP_OK) status = tp_build_find(&build, first, scene->many.count, "block");
  if (status == TP_OK) status = tp_build_find(&build, second, scene->many.count, "block");
  if (status == TP_OK && first == second) {
    status = tp_refuse(message, TP_FAULT_ARGUMENT, build.place, "a joint is between two blocks");
  }
  if (status != TP_OK) return status;
  tp_block_list *many = &scene->many;
  void *joints = many->joints;
  status = tp_build_grow(&build, &joints, many->joint_count, sizeof *many->joints);
  many->joints = joints;
  if (status != TP_OK) return status;
  tp_joint_description *own = many->joints + many->joint_count++;
  tp_joint_init(own);
  own->place = build.place;
  own->between[0] = (long)first - 1;
  own->between[1] = (long)second - 1;
  return TP_OK;
}

/* One number of a joint that was added: that at an offset in it. */
static tp_status set_joint(tp_scene *scene, const char *call, size_t number, tp_given given,
                           size_t offset, tp_message *message) {
  tp_build build;
  tp_status status = tp_build_begin(&build, scene, call, message);
  if (status == TP_OK) status = tp_build_find(&build, number, scene->many.joint_count, "joint");
  if (status == TP_OK) status = tp_build_read(&build, &given, 1);
  if (status == TP_OK) {
    char *own = (char *)(scene->many.joints + (number - 1));
    tp_build_put(&build, (tp_quantity *)(void *)(own + offset), 0);
  }
  tp_build_end(&build);
  return status;
}

tp_status tp_scene_set_joint_friction_angle_deg(tp_scene *scene, size_t number, tp_exact angle_deg,
                                                tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  return set_joint(scene, __func__, number,
                   (tp_given){"angle_deg", angle_deg, TP_RULE_ANGLE_BELOW_90},
                   offsetof(tp_joint_description, friction_angle_deg), message);
}

tp_status tp_scene_set_joint_cohesion_kpa(tp_scene *scene, size_t number, tp_exact cohesion_kpa,
                                          tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  return set_joint(scene, __func__, number,
                   (tp_given){"cohesion_kpa", cohesion_kpa, TP_RULE_NOT_NEGATIVE},
                   offsetof(tp_joint_description, cohesion_kpa), message);
}

tp_status tp_scene_set_joint_tension_kpa(tp_scene *scene, size_t number, tp_exact tension_kpa,
                                         tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  return set_joint(scene, __func__, number,
                   (tp_given){"tension_kpa", tension_kpa, TP_RULE_NOT_NEGATIVE},
                   offsetof(tp_joint_description, tension_kpa), message);
}
