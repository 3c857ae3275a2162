/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The support of a solid as it lies: the convex hull, seen from above, of its vertices that are no
 * higher than a band over the lowest one. Heights, turns and their order are exact. */

#ifndef TP_SOLID_TILT_SUPPORT_H
#define TP_SOLID_TILT_SUPPORT_H

#include "solid/centre.h"
#include "solid/tilting.h"

/* Heights of all vertices over the lowest one, times |up|. Of a solid that a plane has cut they are
 * over that plane, and times the weights of the vertices: 0 of its section, above it of all else.
 */
typedef struct tp_heights_above {
  const tp_surface *surface;
  tp_rest_plane plane; /* through the lowest vertex, the first of several */
  tp_map_frame frame;  /* of the azimuths on it */
  fmpz *heights;
  fmpz_t square; /* of |up| */
} tp_heights_above;

/* `up` is not zero, and the frame that of the least turn where it is NULL; to be cleared where it
 * is true. False when memory is exhausted. */
bool tp_heights_above_init(tp_heights_above *above, const tp_surface *surface, const fmpz up[3],
                           const tp_map_frame *frame);
void tp_heights_above_clear(tp_heights_above *above);

/* The height of the highest vertex, in lengths of the mesh, rounded. */
double tp_heights_above_most(const tp_heights_above *above);

typedef struct tp_solid_support {
  long touching; /* vertices */
  long count;    /* of its corners: 1 and 2 where it is a point or a line */
  int *corners;  /* counter-clockwise seen from above */
} tp_solid_support;

/* Of a band in lengths of the mesh; false when memory is exhausted. */
bool tp_solid_support_init(tp_solid_support *support, const tp_heights_above *above,
                           const fmpq_t band);
void tp_solid_support_clear(tp_solid_support *support);

#endif
