/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The key partial_factors: the name of a set, or a map of factors, which may begin with a set. */

#include "scene/partial_factors.h"
#include "scene_reading/read.h"

#include "common/outside.h"

#include <string.h>

static tp_status read_set(const tp_reader *reader, tp_partial_factors *factors,
                          const tp_node *node) {
  const char *name = node->kind == TP_NODE_SCALAR ? node->text : "";
  if (tp_partial_factors_take_set(factors, name)) return TP_OK;
  const char *nearest = tp_nearest(name, tp_partial_factors_names());
  char list[200];
  tp_partial_factors_list(list, sizeof list);
  if (nearest != NULL) {
    return tp_read_fail(reader, TP_FAULT_KEY, node,
                        "there is no set of partial factors '%s'; did you mean '%s'?",
                        tp_quote_all(name).text, nearest);
  }
  return tp_read_fail(reader, TP_FAULT_KEY, node,
                      "there is no set of partial factors '%s'; there are %s, or give your own: "
                      "{permanent_unfavourable: 1.35, friction: 1.25}",
                      tp_quote_all(name).text, list);
}

static tp_status read_own(const tp_reader *reader, tp_partial_factors *factors,
                          const tp_node *node) {
  tp_status status = tp_read_keys(reader, node, &tp_key_map_partial_factors, "partial_factors");
  const tp_node *set = tp_node_get(node, "set");
  if (status == TP_OK && set != NULL) status = read_set(reader, factors, set);
  for (int k = 0; k < TP_PARTIAL_FACTORS && status == TP_OK; k++) {
    const tp_partial_factor factor = (tp_partial_factor)k;
    const char *key = tp_partial_factor_key(factor);
    const tp_node *own = tp_node_get(node, key);
    if (own == NULL) continue;
    factors->name = NULL;
    status = tp_read_number(reader, factors->values + k, own, key);
    if (status == TP_OK) {
      status = tp_partial_factor_check(factor, factors->values + k, tp_read_place(reader, own),
                                       reader->message);
    }
  }
  if (status != TP_OK || set != NULL) return status;
  /* water is a permanent action unless it has factors of its own */
  if (tp_node_get(node, "water_unfavourable") == NULL) {
    fmpq_set(factors->values + TP_PARTIAL_WATER_UNFAVOURABLE,
             factors->values + TP_PARTIAL_PERMANENT_UNFAVOURABLE);
  }
  if (tp_node_get(node, "water_favourable") == NULL) {
    fmpq_set(factors->values + TP_PARTIAL_WATER_FAVOURABLE,
             factors->values + TP_PARTIAL_PERMANENT_FAVOURABLE);
  }
  return TP_OK;
}

/* What holds the block must be there to be divided. */
static tp_status check_friction(const tp_reader *reader, const tp_partial_factors *factors,
                                const tp_node *node) {
  if (reader->scene->friction_angle_deg.given || factors->toppling_alone ||
      reader->scene->many.count > 0) { /* each of their contacts is asked when it is solved */
    return TP_OK;
  }
  const tp_node *own = node->kind == TP_NODE_MAPPING ? tp_node_get(node, "friction") : NULL;
  return tp_read_fail(reader, TP_FAULT_KEY, own != NULL ? own : node,
                      "partial factors need the friction of the contact, as sliding is judged with "
                      "them: give friction_angle_deg; EQU judges toppling alone");
}

tp_status tp_read_partial_factors(const tp_reader *reader, const tp_node *node) {
  if (node == NULL) return TP_OK;
  tp_scene *scene = reader->scene;
  tp_partial_factors *factors = tp_partial_factors_new(tp_node_place(node, scene->path));
  if (factors == NULL) return tp_fail_memory(reader->message, "the partial factors");
  scene->partial_factors = factors;
  const tp_status status = node->kind == TP_NODE_MAPPING ? read_own(reader, factors, node)
                                                         : read_set(reader, factors, node);
  if (status == TP_OK && scene->required_fos.given) {
    return tp_read_fail(reader, TP_FAULT_KEY, node,
                        "give required_fos or partial_factors, not both: partial factors say "
                        "themselves what the factor must reach, 'resistance' included");
  }
  if (status == TP_OK && factors->toppling_alone && scene->many.count > 0) {
    return tp_read_fail(reader, TP_FAULT_KEY, node,
                        "EQU compares moments about the pivots of one block, and this scene has "
                        "many: take another set, or factors of your own");
  }
  return status == TP_OK ? check_friction(reader, factors, node) : status;
}
