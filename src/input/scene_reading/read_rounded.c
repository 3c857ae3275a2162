/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Reads the rounded corners of a block, by vertex or by end of the underside, with radius and
 * model. */

#include "scene_reading/read.h"

#include <stdlib.h>
#include <string.h>

static tp_status read_at(const tp_reader *reader, tp_corner_description *corner,
                         const tp_node *node) {
  if (node->kind == TP_NODE_SCALAR && strcmp(node->text, "left_end") == 0) {
    corner->at = TP_CORNER_LEFT_END;
    return TP_OK;
  }
  if (node->kind == TP_NODE_SCALAR && strcmp(node->text, "right_end") == 0) {
    corner->at = TP_CORNER_RIGHT_END;
    return TP_OK;
  }
  if (node->kind != TP_NODE_SEQUENCE || node->count != 2) {
    return tp_read_fail(reader, TP_FAULT_KEY, node,
                        "'at' must be left_end or right_end of the underside, or a vertex [x, y]");
  }
  corner->at = TP_CORNER_VERTEX;
  return tp_read_point(reader, &corner->x, &corner->y, node, "at");
}

static tp_status read_corner(const tp_reader *reader, tp_corner_description *corner,
                             const tp_node *node) {
  const tp_node *at = NULL;
  corner->place = tp_node_place(node, reader->scene->path);
  tp_status status =
      tp_read_map(reader, corner, node, &tp_key_map_block_rounded_corners, "a corner");
  if (status == TP_OK) status = tp_read_required(reader, &at, node, "at", "at: left_end");
  return status == TP_OK ? read_at(reader, corner, at) : status;
}

tp_status tp_read_rounded(const tp_reader *reader, const tp_node *node) {
  tp_rounded_description *rounded = &reader->scene->block.rounded;
  if (node == NULL) return TP_OK;
  rounded->place = tp_node_place(node, reader->scene->path);
  const tp_status status = tp_read_keys(reader, node, &tp_key_map_block_rounded, "rounded");
  if (status != TP_OK) return status;
  const tp_node *model = tp_node_get(node, "model"), *corners = tp_node_get(node, "corners");
  const char *name = model == NULL ? "exact" : model->kind == TP_NODE_SCALAR ? model->text : "";
  rounded->keeps_mass = strcmp(name, "paper") == 0;
  if (!rounded->keeps_mass && strcmp(name, "exact") != 0) {
    return tp_read_fail(reader, TP_FAULT_KEY, model,
                        "model must be exact (the corner's tip is taken off) or paper (the axis "
                        "moves, the mass is kept)");
  }
  if (corners == NULL || corners->kind != TP_NODE_SEQUENCE) {
    return tp_read_fail(reader, TP_FAULT_KEY, corners != NULL ? corners : node,
                        "rounded needs a list: 'corners: [{at: left_end, radius: 3}]'");
  }
  rounded->corners = calloc((size_t)corners->count + 1, sizeof *rounded->corners);
  if (rounded->corners == NULL) return tp_fail_memory(reader->message, "the corners");
  tp_status read = TP_OK;
  for (const tp_node *c = corners->first; c != NULL && read == TP_OK; c = c->next) {
    tp_corner_description *corner = rounded->corners + rounded->count++;
    tp_corner_init(corner);
    read = read_corner(reader, corner, c);
  }
  return read;
}
