/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* How deep a rock enters its ground.
 *
 * - Of triangles that cross, the least way that one would have to go to be free of the other:
 *   across either, or across a side of each (the theorem of separating axes); in whole numbers.
 * - Of corners beyond the other surface, their distance from it, in doubles: those behind a face
 *   that an edge crosses, decided exactly, and all that edges lead to from there without meeting
 *   the other surface. */

#ifndef TP_GROUND_DEPTH_H
#define TP_GROUND_DEPTH_H

#include "ground/relief.h"

typedef struct tp_ground_depth {
  double most;       /* as the surfaces' doubles: the deepest; 0: nothing crosses */
  long rock, ground; /* if most > 0: triangles there */
} tp_ground_depth;

/* False when memory is exhausted. */
TP_MUST_USE bool tp_ground_depth_find(tp_ground_depth *depth, const tp_relief *rock,
                                      const tp_relief *ground);

#endif
