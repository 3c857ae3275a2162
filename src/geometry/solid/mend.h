/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A mesh that is not closed, mended: what was done is counted, and what was invented is measured.
 * What is mended passes the gate like any other mesh, or is refused by it; surfaces that cross
 * stay so.
 *
 * In this order: points that are near are merged, where that is asked for; of triangles given twice
 * one stays; small pieces go, where that is asked for; triangles are turned to agree; gaps, which
 * are loops of edges with one triangle, are closed by triangles between their own points; a
 * triangle without area parts its neighbour; all are turned outwards. Coordinates stay exact
 * throughout.
 *
 * A gap of up to 500 points is closed by the triangles of least area (Barequet and Sharir, Computer
 * Aided Geometric Design 12, 1995: over chords, in time with the cube of their number), of which
 * none may be an edge that the surface has; a larger one across the plane that its loop goes round
 * most in, where it is simple seen so. What remains open the gate refuses. */

#ifndef TP_SOLID_MEND_H
#define TP_SOLID_MEND_H

#include "solid/surface.h"
#include "topple.h"

typedef struct tp_mend_wish {
  double
      merge_within; /* in lengths of the mesh; 0: equal points alone, which every mesh has merged */
  double drop_below; /* share of the area; 0: none */
} tp_mend_wish;

/* Triangles of one object, or of all where it is below zero, as a mesh with one object of its name.
 * Those that close gap k bear the number -1 - k. Lengths and areas of the record are in lengths of
 * the mesh. Both to be cleared also on failure. */
TP_MUST_USE tp_status tp_mesh_mend(tp_mesh *mended, tp_solid_repair *record, const tp_mesh *mesh,
                                   long object, const tp_mend_wish *wish, tp_message *message);
void tp_solid_repair_clear(tp_solid_repair *record);

#endif
