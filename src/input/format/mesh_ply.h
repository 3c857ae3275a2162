/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The header of a PLY file: which elements with which properties follow, as text or as binary
 * numbers of either order of bytes. */

#ifndef TP_FORMAT_MESH_PLY_H
#define TP_FORMAT_MESH_PLY_H

#include "format/mesh_source.h"

enum { TP_PLY_ELEMENTS = 16, TP_PLY_PROPERTIES = 64 };

typedef enum tp_ply_type {
  TP_PLY_INT8,
  TP_PLY_UINT8,
  TP_PLY_INT16,
  TP_PLY_UINT16,
  TP_PLY_INT32,
  TP_PLY_UINT32,
  TP_PLY_FLOAT,
  TP_PLY_DOUBLE,
  TP_PLY_NO_TYPE
} tp_ply_type;

/* What a property is to the reader. */
typedef enum tp_ply_role {
  TP_PLY_X,
  TP_PLY_Y,
  TP_PLY_Z,
  TP_PLY_CORNERS,
  TP_PLY_PASSED_OVER
} tp_ply_role;

typedef struct tp_ply_property {
  bool is_list;
  tp_ply_type count_type, type; /* count_type: of the length of a list */
  tp_ply_role role;
} tp_ply_property;

typedef struct tp_ply_element {
  bool is_vertex, is_face;
  long count;
  tp_mesh_word place;
  int property_count;
  tp_ply_property properties[TP_PLY_PROPERTIES];
} tp_ply_element;

typedef struct tp_ply_header {
  bool binary, little;
  int element_count;
  tp_ply_element elements[TP_PLY_ELEMENTS];
} tp_ply_header;

/* Bytes of one number. */
int tp_ply_size(tp_ply_type type);

/* Up to the byte behind `end_header` and its end of line. */
TP_MUST_USE tp_status tp_ply_read_header(tp_ply_header *header, tp_mesh_source *source);

#endif
