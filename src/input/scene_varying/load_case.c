/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Public calls for the load cases of a scene. The nodes of the file are copied with their places,
 * maps of the case merged into those of the scene, all else of it put in their place; then the
 * numbers that it sets by their keys. Numbers that the scene has in place of those of its file go
 * along, where the case does not give its own. */

#include "scene_varying/load_case.h"

#include "common/host.h"
#include "common/outside.h"
#include "scene/check.h"
#include "scene_reading/key.h"

#include <stdlib.h>
#include <string.h>

/* A copy under construction. */
typedef struct merging {
  const tp_scene *scene;
  tp_override *overrides;
  long count;
  bool failed; /* memory is exhausted */
} merging;

static tp_node *copy_head(tp_node *parent, const tp_node *node) {
  tp_node *copy = tp_node_add(parent, node->key, node->kind, node->text);
  if (copy == NULL) return NULL;
  copy->mark = node->mark;
  copy->key_mark = node->key_mark;
  copy->text_offset = node->text_offset;
  return copy;
}

static bool take_override(merging *m, const tp_node *node, const tp_node *copy) {
  const tp_override *own = tp_scene_override(m->scene, node);
  return own == NULL || tp_overrides_put(m->overrides, &m->count, copy, own->value, own->setting);
}

/* `over` NULL: nothing stands over the node. The tree is as deep as the reader allows at most. */
static void merge(merging *m, tp_node *parent, const tp_node *node, const tp_node *over) {
  const bool maps = over != NULL && node->kind == TP_NODE_MAPPING && over->kind == node->kind;
  const tp_node *from = over != NULL && !maps ? over : node;
  tp_node *copy = m->failed ? NULL : copy_head(parent, from);
  m->failed = m->failed || copy == NULL || !take_override(m, from, copy);
  if (m->failed) return;
  for (const tp_node *n = from->first; n != NULL; n = n->next) {
    merge(m, copy, n, maps ? tp_node_get(over, n->key) : NULL);
  }
  for (const tp_node *n = maps ? over->first : NULL; n != NULL; n = n->next) {
    if (tp_node_get(node, n->key) == NULL) merge(m, copy, n, NULL);
  }
}

static bool is_one_of(const char *key, const char *const *keys) {
  while (*keys != NULL && strcmp(*keys, key) != 0) keys++;
  return *keys != NULL;
}

/* A case that says how it is judged is not judged as the scene is, too; nor has it two laws of
 * friction. */
static bool gives_way(const tp_node *node, const tp_node *own) {
  const char *key = node->key;
  return (strcmp(key, "required_fos") == 0 && tp_node_get(own, "partial_factors") != NULL) ||
         (strcmp(key, "partial_factors") == 0 && (tp_node_get(own, "partial_factors") != NULL ||
                                                  tp_node_get(own, "required_fos") != NULL)) ||
         (strcmp(key, "friction_angle_deg") == 0 && tp_node_get(own, "friction") != NULL &&
          tp_node_get(tp_node_get(own, "friction"), "law") != NULL);
}

static tp_node *merge_root(merging *m, const tp_node *own) {
  static const char *const of_case[] = {"name", "set", NULL};
  const tp_node *root = m->scene->source;
  tp_node *copy = copy_head(NULL, root);
  m->failed = copy == NULL;
  for (const tp_node *n = root->first; n != NULL && !m->failed; n = n->next) {
    if (n == m->scene->load_cases) continue;
    const bool replaced = gives_way(n, own);
    if (!replaced) merge(m, copy, n, tp_node_get(own, n->key));
  }
  for (const tp_node *n = own->first; n != NULL && !m->failed; n = n->next) {
    if (is_one_of(n->key, of_case) || tp_node_get(copy, n->key) != NULL) continue;
    merge(m, copy, n, NULL);
  }
  return copy;
}

/* A number by its key. */
static tp_status set_number(tp_node *root, const tp_node *set, const char *name, const char *file,
                            tp_message *message) {
  const tp_node *found = NULL;
  tp_message why = {.text = ""};
  const tp_place at = {file, set->key_mark.line, set->key_mark.column};
  if (set->kind != TP_NODE_SCALAR) {
    return tp_refuse(message, TP_FAULT_KEY, at,
                     "'set' of a case takes numbers; a map or a list such as 'loads: {water: …}' "
                     "stands in the case itself");
  }
  const tp_status status = tp_key_find(&found, root, set->key, file, &why);
  if (status == TP_OUT_OF_MEMORY) return tp_fail_memory(message, "a key");
  if (status != TP_OK) {
    return tp_refuse(message, TP_FAULT_KEY, at,
                     "case '%s' sets '%s', which the scene does not have (%s); a key of the scene "
                     "that is missing stands in the case as in a scene: loads: {water: {height: "
                     "2}}",
                     tp_quote_all(name).text, tp_quote_all(set->key).text, why.text);
  }
  tp_node *node = (tp_node *)found; /* of our own tree */
  char *text = strdup(set->text);
  if (text == NULL) return tp_fail_memory(message, "the scene");
  free(node->text);
  node->text = text;
  node->text_offset = set->text_offset;
  node->mark = set->mark;
  return TP_OK;
}

/* ---- the block is the same ---------------------------------------------------------------------
 */

static bool same_line(const tp_polyline *a, const tp_polyline *b) {
  bool same = a->count == b->count;
  for (long k = 0; k < a->count && same; k++) {
    same = fmpq_equal(a->x + k, b->x + k) && fmpq_equal(a->y + k, b->y + k);
  }
  return same;
}

static bool same_block(const tp_block_description *a, const tp_block_description *b) {
  bool same =
      a->form == b->form && a->hole_count == b->hole_count && same_line(&a->outline, &b->outline) &&
      a->teeth.count == b->teeth.count && fmpq_equal(a->teeth.width, b->teeth.width) &&
      fmpq_equal(a->teeth.height, b->teeth.height) && fmpq_equal(a->teeth.depth, b->teeth.depth) &&
      fmpq_equal(a->ellipse.width.value, b->ellipse.width.value) &&
      fmpq_equal(a->ellipse.height.value, b->ellipse.height.value) &&
      fmpq_equal(a->ellipse.flat.value, b->ellipse.flat.value);
  for (long k = 0; k < a->hole_count && same; k++) same = same_line(a->holes + k, b->holes + k);
  return same;
}

static tp_status finish(tp_scene *own, const tp_scene *scene, const tp_node *name,
                        tp_message *message) {
  if (!same_block(&own->block, &scene->block)) {
    return tp_refuse(message, TP_FAULT_GEOMETRY, tp_node_place(name, scene->path),
                     "case '%s' changes the outline of the block; cases are of one block: write a "
                     "second scene",
                     tp_quote_all(name->text).text);
  }
  own->load_case = own->file->load_case = strdup(name->text);
  return own->load_case != NULL ? TP_OK : tp_fail_memory(message, "the scene");
}

/* ---- the scene of a case -----------------------------------------------------------------------
 */

static tp_status read_case(tp_scene **own, const tp_scene *scene, const tp_node *node,
                           tp_message *message) {
  const tp_node *name = tp_node_get(node, "name"), *set = tp_node_get(node, "set");
  merging m = {.scene = scene};
  m.overrides = calloc((size_t)scene->override_count + 1, sizeof *m.overrides);
  if (m.overrides == NULL) return tp_fail_memory(message, "the scene");
  tp_node *root = merge_root(&m, node);
  tp_status status = m.failed ? tp_fail_memory(message, "the scene") : TP_OK;
  for (const tp_node *n = set != NULL ? set->first : NULL; n != NULL && status == TP_OK;
       n = n->next) {
    status = set_number(root, n, name->text, scene->path, message);
  }
  if (status != TP_OK) {
    tp_node_free(root);
    tp_overrides_free(m.overrides, m.count);
    return status;
  }
  tp_scene *read = NULL;
  status = tp_scene_read_nodes(&read, scene->path, root, m.overrides, m.count, message);
  if (status == TP_OK) status = finish(read, scene, name, message);
  if (status == TP_OK) {
    *own = read;
  } else {
    tp_scene_free(read);
  }
  return status;
}

static void list_names(char *list, size_t size, const tp_scene *scene) {
  list[0] = '\0';
  for (const tp_node *n = scene->load_cases->first; n != NULL; n = n->next) {
    const size_t used = strlen(list);
    if (used + 80 > size) return;
    strcat(list, used > 0 ? ", " : "");
    strcat(list, tp_quote_all(tp_node_get(n, "name")->text).text);
  }
}

size_t tp_scene_load_case_count(const tp_scene *scene) {
  return scene != NULL && scene->load_cases != NULL ? (size_t)scene->load_cases->count : 0;
}

const char *tp_scene_load_case_name(const tp_scene *scene, size_t index) {
  const tp_node *node =
      scene != NULL && scene->load_cases != NULL ? scene->load_cases->first : NULL;
  while (node != NULL && index-- > 0) node = node->next;
  return node != NULL ? tp_node_get(node, "name")->text : NULL;
}

tp_status tp_scene_load_case(tp_scene **own, const tp_scene *scene, const char *name,
                             tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, own);
  TP_REFUSE_NULL(message, scene);
  TP_REFUSE_NULL(message, name);
  char list[600];
  if (scene->load_cases == NULL) {
    return tp_refuse(message, TP_FAULT_KEY, (tp_place){scene->path, 0, 0},
                     "the scene has no cases, so none of the name '%s': give it 'cases: [{name: "
                     "%s}]'",
                     tp_quote_all(name).text, tp_quote_all(name).text);
  }
  for (const tp_node *n = scene->load_cases->first; n != NULL; n = n->next) {
    if (strcmp(tp_node_get(n, "name")->text, name) == 0) return read_case(own, scene, n, message);
  }
  list_names(list, sizeof list, scene);
  return tp_refuse(message, TP_FAULT_KEY, tp_node_place(scene->load_cases, scene->path),
                   "the scene has no case '%s'; its cases are %s", tp_quote_all(name).text, list);
}

tp_status tp_check_load_case(const tp_scene *scene, tp_message *message) {
  char list[600];
  if (scene->load_cases == NULL) return TP_OK;
  list_names(list, sizeof list, scene);
  return tp_refuse(
      message, TP_FAULT_KEY, tp_node_place(scene->load_cases, scene->path),
      "the scene has cases, and one of them is to be chosen: --case NAME, 'case: NAME' "
      "in a study, or tp_scene_load_case; they are %s",
      list);
}
