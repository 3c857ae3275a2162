/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Calls that set the base of a scene in memory: mated, profile, rest, joint, continuation past the
 * block, and the ends of the contact. */

#include "common/host.h"
#include "scene_building/build.h"

/* The base is another one now, or another part of it. */
static void drop_between(tp_base_description *base) {
  tp_polyline_clear(&base->between);
  base->below.given = base->left_of.given = base->right_of.given = false;
}

void tp_base_drop(tp_base_description *base) {
  drop_between(base);
  tp_profile_rule_drop(&base->rule);
  base->rests = base->all_poses = base->within.given = false;
  base->rests_place = (tp_place){0};
  base->shift.given = base->matching.given = base->closure.given = false;
  fmpq_zero(base->within.value);
  tp_polyline_clear(&base->profile);
  base->beyond_left.given = base->beyond_right.given = false;
  fmpq_zero(base->beyond_left.value);
  fmpq_zero(base->beyond_right.value);
}

tp_status tp_scene_set_base_mated(tp_scene *scene, bool whole, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  tp_build build;
  const tp_status status = tp_build_begin(&build, scene, __func__, message);
  if (status != TP_OK) return status;
  tp_base_drop(&scene->base);
  scene->base.mated = true;
  scene->base.whole = whole;
  scene->base.place = build.place;
  return TP_OK;
}

tp_status tp_scene_set_base_profile(tp_scene *scene, tp_coordinates profile, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  tp_build build;
  tp_polyline line = {0};
  tp_status status = tp_build_begin(&build, scene, __func__, message);
  if (status == TP_OK) {
    status = tp_coordinates_read(&line, profile, false, "profile", __func__, 0, message);
  }
  if (status != TP_OK) return status;
  tp_base_drop(&scene->base);
  scene->base.mated = scene->base.whole = false;
  scene->base.profile = line;
  scene->base.place = build.place;
  return TP_OK;
}

static tp_status set_rest(tp_scene *scene, bool rests, bool all, const char *call,
                          tp_message *message) {
  tp_build build;
  const tp_status status = tp_build_begin(&build, scene, call, message);
  if (status != TP_OK) return status;
  scene->base.rests = rests;
  scene->base.all_poses = all;
  scene->base.rests_place = build.place;
  return TP_OK;
}

tp_status tp_scene_set_base_rest(tp_scene *scene, bool rests, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  return set_rest(scene, rests, false, __func__, message);
}

tp_status tp_scene_set_base_poses(tp_scene *scene, bool all, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  return set_rest(scene, all, all, __func__, message);
}

tp_status tp_scene_set_joint_matching(tp_scene *scene, tp_exact matching, bool leftwards,
                                      tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  const tp_status status = tp_build_set(scene, __func__, "joint.matching", matching, message);
  if (status == TP_OK) scene->base.shift_left = leftwards;
  return status;
}

/* The base of a scene that says more of it than that it is mated. */
static void note_base(tp_build *build) {
  tp_base_description *base = &build->scene->base;
  if (base->place.file == NULL) base->place = build->place;
}

tp_status tp_scene_set_base_beyond(tp_scene *scene, tp_exact left, tp_exact right,
                                   tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  const tp_given given[] = {{"left", left, TP_RULE_BEYOND}, {"right", right, TP_RULE_BEYOND}};
  tp_build build;
  tp_status status = tp_build_begin(&build, scene, __func__, message);
  if (status == TP_OK) status = tp_check_base_is_mated(scene, "beyond", build.place, message);
  if (status == TP_OK) status = tp_build_read(&build, given, 2);
  if (status == TP_OK) {
    note_base(&build);
    tp_build_put(&build, &scene->base.beyond_left, 0);
    tp_build_put(&build, &scene->base.beyond_right, 1);
  }
  tp_build_end(&build);
  return status;
}

static tp_status begin_between(tp_build *build, tp_scene *scene, const char *call,
                               tp_message *message) {
  tp_status status = tp_build_begin(build, scene, call, message);
  if (status == TP_OK) status = tp_check_base_is_mated(scene, "between", build->place, message);
  if (status == TP_OK) status = tp_check_base_not_whole(scene, build->place, message);
  return status;
}

tp_status tp_scene_set_base_between(tp_scene *scene, tp_coordinates two_vertices,
                                    tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  tp_build build;
  tp_polyline line = {0};
  tp_status status = begin_between(&build, scene, __func__, message);
  if (status == TP_OK && two_vertices.count != 2) {
    status = tp_refuse(message, TP_FAULT_ARGUMENT, build.place,
                       "the contact ends in two vertices of the outline, not in %zu",
                       two_vertices.count);
  }
  if (status == TP_OK) {
    status = tp_coordinates_read(&line, two_vertices, false, "two_vertices", __func__, 0, message);
  }
  if (status != TP_OK) return status;
  drop_between(&scene->base);
  note_base(&build);
  scene->base.between = line;
  scene->base.between_place = build.place;
  return TP_OK;
}

tp_status tp_scene_set_base_bound(tp_scene *scene, tp_base_bound bound, tp_exact value,
                                  tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  const tp_given given = {"value", value, TP_RULE_ANY};
  tp_build build;
  tp_status status = begin_between(&build, scene, __func__, message);
  if (status == TP_OK && ((int)bound < TP_BASE_BELOW || (int)bound > TP_BASE_RIGHT_OF)) {
    status = tp_refuse(message, TP_FAULT_ARGUMENT, build.place,
                       "'bound' must be below, left_of or right_of");
  }
  if (status == TP_OK) status = tp_build_read(&build, &given, 1);
  if (status == TP_OK) {
    tp_base_description *base = &scene->base;
    tp_quantity *const bounds[] = {&base->below, &base->left_of, &base->right_of};
    tp_polyline_clear(&base->between);
    note_base(&build);
    base->between_place = build.place;
    tp_build_put(&build, bounds[bound], 0);
  }
  tp_build_end(&build);
  return status;
}
