/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The shape of a wedge, in balls, in scene lengths from its toe T, where the line of both joints
 * comes out of the face. With upward normals a, b, f, u of the joints, the face and the ground
 * above, through planes a . x = 0, b . x = 0, f . x = 0 and u . x = u . B:
 *     B the end of the line at the height,  C_A = a, f, u  and  C_B = b, f, u the ends of the
 * crest, of which each must lie within the plane that it is not on. A crack that cuts the lines
 * from C_A and C_B and from T to B in D_A, D_B and E ends it; else these three are B. */

#ifndef TP_SOLID_TILT_WEDGE_SHAPE_H
#define TP_SOLID_TILT_WEDGE_SHAPE_H

#include "format/mesh.h"
#include "scene/scene.h"

#include <arb.h>

enum { TP_WEDGE_BITS = 256 };

enum {
  TP_WEDGE_END_A, /* C_A */
  TP_WEDGE_END_B,
  TP_WEDGE_BACK_A, /* D_A */
  TP_WEDGE_BACK_B,
  TP_WEDGE_DEEP, /* E */
  TP_WEDGE_TOE,
  TP_WEDGE_POINTS
};

typedef struct tp_wedge_shape {
  arb_struct normals[TP_WEDGE_PLANES][3];
  arb_struct points[TP_WEDGE_POINTS][3];
  arb_struct line[3]; /* unit vector up the line of both joints */
  bool has_crack;
} tp_wedge_shape;

/* Refuses planes between which there is no wedge. To be cleared also on failure. */
TP_MUST_USE tp_status tp_wedge_shape_init(tp_wedge_shape *shape, const tp_wedge_description *wedge,
                                          tp_message *message);
void tp_wedge_shape_clear(tp_wedge_shape *shape);

/* Its surface with points to 2^-100; to be cleared also on failure. */
TP_MUST_USE tp_status tp_wedge_shape_mesh(tp_mesh *mesh, const tp_wedge_shape *shape,
                                          const char *file, tp_message *message);

/* Of vectors. */
void tp_wedge_dot(arb_t product, const arb_struct a[3], const arb_struct b[3]);
void tp_wedge_cross(arb_struct product[3], const arb_struct a[3], const arb_struct b[3]);

#endif
