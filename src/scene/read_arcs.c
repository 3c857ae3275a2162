/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Edges of an outline that are arcs. */

#include "scene/read.h"

#include <stdlib.h>

static tp_status read_arc(const tp_reader *reader, tp_arc_description *arc, const tp_node *node) {
  static const char *const keys[] = {"from", "through", "bulge", NULL};
  const tp_node *from = NULL;
  arc->place = tp_node_place(node, reader->scene->path);
  tp_status status =
      tp_node_expect_keys(node, keys, "an arc", reader->scene->path, reader->message);
  if (status == TP_OK) status = tp_read_required(reader, &from, node, "from", "from: [0, 0]");
  if (status != TP_OK) return status;
  const tp_node *through = tp_node_get(node, "through"), *bulge = tp_node_get(node, "bulge");
  if ((through == NULL) == (bulge == NULL)) {
    return tp_read_fail(reader, node, "an arc goes 'through' a point, or has a 'bulge'");
  }
  status = tp_read_point(reader, &arc->x, &arc->y, from, "from");
  if (status == TP_OK && through != NULL) {
    status = tp_read_point(reader, &arc->through_x, &arc->through_y, through, "through");
  }
  if (status == TP_OK) status = tp_read_quantity(reader, &arc->bulge, bulge, "bulge");
  if (status == TP_OK && bulge != NULL && fmpq_is_zero(arc->bulge.value)) {
    status = tp_read_fail(reader, bulge, "a bulge of 0 is a straight edge; leave the arc out");
  }
  return status;
}

tp_status tp_read_arcs(const tp_reader *reader, const tp_node *node) {
  tp_block_description *block = &reader->scene->block;
  if (node == NULL) return TP_OK;
  if (node->kind != TP_NODE_SEQUENCE) {
    return tp_read_fail(reader, node, "arcs are a list of {from: [x, y], through: [x, y]}");
  }
  if (block->form != TP_OUTLINE_VERTICES) {
    return tp_read_fail(reader, node, "arcs belong to an 'outline' of vertices");
  }
  block->arcs = calloc((size_t)node->count + 1, sizeof *block->arcs);
  if (block->arcs == NULL) return tp_fail_memory(reader->message, "the arcs");
  tp_status status = TP_OK;
  for (const tp_node *n = node->first; n != NULL && status == TP_OK; n = n->next) {
    tp_arc_description *arc = block->arcs + block->arc_count++;
    fmpq_init(arc->x.value);
    fmpq_init(arc->y.value);
    fmpq_init(arc->through_x.value);
    fmpq_init(arc->through_y.value);
    fmpq_init(arc->bulge.value);
    status = read_arc(reader, arc, n);
  }
  return status;
}

void tp_arcs_clear(tp_block_description *block) {
  for (long k = 0; k < block->arc_count; k++) {
    fmpq_clear(block->arcs[k].x.value);
    fmpq_clear(block->arcs[k].y.value);
    fmpq_clear(block->arcs[k].through_x.value);
    fmpq_clear(block->arcs[k].through_y.value);
    fmpq_clear(block->arcs[k].bulge.value);
  }
  free(block->arcs);
}
