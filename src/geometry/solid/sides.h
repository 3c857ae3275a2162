/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The sides of triangles, gathered by the edge that they are of: at the lesser of its two vertices,
 * there in the order of the other, then of the triangles. Time grows with their number. */

#ifndef TP_SOLID_SIDES_H
#define TP_SOLID_SIDES_H

#include <stdbool.h>

typedef struct tp_side {
  int other;     /* the greater of its vertices */
  int triangle;  /* that it is a side of */
  bool is_ahead; /* does the triangle pass it towards that vertex? */
} tp_side;

typedef struct tp_sides {
  long *starts; /* those of vertex v are items[starts[v]] … items[starts[v + 1] - 1] */
  tp_side *items;
} tp_sides;

/* False when memory is exhausted; to be cleared also then. */
bool tp_sides_init(tp_sides *sides, const int *triangles, long count, long vertex_count);
void tp_sides_clear(tp_sides *sides);

/* Those of an edge: the first, and how many. */
const tp_side *tp_sides_edge(long *count, const tp_sides *sides, int one, int other);

/* Sets of triangles: `leaders` begins with each its own; the least of a set leads it. */
int tp_sides_leader(int *leaders, int triangle);
void tp_sides_join(int *leaders, int one, int other);

#endif
