/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Outlines and profiles that an upright plane cuts out of meshes: `{mesh: FILE, …}` in place of
 * points, and the key `section` of the scene, which gives the plane. */

#include "common/outside.h"
#include "format/mesh_cut.h"
#include "format/section_take.h"
#include "scene/unit_cautions.h"
#include "scene_reading/read.h"

#include <stdio.h>
#include <string.h>

/* ---- the plane ---------------------------------------------------------------------------------
 */

static tp_status read_map_point(const tp_reader *reader, fmpq point[2], const tp_node *node,
                                const char *name) {
  if (node->kind != TP_NODE_SEQUENCE || node->count != 2) {
    return tp_read_fail(reader, TP_FAULT_FORMAT, node, "'%s' is a point of the map, written [x, y]",
                        name);
  }
  const tp_status status = tp_read_number(reader, point, node->first, "x");
  return status == TP_OK ? tp_read_number(reader, point + 1, node->last, "y") : status;
}

/* By two points, or by one and an azimuth; as `point` and `other`, in scene lengths, or
 * `other[0]`. */
static tp_status read_line(const tp_reader *reader, const tp_node *node, fmpq point[2],
                           fmpq other[2], bool *by_azimuth) {
  const tp_node *from = tp_node_get(node, "from"), *to = tp_node_get(node, "to");
  const tp_node *at = tp_node_get(node, "at"), *azimuth = tp_node_get(node, "azimuth_deg");
  const bool points = from != NULL && to != NULL && at == NULL && azimuth == NULL;
  *by_azimuth = from == NULL && to == NULL && at != NULL && azimuth != NULL;
  if (!points && !*by_azimuth) {
    return tp_read_fail(reader, TP_FAULT_FORMAT, node,
                        "a section goes from one point of the map to another, {from: [x, y], to: "
                        "[x, y]}, or through one at an azimuth, clockwise from y, {at: [x, y], "
                        "azimuth_deg: 40}");
  }
  tp_status status = read_map_point(reader, point, points ? from : at, points ? "from" : "at");
  if (status != TP_OK) return status;
  if (points) return read_map_point(reader, other, to, "to");
  status = tp_read_number(reader, other, azimuth, "azimuth_deg");
  if (status != TP_OK) return status;
  fmpq_t turn;
  fmpq_init(turn);
  fmpq_set_si(turn, 360, 1);
  fmpq_abs(other + 1, other);
  const bool within = fmpq_cmp(other + 1, turn) <= 0;
  fmpq_clear(turn);
  return within ? TP_OK
                : tp_read_fail(reader, TP_FAULT_RANGE, azimuth,
                               "azimuth_deg must lie between -360 and 360");
}

/* By the reading of another mesh that the plane cuts. */
static bool is_noted(const tp_notes *notes, tp_place place) {
  char end[48] = ""; /* a number that was set has no line */
  if (place.line > 0) snprintf(end, sizeof end, ":%d:%d", place.line, place.column);
  const char *whole = place.line > 0 || place.file == NULL ? end : place.file;
  for (size_t k = 0; k < notes->count; k++) {
    const char *other = notes->items[k].place;
    const size_t length = strlen(other), size = strlen(whole);
    if (length >= size && strcmp(other + length - size, whole) == 0) return true;
  }
  return false;
}

static tp_status set_plane(const tp_reader *reader, tp_section_plane *plane, const tp_node *node,
                           fmpq point[2], fmpq other[2], const fmpq_t factor) {
  bool by_azimuth = false;
  const tp_status status = read_line(reader, node, point, other, &by_azimuth);
  if (status != TP_OK) return status;
  fmpq_div(point, point, factor);
  fmpq_div(point + 1, point + 1, factor);
  if (by_azimuth) {
    const tp_node *azimuth = tp_node_get(node, "azimuth_deg");
    const tp_quantity given = {
        .value = {other[0]}, .given = true, .place = tp_read_place(reader, azimuth)};
    tp_section_plane_at(plane, point, point + 1, other);
    return is_noted(&reader->scene->notes, given.place)
               ? TP_OK
               : tp_scene_azimuth_caution(&reader->scene->notes, &given, reader->message);
  }
  fmpq_div(other, other, factor);
  fmpq_div(other + 1, other + 1, factor);
  return tp_section_plane_through(plane, point, point + 1, other, other + 1)
             ? TP_OK
             : tp_read_fail(reader, TP_FAULT_FORMAT, node,
                            "'from' and 'to' are one point, which gives no section");
}

static tp_status read_up(const tp_reader *reader, bool *y_is_up, const tp_node *node) {
  if (node == NULL) return TP_OK;
  const char *text = node->kind == TP_NODE_SCALAR ? node->text : "";
  *y_is_up = strcmp(text, "y") == 0;
  if (*y_is_up || strcmp(text, "z") == 0) return TP_OK;
  return tp_read_fail(reader, TP_FAULT_KEY, node,
                      "up must be z, or y where the mesh has its heights there");
}

/* In lengths of the mesh. */
static tp_status read_plane(const tp_reader *reader, tp_section_plane *plane, const fmpq_t factor) {
  const tp_scene *scene = reader->scene;
  const tp_node *node = NULL;
  fmpq point[2], other[2];
  tp_status status = tp_read_required(reader, &node, scene->source, "section",
                                      "section: {from: [0, 0], to: [10, 0]}");
  if (status == TP_OK) {
    status = tp_read_keys(reader, node, &tp_key_map_section, "a section");
  }
  if (status == TP_OK) status = read_up(reader, &plane->y_is_up, tp_node_get(node, "up"));
  if (status != TP_OK) return status;
  for (int k = 0; k < 2; k++) {
    fmpq_init(point + k);
    fmpq_init(other + k);
  }
  status = set_plane(reader, plane, node, point, other, factor);
  for (int k = 0; k < 2; k++) {
    fmpq_clear(point + k);
    fmpq_clear(other + k);
  }
  return status;
}

tp_status tp_read_section_used(const tp_reader *reader, const tp_node *node) {
  return node == NULL || reader->reading->cut
             ? TP_OK
             : tp_read_fail(reader, TP_FAULT_KEY, node,
                            "this section cuts nothing; it is for an outline or a profile that is "
                            "given as {mesh: FILE}");
}

/* ---- the mesh ----------------------------------------------------------------------------------
 */

tp_status tp_read_mesh_unit(const tp_reader *reader, fmpq_t factor, const tp_node *node) {
  const tp_scene *scene = reader->scene;
  fmpq_one(factor);
  if (node == NULL) return TP_OK;
  const char *name = node->kind == TP_NODE_SCALAR ? node->text : "";
  if (!tp_unit_find(factor, &name)) {
    return tp_read_fail(reader, TP_FAULT_UNIT, node, "unit must be one of mm, cm, m, km, in, ft");
  }
  fmpq_div(factor, factor, scene->metres_per_unit);
  return TP_OK;
}

tp_status tp_note_mesh_unit(const tp_reader *reader, const tp_node *mesh, tp_notes *notes) {
  const char *unit = reader->scene->length_unit;
  if (tp_node_get(mesh, "unit") != NULL) return TP_OK;
  return tp_notes_add(notes, reader->message, TP_CAUTION, tp_read_place(reader, mesh),
                      "a mesh does not say what the unit of its lengths is: taken for %s, the "
                      "scene's; say {%s: …, unit: %s} where that is right",
                      unit, tp_node_get(mesh, "mesh") != NULL ? "mesh" : "file", unit);
}

static tp_status read_taking(const tp_reader *reader, bool *largest, const tp_node *node) {
  if (node == NULL) return TP_OK;
  *largest = node->kind == TP_NODE_SCALAR && strcmp(node->text, "largest") == 0;
  return *largest ? TP_OK
                  : tp_read_fail(reader, TP_FAULT_KEY, node,
                                 "take must be 'largest', of several outlines that the plane cuts");
}

static tp_status fail_object(const tp_reader *reader, const tp_node *node, const tp_mesh *mesh) {
  char names[TP_MESH_NAMES];
  tp_mesh_object_names(names, mesh);
  return tp_read_fail(reader, TP_FAULT_KEY, node,
                      "the mesh has no object of this name with faces; it has %s", names);
}

tp_status tp_read_mesh_object(const tp_reader *reader, long *object, const tp_node *node,
                              const tp_mesh *mesh) {
  *object = -1;
  if (node == NULL) return TP_OK;
  for (long k = 0; k < mesh->object_count && node->kind == TP_NODE_SCALAR; k++) {
    if (strcmp(mesh->objects[k].name, node->text) == 0 && mesh->objects[k].face_count > 0) {
      *object = k;
      return TP_OK;
    }
  }
  return fail_object(reader, node, mesh);
}

static tp_status note_left_out(const tp_reader *reader, const tp_mesh *mesh, tp_notes *notes) {
  const tp_place place = {mesh->file, mesh->left_out_line, 0};
  return mesh->left_out == 0
             ? TP_OK
             : tp_notes_add(notes, reader->message, TP_NOTE, place,
                            "faces without three different corners are left out, %ld in all, the "
                            "first of them face %d",
                            mesh->left_out, mesh->left_out_number);
}

/* What `wish` cannot say. */
static tp_status cut(const tp_reader *reader, tp_mesh_section *section, const tp_node *node,
                     const tp_section_wish *wish, tp_notes *notes) {
  const tp_node *name = tp_node_get(node, "mesh");
  const tp_mesh *mesh = NULL;
  tp_section_plane plane;
  long object = -1;
  if (name->kind != TP_NODE_SCALAR) {
    return tp_read_fail(reader, TP_FAULT_KEY, name,
                        "mesh must be the name of an STL, PLY or OBJ file");
  }
  tp_section_plane_init(&plane);
  tp_status status = read_plane(reader, &plane, wish->factor);
  if (status == TP_OK) {
    status = tp_scene_file_mesh(&mesh, reader->scene->file, name->text, reader->message);
  }
  if (status == TP_OK) {
    status = tp_read_mesh_object(reader, &object, tp_node_get(node, "object"), mesh);
  }
  if (status == TP_OK) status = note_left_out(reader, mesh, notes);
  if (status == TP_OK) status = tp_mesh_cut(section, mesh, object, &plane, reader->message);
  tp_section_plane_clear(&plane);
  return status;
}

static tp_status read_wish(const tp_reader *reader, tp_section_wish *wish, const tp_node *node) {
  const tp_node *gap = tp_node_get(node, "gap");
  tp_status status = tp_read_keys(reader, node, &tp_key_map_block_outline, "a mesh");
  if (status == TP_OK) status = tp_read_mesh_unit(reader, wish->factor, tp_node_get(node, "unit"));
  if (status == TP_OK) status = read_taking(reader, &wish->largest, tp_node_get(node, "take"));
  return status == TP_OK && gap != NULL
             ? tp_read_by_rule(reader, wish->gap, gap, "gap", TP_RULE_NOT_NEGATIVE)
             : status;
}

static tp_status check_points(const tp_reader *reader, const tp_polyline *line, tp_place place) {
  for (long k = 0; k < line->count; k++) {
    tp_status status =
        tp_check_range(line->x + k, "a coordinate of the section", place, reader->message);
    if (status == TP_OK) {
      status = tp_check_range(line->y + k, "a coordinate of the section", place, reader->message);
    }
    if (status != TP_OK) return status;
  }
  return TP_OK;
}

tp_status tp_read_mesh(const tp_reader *reader, tp_polyline *line, tp_polylines *holes,
                       const tp_node *node, bool closed, tp_notes *notes) {
  tp_section_wish wish;
  tp_mesh_section section = {0};
  tp_section_wish_init(&wish);
  wish.closed = closed;
  wish.unit = reader->scene->length_unit;
  wish.place = tp_node_place(node, reader->scene->path);
  tp_status status = read_wish(reader, &wish, node);
  if (status == TP_OK) status = cut(reader, &section, node, &wish, notes);
  if (status == TP_OK)
    status = tp_section_take(line, holes, &section, &wish, notes, reader->message);
  if (status == TP_OK) status = tp_note_mesh_unit(reader, node, notes);
  if (status == TP_OK) status = check_points(reader, line, wish.place);
  for (long k = 0; holes != NULL && k < holes->count && status == TP_OK; k++) {
    status = check_points(reader, holes->lines + k, wish.place);
  }
  tp_mesh_section_clear(&section);
  tp_section_wish_clear(&wish);
  return status;
}
