/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The scene of a study: a scene, or a drawing in its place, with what is set in it. */

#include "study/scene.h"

#include "scene_varying/load_case.h"
#include "study/hash.h"

#include <stdlib.h>

static tp_status hash_scene(const tp_study_reader *reader) {
  tp_study *study = reader->study;
  tp_status status = TP_OK;
  for (size_t k = 0; k < tp_scene_source_count(study->scene) && status == TP_OK; k++) {
    status = tp_hash_file(&study->hash, tp_scene_source(study->scene, k), reader->message);
  }
  study->hash_of_scene = study->hash;
  return status;
}

/* The texts of the list `set`, borrowed of its nodes. */
static tp_status read_settings(const char **settings, const tp_study_reader *reader,
                               const tp_node *set) {
  size_t count = 0;
  const tp_node *n = set->kind == TP_NODE_SEQUENCE ? set->first : NULL;
  for (; n != NULL && n->kind == TP_NODE_SCALAR; n = n->next) settings[count++] = n->text;
  if (n == NULL && count > 0) return TP_OK;
  return tp_study_fail(reader, set,
                       "'set' is a list of KEY=VALUE, for example 'set: [friction_angle_deg=30, "
                       "tilt.towards=left]'");
}

/* The load case of a scene that has some, with what is set in it. */
static tp_status read_chosen(const tp_study_reader *reader, const tp_node *root, const char *unit,
                             const char *const *settings, size_t count, tp_message *message) {
  tp_study *study = reader->study;
  const tp_node *name = tp_node_get(root, "case");
  tp_scene *read = NULL, *own = NULL;
  if (name == NULL) {
    tp_status status =
        tp_scene_read_with(&study->scene, study->scene_path, unit, settings, count, message);
    return status == TP_OK ? tp_check_load_case(study->scene, message) : status;
  }
  if (name->kind != TP_NODE_SCALAR) {
    return tp_refuse(message, TP_FAULT_KEY, (tp_place){0},
                     "'case' is the name of a load case of the scene, as 'case: wet'");
  }
  tp_status status = tp_scene_read_with(&read, study->scene_path, unit, NULL, 0, message);
  if (status == TP_OK) status = tp_scene_load_case(&own, read, name->text, message);
  tp_scene_free(read);
  if (status != TP_OK || count == 0) {
    study->scene = own;
    return status;
  }
  status = tp_scene_with_settings(&study->scene, own, settings, count, message);
  tp_scene_free(own);
  return status;
}

/* The scene, or a drawing in its place, with what is set in it. */
static tp_status read_with_settings(const tp_study_reader *reader, const tp_node *root,
                                    const tp_node *scene) {
  const tp_node *unit = tp_node_get(root, "unit"), *set = tp_node_get(root, "set");
  const size_t count = set != NULL ? (size_t)set->count : 0;
  const char **settings = calloc(count + 1, sizeof *settings);
  tp_status status = settings != NULL ? TP_OK : tp_fail_memory(reader->message, "the study");
  if (status == TP_OK && unit != NULL && unit->kind != TP_NODE_SCALAR) {
    status = tp_study_fail(reader, unit, "'unit' is mm, cm, m, km, in or ft");
  }
  if (status == TP_OK && set != NULL) status = read_settings(settings, reader, set);
  if (status == TP_OK) {
    tp_message inner = {.text = ""};
    status = read_chosen(reader, root, unit != NULL ? unit->text : "", settings, count, &inner);
    if (status != TP_OK) status = tp_study_fail_of(reader, scene, status, &inner);
  }
  free(settings);
  return status;
}

tp_status tp_study_read_scene(const tp_study_reader *reader, const tp_node *root) {
  tp_study *study = reader->study;
  const tp_node *node = tp_node_get(root, "scene");
  if (node == NULL || node->kind != TP_NODE_SCALAR) {
    return tp_study_fail(reader, node != NULL ? node : root,
                         "'scene' names the scene file, for example 'scene: block.yaml'");
  }
  study->scene_path = tp_study_beside(study, node->text);
  if (study->scene_path == NULL) return tp_fail_memory(reader->message, "the study");
  const tp_status status = read_with_settings(reader, root, node);
  if (status != TP_OK) return status;
  const tp_scene *scene = study->scene;
  if (scene->towards_left && scene->towards_right && !tp_scene_lies_in_place(scene) &&
      !tp_scene_is_solid(scene)) {
    return tp_study_fail(reader, node,
                         "this scene tilts both ways; give one, 'tilt: "
                         "{towards: left}'");
  }
  return hash_scene(reader);
}
