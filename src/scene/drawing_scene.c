/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "scene/drawing_scene.h"

#include "outside.h"
#include "scene/setting.h"

#include <stdlib.h>
#include <string.h>

/* topple: 1, drawing: {file: …, unit: …}; NULL when memory is exhausted. */
static tp_node *make_root(const char *path, const char *unit) {
  const char *slash = strrchr(path, '/');
  tp_node *root = tp_node_add(NULL, NULL, TP_NODE_MAPPING, NULL);
  if (root == NULL) return NULL;
  bool done = tp_node_add(root, "topple", TP_NODE_SCALAR, "1") != NULL;
  tp_node *drawing = done ? tp_node_add(root, "drawing", TP_NODE_MAPPING, NULL) : NULL;
  done = drawing != NULL &&
         tp_node_add(drawing, "file", TP_NODE_SCALAR, slash != NULL ? slash + 1 : path) != NULL;
  if (done && unit[0] != '\0') {
    done = tp_node_add(drawing, "unit", TP_NODE_SCALAR, unit) != NULL;
  }
  if (done) return root;
  tp_node_free(root);
  return NULL;
}

/* The node of a part of a key, made where there is none; NULL when memory is exhausted. */
static tp_node *step(tp_node *at, const char *key, size_t length, const char *formula, bool *made) {
  char *own = strndup(key, length);
  if (own == NULL) return NULL;
  const bool last = key[length] == '=';
  tp_node *found = at->first;
  while (found != NULL && strcmp(found->key, own) != 0) found = found->next;
  *made = found == NULL;
  if (*made) {
    found = tp_node_add(at, own, last ? TP_NODE_SCALAR : TP_NODE_MAPPING, last ? formula : NULL);
  }
  free(own);
  return found;
}

/* One word, as in tilt.towards=left: what stands in the file, and no number that is set. Where a
 * number belongs its reader says so. */
static bool is_word(const char *formula) {
  static const char letters[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_";
  return strspn(formula, letters) == strlen(formula);
}

/* The scalar that a setting "a.b=formula" is of. */
static tp_status add_setting(tp_override *overrides, long *count, tp_node *root,
                             const char *setting, tp_message *message) {
  const size_t whole = tp_setting_key_length(setting);
  if (whole == 0 || setting[whole] != '=' || setting[whole + 1] == '\0') {
    return tp_fail(message, TP_BAD_INPUT, (tp_place){0},
                   "'%s' sets no number; write KEY=VALUE, as friction_angle_deg=30",
                   tp_quote_all(setting).text);
  }
  tp_node *at = root;
  bool made = false;
  for (const char *key = setting;;) {
    const size_t length = strcspn(key, ".=");
    if (at->kind != TP_NODE_MAPPING) {
      return tp_fail(message, TP_BAD_INPUT, (tp_place){0}, "'%s' sets no number of a scene",
                     tp_quote_all(setting).text);
    }
    at = step(at, key, length, setting + whole + 1, &made);
    if (at == NULL) return tp_fail_memory(message, "the scene");
    if (key[length] == '=') break;
    key += length + 1;
  }
  if (!made) {
    return tp_fail(message, TP_BAD_INPUT, (tp_place){0}, "'%s' is set twice; leave out one of them",
                   tp_quote_of(setting, whole).text);
  }
  if (is_word(setting + whole + 1)) return TP_OK;
  return tp_overrides_put(overrides, count, at, NULL, setting)
             ? TP_OK
             : tp_fail_memory(message, "the scene");
}

tp_status tp_scene_read_drawing(tp_scene **scene, const char *path, const char *unit,
                                const char *const *settings, size_t count, tp_message *message) {
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
