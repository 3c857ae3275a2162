/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Boxes about the triangles of a surface, in a tree: which of them are near those of another
 * surface on the same lattice. Boxes are in the surface's doubles, widened by what these are off.
 *
 * Triangles are put in the order of a curve that fills space (Morton 1966), of which each node
 * takes a half of its parent's. Building takes n log n; a visit of pairs the time of what it
 * visits. */

#ifndef TP_GROUND_TRIANGLE_TREE_H
#define TP_GROUND_TRIANGLE_TREE_H

#include "solid/surface.h"

typedef struct tp_triangle_node {
  double low[3], high[3];
} tp_triangle_node;

typedef struct tp_triangle_tree {
  const tp_surface *surface; /* borrowed */
  long count;
  int *order;              /* triangles along the curve */
  tp_triangle_node *nodes; /* a node is that of its range of `order`, as visits have it */
} tp_triangle_tree;

/* False when memory is exhausted; to be cleared also then. */
TP_MUST_USE bool tp_triangle_tree_init(tp_triangle_tree *tree, const tp_surface *surface);
void tp_triangle_tree_clear(tp_triangle_tree *tree);

/* For each pair of triangles whose boxes are no farther apart than `reach` along any axis, in
 * lengths of the surface's doubles. False ends it. */
typedef bool tp_triangle_pair_visit(void *of, long one, long other);
bool tp_triangle_tree_pairs(const tp_triangle_tree *one, const tp_triangle_tree *other,
                            double reach, tp_triangle_pair_visit *visit, void *of);

/* Two points that are nearest, of two surfaces with triangles, in doubles. */
typedef struct tp_nearest_pair {
  double distance; /* as the surface's doubles */
  long triangles[2];
  double points[2][3];
} tp_nearest_pair;

tp_nearest_pair tp_triangle_tree_nearest(const tp_triangle_tree *one,
                                         const tp_triangle_tree *other);

/* How far a point is from the surface, and the triangle that is nearest, likewise. */
double tp_triangle_tree_point(long *triangle, const tp_triangle_tree *tree, const double point[3]);

#endif
