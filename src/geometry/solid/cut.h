/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What of a solid lies above a plane: the solid that the plane cuts off.
 *
 * Triangles that cross the plane are clipped at the exact points in which it meets their edges,
 * each with a denominator of its own (solid/surface.h). The origin is put on the plane, so that the
 * tetrahedra between it and the face of the cut have no volume: moments of what lies above are sums
 * over the clipped triangles alone, and nothing fills the cut, whatever loops bound it. A triangle
 * that lies in the plane is left out for the same reason. */

#ifndef TP_SOLID_CUT_H
#define TP_SOLID_CUT_H

#include "solid/cut_plane.h"

/* What of a surface without weights lies above: to be cleared, also on failure. It has no triangle
 * where nothing does. The first one that is cut by a plane chooses the origin and the
 * size of doubles: those that it has inside come after it. */
TP_MUST_USE tp_status tp_cut_above(tp_surface *cut, const tp_surface *surface, tp_cut_plane *plane,
                                   tp_message *message);

/* How many solids lie above, and a triangle of each of the first two. */
typedef struct tp_cut_solids {
  long count;
  long surfaces[2], triangles[2];
} tp_cut_solids;

/* Of surfaces that one plane across `up` has cut, of which some bound holes. Solids that touch in
 * the plane alone are two. False when memory is exhausted. */
bool tp_cut_count(tp_cut_solids *solids, const tp_surface *surfaces, const bool *are_holes,
                  long count, const fmpz up[3]);

#endif
