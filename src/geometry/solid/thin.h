/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A surface of fewer triangles that is nowhere farther than a length from one that is closed, nor
 * that from it, by vertices that move along edges onto neighbours (solid/collapse.h).
 *
 * What stays: all corners of the convex hull, which is therefore that of the surface to the last
 * digit. No vertex is new, so that what lies within a band is a part of what did. Where triangles
 * of the result meet elsewhere than in edges and corners, the vertices that came to their corners
 * stay too, and all is done once more, a few times; at last no vertex moves, and a surface that
 * meets itself as it is is refused. */

#ifndef TP_SOLID_THIN_H
#define TP_SOLID_THIN_H

#include "solid/surface.h"
#include "topple.h"

/* `surface` has passed tp_gate_edges and must have a volume; its mesh must outlive `thinned`, which
 * is on its lattice. The length is above 0, in those of the mesh; the record has no volume. On
 * failure `thinned` is empty. */
TP_MUST_USE tp_status tp_surface_thin(tp_surface *thinned, tp_solid_thinning *record,
                                      const tp_surface *surface, double length,
                                      tp_message *message);

#endif
