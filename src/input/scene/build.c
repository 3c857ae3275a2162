/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Reads and checks all numbers of a call first, then puts them into the scene, so that a call that
 * fails leaves the scene as it was. */

#include "scene/build.h"

#include <stdlib.h>
#include <string.h>

tp_status tp_build_begin(tp_build *build, tp_scene *scene, const char *call, tp_message *message) {
  *build = (tp_build){.scene = scene, .place = {call, 0, 0}, .message = message};
  if (scene->source == NULL) return TP_OK;
  return tp_fail(message, TP_BAD_INPUT, build->place,
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

tp_status tp_build_set(tp_scene *scene, const char *call, tp_given given, size_t offset,
                       tp_message *message) {
  tp_build build;
  tp_status status = tp_build_begin(&build, scene, call, message);
  if (status == TP_OK) status = tp_build_read(&build, &given, 1);
  if (status == TP_OK) {
    tp_build_put(&build, (tp_quantity *)(void *)((char *)scene + offset), 0);
  }
  tp_build_end(&build);
  return status;
}

tp_status tp_build_grow(tp_build *build, void **items, long count, size_t size) {
  enum { MOST_ITEMS = 10000000 };
  if (count >= MOST_ITEMS) {
    return tp_fail(build->message, TP_BAD_INPUT, build->place, "at most 10 million are taken");
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

void tp_build_note_load(tp_build *build) {
  tp_loads_description *loads = &build->scene->loads;
  if (loads->place.file == NULL) loads->place = (tp_place){build->place.file, 0, 0};
}
