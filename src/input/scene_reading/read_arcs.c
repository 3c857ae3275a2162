/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Reads the key arcs of an outline: each arc by its first point and either a point on it or a
 * bulge. */

#include "scene_reading/read.h"

#include <stdlib.h>

static tp_status read_arc(const tp_reader *reader, tp_arc_description *arc, const tp_node *node) {
  const tp_node *from = NULL;
  arc->place = tp_node_place(node, reader->scene->path);
  tp_status status = tp_read_keys(reader, node, &tp_key_map_block_arcs, "an arc");
  if (status == TP_OK) status = tp_read_required(reader, &from, node, "from", "from: [0, 0]");
  if (status != TP_OK) return status;
  const tp_node *through = tp_node_get(node, "through"), *bulge = tp_node_get(node, "bulge");
  if ((through == NULL) == (bulge == NULL)) {
    return tp_read_fail(reader, TP_FAULT_FORMAT, node,
                        "an arc goes 'through' a point, or has a 'bulge'");
  }
  status = tp_read_point(reader, &arc->x, &arc->y, from, "from");
  if (status == TP_OK && through != NULL) {
    status = tp_read_point(reader, &arc->through_x, &arc->through_y, through, "through");
  }
  if (status != TP_OK) return status;
  return tp_read_quantity(reader, &arc->bulge, bulge, "bulge", TP_RULE_BULGE);
}

tp_status tp_read_arcs(const tp_reader *reader, const tp_node *node) {
  tp_block_description *block = &reader->scene->block;
  if (node == NULL) return TP_OK;
  if (node->kind != TP_NODE_SEQUENCE) {
    return tp_read_fail(reader, TP_FAULT_FORMAT, node,
                        "arcs are a list of {from: [x, y], through: [x, y]}");
  }
  tp_status status =
      tp_check_arcs_on_outline(reader->scene, tp_read_place(reader, node), reader->message);
  if (status != TP_OK) return status;
  block->arcs = calloc((size_t)node->count + 1, sizeof *block->arcs);
  if (block->arcs == NULL) return tp_fail_memory(reader->message, "the arcs");
  for (const tp_node *n = node->first; n != NULL && status == TP_OK; n = n->next) {
    tp_arc_description *arc = block->arcs + block->arc_count++;
    tp_arc_init(arc);
    status = read_arc(reader, arc, n);
  }
  return status;
}
