/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Vertices made unique by a hash table with linear probing over exact coordinates; faces, objects
 * and counts with their bounds. */

#include "format/mesh.h"

#include "common/grow.h"
#include "common/outside.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

enum { MOST_OBJECTS = 10000 };

tp_mesh_format tp_mesh_format_of(const char *path) {
  static const struct {
    const char *ending;
    tp_mesh_format format;
  } known[] = {{".stl", TP_MESH_STL}, {".ply", TP_MESH_PLY}, {".obj", TP_MESH_OBJ}};
  const char *ending = strrchr(path, '.');
  for (size_t k = 0; ending != NULL && k < sizeof known / sizeof known[0]; k++) {
    if (strcasecmp(ending, known[k].ending) == 0) return known[k].format;
  }
  return TP_MESH_NONE;
}

void tp_mesh_clear(tp_mesh *mesh) {
  for (long k = 0; k < 3 * mesh->vertex_count; k++) fmpq_clear(mesh->vertices + k);
  for (long k = 0; k < mesh->object_count; k++) free(mesh->objects[k].name);
  free(mesh->vertices);
  free(mesh->faces);
  free(mesh->corners);
  free(mesh->objects);
  free(mesh->slots);
  memset(mesh, 0, sizeof *mesh);
}

void tp_mesh_object_names(char names[TP_MESH_NAMES], const tp_mesh *mesh) {
  size_t length = 0;
  names[0] = '\0';
  for (long k = 0; k < mesh->object_count && length < TP_MESH_NAMES - 80; k++) {
    if (mesh->objects[k].face_count == 0) continue;
    const tp_quote quote = tp_quote_all(mesh->objects[k].name);
    length += (size_t)snprintf(names + length, TP_MESH_NAMES - length, "%s'%.60s'",
                               length > 0 ? ", " : "", quote.text);
  }
}

/* ---- equal vertices ----------------------------------------------------------------------------
 */

static uint64_t mix(uint64_t hash, const fmpz *part) {
  /* the largest below 2^64, or below 2^32 where that is FLINT's word */
  const ulong prime = (ulong)(FLINT_BITS == 64 ? 0xffffffffffffffc5 : 0xfffffffb);
  const uint64_t own = fmpz_fdiv_ui(part, prime);
  hash = (hash ^ own) * 0x9e3779b97f4a7c15;
  return hash ^ (hash >> 29);
}

static uint64_t hash_of(const fmpq *coordinates) {
  uint64_t hash = 0;
  for (int k = 0; k < 3; k++) {
    hash = mix(hash, fmpq_numref(coordinates + k));
    hash = mix(hash, fmpq_denref(coordinates + k));
  }
  return hash;
}

static bool are_equal(const fmpq *a, const fmpq *b) {
  return fmpq_equal(a, b) && fmpq_equal(a + 1, b + 1) && fmpq_equal(a + 2, b + 2);
}

/* Where the vertex is, or is to be put. */
static int *find_slot(const tp_mesh *mesh, const fmpq *coordinates) {
  const uint64_t mask = (uint64_t)mesh->slot_count - 1;
  uint64_t at = hash_of(coordinates) & mask;
  while (mesh->slots[at] != 0 &&
         !are_equal(mesh->vertices + 3L * (mesh->slots[at] - 1), coordinates)) {
    at = (at + 1) & mask;
  }
  return mesh->slots + at;
}

/* Never more than half full. */
static bool reserve_slot(tp_mesh *mesh) {
  if (2 * (mesh->vertex_count + 1) <= mesh->slot_count) return true;
  int *const old = mesh->slots;
  const long count = mesh->slot_count == 0 ? 64 : 2 * mesh->slot_count;
  int *slots = calloc((size_t)count, sizeof *slots);
  if (slots == NULL) return false;
  mesh->slots = slots;
  mesh->slot_count = count;
  for (int k = 0; k < mesh->vertex_count; k++) *find_slot(mesh, mesh->vertices + 3L * k) = k + 1;
  free(old);
  return true;
}

tp_status tp_mesh_add_vertex(tp_mesh *mesh, int *index, const fmpq coordinates[3],
                             tp_message *message) {
  if (!reserve_slot(mesh)) return tp_fail_memory(message, "a mesh");
  int *slot = find_slot(mesh, coordinates);
  if (*slot == 0) {
    if (mesh->vertex_count == TP_MESH_MOST) {
      return tp_refuse(message, TP_FAULT_RANGE, (tp_place){mesh->file, 0, 0},
                       "more than 20 million vertices; thin the mesh out, or cut away what is not "
                       "needed");
    }
    fmpq *vertices =
        tp_grow(mesh->vertices, mesh->vertex_count, &mesh->vertex_room, 3 * sizeof *mesh->vertices);
    if (vertices == NULL) return tp_fail_memory(message, "a mesh");
    mesh->vertices = vertices;
    for (int k = 0; k < 3; k++) {
      fmpq *own = vertices + 3 * mesh->vertex_count + k;
      fmpq_init(own);
      fmpq_set(own, coordinates + k);
    }
    *slot = (int)++mesh->vertex_count;
  }
  *index = *slot - 1;
  return TP_OK;
}

/* ---- objects and faces -------------------------------------------------------------------------
 */

static tp_status add_object(tp_mesh *mesh, const char *name, size_t length, tp_message *message) {
  if (mesh->object_count == MOST_OBJECTS) {
    return tp_refuse(message, TP_FAULT_RANGE, (tp_place){mesh->file, 0, 0},
                     "more than 10000 objects of different names");
  }
  tp_mesh_object *objects =
      tp_grow(mesh->objects, mesh->object_count, &mesh->object_room, sizeof *mesh->objects);
  if (objects == NULL) return tp_fail_memory(message, "a mesh");
  mesh->objects = objects;
  char *own = strndup(name, length);
  if (own == NULL) return tp_fail_memory(message, "a mesh");
  mesh->object = (int)mesh->object_count;
  objects[mesh->object_count++] = (tp_mesh_object){.name = own};
  return TP_OK;
}

tp_status tp_mesh_begin_object(tp_mesh *mesh, const char *name, size_t length,
                               tp_message *message) {
  for (long k = 0; k < mesh->object_count; k++) {
    const char *own = mesh->objects[k].name;
    if (strlen(own) != length || memcmp(own, name, length) != 0) continue;
    mesh->object = (int)k;
    return TP_OK;
  }
  return add_object(mesh, name, length, message);
}

static bool reserve_corners(tp_mesh *mesh, long count) {
  if (mesh->corner_count + count <= mesh->corner_room) return true;
  const long room = 2 * mesh->corner_room + count;
  int *corners = realloc(mesh->corners, (size_t)room * sizeof *corners);
  if (corners == NULL) return false;
  mesh->corners = corners;
  mesh->corner_room = room;
  return true;
}

/* Its corners behind those of the other faces, without one that repeats the one before it. How many
 * there are. */
static int put_corners(const tp_mesh *mesh, const int *corners, long count) {
  int *own = mesh->corners + mesh->corner_count;
  int kept = 0;
  for (long k = 0; k < count; k++) {
    if (kept == 0 || own[kept - 1] != corners[k]) own[kept++] = corners[k];
  }
  while (kept > 1 && own[kept - 1] == own[0]) kept--;
  return kept;
}

tp_status tp_mesh_add_face(tp_mesh *mesh, const int *corners, long count, int line,
                           tp_message *message) {
  const int number = ++mesh->face_numbers;
  if (number > TP_MESH_MOST) {
    return tp_refuse(message, TP_FAULT_RANGE, (tp_place){mesh->file, line, 0},
                     "more than 20 million faces; thin the mesh out, or cut away what is not "
                     "needed");
  }
  tp_mesh_face *faces =
      tp_grow(mesh->faces, mesh->face_count, &mesh->face_room, sizeof *mesh->faces);
  if (faces == NULL || !reserve_corners(mesh, count)) {
    mesh->faces = faces != NULL ? faces : mesh->faces;
    return tp_fail_memory(message, "a mesh");
  }
  mesh->faces = faces;
  const int kept = put_corners(mesh, corners, count);
  if (kept < 3) {
    if (mesh->left_out++ == 0) {
      mesh->left_out_number = number;
      mesh->left_out_line = line;
    }
    return TP_OK;
  }
  faces[mesh->face_count++] =
      (tp_mesh_face){(int)mesh->corner_count, kept, mesh->object, number, line};
  mesh->corner_count += kept;
  mesh->objects[mesh->object].face_count++;
  return TP_OK;
}

/* ---- several meshes ----------------------------------------------------------------------------
 */

/* Where a vertex of another mesh is here. */
static tp_status join_vertex(tp_mesh *mesh, int *corner, const fmpq *vertex, const fmpq_t factor,
                             tp_message *message) {
  fmpq at[3];
  for (int k = 0; k < 3; k++) {
    fmpq_init(at + k);
    fmpq_mul(at + k, vertex + k, factor);
  }
  const tp_status status = tp_mesh_add_vertex(mesh, corner, at, message);
  for (int k = 0; k < 3; k++) fmpq_clear(at + k);
  return status;
}

/* The vertices of a face, as they are here. */
static tp_status join_face(tp_mesh *mesh, const tp_mesh *other, const tp_mesh_face *face,
                           const fmpq_t factor, int *corners, tp_message *message) {
  tp_status status = TP_OK;
  for (int k = 0; k < face->count && status == TP_OK; k++) {
    const fmpq *vertex = other->vertices + 3L * other->corners[face->first + k];
    status = join_vertex(mesh, corners + k, vertex, factor, message);
  }
  if (status == TP_OK) status = tp_mesh_add_face(mesh, corners, face->count, face->line, message);
  if (status == TP_OK) mesh->faces[mesh->face_count - 1].number = face->number;
  return status;
}

tp_status tp_mesh_join_scaled(tp_mesh *mesh, const tp_mesh *other, long object, const fmpq_t factor,
                              tp_message *message) {
  int *corners = malloc(TP_MESH_CORNERS * sizeof *corners);
  if (corners == NULL) return tp_fail_memory(message, "a mesh");
  tp_status status = add_object(mesh, "", 0, message);
  if (status == TP_OK) mesh->objects[mesh->object].file = other->file;
  for (long f = 0; f < other->face_count && status == TP_OK; f++) {
    if (object >= 0 && other->faces[f].object != object) continue;
    status = join_face(mesh, other, other->faces + f, factor, corners, message);
  }
  free(corners);
  return status;
}

tp_status tp_mesh_join(tp_mesh *mesh, const tp_mesh *other, long object, tp_message *message) {
  const fmpq_t one = {{1, 1}};
  return tp_mesh_join_scaled(mesh, other, object, one, message);
}
