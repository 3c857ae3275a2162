/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Holes, parts with their unit weights and arcs of a drawing added to the block of the scene. */

#include "scene/members.h"
#include "scene/read.h"

#include <stdlib.h>

/* Room for `more` items behind those of a list; false when memory is exhausted. */
static bool widen(void **items, long count, long more, size_t size) {
  void *wider = realloc(*items, (size_t)(count + more + 1) * size);
  if (wider == NULL) return false;
  *items = wider;
  return true;
}

tp_status tp_read_drawn_holes(const tp_reader *reader) {
  const tp_drawn *drawn = reader->scene->drawn;
  tp_block_description *block = &reader->scene->block;
  if (drawn == NULL || drawn->hole_count == 0) return TP_OK;
  if (!tp_scene_hole_room(reader->scene, drawn->hole_count)) {
    return tp_fail_memory(reader->message, "the holes");
  }
  for (long k = 0; k < drawn->hole_count; k++) {
    block->holes[block->hole_count++] = tp_polyline_share(drawn->holes + k);
  }
  return TP_OK;
}

/* Of the part with a number among the layers that the scene names. */
static tp_status read_weight(const tp_reader *reader, tp_quantity *weight, const tp_node *parts,
                             long number) {
  const tp_node *part = parts->kind == TP_NODE_SEQUENCE ? parts->first : parts;
  for (; number > 0; number--) part = part->next;
  return tp_read_quantity(reader, weight, tp_node_get(part, "unit_weight_kn_m3"),
                          "unit_weight_kn_m3", TP_RULE_UNIT_WEIGHT);
}

tp_status tp_read_drawn_parts(const tp_reader *reader, const tp_node *drawing) {
  const tp_drawn *drawn = reader->scene->drawn;
  tp_block_description *block = &reader->scene->block;
  if (drawn == NULL || drawn->part_count == 0) return TP_OK;
  const tp_node *node = tp_node_get(drawing, "part");
  tp_status status =
      tp_check_parts_weighed(reader->scene, tp_read_place(reader, node), reader->message);
  if (status != TP_OK) return status;
  void *parts = block->parts;
  if (!widen(&parts, block->part_count, drawn->part_count, sizeof *block->parts)) {
    return tp_fail_memory(reader->message, "the parts");
  }
  block->parts = parts;
  for (long k = 0; k < drawn->part_count && status == TP_OK; k++) {
    tp_part *own = block->parts + block->part_count++;
    *own = (tp_part){.outline = tp_polyline_share(drawn->parts + k)};
    fmpq_init(own->unit_weight_kn_m3.value);
    status = read_weight(reader, &own->unit_weight_kn_m3, node, drawn->part_words[k]);
  }
  return status;
}

tp_status tp_read_drawn_arcs(const tp_reader *reader) {
  const tp_drawn *drawn = reader->scene->drawn;
  tp_block_description *block = &reader->scene->block;
  if (drawn == NULL || drawn->arc_count == 0) return TP_OK;
  void *arcs = block->arcs;
  if (!widen(&arcs, block->arc_count, drawn->arc_count, sizeof *block->arcs)) {
    return tp_fail_memory(reader->message, "the arcs");
  }
  block->arcs = arcs;
  for (long k = 0; k < drawn->arc_count; k++) {
    const tp_drawn_arc *from = drawn->arcs + k;
    tp_arc_description *arc = block->arcs + block->arc_count++;
    *arc = (tp_arc_description){.place = {drawn->path, from->mark.line, from->mark.column}};
    tp_arc_init(arc);
    fmpq_set(arc->x.value, from->x);
    fmpq_set(arc->y.value, from->y);
    fmpq_set(arc->bulge.value, from->bulge);
    arc->x.given = arc->y.given = arc->bulge.given = true;
    arc->x.place = arc->y.place = arc->bulge.place = arc->place;
  }
  return TP_OK;
}
