/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Triangles between points of space, by CGAL behind a C interface: which of them meet, and a
 * proposal of their convex hull.
 *
 * Whether two triangles meet is decided by exact predicates: coordinates are doubles that are taken
 * as they are, or whole numbers of any size with an interval in front; no point is constructed. The
 * search for the hull constructs planes, which are rounded where the coordinates are doubles: what
 * it returns is to be proven (solid/hull.h). Nothing that CGAL throws crosses this interface. Cost
 * for a million triangles of a boulder, in doubles: meetings 3 s, hull 0.7 s. */

#ifndef TP_GEOM_SOLID_H
#define TP_GEOM_SOLID_H

#include "geom/geom.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct tp_geom_points {
  size_t count;
  const double *near;  /* x, y, z of each, times one power of two; exact where `small` */
  const fmpz *whole;   /* the same as whole numbers, used where they are not small */
  const fmpz *weights; /* of each point, by which these are to be divided; NULL: all 1 */
  bool small;
} tp_geom_points;

/* Two triangles that meet elsewhere than in the edge, or in the corner, that they share. */
typedef struct tp_geom_clashes {
  size_t count;         /* of all such pairs */
  size_t first, second; /* the pair with the least first, then the least second; first < second */
} tp_geom_clashes;

/* `triangles` has three corners for each of `count`, none of which lie on one line. Where `marks`
 * is not NULL, those of triangles of such pairs are set; there is one for each. */
tp_geom_status tp_geom_find_clashes(tp_geom_clashes *clashes, const tp_geom_points *points,
                                    const int *triangles, size_t count, bool *marks);

/* A convex hull as it is proposed: triangles whose corners run counter-clockwise seen from outside;
 * several are in one plane where a facet has more corners. */
typedef struct tp_geom_hull {
  size_t count;
  int *triangles; /* three points each, the first of equal ones, to be freed; -1: no given point */
} tp_geom_hull;

/* `exact`: by exact numbers also where the coordinates are doubles, which takes some hundred times
 * as long. TP_GEOM_FAILED where CGAL fails, and where it finds no four triangles, as of points in
 * one plane. On failure the hull is empty. */
tp_geom_status tp_geom_propose_hull(tp_geom_hull *hull, const tp_geom_points *points, bool exact);
void tp_geom_hull_clear(tp_geom_hull *hull);

#ifdef __cplusplus
}
#endif

#endif
