/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The key solid.base: a plane that dips from the level across `up`, or a mesh of the ground in the
 * axes of the rock's. */

#include "scene_reading/read.h"

static tp_status read_dip(const tp_reader *reader, const tp_node *node) {
  static const char *const keys[] = {"object", "unit", "scale", NULL};
  const tp_node *other = tp_node_first_of(node, keys);
  if (other != NULL) {
    return tp_read_fail(reader, TP_FAULT_KEY, other,
                        "'%s' is of a mesh of the ground: name its 'file', or leave this out",
                        other->key);
  }
  return tp_read_map(reader, reader->scene, node, &tp_key_map_solid_base, "the base");
}

/* By its own unit or known length, or as those of the rock's mesh. */
static tp_status read_lengths(const tp_reader *reader, const tp_node *node) {
  tp_solid_description *solid = &reader->scene->solid;
  bool given = false;
  const tp_status status =
      tp_read_mesh_lengths(reader, solid->ground.metres_per_unit, &given, node);
  if (!given) fmpq_set(solid->ground.metres_per_unit, solid->metres_per_unit);
  return status;
}

static tp_status read_ground(const tp_reader *reader, const tp_node *node) {
  static const char *const keys[] = {"dip_deg", "dip_direction_deg", NULL};
  tp_ground_description *ground = &reader->scene->solid.ground;
  const tp_node *dip = tp_node_first_of(node, keys);
  if (dip != NULL) {
    return tp_read_fail(reader, TP_FAULT_KEY, dip,
                        "'%s' is of a base that is a plane, and this one is a mesh, which lies as "
                        "it is: leave it out, and turn both by 'up' or 'tilt'",
                        dip->key);
  }
  tp_status status = tp_read_keys(reader, node, &tp_key_map_solid_base, "the base");
  if (status == TP_OK) {
    status = tp_read_solid_mesh(reader, &ground->mesh, &ground->object, node);
  }
  ground->place = tp_node_place(node, reader->scene->path);
  return status == TP_OK ? read_lengths(reader, node) : status;
}

tp_status tp_read_solid_base(const tp_reader *reader, const tp_node *solid) {
  const tp_node *node = tp_node_get(solid, "base"), *thin = tp_node_get(solid, "thin");
  if (node == NULL) return TP_OK;
  if (tp_node_get(node, "file") == NULL) return read_dip(reader, node);
  return thin == NULL ? read_ground(reader, node)
                      : tp_read_fail(reader, TP_FAULT_KEY, thin,
                                     "a rock on a mesh of the ground touches it with its own "
                                     "surface: leave out 'thin', or thin the mesh beforehand");
}
