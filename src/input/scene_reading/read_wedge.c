/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The key solid.wedge: planes by dip and dip direction, strength, crack, water. */

#include "scene_reading/read.h"

#include <string.h>

/* A map of it; where `has` is NULL it must be there. */
static tp_status read_part(const tp_reader *reader, bool *has, const tp_node *wedge,
                           const char *key, const tp_key_map *map) {
  static const char *const example = "{dip_deg: 45, dip_direction_deg: 105}";
  const tp_node *node = tp_node_get(wedge, key);
  if (has != NULL) {
    *has = node != NULL;
    if (node == NULL) return TP_OK;
  }
  tp_status status = tp_read_required(reader, &node, wedge, key, example);
  if (status == TP_OK) status = tp_read_map(reader, reader->scene, node, map, key);
  return status;
}

static tp_status check_solid(const tp_reader *reader, const tp_node *solid) {
  for (const tp_node *n = solid->first; n != NULL; n = n->next) {
    if (strcmp(n->key, "wedge") == 0 || strcmp(n->key, "unit_weight_kn_m3") == 0 ||
        strcmp(n->key, "azimuths") == 0) {
      continue;
    }
    return tp_read_fail(reader, TP_FAULT_KEY, n,
                        "a solid that is a 'wedge' has its 'unit_weight_kn_m3' and 'azimuths' "
                        "beside it, and no '%s'",
                        n->key);
  }
  const tp_node *unit_weight = NULL;
  return tp_read_required(reader, &unit_weight, solid, "unit_weight_kn_m3",
                          "unit_weight_kn_m3: 26");
}

tp_status tp_read_wedge(const tp_reader *reader, const tp_node *solid) {
  tp_scene *scene = reader->scene;
  tp_wedge_description *own = &scene->solid.wedge;
  const tp_node *node = tp_node_get(solid, "wedge");
  own->place = tp_node_place(node, scene->path);
  scene->solid.object = -1;
  fmpq_set(scene->solid.metres_per_unit, scene->metres_per_unit);
  fmpq_one(scene->solid.up + 2);
  tp_status status = check_solid(reader, solid);
  if (status == TP_OK) {
    status = tp_read_map(reader, scene, node, &tp_key_map_solid_wedge, "a wedge");
  }
  if (status == TP_OK) {
    status = read_part(reader, NULL, node, "a", &tp_key_map_solid_wedge_a);
  }
  if (status == TP_OK) {
    status = read_part(reader, NULL, node, "b", &tp_key_map_solid_wedge_b);
  }
  if (status == TP_OK) {
    status = read_part(reader, NULL, node, "face", &tp_key_map_solid_wedge_face);
  }
  if (status == TP_OK) {
    status = read_part(reader, NULL, node, "upper", &tp_key_map_solid_wedge_upper);
  }
  if (status == TP_OK) {
    status = read_part(reader, &own->has_crack, node, "crack", &tp_key_map_solid_wedge_crack);
  }
  return status == TP_OK
             ? read_part(reader, &own->has_water, node, "water", &tp_key_map_solid_wedge_water)
             : status;
}
