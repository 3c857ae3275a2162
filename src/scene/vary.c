/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "scene/vary.h"

#include <stdlib.h>
#include <string.h>

static tp_place place_in_file(const tp_node *node, const tp_scene *scene) {
  tp_place place = tp_node_place(node, scene->path);
  place.column += node->text_offset;
  return place;
}

/* Scalars of a scene that may look like a number, and are none. */
static bool is_header(const tp_node *node, const tp_scene *scene) {
  return node == tp_node_get(scene->source, "topple") ||
         node == tp_node_get(scene->source, "title");
}

tp_status tp_scene_key_find(tp_scene_key *key, const tp_scene *scene, const char *text,
                            tp_message *message) {
  *key = (tp_scene_key){.node = NULL};
  if (scene->source == NULL) return tp_slot_find(&key->slot, scene, text, message);
  const tp_status status = tp_key_find(&key->node, scene->source, text, scene->path, message);
  if (status != TP_OK || !is_header(key->node, scene)) return status;
  return tp_fail(message, TP_BAD_INPUT, tp_node_place(key->node, scene->path),
                 "this is no number of the scene");
}

tp_place tp_scene_key_place(const tp_scene_key *key, const tp_scene *scene) {
  return key->node != NULL ? place_in_file(key->node, scene) : tp_slot_place(&key->slot, scene);
}

tp_status tp_scene_key_value(fmpq_t value, const tp_scene_key *key, const tp_scene *scene,
                             tp_message *message) {
  if (key->node == NULL) {
    tp_slot_get(value, &key->slot, scene);
    return TP_OK;
  }
  const tp_override *own = tp_scene_override(scene, key->node);
  if (own == NULL) {
    return tp_expression_evaluate(value, key->node->text, place_in_file(key->node, scene),
                                  &scene->parameters, message);
  }
  fmpq_set(value, own->value);
  return TP_OK;
}

tp_status tp_scene_key_reach(tp_reach *reach, const tp_scene_key *key, const tp_scene *scene,
                             tp_message *message) {
  if (key->node != NULL) return tp_key_reach(reach, scene->source, key->node, message);
  const char *pattern = tp_slot_pattern(&key->slot);
  const bool friction =
      strncmp(pattern, "friction", 8) == 0 || strcmp(pattern, "loads.cohesion_kpa") == 0;
  const bool tilt = strcmp(pattern, "tilt.angle_deg") == 0;
  *reach = (tp_reach){.friction = friction, .tilt = tilt, .other = !friction && !tilt};
  return TP_OK;
}

/* ---- a scene read from a file ------------------------------------------------------------------
 */

/* In place of what the scene has for the node, or beside that. */
static void put_override(tp_override *overrides, long *count, const tp_node *node,
                         const fmpq_t value) {
  long k = 0;
  while (k < *count && overrides[k].node != node) k++;
  if (k == *count) {
    fmpq_init(overrides[k].value);
    (*count)++;
  }
  overrides[k].node = node;
  overrides[k].used = false;
  fmpq_set(overrides[k].value, value);
}

static tp_status vary_file(tp_scene **varied, const tp_scene *scene, const tp_scene_key *keys,
                           const fmpq *values, size_t count, tp_message *message) {
  tp_override *overrides = calloc((size_t)scene->override_count + count + 1, sizeof *overrides);
  if (overrides == NULL) return tp_fail_memory(message, "the scene");
  long own = 0;
  for (long k = 0; k < scene->override_count; k++) {
    put_override(overrides, &own, scene->overrides[k].node, scene->overrides[k].value);
  }
  for (size_t k = 0; k < count; k++) put_override(overrides, &own, keys[k].node, values + k);
  return tp_scene_read_again(varied, scene->file, overrides, own, message);
}

/* ---- a scene in memory -------------------------------------------------------------------------
 */

static tp_status vary_built(tp_scene **varied, const tp_scene *scene, const tp_scene_key *keys,
                            const fmpq *values, size_t count, tp_message *message) {
  tp_slot *slots = calloc(count + 1, sizeof *slots);
  if (slots == NULL) return tp_fail_memory(message, "the scene");
  for (size_t k = 0; k < count; k++) slots[k] = keys[k].slot;
  tp_scene *copy = tp_scene_copy(scene);
  const tp_status status = copy != NULL ? tp_slots_set(copy, slots, values, count, message)
                                        : tp_fail_memory(message, "the scene");
  free(slots);
  if (status == TP_OK) {
    *varied = copy;
  } else {
    tp_scene_free(copy);
  }
  return status;
}

tp_status tp_scene_vary(tp_scene **varied, const tp_scene *scene, const tp_scene_key *keys,
                        const fmpq *values, size_t count, tp_message *message) {
  return scene->file != NULL ? vary_file(varied, scene, keys, values, count, message)
                             : vary_built(varied, scene, keys, values, count, message);
}
