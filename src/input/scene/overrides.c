/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Lists of numbers that replace those of a scene's nodes or keys, with the setting that each came
 * from. */

#include "scene/setting.h"

#include <stdlib.h>
#include <string.h>

void tp_overrides_free(tp_override *overrides, long count) {
  for (long k = 0; k < count && overrides != NULL; k++) {
    fmpq_clear(overrides[k].value);
    free(overrides[k].setting);
  }
  free(overrides);
}

/* Of a node, or in memory of a key. */
static bool is_of(const tp_override *own, const tp_node *node, const char *setting) {
  if (node != NULL || own->node != NULL) return own->node == node;
  if (setting == NULL || own->setting == NULL) return false;
  const size_t length = tp_setting_key_length(setting);
  return strncmp(own->setting, setting, length + 1) == 0;
}

bool tp_overrides_put(tp_override *overrides, long *count, const tp_node *node, const fmpq *value,
                      const char *setting) {
  char *copy = setting != NULL ? strdup(setting) : NULL;
  if (setting != NULL && copy == NULL) return false;
  long k = 0;
  while (k < *count && !is_of(overrides + k, node, setting)) k++;
  tp_override *own = overrides + k;
  if (k == *count) {
    *own = (tp_override){.node = node};
    fmpq_init(own->value);
    (*count)++;
  }
  free(own->setting);
  own->setting = copy;
  own->used = false;
  if (value != NULL) fmpq_set(own->value, value);
  return true;
}

bool tp_overrides_append(tp_override *overrides, long *count, const tp_scene *scene) {
  bool done = true;
  for (long k = 0; k < scene->override_count && done; k++) {
    const tp_override *own = scene->overrides + k;
    done = tp_overrides_put(overrides, count, own->node, own->value, own->setting);
  }
  return done;
}

const tp_override *tp_scene_override(const tp_scene *scene, const tp_node *node) {
  for (long k = 0; k < scene->override_count; k++) {
    if (scene->overrides[k].node == node) return scene->overrides + k;
  }
  return NULL;
}
