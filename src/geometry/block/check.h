/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Is a section a block? Simple rings, holes and parts inside the outline, none overlapping.
 *
 * Each ring by itself first (block/check_ring.h), then the meetings of edges of different rings,
 * then the triangles of a constrained Delaunay triangulation: each says which rings it lies in.
 * Exact. Cost: a section of one ring is never triangulated. */

#ifndef TP_BLOCK_CHECK_H
#define TP_BLOCK_CHECK_H

#include "block/section.h"
#include "geom/geom.h"

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

/* Are all triangles counter-clockwise, with the area of the outline less that of its holes? These
 * are the first chains of the lattice. A check of what CGAL found. */
bool tp_check_fills(const tp_geom_triangulation *triangulation, const tp_lattice *lattice,
                    long hole_count);

#endif
