/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A mesh cut by an upright plane: the chains in which the plane meets its faces.
 *
 * Which edges are cut is decided exactly; a vertex that lies on the plane counts as left of it, as
 * if the plane were shifted to its right by less than any length. So every face that is cut is cut
 * in pieces between two of its edges, and pieces are joined where they meet in an edge, never by
 * coordinates: of a closed surface all chains close, whatever lies on the plane. Points are exact
 * quotients; points between two others of a straight piece, and chains without extent, are left
 * out. A face that lies in the plane has no section and is refused, and so is an edge of three
 * faces or more. Which way round faces are given does not matter; those that run against their
 * neighbours are counted. */

#ifndef TP_FORMAT_MESH_CUT_H
#define TP_FORMAT_MESH_CUT_H

#include "format/mesh.h"
#include "format/section_plane.h"
#include "plane/polyline.h"

typedef struct tp_section_chain {
  bool closed;
  tp_polyline points; /* s and height, each with the line of the face that it was cut from */
} tp_section_chain;

typedef struct tp_mesh_section {
  long count, room;
  tp_section_chain *chains;
  long flipped; /* places where a face that is cut runs against its neighbour */
  long specks;  /* chains without extent */
  bool is_left; /* where there is no chain: does the mesh lie left of the plane? */
} tp_mesh_section;

/* The faces of one object, or of all where it is below zero. */
TP_MUST_USE tp_status tp_mesh_cut(tp_mesh_section *section, const tp_mesh *mesh, long object,
                                  const tp_section_plane *plane, tp_message *message);
void tp_mesh_section_clear(tp_mesh_section *section);

#endif
