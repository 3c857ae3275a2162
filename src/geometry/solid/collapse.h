/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A closed, oriented surface with fewer vertices: one after another moves along an edge onto a
 * neighbour, with which the two triangles at that edge go (a half-edge collapse: Kobbelt, Campagna
 * and Seidel, Graphics Interface 1998).
 *
 * Bound: let f move each vertex v of the surface as it was to that onto which it came in the end,
 * straight within each triangle. f(p) of p = sum l_i v_i is sum l_i f(v_i), so |f(p) - p| <= max
 * |f(v_i) - v_i| <= reach. All of the surface as it is is f of it as it was, for each collapse maps
 * triangles, edges and vertices onto all that are left. So no point of either is farther than the
 * reach from the other.
 *
 * A collapse is made where the edge's ends have two common neighbours, which keeps the surface
 * closed and what it is (Dey, Edelsbrunner, Guha and Nekhayev 1999), where no vertex that came to
 * the one that moves gets farther than the reach from where it was, and where no triangle turns by
 * more than 78 degrees or becomes a sliver. That the surface does not meet itself elsewhere is for
 * the gate. */

#ifndef TP_SOLID_COLLAPSE_H
#define TP_SOLID_COLLAPSE_H

#include "solid/surface.h"

typedef struct tp_collapse {
  const tp_surface *surface;
  int *triangles;  /* three corners of each as they are; the first -1: it is gone */
  int *first_last; /* of each vertex the first corner at it, -1: it has moved; and the last that
                      moved to it */
  int *next;       /* of each corner the next at its vertex, -1: none */
  int *moved;      /* of each vertex the next that moved to the same one, -1: none */
  int *marks;      /* of each vertex: the last round in which it was a neighbour */
  int round;
  long room;
  int *ring;       /* neighbours of the vertex that draws them to it */
  double farthest; /* bound of what vertices moved, as the surface's `near` */
} tp_collapse;

/* Vertices that `stay` do not move. False when memory is exhausted; to be cleared also then. */
TP_MUST_USE bool tp_collapse_run(tp_collapse *collapse, const tp_surface *surface, double reach,
                                 const bool *stay);
void tp_collapse_clear(tp_collapse *collapse);

#endif
