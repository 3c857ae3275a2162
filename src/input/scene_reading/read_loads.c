/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Reads the key loads of a scene: earthquake, water, pressures, surcharges, anchors, bond and
 * cohesion. */

#include "scene_reading/read.h"

#include <stdlib.h>
#include <string.h>

/* Which way it shakes a block that lies on a slope. */
static tp_status read_direction(const tp_reader *reader, const tp_node *node) {
  static const char *const words[] = {"both", "down_dip", "up_dip"};
  tp_loads_description *loads = &reader->scene->loads;
  if (node == NULL) return TP_OK;
  for (int k = 0; k < 3 && !loads->direction_given; k++) {
    loads->direction_given = node->kind == TP_NODE_SCALAR && strcmp(node->text, words[k]) == 0;
    loads->direction = (tp_seismic_direction)k;
  }
  return loads->direction_given ? TP_OK
                                : tp_read_fail(reader, TP_FAULT_KEY, node,
                                               "direction must be both, down_dip or up_dip");
}

static tp_status read_seismic(const tp_reader *reader, const tp_node *node) {
  tp_loads_description *loads = &reader->scene->loads;
  if (node == NULL) return TP_OK;
  loads->seismic_place = tp_node_place(node, reader->scene->path);
  tp_status status = tp_read_map(reader, reader->scene, node, &tp_key_map_loads_seismic, "seismic");
  if (status == TP_OK) status = read_direction(reader, tp_node_get(node, "direction"));
  if (status == TP_OK && !loads->horizontal.given && !loads->vertical.given) {
    status = tp_read_fail(reader, TP_FAULT_KEY, node,
                          "seismic needs 'horizontal' (k_h) or 'vertical' (k_v)");
  }
  return status;
}

static tp_status read_required_point(const tp_reader *reader, tp_quantity *x, tp_quantity *y,
                                     const tp_node *parent, const char *key) {
  const tp_node *node = NULL;
  const tp_status status = tp_read_required(reader, &node, parent, key, "[0, 10]");
  return status == TP_OK ? tp_read_point(reader, x, y, node, key) : status;
}

/* `kpa` as one number, or as two at the ends where `two` allows it. */
static tp_status read_kpa(const tp_reader *reader, tp_line_load *load, const tp_node *parent,
                          bool two) {
  const tp_node *node = NULL;
  const tp_status status = tp_read_required(reader, &node, parent, "kpa", "kpa: 10");
  if (status != TP_OK) return status;
  if (node->kind == TP_NODE_SEQUENCE && node->count == 2 && two) {
    const tp_status first =
        tp_read_quantity(reader, &load->first_kpa, node->first, "a pressure", TP_RULE_NOT_NEGATIVE);
    return first == TP_OK ? tp_read_quantity(reader, &load->last_kpa, node->last, "a pressure",
                                             TP_RULE_NOT_NEGATIVE)
                          : first;
  }
  const tp_status first =
      tp_read_quantity(reader, &load->first_kpa, node, "a pressure", TP_RULE_NOT_NEGATIVE);
  return first == TP_OK
             ? tp_read_quantity(reader, &load->last_kpa, node, "a pressure", TP_RULE_NOT_NEGATIVE)
             : first;
}

static tp_status read_lines(const tp_reader *reader, tp_line_load **loads, long *count,
                            const tp_node *node, const tp_key_map *map, const char *what,
                            bool two) {
  if (node == NULL) return TP_OK;
  if (node->kind != TP_NODE_SEQUENCE) {
    return tp_read_fail(reader, TP_FAULT_FORMAT, node,
                        "%s are a list of {from: [x, y], to: [x, y], kpa: 10}", what);
  }
  *loads = calloc((size_t)node->count + 1, sizeof **loads);
  if (*loads == NULL) return tp_fail_memory(reader->message, "the loads");
  tp_status status = TP_OK;
  for (const tp_node *n = node->first; n != NULL && status == TP_OK; n = n->next) {
    tp_line_load *load = *loads + (*count)++;
    tp_line_load_init(load);
    load->place = tp_node_place(n, reader->scene->path);
    load->passive = map == &tp_key_map_loads_support_pressures;
    status = tp_read_map(reader, load, n, map, what);
    if (status == TP_OK) status = read_required_point(reader, &load->x0, &load->y0, n, "from");
    if (status == TP_OK) status = read_required_point(reader, &load->x1, &load->y1, n, "to");
    if (status == TP_OK) status = read_kpa(reader, load, n, two);
  }
  return status;
}

static tp_status read_side(const tp_reader *reader, tp_bolt_side *side, const tp_node *node) {
  if (node == NULL) return TP_OK;
  if (node->kind == TP_NODE_SCALAR && strcmp(node->text, "left") == 0) *side = TP_BOLT_LEFT;
  if (node->kind == TP_NODE_SCALAR && strcmp(node->text, "right") == 0) *side = TP_BOLT_RIGHT;
  return *side != TP_BOLT_UP_DIP
             ? TP_OK
             : tp_read_fail(reader, TP_FAULT_KEY, node, "towards must be left or right");
}

/* A bolt, or a force from outside. */
static tp_status read_anchor(const tp_reader *reader, tp_anchor_description *anchor,
                             const tp_node *node, const tp_key_map *map) {
  const bool is_force = map == &tp_key_map_loads_forces;
  anchor->place = tp_node_place(node, reader->scene->path);
  tp_status status = tp_read_map(reader, anchor, node, map, is_force ? "a force" : "an anchor");
  /* a wedge does not turn: where it is held is of no account */
  if (status == TP_OK && reader->scene->solid.wedge.place.file == NULL) {
    status = read_required_point(reader, &anchor->x, &anchor->y, node, "at");
  }
  if (status == TP_OK) status = read_side(reader, &anchor->side, tp_node_get(node, "towards"));
  const tp_node *step = tp_node_get(node, "row_step"), *to = tp_node_get(node, "to");
  if (status == TP_OK && step != NULL) {
    status = tp_read_point(reader, &anchor->step_x, &anchor->step_y, step, "row_step");
  }
  if (status != TP_OK || to == NULL) return status;
  return tp_read_point(reader, &anchor->to_x, &anchor->to_y, to, "to");
}

static tp_status read_anchors(const tp_reader *reader, tp_anchor_description **anchors, long *count,
                              const tp_node *node, const tp_key_map *map) {
  if (node == NULL) return TP_OK;
  if (node->kind != TP_NODE_SEQUENCE) {
    return tp_read_fail(reader, TP_FAULT_FORMAT, node,
                        "%s are a list of {at: [x, y], dip_deg: 15, force_kn: 50}", node->key);
  }
  *anchors = calloc((size_t)node->count + 1, sizeof **anchors);
  if (*anchors == NULL) return tp_fail_memory(reader->message, "the loads");
  tp_status status = TP_OK;
  for (const tp_node *n = node->first; n != NULL && status == TP_OK; n = n->next) {
    tp_anchor_description *anchor = *anchors + (*count)++;
    tp_anchor_init(anchor);
    status = read_anchor(reader, anchor, n, map);
  }
  return status;
}

tp_status tp_read_loads(const tp_reader *reader, const tp_node *node) {
  tp_scene *scene = reader->scene;
  tp_loads_description *loads = &scene->loads;
  if (node == NULL) return TP_OK;
  loads->place = tp_node_place(node, scene->path);
  tp_status status = tp_read_keys(reader, node, &tp_key_map_loads, "loads");
  if (status == TP_OK) status = tp_check_loads_weighed(scene, loads->place, reader->message);
  if (status == TP_OK) status = read_seismic(reader, tp_node_get(node, "seismic"));
  if (status == TP_OK) status = tp_read_water(reader, tp_node_get(node, "water"));
  if (status == TP_OK) {
    status =
        read_lines(reader, &loads->pressures, &loads->pressure_count,
                   tp_node_get(node, "pressures"), &tp_key_map_loads_pressures, "pressures", true);
  }
  if (status == TP_OK) {
    status = read_lines(reader, &loads->surcharges, &loads->surcharge_count,
                        tp_node_get(node, "surcharges"), &tp_key_map_loads_pressures, "surcharges",
                        false);
  }
  if (status == TP_OK) {
    status = read_lines(reader, &loads->supports, &loads->support_count,
                        tp_node_get(node, "support_pressures"), &tp_key_map_loads_support_pressures,
                        "support_pressures", true);
  }
  if (status == TP_OK) {
    status = read_anchors(reader, &loads->anchors, &loads->anchor_count,
                          tp_node_get(node, "anchors"), &tp_key_map_loads_anchors);
  }
  if (status == TP_OK) {
    status = read_anchors(reader, &loads->forces, &loads->force_count, tp_node_get(node, "forces"),
                          &tp_key_map_loads_forces);
  }
  return status == TP_OK ? tp_read_values(reader, scene, node, &tp_key_map_loads) : status;
}
