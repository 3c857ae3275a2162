/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Calls that add to a scene of many blocks in memory what a scene of one has not: forces from
 * outside, bolts to a point or into a block, the block of a load, and the support asked for. */

#include "common/host.h"
#include "scene_building/build.h"

tp_status tp_scene_add_bolt_to(tp_scene *scene, tp_exact x, tp_exact y, tp_exact to_x,
                               tp_exact to_y, tp_exact force_kn, bool passive,
                               tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  const tp_pull pull = {
      .x = x,
      .y = y,
      .force_kn = force_kn,
      .passive = passive,
      .way = {{"to_x", to_x, TP_RULE_ANY}, {"to_y", to_y, TP_RULE_ANY}},
      .members = {offsetof(tp_anchor_description, to_x), offsetof(tp_anchor_description, to_y)}};
  return tp_build_pull(scene, __func__, TP_LIST_ANCHORS, &pull, message);
}

tp_status tp_scene_add_force(tp_scene *scene, tp_exact x, tp_exact y, tp_exact direction_deg,
                             tp_exact force_kn, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  const tp_pull pull = {.x = x,
                        .y = y,
                        .force_kn = force_kn,
                        .way = {{"direction_deg", direction_deg, TP_RULE_ANY}},
                        .members = {offsetof(tp_anchor_description, direction_deg)}};
  return tp_build_pull(scene, __func__, TP_LIST_FORCES, &pull, message);
}

tp_status tp_scene_set_bolt_into(tp_scene *scene, size_t number, size_t block,
                                 tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  tp_build build;
  tp_status status = tp_build_begin(&build, scene, __func__, message);
  if (status == TP_OK) status = tp_build_find(&build, number, scene->loads.anchor_count, "bolt");
  if (status == TP_OK) status = tp_build_find(&build, block, scene->many.count, "block");
  if (status == TP_OK) scene->loads.anchors[number - 1].into = (long)block - 1;
  return status;
}

/* The list of such loads, and where an item of it has its block. */
static tp_status list_of(tp_list_kind *list, size_t *offset, const tp_build *build,
                         tp_placed_load load) {
  static const size_t of_line = offsetof(tp_line_load, block),
                      of_anchor = offsetof(tp_anchor_description, block);
  const struct {
    tp_list_kind list;
    size_t offset;
  } lists[] = {[TP_PLACED_PRESSURE] = {TP_LIST_PRESSURES, of_line},
               [TP_PLACED_SURCHARGE] = {TP_LIST_SURCHARGES, of_line},
               [TP_PLACED_SUPPORT_PRESSURE] = {TP_LIST_SUPPORTS, of_line},
               [TP_PLACED_BOLT] = {TP_LIST_ANCHORS, of_anchor},
               [TP_PLACED_FORCE] = {TP_LIST_FORCES, of_anchor}};
  if ((int)load < 0 || (size_t)load >= sizeof lists / sizeof lists[0]) {
    return tp_refuse(build->message, TP_FAULT_ARGUMENT, build->place, "there is no such load");
  }
  *list = lists[load].list;
  *offset = lists[load].offset;
  return TP_OK;
}

tp_status tp_scene_set_load_block(tp_scene *scene, tp_placed_load load, size_t number, size_t block,
                                  tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  tp_build build;
  tp_list_kind list = TP_LISTS;
  size_t offset = 0;
  tp_status status = tp_build_begin(&build, scene, __func__, message);
  if (status == TP_OK) status = list_of(&list, &offset, &build, load);
  if (status == TP_OK) {
    status = tp_build_find(&build, number, tp_member_count(scene, list), "load");
  }
  if (status == TP_OK) status = tp_build_find(&build, block, scene->many.count, "block");
  if (status != TP_OK) return status;
  char *item = tp_member_items(scene, list) + (number - 1) * tp_scene_lists[list].size;
  *(long *)(void *)(item + offset) = (long)block - 1;
  return TP_OK;
}

tp_status tp_scene_set_support(tp_scene *scene, size_t block, tp_exact x, tp_exact y,
                               tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  const tp_given given[] = {{"x", x, TP_RULE_ANY}, {"y", y, TP_RULE_ANY}};
  tp_build build;
  tp_status status = tp_build_begin(&build, scene, __func__, message);
  if (status == TP_OK) status = tp_build_find(&build, block, scene->many.count, "block");
  if (status == TP_OK) status = tp_build_read(&build, given, 2);
  if (status == TP_OK) {
    tp_support_description *own = &scene->many.support;
    own->place = build.place;
    own->block = (long)block - 1;
    tp_build_put(&build, &own->x, 0);
    tp_build_put(&build, &own->y, 1);
  }
  tp_build_end(&build);
  return status;
}
