/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Builds the tree of nodes that a scene naming the drawing or mesh would have, and adds the nodes
 * of all settings. */

#include "scene_reading/drawing_scene.h"

#include "common/outside.h"
#include "format/mesh.h"
#include "format/read.h"
#include "scene/setting.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bool is_mesh(const char *path) {
  return tp_mesh_format_of(path) != TP_MESH_NONE;
}

bool tp_scene_is_drawing(const char *path) {
  return tp_drawing_is_named(path) || is_mesh(path);
}

/* drawing: {file: …, unit: …}; false when memory is exhausted. */
static bool add_drawing(tp_node *root, const char *name, const char *unit) {
  tp_node *drawing = tp_node_add(root, "drawing", TP_NODE_MAPPING, NULL);
  if (drawing == NULL || tp_node_add(drawing, "file", TP_NODE_SCALAR, name) == NULL) return false;
  return unit[0] == '\0' || tp_node_add(drawing, "unit", TP_NODE_SCALAR, unit) != NULL;
}

/* length_unit: …, block: {outline: {mesh: …, unit: …}}; likewise. */
static bool add_mesh(tp_node *root, const char *name, const char *unit) {
  if (tp_node_add(root, "length_unit", TP_NODE_SCALAR, unit) == NULL) return false;
  tp_node *block = tp_node_add(root, "block", TP_NODE_MAPPING, NULL);
  tp_node *outline = block != NULL ? tp_node_add(block, "outline", TP_NODE_MAPPING, NULL) : NULL;
  return outline != NULL && tp_node_add(outline, "mesh", TP_NODE_SCALAR, name) != NULL &&
         tp_node_add(outline, "unit", TP_NODE_SCALAR, unit) != NULL;
}

/* topple: 1, and the file; NULL when memory is exhausted. */
static tp_node *make_root(const char *path, const char *unit) {
  const char *slash = strrchr(path, '/'), *name = slash != NULL ? slash + 1 : path;
  tp_node *root = tp_node_add(NULL, NULL, TP_NODE_MAPPING, NULL);
  if (root == NULL) return NULL;
  bool done = tp_node_add(root, "topple", TP_NODE_SCALAR, "1") != NULL;
  if (done) done = is_mesh(path) ? add_mesh(root, name, unit) : add_drawing(root, name, unit);
  if (done) return root;
  tp_node_free(root);
  return NULL;
}

static tp_node *find_child(const tp_node *at, const char *key) {
  tp_node *found = at->first;
  while (found != NULL && strcmp(found->key, key) != 0) found = found->next;
  return found;
}

/* May a node have a child of that key? One that has none yet is a list where the key is 1, whose
 * entries come in their order. */
static bool may_have(tp_node *at, const char *key) {
  char next[24];
  if (key[0] < '0' || key[0] > '9') return at->kind == TP_NODE_MAPPING;
  if (at->kind == TP_NODE_MAPPING && at->first == NULL) at->kind = TP_NODE_SEQUENCE;
  snprintf(next, sizeof next, "%ld", at->count + 1);
  return at->kind == TP_NODE_SEQUENCE && (strcmp(key, next) == 0 || find_child(at, key) != NULL);
}

/* The node of a part of a key, made where there is none, `made` then; NULL when memory is exhausted
 * or, not `possible`, where there can be none. */
static tp_node *step(tp_node *at, const char *key, size_t length, const char *formula, bool *made,
                     bool *possible) {
  char *own = strndup(key, length);
  if (own == NULL) return NULL;
  const bool last = key[length] == '=';
  tp_node *found = NULL;
  *possible = may_have(at, own);
  if (*possible) found = find_child(at, own);
  *made = found == NULL;
  if (*made && *possible) {
    found = tp_node_add(at, own, last ? TP_NODE_SCALAR : TP_NODE_MAPPING, last ? formula : NULL);
  }
  free(own);
  return found;
}

/* One word, as in tilt.towards=left: what stands in the file, and no number that is set. Where a
 * number belongs its reader says so. */
static bool is_word(const char *formula) {
  static const char letters[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_0123456789";
  return (formula[0] < '0' || formula[0] > '9') && strspn(formula, letters) == strlen(formula);
}

/* The scalar that a setting "a.b=formula" is of. */
static tp_status add_setting(tp_override *overrides, long *count, tp_node *root,
                             const char *setting, tp_message *message) {
  const size_t whole = tp_setting_key_length(setting);
  if (whole == 0 || setting[whole] != '=' || setting[whole + 1] == '\0') {
    return tp_refuse(message, TP_FAULT_KEY, (tp_place){0},
                     "'%s' sets no number; write KEY=VALUE, as friction_angle_deg=30",
                     tp_quote_all(setting).text);
  }
  tp_node *at = root;
  bool made = false, possible = true;
  for (const char *key = setting;;) {
    const size_t length = strcspn(key, ".=");
    at = step(at, key, length, setting + whole + 1, &made, &possible);
    if (!possible) {
      return tp_refuse(message, TP_FAULT_KEY, (tp_place){0},
                       "'%s' sets no number of a scene; entries of a list come in their order",
                       tp_quote_all(setting).text);
    }
    if (at == NULL) return tp_fail_memory(message, "the scene");
    if (key[length] == '=') break;
    key += length + 1;
  }
  if (!made) {
    return tp_refuse(message, TP_FAULT_KEY, (tp_place){0},
                     "'%s' is set twice; leave out one of them", tp_quote_of(setting, whole).text);
  }
  if (is_word(setting + whole + 1)) return TP_OK;
  return tp_overrides_put(overrides, count, at, NULL, setting)
             ? TP_OK
             : tp_fail_memory(message, "the scene");
}

tp_status tp_scene_read_drawing(tp_scene **scene, const char *path, const char *unit,
                                const char *const *settings, size_t count, tp_message *message) {
  if (is_mesh(path) && unit[0] == '\0') {
    return tp_refuse(message, TP_FAULT_UNIT, (tp_place){path, 0, 0},
                     "a mesh does not say what the unit of its lengths is; say --unit m, and lay a "
                     "section through it, as by --set section.at.1=0 --set section.at.2=0 --set "
                     "section.azimuth_deg=90");
  }
  tp_override *overrides = calloc(count + 1, sizeof *overrides);
  tp_node *root = overrides != NULL ? make_root(path, unit) : NULL;
  tp_status status = root != NULL ? TP_OK : tp_fail_memory(message, "the scene");
  long own = 0;
  for (size_t k = 0; k < count && status == TP_OK; k++) {
    status = add_setting(overrides, &own, root, settings[k], message);
  }
  if (status == TP_OK) return tp_scene_read_nodes(scene, path, root, overrides, own, message);
  tp_overrides_free(overrides, own);
  if (root != NULL) tp_node_free(root);
  return status;
}
