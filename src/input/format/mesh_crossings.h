/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The edges of a mesh that the plane of a section crosses, and the pieces of faces between them. */

#ifndef TP_FORMAT_MESH_CROSSINGS_H
#define TP_FORMAT_MESH_CROSSINGS_H

#include "format/mesh.h"
#include "format/section_plane.h"
#include "plane/polyline.h"

/* An edge that is crossed, from vertex a to a greater one, in one point. */
typedef struct tp_mesh_crossing {
  int a, b;
  int face; /* the first that has it */
  int piece_count;
  int pieces[2]; /* that end here */
  int upward;    /* faces that pass from the right to the left here, less those that pass back */
  fmpq s, height;
} tp_mesh_crossing;

/* Within a face, between two crossings of its edges. */
typedef struct tp_mesh_piece {
  int ends[2];
  bool used;
} tp_mesh_piece;

typedef struct tp_crossings {
  const tp_mesh *mesh;
  const tp_section_plane *plane;
  tp_message *message;
  signed char *sides; /* of the vertices: 1 left of the plane or on it, -1 right of it; 0: on it
                         before it counts as left */
  long count, room;
  tp_mesh_crossing *items;
  long slot_count;
  int *slots; /* by a and b: one more than the index, 0 where none is */
  long piece_count, piece_room;
  tp_mesh_piece *pieces;
  bool left; /* does any face lie left of the plane? */
} tp_crossings;

/* All of the faces of an object, or of all; to be cleared, also on failure. */
TP_MUST_USE tp_status tp_crossings_find(tp_crossings *crossings, const tp_mesh *mesh, long object,
                                        const tp_section_plane *plane, tp_message *message);
void tp_crossings_clear(tp_crossings *crossings);

#endif
