/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Public calls that read a scene from a file or a text, or make one of a drawing or a mesh, with
 * settings. */

#include "common/host.h"
#include "scene_reading/drawing_scene.h"

#include <string.h>
#include <strings.h>

static bool is_scene_by_name(const char *path) {
  const char *ending = strrchr(path, '.');
  return ending != NULL && (strcasecmp(ending, ".yaml") == 0 || strcasecmp(ending, ".yml") == 0);
}

tp_status tp_scene_read(tp_scene **scene, const char *path, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  TP_REFUSE_NULL(message, path);
  if (tp_scene_is_drawing(path)) {
    return tp_scene_read_drawing(scene, path, "", NULL, 0, message);
  }
  tp_node *root = NULL;
  const tp_status status = tp_node_read(&root, path, message);
  return status == TP_OK ? tp_scene_read_nodes(scene, path, root, NULL, 0, message) : status;
}

tp_status tp_scene_read_text(tp_scene **scene, const char *text, const char *name,
                             tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  TP_REFUSE_NULL(message, text);
  TP_REFUSE_NULL(message, name);
  tp_node *root = NULL;
  const tp_status status = tp_node_read_text(&root, text, name, message);
  return status == TP_OK ? tp_scene_read_nodes(scene, name, root, NULL, 0, message) : status;
}

tp_status tp_scene_read_with(tp_scene **scene, const char *path, const char *unit,
                             const char *const *settings, size_t count, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  TP_REFUSE_NULL(message, path);
  TP_REFUSE_NULL(message, unit);
  if (count > 0) TP_REFUSE_NULL(message, settings);
  for (size_t k = 0; k < count; k++) {
    if (settings[k] != NULL) continue;
    return tp_refuse(message, TP_FAULT_ARGUMENT, (tp_place){0},
                     "tp_scene_read_with: setting %zu must not be NULL", k + 1);
  }
  if (unit[0] != '\0' && is_scene_by_name(path)) {
    return tp_refuse(message, TP_FAULT_KEY, (tp_place){path, 0, 0},
                     "the unit is of a drawing in place of a scene; a scene states it "
                     "length_unit");
  }
  if (unit[0] != '\0' || tp_scene_is_drawing(path)) {
    return tp_scene_read_drawing(scene, path, unit, settings, count, message);
  }
  tp_scene *read = NULL;
  tp_status status = tp_scene_read(&read, path, message);
  if (status != TP_OK || count == 0) {
    if (status == TP_OK) *scene = read;
    return status;
  }
  status = tp_scene_with_settings(scene, read, settings, count, message);
  tp_scene_free(read);
  return status;
}
