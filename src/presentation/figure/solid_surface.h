/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Surfaces of a solid and of its ground, read again for drawing. */

#ifndef TP_FIGURE_SOLID_SURFACE_H
#define TP_FIGURE_SOLID_SURFACE_H

#include "solid/surface.h"
#include "topple_solid.h"

/* East and north of its azimuths on the base, and the unit vector across it: up, or the normal of a
 * base that dips. */
void tp_solid_base_axes(double axes[3][3], const tp_solid *solid);

/* The surface of a solid as it was solved: mended, thinned, cut by its plane. Both are to be
 * cleared, the surface first; on failure they are empty. Refused: a file that has changed. */
TP_MUST_USE tp_status tp_solid_surface_read(tp_surface *surface, tp_mesh *mesh,
                                            const tp_solid *solid, tp_message *message);

/* Likewise the surface of the ground of a solid that has one. */
TP_MUST_USE tp_status tp_solid_ground_read(tp_surface *surface, tp_mesh *mesh,
                                           const tp_solid *solid, tp_message *message);

#endif
