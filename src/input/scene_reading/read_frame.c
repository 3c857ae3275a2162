/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Reads the keys frame and slope of a scene: coordinates along the base, along a slope or of the
 * world, and a mean plane by two points. */

#include "scene_reading/read.h"

#include <string.h>

static tp_status read_mean_plane(const tp_reader *reader, const tp_node *node) {
  tp_polyline *plane = &reader->scene->mean_plane;
  if (node->kind != TP_NODE_SEQUENCE || node->count != 2) {
    return tp_read_fail(reader, TP_FAULT_FORMAT, node,
                        "the mean plane is named by two points on it, the left one first: "
                        "'mean_plane: [[x, y], [x, y]]'");
  }
  const tp_status status = tp_read_points(reader, plane, node, false, "the mean plane");
  return status == TP_OK ? tp_check_mean_plane(plane, tp_read_place(reader, node), reader->message)
                         : status;
}

static bool has_azimuth(const tp_scene *scene) {
  return scene->slope.dip_direction_deg.given || scene->slope.strike_deg.given;
}

static tp_status check_azimuths(const tp_reader *reader, const tp_node *node, const char *what) {
  const tp_slope_description *slope = &reader->scene->slope;
  if (!slope->strike_deg.given || !slope->dip_direction_deg.given) return TP_OK;
  return tp_read_fail(reader, TP_FAULT_KEY, node,
                      "%s has its 'dip_direction_deg' or its 'strike_deg', not both", what);
}

tp_status tp_read_frame(const tp_reader *reader, const tp_node *node) {
  tp_scene *scene = reader->scene;
  if (node == NULL) return TP_OK;
  scene->frame_place = tp_node_place(node, scene->path);
  if (node->kind == TP_NODE_MAPPING) {
    const tp_node *plane = tp_node_get(node, "mean_plane");
    tp_status status = tp_read_map(reader, scene, node, &tp_key_map_frame, "frame");
    if (status == TP_OK) status = check_azimuths(reader, node, "the mean plane");
    if (status == TP_OK && plane == NULL && !has_azimuth(scene)) {
      status = tp_read_required(reader, &plane, node, "mean_plane",
                                "frame: {mean_plane: [[0, 0], [2, 1]]}");
    }
    scene->frame = TP_FRAME_WORLD;
    return status == TP_OK && plane != NULL ? read_mean_plane(reader, plane) : status;
  }
  const bool scalar = node->kind == TP_NODE_SCALAR;
  if (scalar && strcmp(node->text, "base") == 0) {
    scene->frame = TP_FRAME_BASE;
  } else if (scalar && strcmp(node->text, "world") == 0) {
    scene->frame = TP_FRAME_WORLD;
  } else {
    return tp_read_fail(reader, TP_FAULT_KEY, node,
                        "frame must be 'base' (x runs along the mean plane of the base), 'world' "
                        "(y runs up, the block lies as it lies) or {mean_plane: [[x, y], [x, y]]} "
                        "(as world, with two points on the mean plane; or with the azimuth of its "
                        "dip, {dip_direction_deg: 135})");
  }
  return TP_OK;
}

tp_status tp_read_slope(const tp_reader *reader, const tp_node *node) {
  tp_scene *scene = reader->scene;
  tp_slope_description *slope = &scene->slope;
  const tp_node *towards = NULL;
  if (node == NULL) return TP_OK;
  if (scene->frame != TP_FRAME_UNSTATED) {
    return tp_read_fail(reader, TP_FAULT_KEY, node,
                        "a scene has 'frame' or 'slope': along a slope x runs along its plane, in "
                        "'frame: world' the coordinates include the dip");
  }
  scene->frame = TP_FRAME_SLOPE;
  scene->frame_place = tp_node_place(node, scene->path);
  tp_status status = tp_read_map(reader, scene, node, &tp_key_map_slope, "slope");
  if (status == TP_OK) {
    status =
        tp_read_required(reader, &towards, node, "towards", "slope: {dip_deg: 25, towards: left}");
  }
  if (status == TP_OK) status = check_azimuths(reader, node, "a slope");
  if (status != TP_OK) return status;
  slope->left = towards->kind == TP_NODE_SCALAR && strcmp(towards->text, "left") == 0;
  if (slope->left || (towards->kind == TP_NODE_SCALAR && strcmp(towards->text, "right") == 0)) {
    return TP_OK;
  }
  return tp_read_fail(reader, TP_FAULT_KEY, towards, "towards must be left or right");
}
