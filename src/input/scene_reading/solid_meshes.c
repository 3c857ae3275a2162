/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The meshes of a solid: its own with its repair, and those inside, by the keys solid.holes and
 * solid.parts, as holes and parts of a block are outlines inside its own. That they lie inside is
 * for whoever has their surfaces (solid/pieces.h). */

#include "number/ball.h"
#include "scene/members.h"
#include "scene_reading/read.h"

#include <stdlib.h>

/* ---- one mesh ----------------------------------------------------------------------------------
 */

tp_status tp_read_solid_mesh(const tp_reader *reader, const tp_mesh **mesh, long *object,
                             const tp_node *node) {
  const tp_node *name = NULL;
  tp_status status = tp_read_required(reader, &name, node, "file", "file: boulder.stl");
  if (status != TP_OK) return status;
  if (name->kind != TP_NODE_SCALAR) {
    return tp_read_fail(reader, TP_FAULT_KEY, name,
                        "file must be the name of an STL, PLY or OBJ file");
  }
  status = tp_scene_file_mesh(mesh, reader->scene->file, name->text, reader->message);
  if (status != TP_OK) return status;
  return tp_read_mesh_object(reader, object, tp_node_get(node, "object"), *mesh);
}

/* ---- lists -------------------------------------------------------------------------------------
 */

/* What both lists have in common. */
typedef struct list {
  const tp_node *node; /* NULL: none */
  bool is_of_holes;
  const tp_key_map *keys;
  const char *item, *all; /* for messages */
} list;

static tp_status read_item(const tp_reader *reader, const list *l, const tp_node *node) {
  tp_solid_description *solid = &reader->scene->solid;
  tp_solid_part_description *own = solid->parts + solid->part_count++;
  *own = (tp_solid_part_description){.place = tp_node_place(node, reader->scene->path),
                                     .is_hole = l->is_of_holes};
  for (size_t k = 0; k < tp_solid_part_numbers.count; k++) {
    fmpq_init(tp_member_number(own, tp_solid_part_numbers.items[k]));
  }
  const tp_status status = tp_read_map(reader, own, node, l->keys, l->item);
  return status == TP_OK ? tp_read_solid_mesh(reader, &own->mesh, &own->object, node) : status;
}

static tp_status read_list(const tp_reader *reader, const list *l) {
  if (l->node == NULL) return TP_OK;
  if (l->node->kind != TP_NODE_SEQUENCE)
    return tp_read_fail(reader, TP_FAULT_FORMAT, l->node, "%s", l->all);
  tp_status status = TP_OK;
  for (const tp_node *n = l->node->first; n != NULL && status == TP_OK; n = n->next) {
    status = read_item(reader, l, n);
  }
  return status;
}

static size_t length(const tp_node *node) {
  return node != NULL && node->kind == TP_NODE_SEQUENCE ? (size_t)node->count : 0;
}

tp_status tp_read_solid_parts(const tp_reader *reader, const tp_node *node) {
  tp_solid_description *solid = &reader->scene->solid;
  const list holes = {tp_node_get(node, "holes"), true, &tp_key_map_solid_holes, "a hole",
                      "holes must be a list of meshes: [{file: cave.obj}]"};
  const list parts = {tp_node_get(node, "parts"), false, &tp_key_map_solid_parts, "a part",
                      "parts must be a list of {file, unit_weight_kn_m3}"};
  if (parts.node != NULL && !solid->unit_weight_kn_m3.given) {
    return tp_read_fail(reader, TP_FAULT_KEY, parts.node,
                        "parts of another density need the solid's 'unit_weight_kn_m3' too");
  }
  solid->parts = calloc(length(holes.node) + length(parts.node) + 1, sizeof *solid->parts);
  if (solid->parts == NULL) return tp_fail_memory(reader->message, "the parts of a solid");
  const tp_status status = read_list(reader, &holes);
  return status == TP_OK ? read_list(reader, &parts) : status;
}

/* ---- a repair ----------------------------------------------------------------------------------
 */

/* A length of the scene in those of the mesh. */
static tp_status read_mesh_length(const tp_reader *reader, double *length, const tp_node *node,
                                  const char *name, tp_rule rule) {
  fmpq_t own;
  fmpq_init(own);
  const tp_status status = tp_read_by_rule(reader, own, node, name, rule);
  fmpq_mul(own, own, reader->scene->metres_per_unit);
  fmpq_div(own, own, reader->scene->solid.metres_per_unit);
  if (status == TP_OK) {
    arf_t nearest;
    arf_init(nearest);
    arf_fmpz_div_fmpz(nearest, fmpq_numref(own), fmpq_denref(own), DBL_MANT_DIG, ARF_RND_NEAR);
    *length = tp_ball_nearest(nearest);
    arf_clear(nearest);
  }
  fmpq_clear(own);
  return status;
}

static tp_status read_merge_within(const tp_reader *reader, const tp_node *node) {
  return node == NULL ? TP_OK
                      : read_mesh_length(reader, &reader->scene->solid.repair_merge_within, node,
                                         "merge_within", TP_RULE_NOT_NEGATIVE);
}

static tp_status read_drop_below(const tp_reader *reader, const tp_node *node) {
  tp_solid_description *own = &reader->scene->solid;
  if (node == NULL) return TP_OK;
  fmpq_t share;
  fmpq_init(share);
  tp_status status = tp_read_by_rule(reader, share, node, "drop_below", TP_RULE_NOT_NEGATIVE);
  own->repair_drop_below = fmpq_get_d(share);
  fmpq_clear(share);
  if (status == TP_OK && !(own->repair_drop_below < 1)) {
    status = tp_read_fail(reader, TP_FAULT_RANGE, node,
                          "'drop_below' is a share of the area of the mesh, below 1: 0.01");
  }
  return status;
}

/* true, or {merge_within, drop_below}. */
tp_status tp_read_solid_repair(const tp_reader *reader, const tp_node *node) {
  tp_solid_description *own = &reader->scene->solid;
  if (node == NULL) return TP_OK;
  if (node->kind == TP_NODE_SCALAR) return tp_read_bool(reader, &own->repair, node, "repair");
  own->repair = true;
  tp_status status = tp_read_keys(reader, node, &tp_key_map_solid_repair, "repair");
  if (status == TP_OK) status = read_merge_within(reader, tp_node_get(node, "merge_within"));
  return status == TP_OK ? read_drop_below(reader, tp_node_get(node, "drop_below")) : status;
}

/* ---- thinning ----------------------------------------------------------------------------------
 */

tp_status tp_read_solid_thin(const tp_reader *reader, const tp_node *node) {
  tp_solid_description *own = &reader->scene->solid;
  if (node == NULL) return TP_OK;
  if (own->part_count > 0) {
    return tp_read_fail(reader, TP_FAULT_KEY, node,
                        "a rock with 'holes' or 'parts' is not thinned, for these may touch its "
                        "surface: leave out 'thin', or them");
  }
  return read_mesh_length(reader, &own->thin, node, "thin", TP_RULE_ABOVE_ZERO);
}
