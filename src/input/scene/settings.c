/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Copies key, formula and value of each setting, the value looked up in the scene at its key. */

#include "scene/settings.h"

#include "number/ball.h"
#include "scene/setting.h"
#include "scene/unit.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The number that the scene has at the key; in memory a later call may have put another there. */
static tp_status look_up(fmpq_t value, bool *holds, const tp_scene *scene, const tp_override *own,
                         tp_message *message) {
  char *key = strndup(own->setting, tp_setting_key_length(own->setting));
  if (key == NULL) return tp_fail_memory(message, "the settings");
  tp_scene_key found;
  tp_status status = tp_scene_key_find(&found, scene, key, NULL);
  free(key);
  if (status == TP_OUT_OF_MEMORY) return tp_fail_memory(message, "the settings");
  *holds = status == TP_OK;
  if (!*holds) return TP_OK;
  status = tp_scene_key_value(value, &found, scene, message);
  *holds = status == TP_OK && fmpq_equal(value, own->value);
  return status;
}

static tp_status add_setting(tp_settings *settings, const tp_scene *scene, const char *text,
                             tp_bounded value, tp_message *message) {
  const size_t length = tp_setting_key_length(text);
  tp_setting *own = settings->items + settings->count++;
  *own = (tp_setting){
      .key = strndup(text, length), .formula = strdup(text + length + 1), .value = value};
  if (own->key == NULL || own->formula == NULL) return tp_fail_memory(message, "the settings");
  own->unit = tp_scene_unit(scene, own->key);
  return TP_OK;
}

static tp_bounded bounded(const fmpq_t value) {
  arb_t ball;
  arb_init(ball);
  arb_set_fmpq(ball, value, 128);
  const tp_bounded result = tp_ball_bounded(ball);
  arb_clear(ball);
  return result;
}

/* Those of the list: `made`, of the scene itself, with what it has. */
static tp_status add_settings(tp_settings *settings, const tp_scene *scene,
                              const tp_override *overrides, long count, bool made,
                              tp_message *message) {
  tp_status status = TP_OK;
  fmpq_t value;
  fmpq_init(value);
  for (long k = 0; k < count && status == TP_OK; k++) {
    const char *text = overrides[k].setting;
    if (text == NULL) continue;
    bool holds = true, known = true;
    if (made) {
      status = look_up(value, &holds, scene, overrides + k, message);
    } else {
      known = tp_setting_evaluate(value, text, NULL, NULL) == TP_OK;
    }
    const tp_bounded number = known ? bounded(value) : (tp_bounded){.value = NAN, .error = NAN};
    if (status == TP_OK && holds) status = add_setting(settings, scene, text, number, message);
  }
  fmpq_clear(value);
  return status;
}

tp_status tp_scene_settings(tp_settings *settings, const tp_scene *scene, tp_message *message) {
  bool any = false;
  for (long k = 0; k < scene->override_count; k++) any |= scene->overrides[k].setting != NULL;
  if (!any) return TP_OK;
  settings->items = calloc((size_t)scene->override_count, sizeof *settings->items);
  if (settings->items == NULL) return tp_fail_memory(message, "the settings");
  return add_settings(settings, scene, scene->overrides, scene->override_count, true, message);
}

tp_status tp_scene_settings_with(tp_settings *settings, const tp_scene *scene,
                                 const tp_scene_key *keys, const char *const *texts, size_t count,
                                 tp_message *message) {
  const size_t room = (size_t)scene->override_count + count + 1;
  tp_override *overrides = calloc(room, sizeof *overrides);
  settings->items = calloc(room, sizeof *settings->items);
  long own = 0;
  bool done =
      overrides != NULL && settings->items != NULL && tp_overrides_append(overrides, &own, scene);
  for (size_t k = 0; k < count && done; k++) {
    done = tp_overrides_put(overrides, &own, keys[k].node, NULL, texts[k]);
  }
  const tp_status status = done ? add_settings(settings, scene, overrides, own, false, message)
                                : tp_fail_memory(message, "the settings");
  tp_overrides_free(overrides, own);
  return status;
}

void tp_settings_clear(tp_settings *settings) {
  for (size_t k = 0; k < settings->count; k++) {
    free(settings->items[k].key);
    free(settings->items[k].formula);
  }
  free(settings->items);
  *settings = (tp_settings){.count = 0};
}
