/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Calls that make a scene in memory and set its title, tilt, frame, slope and mean plane. */

#include "common/host.h"
#include "scene_building/build.h"

#include <stdlib.h>
#include <string.h>

tp_status tp_scene_new(tp_scene **scene, const char *length_unit, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  TP_REFUSE_NULL(message, length_unit);
  tp_scene *made = tp_scene_make("scene in memory");
  if (made == NULL) return tp_fail_memory(message, "the scene");
  const tp_status status =
      tp_scene_use_unit(made, length_unit, (tp_place){__func__, 0, 0}, message);
  if (status == TP_OK) {
    *scene = made;
  } else {
    tp_scene_free(made);
  }
  return status;
}

tp_status tp_scene_set_title(tp_scene *scene, const char *title, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  TP_REFUSE_NULL(message, title);
  tp_build build;
  const tp_status status = tp_build_begin(&build, scene, __func__, message);
  if (status != TP_OK) return status;
  char *own = strdup(title);
  if (own == NULL) return tp_fail_memory(message, "the scene");
  free(scene->title);
  scene->title = own;
  return TP_OK;
}

tp_status tp_scene_set_tilt_towards(tp_scene *scene, bool left, bool right, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  tp_build build;
  const tp_status status = tp_build_begin(&build, scene, __func__, message);
  if (status != TP_OK) return status;
  if (!left && !right) {
    return tp_refuse(message, TP_FAULT_ARGUMENT, build.place,
                     "one of 'left' and 'right' must be true: the block tilts some way");
  }
  scene->towards_left = left;
  scene->towards_right = right;
  scene->tilt_place = build.place;
  return TP_OK;
}

tp_status tp_scene_set_tilt_angle_deg(tp_scene *scene, tp_exact angle_deg, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  return tp_build_set(scene, __func__, "tilt.angle_deg", angle_deg, message);
}

static void set_frame(tp_build *build, tp_frame frame, tp_polyline plane) {
  tp_polyline_clear(&build->scene->mean_plane);
  build->scene->frame = frame;
  build->scene->frame_place = build->place;
  build->scene->mean_plane = plane;
}

tp_status tp_scene_set_frame_base(tp_scene *scene, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  tp_build build;
  const tp_status status = tp_build_begin(&build, scene, __func__, message);
  if (status == TP_OK) set_frame(&build, TP_FRAME_BASE, (tp_polyline){0});
  return status;
}

tp_status tp_scene_set_frame_world(tp_scene *scene, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  tp_build build;
  const tp_status status = tp_build_begin(&build, scene, __func__, message);
  if (status == TP_OK) set_frame(&build, TP_FRAME_WORLD, (tp_polyline){0});
  return status;
}

tp_status tp_scene_set_slope(tp_scene *scene, tp_exact dip_deg, tp_direction towards,
                             tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  const tp_given given = {"dip_deg", dip_deg, TP_RULE_ANGLE_TO_90};
  tp_build build;
  tp_status status = tp_build_begin(&build, scene, __func__, message);
  if (status == TP_OK) status = tp_build_read(&build, &given, 1);
  if (status == TP_OK && towards != TP_TOWARDS_LEFT && towards != TP_TOWARDS_RIGHT) {
    status = tp_refuse(message, TP_FAULT_ARGUMENT, build.place, "there is no such direction");
  }
  if (status == TP_OK) {
    set_frame(&build, TP_FRAME_SLOPE, (tp_polyline){0});
    tp_build_put(&build, &scene->slope.dip_deg, 0);
    scene->slope.left = towards == TP_TOWARDS_LEFT;
  }
  tp_build_end(&build);
  return status;
}

tp_status tp_scene_set_mean_plane(tp_scene *scene, tp_coordinates two_points, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  tp_build build;
  tp_polyline plane = {0};
  tp_status status = tp_build_begin(&build, scene, __func__, message);
  if (status == TP_OK && two_points.count != 2) {
    status = tp_refuse(message, TP_FAULT_ARGUMENT, build.place,
                       "the mean plane is named by two points on it, not by %zu", two_points.count);
  }
  if (status == TP_OK) {
    status =
        tp_coordinates_read(&plane, two_points, false, "two_points", build.place.file, 0, message);
  }
  if (status == TP_OK) status = tp_check_mean_plane(&plane, build.place, message);
  if (status == TP_OK) {
    set_frame(&build, TP_FRAME_WORLD, plane);
  } else {
    tp_polyline_clear(&plane);
  }
  return status;
}
