/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Calls that make edges of the outline arcs, by a point or a bulge, and round its corners. */

#include "common/host.h"
#include "scene_building/build.h"

/* Room for one more arc, and its numbers read. */
static tp_status begin_arc(tp_build *build, tp_scene *scene, const char *call,
                           const tp_given *given, long count, tp_message *message) {
  tp_status status = tp_build_begin(build, scene, call, message);
  if (status == TP_OK) status = tp_build_read(build, given, count);
  if (status != TP_OK) return status;
  tp_block_description *block = &scene->block;
  void *arcs = block->arcs;
  status = tp_build_grow(build, &arcs, block->arc_count, sizeof *block->arcs);
  block->arcs = arcs;
  if (status != TP_OK) return status;
  tp_arc_description *arc = block->arcs + block->arc_count++;
  tp_arc_init(arc);
  arc->place = build->place;
  tp_build_put(build, &arc->x, 0);
  tp_build_put(build, &arc->y, 1);
  return TP_OK;
}

tp_status tp_scene_add_arc_through(tp_scene *scene, tp_exact from_x, tp_exact from_y,
                                   tp_exact through_x, tp_exact through_y, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  const tp_given given[] = {{"from_x", from_x, TP_RULE_ANY},
                            {"from_y", from_y, TP_RULE_ANY},
                            {"through_x", through_x, TP_RULE_ANY},
                            {"through_y", through_y, TP_RULE_ANY}};
  tp_build build;
  const tp_status status = begin_arc(&build, scene, __func__, given, 4, message);
  if (status == TP_OK) {
    tp_arc_description *arc = scene->block.arcs + scene->block.arc_count - 1;
    tp_build_put(&build, &arc->through_x, 2);
    tp_build_put(&build, &arc->through_y, 3);
  }
  tp_build_end(&build);
  return status;
}

tp_status tp_scene_add_arc_bulge(tp_scene *scene, tp_exact from_x, tp_exact from_y, tp_exact bulge,
                                 tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  const tp_given given[] = {{"from_x", from_x, TP_RULE_ANY},
                            {"from_y", from_y, TP_RULE_ANY},
                            {"bulge", bulge, TP_RULE_BULGE}};
  tp_build build;
  const tp_status status = begin_arc(&build, scene, __func__, given, 3, message);
  if (status == TP_OK) {
    tp_build_put(&build, &scene->block.arcs[scene->block.arc_count - 1].bulge, 2);
  }
  tp_build_end(&build);
  return status;
}

/* Room for one more corner, with its radius, the first number read. */
static tp_status add_corner(tp_build *build, tp_corner_description **corner) {
  tp_rounded_description *rounded = &build->scene->block.rounded;
  const tp_place call = build->place;
  void *corners = rounded->corners;
  const tp_status status = tp_build_grow(build, &corners, rounded->count, sizeof *rounded->corners);
  rounded->corners = corners;
  if (status != TP_OK) return status;
  if (rounded->place.file == NULL) rounded->place = call;
  *corner = rounded->corners + rounded->count++;
  tp_corner_init(*corner);
  (*corner)->place = build->place;
  tp_build_put(build, &(*corner)->radius, 0);
  return TP_OK;
}

tp_status tp_scene_add_rounded_end(tp_scene *scene, tp_underside_end at, tp_exact radius,
                                   tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  const tp_given given = {"radius", radius, TP_RULE_NOT_NEGATIVE};
  tp_build build;
  tp_corner_description *corner = NULL;
  tp_status status = tp_build_begin(&build, scene, __func__, message);
  if (status == TP_OK && at != TP_UNDERSIDE_LEFT_END && at != TP_UNDERSIDE_RIGHT_END) {
    status = tp_refuse(message, TP_FAULT_ARGUMENT, build.place,
                       "'at' must be the left or the right end of the underside");
  }
  if (status == TP_OK) status = tp_build_read(&build, &given, 1);
  if (status == TP_OK) status = add_corner(&build, &corner);
  if (status == TP_OK) {
    corner->at = at == TP_UNDERSIDE_LEFT_END ? TP_CORNER_LEFT_END : TP_CORNER_RIGHT_END;
  }
  tp_build_end(&build);
  return status;
}

tp_status tp_scene_add_rounded_vertex(tp_scene *scene, tp_exact x, tp_exact y, tp_exact radius,
                                      tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  const tp_given given[] = {
      {"radius", radius, TP_RULE_NOT_NEGATIVE}, {"x", x, TP_RULE_ANY}, {"y", y, TP_RULE_ANY}};
  tp_build build;
  tp_corner_description *corner = NULL;
  tp_status status = tp_build_begin(&build, scene, __func__, message);
  if (status == TP_OK) status = tp_build_read(&build, given, 3);
  if (status == TP_OK) status = add_corner(&build, &corner);
  if (status == TP_OK) {
    corner->at = TP_CORNER_VERTEX;
    tp_build_put(&build, &corner->x, 1);
    tp_build_put(&build, &corner->y, 2);
  }
  tp_build_end(&build);
  return status;
}

tp_status tp_scene_set_rounding_keeps_mass(tp_scene *scene, bool keeps_mass, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  tp_build build;
  const tp_status status = tp_build_begin(&build, scene, __func__, message);
  if (status != TP_OK) return status;
  scene->block.rounded.keeps_mass = keeps_mass;
  scene->block.rounded.place = build.place;
  return TP_OK;
}
