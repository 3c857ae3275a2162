/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Areas and volume of a wedge, and what pushes it, in balls: its weight W, less the share of a
 * vertical earthquake, and the water's pressure p times areas, into the wedge along the normals of
 * its joints and across its crack, and what bolts pull it by. A horizontal earthquake comes on top
 * (wedge_law.h). */

#ifndef TP_SOLID_TILT_WEDGE_FORCES_H
#define TP_SOLID_TILT_WEDGE_FORCES_H

#include "solid_tilt/wedge_shape.h"

typedef struct tp_wedge_forces {
  arb_struct metres;   /* of a length of the scene */
  arb_struct areas[3]; /* of A, B and the crack, in square metres */
  arb_struct volume;   /* in cubic metres */
  arb_struct pressure; /* mean, of the water, in kPa */
  arb_struct weight;   /* in kN, as all forces */
  arb_struct push[3];  /* R without a horizontal earthquake, to the east, to the north and up */
} tp_wedge_forces;

void tp_wedge_forces_init(tp_wedge_forces *forces, const tp_wedge_shape *shape,
                          const tp_scene *scene);
void tp_wedge_forces_clear(tp_wedge_forces *forces);

#endif
