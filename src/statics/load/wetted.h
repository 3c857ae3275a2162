/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Water that is sited: told by a level, a surface or a crack filled with it. What it presses on, as
 * lines of the outline and of the base joint with a pressure linear along each, exact.
 *
 * At a depth z below the water the pressure is g z, normal to the face, whichever way that leans.
 * The depth is measured as the block lies at the scene's tilt; at other tilts the pressures stay as
 * they are on the block, as the scene's `pressures` do, and add a constant to each moment. Over a
 * line from a to a + d with pressures p0 and p1, the block on its left, the force per thickness is
 * (p0 + p1) / 2 (-dy, dx) and its moment about the origin a.d (p0 + p1) / 2 + d.d (p0 / 6 + p1 /
 * 3).
 *
 * Exact but for the direction of the vertical, where the tilt has no rational cosine: that is
 * rounded to 256 binary digits (problem/water_site.h). */

#ifndef TP_LOAD_WETTED_H
#define TP_LOAD_WETTED_H

#include "load/lie.h"
#include "load/wet_lines.h"

typedef struct tp_wetted {
  tp_wet_lines faces, joint, ice; /* in scene lengths and the frame of the block */
  long gap_lines;  /* of the joint's: the last ones, which are of open gaps before its contacts */
  long from_right; /* the first of the faces that the water on the right presses on */
  bool overtops;   /* the water stands above the top of the block */
  bool dry;        /* it stands below all of the block and its joint */
} tp_wetted;

/* A block and what it stands in, as it goes towards a side. */
typedef struct tp_wetting {
  const tp_scene *scene;
  const tp_polyline *ring; /* the outline, counter-clockwise */
  fmpq x[2], y[2];         /* ends of the base joint, left and right, in scene lengths */
  long vertex[2];          /* of the outline; -1: inside an edge of it */
  bool gapes[2];           /* between that end and the outermost contact an open gap is wetted, */
  fmpq contact_x[2], contact_y[2];
  long contact_vertex[2];  /* which is there; else the same as the end */
  int behind;              /* which of them is up-dip */
  bool up_dip;             /* the block goes up-dip: what pushes from behind is left out */
  tp_lie block;            /* how the frame of the block lies, */
  tp_lie drawn;            /* and the one in which the scene gives a surface */
  fmpq_t foot_up, face_up; /* what a length up-dip along the mean plane, and normal to it, rises */
} tp_wetting;

/* On failure there is nothing to clear. */
TP_MUST_USE tp_status tp_wetted_init(tp_wetted *wetted, const tp_wetting *wetting,
                                     tp_message *message);
void tp_wetted_clear(tp_wetted *wetted);

#endif
