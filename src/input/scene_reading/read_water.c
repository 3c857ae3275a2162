/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Reads loads.water: a height, a level, a surface or a filled crack, which faces it wets, how it
 * lifts the block. */

#include "scene_reading/read.h"

#include <string.h>

enum { GAMMA_W = 981, PER_UNIT = 100 }; /* 9.81 kN/m3 where none is given */

/* Which of the words a node is; `count`: none of them. */
static size_t word_of(const tp_node *node, const char *const *words, size_t count) {
  size_t k = 0;
  while (k < count && (node->kind != TP_NODE_SCALAR || strcmp(node->text, words[k]) != 0)) k++;
  return k;
}

static tp_status read_faces(const tp_reader *reader, const tp_node *node) {
  static const char *const words[] = {"behind", "front", "both"};
  if (node == NULL) return TP_OK;
  const size_t word = word_of(node, words, 3);
  if (word == 3) {
    return tp_read_fail(reader, TP_FAULT_KEY, node,
                        "faces that water wets are behind (up-dip of the block), front or both");
  }
  reader->scene->loads.water.faces = (tp_water_faces)(TP_WATER_BEHIND + word);
  return TP_OK;
}

static tp_status read_uplift(const tp_reader *reader, const tp_node *node) {
  static const char *const words[] = {"none", "false", "triangular", "true", "full"};
  static const tp_water_uplift shapes[] = {TP_WATER_UPLIFT_NONE, TP_WATER_UPLIFT_NONE,
                                           TP_WATER_UPLIFT_TRIANGULAR, TP_WATER_UPLIFT_TRIANGULAR,
                                           TP_WATER_UPLIFT_FULL};
  tp_water_description *water = &reader->scene->loads.water;
  if (node == NULL) return TP_OK;
  const size_t word = word_of(node, words, 5);
  if (word == 5) {
    return tp_read_fail(reader, TP_FAULT_KEY, node,
                        "uplift must be true or false, or none, triangular (to nothing at a "
                        "drained toe) or full");
  }
  water->shape = shapes[word];
  water->uplift = water->shape != TP_WATER_UPLIFT_NONE;
  return TP_OK;
}

static tp_status read_crack(const tp_reader *reader, const tp_node *node) {
  tp_scene *scene = reader->scene;
  if (node == NULL) return TP_OK;
  scene->loads.water.cracked = true;
  return tp_read_map(reader, scene, node, &tp_key_map_loads_water_tension_crack, "tension_crack");
}

static tp_status read_surface(const tp_reader *reader, const tp_node *node) {
  tp_polyline *surface = &reader->scene->loads.water.surface;
  if (node == NULL) return TP_OK;
  const tp_status status = tp_read_points(reader, surface, node, false, "the surface of the water");
  if (status != TP_OK || surface->count > 1) return status;
  return tp_read_fail(reader, TP_FAULT_GEOMETRY, node,
                      "the surface of the water needs two points at least, from left to right; one "
                      "that is level may be given as 'level'");
}

tp_status tp_read_water(const tp_reader *reader, const tp_node *node) {
  tp_scene *scene = reader->scene;
  tp_water_description *water = &scene->loads.water;
  if (node == NULL) return TP_OK;
  water->given = true;
  water->place = tp_node_place(node, scene->path);
  fmpq_set_si(water->unit_weight_kn_m3.value, GAMMA_W, PER_UNIT);
  tp_status status = tp_read_map(reader, scene, node, &tp_key_map_loads_water, "water");
  if (status == TP_OK) status = read_faces(reader, tp_node_get(node, "faces"));
  if (status == TP_OK) status = read_uplift(reader, tp_node_get(node, "uplift"));
  if (status == TP_OK) status = read_surface(reader, tp_node_get(node, "surface"));
  if (status == TP_OK) status = read_crack(reader, tp_node_get(node, "tension_crack"));
  if (status == TP_OK) status = tp_check_water(scene, reader->message);
  if (status == TP_OK && water->shape == TP_WATER_UPLIFT_UNSTATED) {
    water->uplift = tp_water_is_sited(&scene->loads.water);
  }
  return status;
}
