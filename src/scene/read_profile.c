/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A base profile that is made by rule: teeth, a self-affine one or a measured one, then noise on
 * it, then wear. */

#include "generate/generate.h"
#include "number/ratio.h"
#include "scene/read_generated.h"

#include <string.h>

/* Standard deviation, and the seed that is drawn from. */
static tp_status add_noise(const tp_reader *reader, tp_polyline *line, const tp_node *node) {
  static const char *const keys[] = {"deviation", "seed", NULL};
  static const char example[] = "noise: {deviation: 0.1, seed: 1}";
  uint64_t seed = 0;
  fmpq_t deviation;
  if (node == NULL) return TP_OK;
  fmpq_init(deviation);
  tp_status status = tp_node_expect_keys(node, keys, "noise", reader->scene->path, reader->message);
  if (status == TP_OK) {
    status = tp_read_rule_of(reader, deviation, node, keys[0], example, TP_RULE_ABOVE_ZERO);
  }
  if (status == TP_OK) status = tp_read_seed(reader, &seed, node, true);
  if (status == TP_OK) tp_add_noise(line, deviation, seed);
  fmpq_clear(deviation);
  return status;
}

static tp_status check_depth(const tp_reader *reader, const tp_polyline *line, tp_wear wear,
                             const fmpq_t depth, const tp_node *node) {
  tp_status status = TP_OK;
  fmpq_t most;
  fmpq_init(most);
  tp_wear_most(most, line, wear);
  if (wear != TP_WEAR_ROUNDED && fmpq_cmp(depth, most) >= 0) {
    char text[80];
    tp_ratio_text(text, sizeof text, most);
    status = tp_read_fail(reader, node,
                          "'%s' takes off all of the roughness: the highest point stands %s above "
                          "the %s; take less",
                          node->key, text, wear == TP_WEAR_CUT ? "lowest" : "mean of all points");
  }
  fmpq_clear(most);
  return status;
}

static tp_status wear_off(const tp_reader *reader, tp_polyline *line, const tp_node *node) {
  static const char *const keys[] = {"cut", "rounded", "abraded", NULL};
  if (node == NULL) return TP_OK;
  tp_status status = tp_node_expect_keys(node, keys, "worn", reader->scene->path, reader->message);
  if (status != TP_OK) return status;
  if (node->count != 1) {
    return tp_read_fail(reader, node,
                        "worn says one of cut, rounded and abraded, with its depth: 'worn: {cut: "
                        "0.5}'");
  }
  int key = 0;
  while (keys[key + 1] != NULL && strcmp(keys[key], node->first->key) != 0) key++;
  const tp_wear wear = (tp_wear)key;
  fmpq_t depth;
  fmpq_init(depth);
  status = tp_read_by_rule(reader, depth, node->first, keys[key], TP_RULE_ABOVE_ZERO);
  if (status == TP_OK) status = check_depth(reader, line, wear, depth, node->first);
  if (status == TP_OK && !tp_wear_off(line, wear, depth)) {
    status = tp_fail_memory(reader->message, "the profile");
  }
  fmpq_clear(depth);
  return status;
}

/* Points that other scenes share become some of its own, which may be changed. */
static tp_status read_measured(const tp_reader *reader, tp_polyline *line, const tp_node *node) {
  const tp_status status = tp_read_points(reader, line, node, false, "the profile");
  if (status == TP_OK && !tp_polyline_separate(line)) {
    tp_polyline_clear(line);
    return tp_fail_memory(reader->message, "the profile");
  }
  if (status == TP_OK && line->count < 2) {
    return tp_read_fail(reader, node, "a base profile needs at least two points");
  }
  return status;
}

/* What a rule makes of numbers in range may be out of it. */
static tp_status check_range(const tp_reader *reader, const tp_polyline *line,
                             const tp_node *node) {
  const tp_place place = tp_read_place(reader, node);
  const long last = line->count - 1;
  tp_status status = tp_check_range(line->x + last, "the profile's x", place, reader->message);
  for (long k = 0; k <= last && status == TP_OK; k++) {
    status = tp_check_range(line->y + k, "the profile's y", place, reader->message);
  }
  return status;
}

tp_status tp_read_generated(const tp_reader *reader, tp_polyline *line, const tp_node *node) {
  static const char *const keys[] = {"teeth", "self_affine", "measured", "noise", "worn", NULL};
  tp_status status = tp_node_expect_keys(node, keys, "a profile made by rule", reader->scene->path,
                                         reader->message);
  if (status != TP_OK) return status;
  const tp_node *teeth = tp_node_get(node, keys[0]), *rough = tp_node_get(node, keys[1]);
  const tp_node *measured = tp_node_get(node, keys[2]);
  if ((teeth != NULL) + (rough != NULL) + (measured != NULL) != 1) {
    return tp_read_fail(reader, node,
                        "a profile made by rule begins with one of teeth, self_affine and "
                        "measured: 'profile: {self_affine: {…}, noise: {…}, worn: {…}}'");
  }
  tp_polyline own = {.file = reader->scene->path, .mark = node->mark};
  status = teeth != NULL   ? tp_read_teeth_profile(reader, &own, teeth)
           : rough != NULL ? tp_read_self_affine(reader, &own, rough)
                           : read_measured(reader, &own, measured);
  if (status == TP_OK) status = add_noise(reader, &own, tp_node_get(node, "noise"));
  if (status == TP_OK) status = wear_off(reader, &own, tp_node_get(node, "worn"));
  if (status == TP_OK) status = check_range(reader, &own, node);
  if (status == TP_OK && own.users == NULL && !tp_polyline_make_shared(&own)) {
    status = tp_fail_memory(reader->message, "the profile");
  }
  if (status == TP_OK) {
    *line = own;
  } else {
    tp_polyline_clear(&own);
  }
  return status;
}
