/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Public call that makes a scene from another by settings KEY=FORMULA. */

#include "common/host.h"
#include "common/outside.h"
#include "scene/setting.h"
#include "scene_varying/vary.h"

#include <stdlib.h>
#include <string.h>

static tp_status find_key(tp_scene_key *found, char **key, const tp_scene *scene,
                          const char *setting, tp_message *message) {
  const size_t length = tp_setting_key_length(setting);
  if (length == 0 || setting[length] == '\0') {
    return tp_refuse(message, TP_FAULT_KEY, (tp_place){0},
                     "'%s' sets no number; write KEY=VALUE, as friction_angle_deg=30",
                     tp_quote_all(setting).text);
  }
  *key = strndup(setting, length);
  if (*key == NULL) return tp_fail_memory(message, "the scene");
  return tp_scene_key_find(found, scene, *key, message);
}

static tp_status find_keys(tp_scene_key *found, char **keys, const tp_scene *scene,
                           const char *const *settings, size_t count, tp_message *message) {
  tp_status status = TP_OK;
  for (size_t k = 0; k < count && status == TP_OK; k++) {
    if (settings[k] == NULL) {
      return tp_refuse(message, TP_FAULT_ARGUMENT, (tp_place){0},
                       "tp_scene_with_settings: setting %zu must not be NULL", k + 1);
    }
    status = find_key(found + k, keys + k, scene, settings[k], message);
    for (size_t j = 0; j < k && status == TP_OK; j++) {
      if (!tp_scene_key_same(found + j, found + k)) continue;
      status = tp_refuse(message, TP_FAULT_KEY, (tp_place){0},
                         "'%s' is set twice; leave out one of them", tp_quote_all(keys[k]).text);
    }
  }
  return status;
}

tp_status tp_scene_with_settings(tp_scene **varied, const tp_scene *scene,
                                 const char *const *settings, size_t count, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, varied);
  TP_REFUSE_NULL(message, scene);
  TP_REFUSE_NULL(message, settings);
  enum { MOST = 10000 }; /* of which each is compared with all others */
  if (count > MOST) {
    return tp_refuse(message, TP_FAULT_RANGE, (tp_place){0}, "at most %d numbers are set at once",
                     MOST);
  }
  tp_scene_key *found = calloc(count + 1, sizeof *found);
  char **keys = calloc(count + 1, sizeof *keys);
  tp_status status = found != NULL && keys != NULL
                         ? find_keys(found, keys, scene, settings, count, message)
                         : tp_fail_memory(message, "the scene");
  if (status == TP_OK) status = tp_scene_set(varied, scene, found, settings, count, message);
  for (size_t k = 0; keys != NULL && k < count; k++) free(keys[k]);
  free(keys);
  free(found);
  return status;
}
