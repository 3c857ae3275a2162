/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Is a section a block? Simple rings, holes and parts inside the outline, none overlapping. */

#ifndef TP_CHECK_H
#define TP_CHECK_H

#include "block/section.h"
#include "geom.h"

/* The chains from `first` on, `count` of them, as rings of the geometry. `start` has room for
 * count + 1 entries and must outlive the view. */
tp_geom_rings tp_check_rings(const tp_lattice *lattice, long first, long count, size_t *start);

/* A status of the geometry as one of the library, with its message. */
tp_status tp_check_geometry(tp_geom_status geometry, const char *what, tp_message *message);

/* "the edge from vertex 2 (30, 5) to vertex 3 (60, 0)" for the k-th edge of a closed ring. */
void tp_check_edge_text(char *text, size_t size, const tp_polyline *ring, long edge);

/* The first meeting in the order of edges; a mess of meetings is cut off after a million. */
typedef struct tp_first_meeting {
  bool found;
  long seen;
  tp_geom_meeting meeting;
  bool (*counts)(const void *context, tp_geom_meeting meeting);
  const void *context;
} tp_first_meeting;

/* A tp_geom_visitor for a tp_first_meeting. */
bool tp_check_keep_first(void *context, tp_geom_meeting meeting);

/* "crosses", "touches", "lies on". */
const char *tp_check_verb(tp_geom_meeting_kind kind);

/* Refuse a closed ring with a vertex given twice in a row, all vertices on a line, or one that
 * meets itself. `name` is the ring in the message, which offers a repair where it is `repairable`
 * and that would help. */
TP_MUST_USE tp_status tp_check_ring(const tp_polyline *ring, const tp_lattice *lattice, long chain,
                                    bool repairable, const char *name, tp_message *message);

/* Refuse holes that cut the block: all of its triangles, with those of its holes, whose layers are
 * checked. */
TP_MUST_USE tp_status tp_check_in_one_piece(const tp_geom_triangulation *triangulation,
                                            const tp_section *section, tp_message *message);

/* Check all rings of the section, which are the first chains of the lattice. A section of several
 * rings has to be triangulated for that: the triangles of the block are left in `triangulation`,
 * layers 0 outline, 1 holes, 2 parts, for the caller to clear. */
TP_MUST_USE tp_status tp_check_section(tp_geom_triangulation *triangulation,
                                       const tp_section *section, const tp_lattice *lattice,
                                       tp_message *message);

/* Triangulate a checked section. */
TP_MUST_USE tp_status tp_check_triangulate(tp_geom_triangulation *triangulation,
                                           const tp_section *section, const tp_lattice *lattice,
                                           tp_message *message);

#endif
