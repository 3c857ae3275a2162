/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Reads of the loads of many blocks what those of one have not: which block each acts on, where a
 * bolt holds, and the key support; and refuses of water what is said of one block on its base. */

#include "scene_reading/block_names.h"

#include <stdlib.h>
#include <string.h>

/* ---- a scene of one block ----------------------------------------------------------------------
 */

static tp_status refuse_of_many(const tp_reader *reader, const tp_node *node) {
  if (node == NULL) return TP_OK;
  return tp_read_fail(reader, TP_FAULT_KEY, node,
                      "'%s' is of a scene of many 'blocks', and this one has one block: leave it "
                      "out",
                      node->key);
}

static tp_status refuse_in_items(const tp_reader *reader, const tp_node *list) {
  static const char *const keys[] = {"block", "into", "to"};
  const bool is_line = list == NULL || strcmp(list->key, "anchors") != 0;
  tp_status status = TP_OK;
  for (const tp_node *n = list != NULL ? list->first : NULL; n != NULL; n = n->next) {
    for (int k = 0; k < (is_line ? 1 : 3) && status == TP_OK; k++) {
      status = refuse_of_many(reader, tp_node_get(n, keys[k]));
    }
  }
  return status;
}

static tp_status check_one(const tp_reader *reader, const tp_node *root, const tp_node *loads) {
  static const char *const lists[] = {"pressures", "surcharges", "support_pressures", "anchors"};
  tp_status status = refuse_of_many(reader, tp_node_get(root, "support"));
  if (status == TP_OK && loads != NULL) {
    status = refuse_of_many(reader, tp_node_get(loads, "forces"));
  }
  for (int k = 0; k < 4 && status == TP_OK && loads != NULL; k++) {
    status = refuse_in_items(reader, tp_node_get(loads, lists[k]));
  }
  return status;
}

/* ---- many blocks -------------------------------------------------------------------------------
 */

static tp_status read_name(const tp_reader *reader, long *number, const tp_node *parent,
                           const char *key, const tp_block_name *names) {
  const tp_node *node = NULL;
  const tp_status status = tp_read_required(reader, &node, parent, key, "block: B1");
  return status == TP_OK ? tp_block_name_find(reader, number, node, names) : status;
}

/* Where it is not named it is found by where the load lies. */
static tp_status read_block(const tp_reader *reader, long *number, const tp_node *parent,
                            const tp_block_name *names) {
  const tp_node *node = tp_node_get(parent, "block");
  *number = -1;
  return node != NULL ? tp_block_name_find(reader, number, node, names) : TP_OK;
}

static tp_status read_lines(const tp_reader *reader, tp_line_load *lines, const tp_node *list,
                            const tp_block_name *names) {
  tp_status status = TP_OK;
  for (const tp_node *n = list != NULL ? list->first : NULL; n != NULL && status == TP_OK;
       n = n->next) {
    status = read_block(reader, &(lines++)->block, n, names);
  }
  return status;
}

/* Of bolts also where they end: that of a bolt has to be known. */
static tp_status read_anchors(const tp_reader *reader, tp_anchor_description *anchors,
                              const tp_node *list, const tp_block_name *names) {
  tp_status status = TP_OK;
  for (const tp_node *n = list != NULL ? list->first : NULL; n != NULL && status == TP_OK;
       n = n->next) {
    const tp_node *into = tp_node_get(n, "into");
    tp_anchor_description *own = anchors++;
    own->into = -1;
    status = read_block(reader, &own->block, n, names);
    if (status == TP_OK && into != NULL) {
      status = tp_block_name_find(reader, &own->into, into, names);
    }
  }
  return status;
}

static tp_status check_ends(const tp_reader *reader) {
  const tp_loads_description *loads = &reader->scene->loads;
  for (long k = 0; k < loads->anchor_count; k++) {
    const tp_anchor_description *own = loads->anchors + k;
    if (own->into >= 0 || own->to_x.given || own->length.given) continue;
    return tp_refuse(reader->message, TP_FAULT_KEY, own->place,
                     "say where this bolt holds: its far end by 'to: [x, y]' or by its 'length', "
                     "or the block by 'into', as 'into: ground'");
  }
  return TP_OK;
}

static tp_status read_support(const tp_reader *reader, const tp_node *node,
                              const tp_block_name *names) {
  tp_support_description *own = &reader->scene->many.support;
  const tp_node *at = NULL;
  if (node == NULL) return TP_OK;
  own->place = tp_node_place(node, reader->scene->path);
  tp_status status = tp_read_map(reader, reader->scene, node, &tp_key_map_support, "support");
  if (status == TP_OK) status = read_name(reader, &own->block, node, "block", names);
  if (status == TP_OK) status = tp_read_required(reader, &at, node, "at", "at: [0, 4]");
  return status == TP_OK ? tp_read_point(reader, &own->x, &own->y, at, "at") : status;
}

/* Water is a level or a surface; it stands in all joints below, or in none. */
static tp_status check_water(const tp_reader *reader, const tp_node *node) {
  static const char level[] = "water in and about many blocks has a 'level', or a 'surface' of "
                              "points from left to right";
  static const char ice[] = "give the pressure of ice as 'pressures: [{block: …, from: …, to: …, "
                            "kpa: …}]' on each block that it presses on";
  static const struct {
    const char *key, *instead;
  } keys[] = {{"height", level},
              {"stays_level", level},
              {"tension_crack", "between many blocks water stands in every joint below the "
                                "'surface': draw that up to where it stands in the crack"},
              {"ice_kpa", ice},
              {"ice_thickness", ice}};
  const tp_water_description *water = &reader->scene->loads.water;
  if (node == NULL) return TP_OK;
  for (size_t k = 0; k < sizeof keys / sizeof keys[0]; k++) {
    const tp_node *own = tp_node_get(node, keys[k].key);
    if (own == NULL) continue;
    return tp_read_fail(reader, TP_FAULT_KEY, own, "'%s' is of one block on its base: %s",
                        keys[k].key, keys[k].instead);
  }
  if (water->shape == TP_WATER_UPLIFT_TRIANGULAR) {
    return tp_read_fail(reader, TP_FAULT_KEY, tp_node_get(node, "uplift"),
                        "between many blocks water stands in all joints below its level or "
                        "surface, 'uplift: full', or in none, 'uplift: none'; draw the surface as "
                        "low as it stands where joints are drained");
  }
  if (water->faces != TP_WATER_IN_FRONT) return TP_OK;
  return tp_read_fail(reader, TP_FAULT_KEY, tp_node_get(node, "faces"),
                      "of many blocks water presses on the faces 'behind', from where it drives "
                      "them, or on 'both', those that it holds too; where it stands the surface "
                      "says");
}

static tp_status read_all(const tp_reader *reader, const tp_node *root, const tp_node *loads,
                          const tp_block_name *names) {
  tp_loads_description *own = &reader->scene->loads;
  tp_status status = read_support(reader, tp_node_get(root, "support"), names);
  if (status != TP_OK || loads == NULL) return status;
  const tp_node *const lists[] = {tp_node_get(loads, "pressures"), tp_node_get(loads, "surcharges"),
                                  tp_node_get(loads, "support_pressures")};
  tp_line_load *const lines[] = {own->pressures, own->surcharges, own->supports};
  for (int k = 0; k < 3 && status == TP_OK; k++) {
    status = read_lines(reader, lines[k], lists[k], names);
  }
  if (status == TP_OK) {
    status = read_anchors(reader, own->anchors, tp_node_get(loads, "anchors"), names);
  }
  if (status == TP_OK) {
    status = read_anchors(reader, own->forces, tp_node_get(loads, "forces"), names);
  }
  if (status == TP_OK) status = check_ends(reader);
  return status == TP_OK ? check_water(reader, tp_node_get(loads, "water")) : status;
}

tp_status tp_read_block_loads(const tp_reader *reader, const tp_node *root) {
  const tp_node *loads = tp_node_get(root, "loads");
  if (reader->scene->many.count == 0) return check_one(reader, root, loads);
  if (loads == NULL && tp_node_get(root, "support") == NULL) return TP_OK;
  tp_block_name *names = NULL;
  tp_status status = tp_block_names_sort(&names, reader);
  if (status == TP_OK) status = read_all(reader, root, loads, names);
  free(names);
  return status;
}
