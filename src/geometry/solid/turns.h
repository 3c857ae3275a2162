/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Exact signs of the vertices of a surface: doubles with bounds, and whole numbers where these do
 * not tell. */

#ifndef TP_SOLID_TURNS_H
#define TP_SOLID_TURNS_H

#include "solid/surface.h"

/* Do three vertices lie on one line? */
bool tp_surface_is_straight(const tp_surface *surface, int a, int b, int c);

/* On which side of a triangle's plane lies a vertex: 1 where its corners run counter-clockwise seen
 * from there, -1 beyond, 0 on it. */
int tp_surface_side(const tp_surface *surface, const int corners[3], int vertex);

#endif
