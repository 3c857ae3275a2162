/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The triangle of a surface that is nearest to a point, in doubles: for what a user points at. */

#ifndef TP_SOLID_NEAREST_H
#define TP_SOLID_NEAREST_H

#include "solid/surface.h"

typedef struct tp_nearest_triangle {
  long triangle;
  double distance; /* as the surface's `near` */
  bool is_edge;    /* another that is as near faces another way */
} tp_nearest_triangle;

/* Of a point as the surface's `near`. Cost: all triangles. */
tp_nearest_triangle tp_surface_nearest_triangle(const tp_surface *surface, const double point[3]);

/* Into the solid, across a triangle: whole numbers of any length. */
void tp_surface_inward(fmpz inward[3], const tp_surface *surface, long triangle);

#endif
