/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Reads of the loads of many blocks what those of one have not: which block each acts on, where a
 * bolt holds, and the key support; and refuses of water what is said of one block on its base. */

#include "scene/block_names.h"
#include "scene_reading/read.h"

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
  if (status != TP_OK) return status;
  return tp_block_name_find(number, reader->scene, node, names, reader->message);
}

/* Where a key does not name it it is found by where the load lies. */
static tp_status read_block(const tp_reader *reader, long *number, const tp_node *parent,
                            const char *key, const tp_block_name *names) {
  const tp_node *node = tp_node_get(parent, key);
  return node != NULL ? tp_block_name_find(number, reader->scene, node, names, reader->message)
                      : TP_OK;
}

static tp_status read_lines(const tp_reader *reader, tp_line_load *lines, const tp_node *list,
                            const tp_block_name *names) {
  tp_status status = TP_OK;
  for (const tp_node *n = list != NULL ? list->first : NULL; n != NULL && status == TP_OK;
       n = n->next) {
    status = read_block(reader, &(lines++)->block, n, "block", names);
  }
  return status;
}

/* Of bolts also where they end: that of a bolt has to be known. */
static tp_status read_anchors(const tp_reader *reader, tp_anchor_description *anchors,
                              const tp_node *list, const tp_block_name *names) {
  tp_status status = TP_OK;
  for (const tp_node *n = list != NULL ? list->first : NULL; n != NULL && status == TP_OK;
       n = n->next) {
    tp_anchor_description *own = anchors++;
    status = read_block(reader, &own->block, n, "block", names);
    if (status == TP_OK) status = read_block(reader, &own->into, n, "into", names);
  }
  return status;
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
static tp_status check_water(const tp_reader *reader, const tp_node *water) {
  tp_status status = TP_OK;
  for (const tp_node *n = water != NULL ? water->first : NULL; n != NULL && status == TP_OK;
       n = n->next) {
    status = tp_check_block_water(&reader->scene->loads.water, n->key,
                                  tp_node_place(n, reader->scene->path), reader->message);
  }
  return status;
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
  if (status == TP_OK) status = tp_check_bolt_ends(reader->scene, reader->message);
  return status == TP_OK ? check_water(reader, tp_node_get(loads, "water")) : status;
}

tp_status tp_read_block_loads(const tp_reader *reader, const tp_node *root) {
  const tp_node *loads = tp_node_get(root, "loads");
  if (reader->scene->many.count == 0) return check_one(reader, root, loads);
  if (loads == NULL && tp_node_get(root, "support") == NULL) return TP_OK;
  tp_block_name *names = NULL;
  tp_status status = tp_block_names_sort(&names, reader->scene, reader->message);
  if (status == TP_OK) status = read_all(reader, root, loads, names);
  free(names);
  return status;
}
