/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The profile of a scene as CSV, every digit of it: read again it is the same. */

#include "common/host.h"
#include "number/ratio.h"
#include "output/file.h"
#include "output/text.h"
#include "scene/scene.h"
#include "scene_reading/csv.h"

#include <stdlib.h>
#include <string.h>

static bool add(tp_text *text, const fmpq_t value, const char *after) {
  char *digits = tp_ratio_exact_text(value);
  if (digits == NULL) return false;
  tp_text_add(text, "%s%s", digits, after);
  free(digits);
  return true;
}

static tp_status make(char **csv, const tp_scene *scene, tp_message *message) {
  const tp_polyline *profile = &scene->base.profile;
  if (scene->base.mated || profile->count == 0) {
    return tp_refuse(message, TP_FAULT_KEY, scene->base.place,
                     "the base has no separate profile: it is mated with the block");
  }
  tp_text text = {0}, points = {0};
  bool room = true;
  for (long k = 0; k < profile->count && room; k++) {
    room = add(&points, profile->x + k, ",") && add(&points, profile->y + k, "\n");
  }
  const bool fractions = points.data != NULL && strchr(points.data, '/') != NULL;
  tp_text_add(&text, "%sx,y\n", fractions ? TP_CSV_FRACTIONS "\n" : "");
  tp_text_append(&text, points.data != NULL ? points.data : "", points.length);
  if (!room || points.failed) text.failed = true;
  tp_text_drop(&points);
  const tp_status status = tp_text_finish(&text, csv);
  return status == TP_OK ? TP_OK : tp_fail_memory(message, "the profile");
}

tp_status tp_scene_profile_csv(char **text, const tp_scene *scene, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, text);
  TP_REFUSE_NULL(message, scene);
  return make(text, scene, message);
}

tp_status tp_scene_write_profile(const char *path, const tp_scene *scene, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, scene);
  TP_REFUSE_NULL(message, path);
  char *text = NULL;
  const size_t count = tp_scene_source_count(scene);
  const char **sources = calloc(count + 1, sizeof *sources);
  if (sources == NULL) return tp_fail_memory(message, "the profile");
  for (size_t k = 0; k < count; k++) sources[k] = tp_scene_source(scene, k);
  tp_status status = make(&text, scene, message);
  if (status == TP_OK && text != NULL) {
    status = tp_file_write(path, text, strlen(text), (tp_file_sources){count, sources}, message);
  }
  free(sources);
  free(text);
  return status;
}
