/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Edges and corners of a surface as it is, not as it is cut into triangles: an edge is where two
 * triangles of different planes meet, or where the surface ends; a corner is where edges meet that
 * are not two of one line. Parting triangles makes no new ones. All of it is decided exactly. */

#ifndef TP_GROUND_RELIEF_H
#define TP_GROUND_RELIEF_H

#include "ground/triangle_tree.h"
#include "ground/whole.h"

typedef struct tp_relief_edge {
  int from, to;     /* vertices */
  int triangles[2]; /* it is the side of; the second -1 where the surface ends */
  int opposite[2];  /* the third vertex of each */
  bool is_edge;     /* else its triangles lie in one plane */
} tp_relief_edge;

typedef struct tp_relief {
  tp_surface surface; /* borrowed */
  tp_triangle_tree tree;
  long edge_count;
  tp_relief_edge *edges;
  int *edge_of;    /* the edge of each side of each triangle, from its corner on */
  long *starts;    /* triangles at vertex v are at[starts[v]] … at[starts[v + 1] - 1], */
  int *at;         /* the least first */
  bool *is_corner; /* of each vertex */
  int *along;      /* the ends of the first two edges at each vertex */
} tp_relief;

/* Of a surface of which each edge has one triangle or two. False when memory is exhausted; to be
 * cleared also then. It stays where it was made. */
TP_MUST_USE bool tp_relief_init(tp_relief *relief, const tp_surface *surface);
void tp_relief_clear(tp_relief *relief);

static inline const fmpz *tp_relief_point(const tp_relief *relief, long vertex) {
  return relief->surface.whole + 3 * vertex;
}

/* The corner at the end of the straight edge that leads from a corner to a vertex. */
int tp_relief_end(const tp_relief *relief, int corner, int vertex);

/* Across a triangle, to the side from which its corners run counter-clockwise, of any length. */
void tp_relief_normal(tp_whole *normal, const tp_relief *relief, long triangle);

/* The sign of normal . (a vertex - the first corner of the triangle): 1 in front of its plane. */
int tp_relief_side(const tp_relief *relief, long triangle, const tp_relief *other, long vertex);

#endif
