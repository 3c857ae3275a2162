/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Reads and checks all numbers of a call first, then puts them into the scene, so that a call that
 * fails leaves the scene as it was. */

#include "scene_building/build.h"

#include "common/host.h"
#include "common/outside.h"
#include "scene_keys.h"

#include <stdlib.h>
#include <string.h>

tp_status tp_build_begin(tp_build *build, tp_scene *scene, const char *call, tp_message *message) {
  *build = (tp_build){.scene = scene, .place = {call, 0, 0}, .message = message};
  if (scene->source == NULL) return TP_OK;
  return tp_refuse(message, TP_FAULT_ARGUMENT, build->place,
                   "this scene was read from a file; change what it says there, or build one by "
                   "tp_scene_new");
}

tp_status tp_build_read(tp_build *build, const tp_given *given, long count) {
  tp_status status = TP_OK;
  for (long k = 0; k < count && status == TP_OK; k++) {
    fmpq *value = build->values + build->count++;
    fmpq_init(value);
    status = tp_exact_read(value, given[k].value, given[k].name, build->place.file, build->message);
    if (status == TP_OK) {
      status = tp_check_rule(given[k].rule, value, given[k].name, build->place, build->message);
    }
  }
  return status;
}

void tp_build_end(tp_build *build) {
  for (long k = 0; k < build->count; k++) fmpq_clear(build->values + k);
  build->count = 0;
}

void tp_build_put(tp_build *build, tp_quantity *quantity, long index) {
  fmpq_swap(quantity->value, build->values + index);
  quantity->given = true;
  quantity->place = build->place;
}

/* A number that stands by itself: of no list, no form and no law, and nothing follows from it but
 * what is computed when the scene is solved. NULL: there is none of that key. */
static const tp_key_value *find_number(const char *key) {
  static const tp_key_value numbers[] = TP_SCENE_LONE_NUMBERS;
  for (size_t k = 0; k < sizeof numbers / sizeof numbers[0]; k++) {
    if (strcmp(numbers[k].key, key) == 0) return numbers + k;
  }
  return NULL;
}

static bool is_under(const char *key, const char *map) {
  return strncmp(key, map, strlen(map)) == 0;
}

/* The maps that the key is in are given by the call, where nothing gave them before. */
static void note_maps(tp_build *build, const char *key) {
  tp_place *test = &build->scene->tilt_test.place;
  if (is_under(key, "loads.")) tp_build_note_load(build);
  if (is_under(key, "loads.seismic.")) build->scene->loads.seismic_place = build->place;
  if (is_under(key, "tilt_test.") && test->file == NULL) *test = build->place;
}

/* A number takes the place of another one that excludes it: the last one set is taken. */
static void drop_other(tp_scene *scene, const char *key) {
  if (strcmp(key, "joint.shift") == 0) scene->base.matching.given = false;
  if (strcmp(key, "joint.matching") == 0) scene->base.shift.given = false;
}

tp_status tp_build_set(tp_scene *scene, const char *call, const char *key, tp_exact value,
                       tp_message *message) {
  const tp_key_value *own = find_number(key);
  const char *dot = strrchr(key, '.');
  tp_build build;
  tp_status status = tp_build_begin(&build, scene, call, message);
  if (status != TP_OK) return status;
  if (own == NULL) {
    return tp_refuse(message, TP_FAULT_KEY, build.place,
                     "'%s' is no key of a number that stands by itself in a scene",
                     tp_quote_all(key).text);
  }
  const tp_given given = {dot != NULL ? dot + 1 : key, value, own->rule};
  status = tp_build_read(&build, &given, 1);
  if (status == TP_OK) {
    tp_build_put(&build, (tp_quantity *)(void *)((char *)scene + own->offset), 0);
    note_maps(&build, key);
    drop_other(scene, key);
  }
  tp_build_end(&build);
  return status;
}

tp_status tp_scene_set_number(tp_scene *scene, const char *key, tp_exact value,
                              tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  TP_REFUSE_NULL(message, key);
  const tp_key_value *own =
      find_number(key); /* its key is the place that messages and notes name */
  return tp_build_set(scene, own != NULL ? own->key : __func__, key, value, message);
}

tp_status tp_build_grow(tp_build *build, void **items, long count, size_t size) {
  enum { MOST_ITEMS = 10000000 };
  if (count >= MOST_ITEMS) {
    return tp_refuse(build->message, TP_FAULT_RANGE, build->place, "at most 10 million are taken");
  }
  /* room for 1, 2, 4, 8, ... */
  if ((count & (count - 1)) == 0) {
    void *grown = realloc(*items, (size_t)(count > 0 ? 2 * count : 1) * size);
    if (grown == NULL) return tp_fail_memory(build->message, "the scene");
    *items = grown;
  }
  memset((char *)*items + (size_t)count * size, 0, size);
  build->place.line = (int)count + 1;
  return TP_OK;
}

tp_status tp_build_find(const tp_build *build, size_t number, long count, const char *what) {
  if (number >= 1 && number <= (size_t)count) return TP_OK;
  return tp_refuse(build->message, TP_FAULT_ARGUMENT, build->place,
                   "there is no %s of this number: they count from 1, and the scene has %ld", what,
                   count);
}

void tp_build_note_load(tp_build *build) {
  tp_loads_description *loads = &build->scene->loads;
  if (loads->place.file == NULL) loads->place = (tp_place){build->place.file, 0, 0};
}
