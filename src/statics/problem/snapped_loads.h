/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Pressures and surcharges on edges that were moved onto the profile: points of it became vertices
 * of such an edge, and the load acts on each of the edges between them, as large at each as it was
 * above it. */

#ifndef TP_PROBLEM_SNAPPED_LOADS_H
#define TP_PROBLEM_SNAPPED_LOADS_H

#include "scene/scene.h"

/* The outline before, its vertices where they are now, and the new outline: these with more between
 * them. */
typedef struct tp_snapped_outline {
  const tp_polyline *before, *moved, *now;
} tp_snapped_outline;

/* `count` loads in the place of `own_count`, all their numbers their own; a line that lies on no
 * edge, or runs the wrong way, stays as it is, for the check of loads. NULL when memory is
 * exhausted. */
tp_line_load *tp_snapped_lines(long *count, const tp_line_load *own, long own_count,
                               const tp_snapped_outline *outline);

#endif
