/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Builds the scene of one block of a batch: outline in metres, mean plane level, tilted towards one
 * side, by the public calls that a user would make (docs/blocks.md). */

#include "batch/block_scene.h"

tp_status tp_block_scene_new(tp_scene **scene, tp_vertices vertices, tp_direction towards,
                             tp_message *message) {
  tp_scene *own = NULL;
  tp_status status = tp_scene_new(&own, "m", message);
  if (status != TP_OK) return status;
  const bool left = towards == TP_TOWARDS_LEFT;
  status = tp_scene_set_outline(own, tp_coordinates_of(vertices.xy, vertices.count), message);
  if (status == TP_OK) status = tp_scene_set_tilt_towards(own, left, !left, message);
  if (status == TP_OK) {
    *scene = own;
  } else {
    tp_scene_free(own);
  }
  return status;
}
