/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A base profile that is made by rule: the numbers of its rule, each with its place; what must hold
 * of them is checked where the profile is made (scene/profile_make.h). */

#include "scene/profile_make.h"
#include "scene/rule_jrc.h"
#include "scene_reading/read.h"

#include <string.h>

/* A number that a map must have. */
static tp_status read_required(const tp_reader *reader, tp_quantity *quantity, const tp_node *map,
                               const char *key, const char *example) {
  const tp_node *node = NULL;
  const tp_status status = tp_read_required(reader, &node, map, key, example);
  return status == TP_OK ? tp_read_quantity(reader, quantity, node, key, TP_RULE_ANY) : status;
}

/* One that it may have. */
static tp_status read_own(const tp_reader *reader, tp_quantity *quantity, const tp_node *map,
                          const char *key) {
  return tp_read_quantity(reader, quantity, tp_node_get(map, key), key, TP_RULE_ANY);
}

static tp_status read_start(const tp_reader *reader, tp_profile_rule *rule, const tp_node *map) {
  const tp_node *node = tp_node_get(map, "start");
  if (node == NULL) return TP_OK;
  return tp_read_point(reader, &rule->start_x, &rule->start_y, node, "start");
}

static tp_status read_seed(const tp_reader *reader, tp_quantity *seed, const tp_node *map) {
  return read_required(reader, seed, map, "seed", "seed: 1");
}

/* ---- teeth -------------------------------------------------------------------------------------
 */

static tp_status read_left_end(const tp_reader *reader, bool *valley, const tp_node *map) {
  const tp_node *node = NULL;
  const tp_status status = tp_read_required(reader, &node, map, "left_end", "left_end: valley");
  if (status != TP_OK) return status;
  const char *text = node->kind == TP_NODE_SCALAR ? node->text : "";
  *valley = strcmp(text, "valley") == 0;
  if (*valley || strcmp(text, "peak") == 0) return TP_OK;
  return tp_read_fail(reader, TP_FAULT_KEY, node, "left_end must be valley or peak");
}

static tp_status read_scatter(const tp_reader *reader, tp_profile_rule *rule, const tp_node *node) {
  if (node == NULL) return TP_OK;
  tp_status status =
      tp_node_expect_keys(node, tp_scatter_keys, "scatter", reader->scene->path, reader->message);
  for (int k = 0; tp_scatter_keys[k] != NULL && status == TP_OK; k++) {
    status = read_own(reader, rule->scatter + k, node, tp_scatter_keys[k]);
  }
  return status;
}

static tp_status read_teeth(const tp_reader *reader, tp_profile_rule *rule, const tp_node *node) {
  static const char *const keys[] = {"count",   "wavelength", "amplitude", "skew", "left_end",
                                     "scatter", "start",      "seed",      NULL};
  static const char example[] = "teeth: {count: 8, wavelength: 60, amplitude: 5, left_end: valley}";
  tp_quantity *const needed[] = {&rule->count, &rule->wavelength, &rule->amplitude};
  tp_status status = tp_node_expect_keys(node, keys, "teeth", reader->scene->path, reader->message);
  for (int k = 0; k < 3 && status == TP_OK; k++) {
    status = read_required(reader, needed[k], node, keys[k], example);
  }
  if (status == TP_OK) status = read_own(reader, &rule->skew, node, "skew");
  if (status == TP_OK) status = read_left_end(reader, &rule->left_end_valley, node);
  if (status == TP_OK) status = read_scatter(reader, rule, tp_node_get(node, "scatter"));
  if (status == TP_OK) status = read_start(reader, rule, node);
  return status == TP_OK ? read_own(reader, &rule->seed, node, "seed") : status;
}

/* ---- self-affine, and in place of a standard profile -------------------------------------------
 */

/* By which number it is said how rough a profile is. */
static tp_status read_roughness(const tp_reader *reader, tp_quantity *by, const tp_node *map,
                                const char *what) {
  int given = 0;
  for (int k = 0; k < TP_ROUGHNESS_KINDS; k++) {
    given += tp_node_get(map, tp_roughness_keys[k]) != NULL ? 1 : 0;
  }
  if (given != 1) {
    return tp_read_fail(reader, TP_FAULT_KEY, map,
                        "how rough %s is, one of rms_height, z2 and jrc says", what);
  }
  tp_status status = TP_OK;
  for (int k = 0; k < TP_ROUGHNESS_KINDS && status == TP_OK; k++) {
    status = read_own(reader, by + k, map, tp_roughness_keys[k]);
  }
  return status;
}

static tp_status read_self_affine(const tp_reader *reader, tp_profile_rule *rule,
                                  const tp_node *node) {
  static const char example[] =
      "self_affine: {length: 100, step: 0.5, hurst: 0.8, rms_height: 1, seed: 1}";
  tp_status status =
      tp_read_keys(reader, node, &tp_key_map_base_profile_self_affine, "self_affine");
  if (status == TP_OK) status = read_required(reader, &rule->length, node, "length", example);
  if (status == TP_OK) status = read_required(reader, &rule->step, node, "step", example);
  if (status == TP_OK) status = read_own(reader, &rule->shortest, node, "shortest");
  if (status == TP_OK) status = read_own(reader, &rule->longest, node, "longest");
  if (status == TP_OK) status = read_required(reader, &rule->hurst, node, "hurst", "hurst: 0.8");
  if (status == TP_OK) {
    status = read_roughness(reader, rule->roughness, node, "a self-affine profile");
  }
  if (status == TP_OK) status = read_start(reader, rule, node);
  return status == TP_OK ? read_seed(reader, &rule->seed, node) : status;
}

/* ---- what changes a profile --------------------------------------------------------------------
 */

static tp_status read_noise(const tp_reader *reader, tp_profile_rule *rule, const tp_node *node) {
  if (node == NULL) return TP_OK;
  tp_status status = tp_read_keys(reader, node, &tp_key_map_base_profile_noise, "noise");
  if (status == TP_OK) {
    status = read_required(reader, &rule->deviation, node, "deviation",
                           "noise: {deviation: 0.1, seed: 1}");
  }
  return status == TP_OK ? read_seed(reader, &rule->noise_seed, node) : status;
}

static tp_status read_scaled(const tp_reader *reader, tp_profile_rule *rule, const tp_node *node) {
  if (node == NULL) return TP_OK;
  const tp_status status =
      tp_node_expect_keys(node, tp_roughness_keys, "scaled", reader->scene->path, reader->message);
  return status == TP_OK ? read_roughness(reader, rule->scaled, node, "a scaled profile") : status;
}

static tp_status read_worn(const tp_reader *reader, tp_profile_rule *rule, const tp_node *node) {
  if (node == NULL) return TP_OK;
  tp_status status =
      tp_node_expect_keys(node, tp_wear_keys, "worn", reader->scene->path, reader->message);
  if (status != TP_OK) return status;
  if (node->count != 1) {
    return tp_read_fail(reader, TP_FAULT_KEY, node,
                        "worn says one of cut, rounded and abraded, with its depth: 'worn: {cut: "
                        "0.5}'");
  }
  for (int k = 0; k < TP_WEAR_KINDS && status == TP_OK; k++) {
    status = read_own(reader, rule->worn + k, node, tp_wear_keys[k]);
  }
  return status;
}

/* ---- the whole ---------------------------------------------------------------------------------
 */

static tp_status read_first(const tp_reader *reader, tp_profile_rule *rule, const tp_node *node) {
  rule->first_place = tp_read_place(reader, node);
  switch (rule->made) {
  case TP_MADE_OF_TEETH:
    return read_teeth(reader, rule, node);
  case TP_MADE_SELF_AFFINE:
    return read_self_affine(reader, rule, node);
  case TP_MADE_LIKE_STANDARD:
    return tp_read_quantity(reader, &rule->standard, node, "jrc_profile", TP_RULE_ANY);
  case TP_MADE_OF_MEASURED:
  case TP_MADE_OF_POINTS:
    break;
  }
  return tp_read_points(reader, &rule->measured, node, false, "the profile");
}

/* As its rule says; what the same numbers made before is taken again. */
static tp_status make(const tp_reader *reader, const tp_node *node) {
  tp_scene *scene = reader->scene;
  tp_polyline *line = &scene->base.profile;
  const tp_polyline *kept = tp_read_kept(reader, node);
  if (kept != NULL) {
    *line = tp_polyline_share(kept);
    return TP_OK;
  }
  const tp_status status =
      tp_profile_make(line, &scene->base.rule, scene->metres_per_unit, reader->message);
  if (status != TP_OK || tp_read_keep(reader, line, node)) return status;
  return tp_fail_memory(reader->message, "the profile");
}

tp_status tp_read_generated(const tp_reader *reader, const tp_node *node) {
  static const char *const keys[] = {"teeth", "self_affine", "jrc_profile", "measured",
                                     "noise", "scaled",      "worn",        NULL};
  enum { FIRST = 4 };
  tp_scene *scene = reader->scene;
  tp_profile_rule *rule = &scene->base.rule;
  const tp_node *first = NULL;
  int begins = 0;
  tp_status status =
      tp_node_expect_keys(node, keys, "a profile made by rule", scene->path, reader->message);
  if (status != TP_OK) return status;
  for (int k = 0; k < FIRST; k++) {
    const tp_node *own = tp_node_get(node, keys[k]);
    if (own == NULL) continue;
    first = own;
    rule->made = (tp_made_of)(TP_MADE_OF_TEETH + k);
    begins++;
  }
  if (begins != 1) {
    return tp_read_fail(reader, TP_FAULT_KEY, node,
                        "a profile made by rule begins with one of teeth, self_affine, jrc_profile "
                        "and measured: 'profile: {self_affine: {…}, noise: {…}, worn: {…}}'");
  }
  rule->place = tp_read_place(reader, node);
  reader->reading->varies = false;
  status = read_first(reader, rule, first);
  if (status == TP_OK) status = read_noise(reader, rule, tp_node_get(node, "noise"));
  if (status == TP_OK) status = read_scaled(reader, rule, tp_node_get(node, "scaled"));
  if (status == TP_OK) status = read_worn(reader, rule, tp_node_get(node, "worn"));
  if (status == TP_OK) status = make(reader, node);
  tp_polyline_clear(&rule->measured);
  if (status != TP_OK) return status;
  return tp_profile_rule_notes(&scene->notes, rule, scene->metres_per_unit, reader->message);
}
