/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The proof that triangles are the convex hull of the points of a surface, by exact signs alone.
 *
 * With o a point within, six conditions are proven, and any of them may fail alone:
 *   1. each corner is a point of the surface;
 *   2. the triangles are closed: each edge is passed once in either direction;
 *   3. o is strictly inside the plane of each triangle;
 *   4. no edge is a dent: of two neighbours neither has its far corner beyond the other's plane;
 *   5. the ray from o through the middle of one triangle meets no other triangle;
 *   6. each point that is no corner is in the cone from o over some triangle, and not beyond it.
 * By 2 and 3 the triangles, seen from o, cover all directions equally often, and by 5 once: they
 * bound a body that is star-shaped about o. By 4 that body is convex (Tietze 1928, Nakajima 1928).
 * By 6 it holds all points, and by 1 it is no larger than their hull. Without 5, a surface that is
 * wound twice, or a second surface around the first, would pass (Mehlhorn et al., "Checking
 * geometric programs or verification of geometric structures", Comput. Geom. 12, 1999, 85-103). */

#ifndef TP_SOLID_HULL_PROOF_H
#define TP_SOLID_HULL_PROOF_H

#include "solid/surface.h"

/* Triangles whose corners run counter-clockwise seen from outside; several are in one plane where a
 * facet has more corners. Side 3 t + c runs from corner c of triangle t to the next one. */
typedef struct tp_hull {
  long count;
  int *corners; /* vertices of the surface, three for each triangle */
  int *across;  /* of each side: the triangle beyond it */
  bool *level;  /* of each side: is that triangle in the same plane? */
} tp_hull;

void tp_hull_clear(tp_hull *hull);

/* The condition that failed, in the order in which they are tried. */
typedef enum tp_hull_fault {
  TP_HULL_PROVEN,
  TP_HULL_NO_MEMORY,
  TP_HULL_NO_POINT, /* 1 */
  TP_HULL_OPEN,     /* 2 */
  TP_HULL_TURNED,   /* 3 */
  TP_HULL_DENTED,   /* 4 */
  TP_HULL_WOUND,    /* 5 */
  TP_HULL_BEYOND    /* 6 */
} tp_hull_fault;

/* Four points of the surface that are not in one plane; false: all are in one. */
bool tp_hull_span(int four[4], const tp_surface *surface);

/* `hull` has its corners; `across` and `level` are allocated and set as far as the proof goes. A
 * weighted mean of the four points is o. */
tp_hull_fault tp_hull_prove(tp_hull *hull, const tp_surface *surface, const int four[4]);

/* For a message: what a fault means. */
const char *tp_hull_fault_text(tp_hull_fault fault);

#endif
