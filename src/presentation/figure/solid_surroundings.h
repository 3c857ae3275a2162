/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* How much of a ground is drawn, and what of its triangles and lines lies within. */

#ifndef TP_FIGURE_SOLID_SURROUNDINGS_H
#define TP_FIGURE_SOLID_SURROUNDINGS_H

#include "figure/solid.h"

enum { TP_CLIPPED_CORNERS = 9 }; /* a triangle has at most, within six sides */

typedef struct tp_surroundings {
  double axes[3][3]; /* unit vectors: to the right as far as that is level, across it, and up */
  double low[3], high[3];
  bool cuts; /* there is ground outside */
} tp_surroundings;

tp_surroundings tp_surroundings_of(const tp_solid_mesh *rock, const tp_solid_mesh *ground,
                                   const tp_solid_view *view);

/* What of a triangle lies within: a convex polygon of so many corners, or 0. */
int tp_surroundings_clip(double polygon[TP_CLIPPED_CORNERS][3], const tp_surroundings *box,
                         const tp_solid_mesh *mesh, long triangle);

/* The ends of what of a line lies within; false: nothing does. */
bool tp_surroundings_clip_line(double ends[2][3], const tp_surroundings *box, const double from[3],
                               const double to[3]);

#endif
