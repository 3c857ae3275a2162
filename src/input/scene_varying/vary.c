/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Varies a file's nodes by a list of overrides that the reader applies, or copies a scene in memory
 * and puts the numbers into its slots (scene_varying/slots.h). */

#include "scene_varying/vary.h"

#include "scene/setting.h"

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
  return tp_refuse(message, TP_FAULT_KEY, tp_node_place(key->node, scene->path),
                   "this is not a number of the scene");
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

bool tp_scene_key_same(const tp_scene_key *one, const tp_scene_key *other) {
  if (one->node != NULL || other->node != NULL) return one->node == other->node;
  return one->slot.row == other->slot.row && one->slot.item == other->slot.item &&
         one->slot.point == other->slot.point && one->slot.axis == other->slot.axis;
}

/* ---- a scene read from a file ------------------------------------------------------------------
 */

/* Of each key a value, or a setting. */
static tp_status vary_file(tp_scene **varied, const tp_scene *scene, const tp_scene_key *keys,
                           const fmpq *values, const char *const *settings, size_t count,
                           tp_message *message) {
  tp_override *overrides = calloc((size_t)scene->override_count + count + 1, sizeof *overrides);
  if (overrides == NULL) return tp_fail_memory(message, "the scene");
  long own = 0;
  bool done = tp_overrides_append(overrides, &own, scene);
  for (size_t k = 0; k < count && done; k++) {
    done = tp_overrides_put(overrides, &own, keys[k].node, values != NULL ? values + k : NULL,
                            settings != NULL ? settings[k] : NULL);
  }
  if (done) return tp_scene_read_again(varied, scene->file, overrides, own, message);
  tp_overrides_free(overrides, own);
  return tp_fail_memory(message, "the scene");
}

/* ---- a scene in memory -------------------------------------------------------------------------
 */

static tp_status put_slots(tp_scene *scene, const tp_scene_key *keys, const fmpq *values,
                           size_t count, tp_message *message) {
  tp_slot *slots = calloc(count + 1, sizeof *slots);
  if (slots == NULL) return tp_fail_memory(message, "the scene");
  for (size_t k = 0; k < count; k++) slots[k] = keys[k].slot;
  const tp_status status = tp_slots_set(scene, slots, values, count, message);
  free(slots);
  return status;
}

static bool keep_settings(tp_scene *scene, const fmpq *values, const char *const *settings,
                          size_t count) {
  const size_t room = (size_t)scene->override_count + count;
  tp_override *larger = realloc(scene->overrides, (room + 1) * sizeof *larger);
  if (larger == NULL) return false;
  scene->overrides = larger;
  bool done = true;
  for (size_t k = 0; k < count && done; k++) {
    done = tp_overrides_put(larger, &scene->override_count, NULL, values + k, settings[k]);
  }
  return done;
}

static tp_status vary_built(tp_scene **varied, const tp_scene *scene, const tp_scene_key *keys,
                            const fmpq *values, const char *const *settings, size_t count,
                            tp_message *message) {
  tp_scene *copy = tp_scene_copy(scene);
  if (copy == NULL) return tp_fail_memory(message, "the scene");
  tp_status status = put_slots(copy, keys, values, count, message);
  if (status == TP_OK && settings != NULL && !keep_settings(copy, values, settings, count)) {
    status = tp_fail_memory(message, "the scene");
  }
  if (status == TP_OK) {
    *varied = copy;
  } else {
    tp_scene_free(copy);
  }
  return status;
}

tp_status tp_scene_vary(tp_scene **varied, const tp_scene *scene, const tp_scene_key *keys,
                        const fmpq *values, size_t count, tp_message *message) {
  return scene->file != NULL ? vary_file(varied, scene, keys, values, NULL, count, message)
                             : vary_built(varied, scene, keys, values, NULL, count, message);
}

tp_status tp_scene_set(tp_scene **varied, const tp_scene *scene, const tp_scene_key *keys,
                       const char *const *settings, size_t count, tp_message *message) {
  if (scene->file != NULL) return vary_file(varied, scene, keys, NULL, settings, count, message);
  fmpq *values = calloc(count + 1, sizeof *values);
  if (values == NULL) return tp_fail_memory(message, "the scene");
  tp_status status = TP_OK;
  for (size_t k = 0; k < count; k++) fmpq_init(values + k);
  for (size_t k = 0; k < count && status == TP_OK; k++) {
    status = tp_setting_evaluate(values + k, settings[k], NULL, message);
    if (status == TP_OK) {
      status = tp_check_range(values + k, "the number", (tp_place){settings[k], 0, 0}, message);
    }
  }
  if (status == TP_OK) {
    status = vary_built(varied, scene, keys, values, settings, count, message);
  }
  for (size_t k = 0; k < count; k++) fmpq_clear(values + k);
  free(values);
  return status;
}
