/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Plane geometry on rings of integer points, by CGAL behind a C interface; none of its exceptions
 * passes. Predicates are exact: coordinates are taken as doubles where they fit in 53 bits and as
 * big integers otherwise, meetings of these by doubles with bounds first. No point is constructed,
 * except by arrangements, as exact rationals. A triangulation, an arrangement or a basis is what
 * CGAL returns; docs/architecture.md says how each is checked. TP_GEOM_FAILED says that CGAL
 * failed, never what is wrong with the input. Cost per vertex for a million: simplicity 0.3 us,
 * meeting edges 0.2 to 1.7 us, triangulation 0.4 to 6 us. */

#ifndef TP_GEOM_GEOM_H
#define TP_GEOM_GEOM_H

#include <flint/fmpq.h>
#include <flint/fmpz.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef enum tp_geom_status { TP_GEOM_OK, TP_GEOM_OUT_OF_MEMORY, TP_GEOM_FAILED } tp_geom_status;

/* Closed rings: ring r has the vertices start[r] … start[r + 1] - 1; edge k runs from vertex k to
 * the next of its ring. */
typedef struct tp_geom_rings {
  size_t count;
  const size_t *start;
  const double *u, *v; /* where `small` exact integers; else x and y times a power of two each, off
                          by at most 2^-52 of the largest */
  const fmpz *x, *y;   /* used where they are not small */
  bool small;
} tp_geom_rings;

/* Is the ring a simple polygon: no edge meets another but at the vertex that neighbours share? */
tp_geom_status tp_geom_is_simple(bool *simple, const tp_geom_rings *rings, size_t ring);

typedef enum tp_geom_meeting_kind {
  TP_GEOM_CROSS,  /* the interiors cross in one point */
  TP_GEOM_TOUCH,  /* an end of one lies on the other */
  TP_GEOM_OVERLAP /* they share a piece of positive length */
} tp_geom_meeting_kind;

/* Two edges that meet, other than neighbours of a ring in their common vertex. */
typedef struct tp_geom_meeting {
  tp_geom_meeting_kind kind;
  size_t a, b; /* edges, named by their first vertex; a < b */
} tp_geom_meeting;

/* Receives the meetings in no particular order; false ends the search. */
typedef bool (*tp_geom_visitor)(void *context, tp_geom_meeting meeting);

/* All pairs of meeting edges, or with `between` >= 0 only pairs of an edge of ring `between` and an
 * edge of another ring. */
tp_geom_status tp_geom_find_meetings(const tp_geom_rings *rings, long between,
                                     tp_geom_visitor visitor, void *context);

enum { TP_GEOM_LAYERS = 4 };
#define TP_GEOM_NONE SIZE_MAX

/* A triangle, counter-clockwise, and for each layer of rings the ring that it lies in, counted from
 * 1; 0: in none. */
typedef struct tp_geom_triangle {
  size_t corner[3];
  int ring_in_layer[TP_GEOM_LAYERS];
} tp_geom_triangle;

typedef struct tp_geom_triangulation {
  size_t count;
  tp_geom_triangle *triangles; /* those that lie in some ring */
  size_t *across;              /* across[3 k + c]: the triangle that shares the side of triangle k
                                  opposite its corner c, or TP_GEOM_NONE; NULL for a single ring */
  bool conflict;               /* two rings of one layer overlap */
  size_t conflict_a, conflict_b;
} tp_geom_triangulation;

/* Constrained Delaunay triangulation of all rings, each assigned to a layer; of one below 0 only
 * the points take part. Rings may touch and share pieces of edges, but no two edges may cross, and
 * not all points may lie on one line (TP_GEOM_FAILED). */
tp_geom_status tp_geom_triangulate(tp_geom_triangulation *result, const tp_geom_rings *rings,
                                   const int *layer_of_ring);
void tp_geom_triangulation_clear(tp_geom_triangulation *result);

/* Maximise t subject to sum_k f_k column_k + t direction = target, three rows, 0 <= f_k, and
 * f_k <= most_k where `most` and most_k are not NULL; t is free. All rational. */
typedef struct tp_geom_program {
  size_t count;
  const fmpq *columns; /* three entries a column */
  const fmpq *direction, *target;
  const fmpq *const *most;
} tp_geom_program;

typedef enum tp_geom_outcome {
  TP_GEOM_OPTIMAL,
  TP_GEOM_UNBOUNDED,
  TP_GEOM_INFEASIBLE
} tp_geom_outcome;

typedef struct tp_geom_maximum {
  tp_geom_outcome outcome;
  fmpq *value;     /* t, initialised by the caller; set where optimal */
  int basis_count; /* columns in an optimal basis, at most three; where unbounded, those that grow
                    */
  long basis[3];
} tp_geom_maximum;

/* By CGAL's simplex over rationals: exact. 0.3 ms for 13 columns, 0.3 s for 400 000. */
tp_geom_status tp_geom_maximise(tp_geom_maximum *maximum, const tp_geom_program *program);

/* How segments part the plane. The sides of edge e are the half-edges 2 e and 2 e + 1; each has a
 * face on its left. */
typedef struct tp_geom_arrangement {
  size_t vertex_count, edge_count;
  fmpq *points;             /* x and y of each vertex */
  size_t *origin, *next;    /* of a half-edge: the vertex that it leaves, and the one after it
                               around its face */
  size_t *first, *segments; /* edge e is a piece of the segments with the numbers segments[first[e]]
                               … segments[first[e + 1] - 1], which grow */
} tp_geom_arrangement;

/* Of segments that are no points; `ends` are x and y of one end and of the other, of each. */
tp_geom_status tp_geom_arrange(tp_geom_arrangement *result, const fmpq *ends, size_t count);
void tp_geom_arrangement_clear(tp_geom_arrangement *arrangement);

#ifdef __cplusplus
}
#endif

#endif
