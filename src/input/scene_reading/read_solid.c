/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Reads the key solid: a mesh, which way is up, and what touches the base. */

#include "scene_reading/read.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { AXES = 3, MOST_BANDS = TP_SOLID_BANDS };

/* ---- points ------------------------------------------------------------------------------------
 */

static void init_point(fmpq point[AXES]) {
  for (int k = 0; k < AXES; k++) fmpq_init(point + k);
}

static void clear_point(fmpq point[AXES]) {
  for (int k = 0; k < AXES; k++) fmpq_clear(point + k);
}

static bool is_zero(const fmpq point[AXES]) {
  return fmpq_is_zero(point) && fmpq_is_zero(point + 1) && fmpq_is_zero(point + 2);
}

static void subtract(fmpq way[AXES], const fmpq to[AXES], const fmpq from[AXES]) {
  for (int k = 0; k < AXES; k++) fmpq_sub(way + k, to + k, from + k);
}

/* ---- up ----------------------------------------------------------------------------------------
 */

static double along(const fmpq up[AXES], const fmpq *vertex, const fmpq point[AXES]) {
  double sum = 0;
  for (int k = 0; k < AXES; k++) {
    sum += fmpq_get_d(up + k) * (fmpq_get_d(vertex + k) - fmpq_get_d(point + k));
  }
  return sum;
}

/* The mean height of the vertices over a plane, as a share of their mean distance from it. */
static double mean_side(const tp_mesh *mesh, const fmpq up[AXES], const fmpq point[AXES]) {
  double sum = 0, size = 0;
  for (long v = 0; v < mesh->vertex_count; v++) {
    const double own = along(up, mesh->vertices + 3 * v, point);
    sum += own;
    size += fabs(own);
  }
  return size > 0 ? sum / size : 0;
}

static tp_status turn_up(const tp_reader *reader, const fmpq point[AXES], const tp_node *node) {
  static const double least = 0.01;
  tp_solid_description *own = &reader->scene->solid;
  const double side = mean_side(own->mesh, own->up, point);
  if (fabs(side) < least) {
    return tp_read_fail(reader, TP_FAULT_RANGE, node,
                        "as much of the mesh lies below this plane as above: name three points of "
                        "the base that it stands on, or say which way is up by 'up: [x, y, z]'");
  }
  for (int k = 0; k < AXES && side < 0; k++) fmpq_neg(own->up + k, own->up + k);
  return TP_OK;
}

static void cross(fmpq product[AXES], const fmpq a[AXES], const fmpq b[AXES]) {
  for (int k = 0; k < AXES; k++) {
    const int i = (k + 1) % AXES, j = (k + 2) % AXES;
    fmpq_mul(product + k, a + i, b + j);
    fmpq_submul(product + k, a + j, b + i);
  }
}

static tp_status read_base_points(const tp_reader *reader, const tp_node *node) {
  const tp_node *list = NULL;
  fmpq points[AXES][AXES];
  tp_status status = tp_read_keys(reader, node, &tp_key_map_solid_up, "up");
  if (status == TP_OK) {
    status = tp_read_required(reader, &list, node, "points",
                              "points: [[0, 0, 0], [1, 0, 0], [0, 1, 0]]");
  }
  if (status != TP_OK) return status;
  if (list->kind != TP_NODE_SEQUENCE || list->count != AXES) {
    return tp_read_fail(reader, TP_FAULT_FORMAT, list,
                        "three points of the plane that it lies on are needed: [[x, y, z], [x, y, "
                        "z], [x, y, z]]");
  }
  const tp_node *n = list->first;
  for (int k = 0; k < AXES; k++) init_point(points[k]);
  for (int k = 0; k < AXES && status == TP_OK; k++, n = n->next) {
    status = tp_read_triple(reader, points[k], n, "a point of the base");
  }
  if (status == TP_OK) {
    subtract(points[1], points[1], points[0]);
    subtract(points[2], points[2], points[0]);
    cross(reader->scene->solid.up, points[1], points[2]);
    status = is_zero(reader->scene->solid.up)
                 ? tp_read_fail(reader, TP_FAULT_RANGE, list,
                                "these three points lie on one line, which gives no plane")
                 : turn_up(reader, points[0], list);
  }
  for (int k = 0; k < AXES; k++) clear_point(points[k]);
  return status;
}

static tp_status read_up_vector(const tp_reader *reader, const tp_node *node) {
  fmpq *up = reader->scene->solid.up;
  fmpq_one(up + 2);
  if (node == NULL) return TP_OK;
  if (node->kind == TP_NODE_MAPPING) return read_base_points(reader, node);
  const tp_status status = tp_read_triple(reader, up, node, "up");
  if (status != TP_OK || !is_zero(up)) return status;
  return tp_read_fail(reader, TP_FAULT_RANGE, node,
                      "of the three numbers of 'up' at least one is not 0");
}

/* ---- bands -------------------------------------------------------------------------------------
 */

static tp_status read_bands(const tp_reader *reader, const tp_node *parent) {
  tp_solid_description *own = &reader->scene->solid;
  const tp_node *node = NULL;
  static const char *const others[] = {"bands", "contacts", NULL};
  const tp_node *other = tp_node_first_of(parent, others);
  if (other == NULL && own->ground.place.file != NULL) other = tp_node_get(parent, "base");
  if (own->below.given && other != NULL) {
    return tp_read_fail(reader, TP_FAULT_KEY, other,
                        "a rock that a plane cuts rests on the section, 'below' which all is "
                        "ground: leave out '%s', or 'below'",
                        other->key);
  }
  if (own->below.given) return TP_OK;
  if (tp_node_get(parent, "contacts") != NULL && tp_node_get(parent, "bands") == NULL) {
    return TP_OK;
  }
  tp_status status = tp_read_required(reader, &node, parent, "bands", "bands: [0.002, 0.005]");
  if (status != TP_OK) return status;
  const bool is_list = node->kind == TP_NODE_SEQUENCE;
  if (node->kind == TP_NODE_MAPPING ||
      (is_list && (node->count == 0 || node->count > MOST_BANDS))) {
    return tp_read_fail(reader, TP_FAULT_FORMAT, node,
                        "bands are one length or a list of up to %d: [0.002, 0.005]", MOST_BANDS);
  }
  own->bands = calloc(is_list ? (size_t)node->count : 1, sizeof *own->bands);
  if (own->bands == NULL) return tp_fail_memory(reader->message, "the bands of a solid");
  for (const tp_node *n = is_list ? node->first : node; n != NULL && status == TP_OK;
       n = is_list ? n->next : NULL) {
    fmpq_init(own->bands + own->band_count);
    status =
        tp_read_by_rule(reader, own->bands + own->band_count++, n, "a band", TP_RULE_NOT_NEGATIVE);
  }
  return status;
}

/* ---- the scene ---------------------------------------------------------------------------------
 */

/* Keys that say nothing of a solid. */
static tp_status check_root(const tp_reader *reader, const tp_node *root) {
  static const char *const keys[] = {
      "block",   "blocks",  "columns",   "jointed_slope",   "joints",  "base",  "joint",
      "drawing", "section", "cases",     "friction",        "contact", "frame", "slope",
      "support", "shaking", "tilt_test", "partial_factors", NULL};
  const tp_node *node = tp_node_first_of(root, keys);
  if (node != NULL) {
    return tp_read_fail(reader, TP_FAULT_KEY, node,
                        "'%s' is of a scene of a block in a section, and this one has a 'solid': "
                        "leave it out",
                        node->key);
  }
  return TP_OK;
}

static tp_status check_azimuth_count(const tp_reader *reader) {
  const tp_quantity *azimuths = &reader->scene->solid.azimuths;
  const bool is_count = fmpz_is_one(fmpq_denref(azimuths->value)) &&
                        fmpq_cmp_si(azimuths->value, TP_SOLID_AZIMUTHS) <= 0;
  return !azimuths->given || is_count
             ? TP_OK
             : tp_refuse(reader->message, TP_FAULT_RANGE, azimuths->place,
                         "azimuths must be a whole number from 1 to %d", TP_SOLID_AZIMUTHS);
}

tp_status tp_read_solid(const tp_reader *reader, const tp_node *root) {
  tp_scene *scene = reader->scene;
  const tp_node *node = tp_node_get(root, "solid");
  scene->solid.place = scene->block.place = tp_node_place(node, scene->path);
  scene->block.form = TP_OUTLINE_OF_SOLID;
  bool has_lengths = false;
  tp_status status = check_root(reader, root);
  if (status == TP_OK) status = tp_read_map(reader, scene, node, &tp_key_map_solid, "a solid");
  if (status == TP_OK) status = check_azimuth_count(reader);
  if (status == TP_OK && tp_node_get(node, "wedge") != NULL) return tp_read_wedge(reader, node);
  if (status == TP_OK) {
    status = tp_read_solid_mesh(reader, &scene->solid.mesh, &scene->solid.object, node);
  }
  if (status == TP_OK) status = tp_read_solid_parts(reader, node);
  if (status == TP_OK) {
    status = tp_read_mesh_lengths(reader, scene->solid.metres_per_unit, &has_lengths, node);
  }
  if (status == TP_OK && !has_lengths) status = tp_note_mesh_unit(reader, node, &scene->notes);
  if (status == TP_OK) status = tp_read_solid_repair(reader, tp_node_get(node, "repair"));
  if (status == TP_OK) status = tp_read_solid_thin(reader, tp_node_get(node, "thin"));
  if (status == TP_OK) status = read_up_vector(reader, tp_node_get(node, "up"));
  if (status == TP_OK) status = tp_read_solid_base(reader, node);
  if (status == TP_OK) status = read_bands(reader, node);
  return status == TP_OK ? tp_read_solid_contacts(reader, node) : status;
}
