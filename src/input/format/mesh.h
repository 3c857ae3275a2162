/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Surfaces of flat faces, as scanners and modellers write them: exact vertices, of which equal ones
 * are one, and the faces between them, each of an object of the file.
 *
 * Coordinates are taken exactly: decimals of a text as they stand, binary floats as the dyadic
 * fractions that they are. Faces that fall short of three different corners are left out, and
 * counted. A file holds at most TP_MESH_MOST vertices and as many faces, and TP_MESH_BYTES bytes.
 */

#ifndef TP_FORMAT_MESH_H
#define TP_FORMAT_MESH_H

#include "common/message.h"

#include <flint/fmpq.h>

enum { TP_MESH_MOST = 20000000, TP_MESH_CORNERS = 10000, TP_MESH_BYTES = 1 << 30 };

/* What one `solid`, `o` or `g` of a file holds. */
typedef struct tp_mesh_object {
  TP_OUTSIDE char *name; /* empty where the file has none */
  const char *file;      /* of a mesh of several: which it is of, borrowed; else NULL */
  long face_count;
} tp_mesh_object;

typedef struct tp_mesh_face {
  int first, count; /* its corners */
  int object;
  int number; /* of the face in its file, from 1 */
  int line;   /* where it stands; 0 in a binary file */
} tp_mesh_face;

typedef struct tp_mesh {
  const char *file; /* borrowed; it must outlive the mesh */
  long vertex_count, vertex_room;
  fmpq *vertices; /* x, y, z of each */
  long face_count, face_room;
  tp_mesh_face *faces;
  long corner_count, corner_room;
  int *corners; /* vertices of the faces, one face after the other */
  long object_count, object_room;
  tp_mesh_object *objects;
  int object; /* that the next faces belong to */
  long slot_count;
  int *slots;       /* vertices by their coordinates: one more than the index, 0 where none is */
  int face_numbers; /* faces that the file gave, those left out too */
  bool is_mended;   /* it is not as the file has it (solid/mend.h) */
  long left_out;    /* faces without three different corners, */
  int left_out_number, left_out_line; /* and the first of them */
} tp_mesh;

typedef enum tp_mesh_format { TP_MESH_NONE, TP_MESH_STL, TP_MESH_PLY, TP_MESH_OBJ } tp_mesh_format;

/* By the ending of the name: .stl, .ply or .obj in either case. */
tp_mesh_format tp_mesh_format_of(const char *path);

/* Read a file; `path` must outlive the mesh. On failure it is empty. */
TP_MUST_USE tp_status tp_mesh_read(tp_mesh *mesh, const char *path, tp_message *message);
/* The same from memory; `name` is what places refer to. */
TP_MUST_USE tp_status tp_mesh_read_bytes(tp_mesh *mesh, tp_mesh_format format, const char *bytes,
                                         size_t length, const char *name, tp_message *message);
void tp_mesh_clear(tp_mesh *mesh);

/* For a message: the names of objects that have faces, in quotes, as many as there is room for. */
enum { TP_MESH_NAMES = 300 };
void tp_mesh_object_names(char names[TP_MESH_NAMES], const tp_mesh *mesh);

/* The faces of an object of another mesh, or of all where it is below zero, as a new object of this
 * one: equal vertices of both are one. The other's file must outlive the mesh. */
TP_MUST_USE tp_status tp_mesh_join(tp_mesh *mesh, const tp_mesh *other, long object,
                                   tp_message *message);
/* The same with its coordinates times a factor above 0. */
TP_MUST_USE tp_status tp_mesh_join_scaled(tp_mesh *mesh, const tp_mesh *other, long object,
                                          const fmpq_t factor, tp_message *message);

/* For the readers: the vertex of these coordinates, an old one where it is equal. */
TP_MUST_USE tp_status tp_mesh_add_vertex(tp_mesh *mesh, int *index, const fmpq coordinates[3],
                                         tp_message *message);
/* A face of the object that was begun last, between `count` vertices. */
TP_MUST_USE tp_status tp_mesh_add_face(tp_mesh *mesh, const int *corners, long count, int line,
                                       tp_message *message);
/* The object of this name, a new one where there is none, becomes that of the next faces. */
TP_MUST_USE tp_status tp_mesh_begin_object(tp_mesh *mesh, const char *name, size_t length,
                                           tp_message *message);

#endif
