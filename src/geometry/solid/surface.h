/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The surface of a solid: triangles between points of one integer lattice.
 *
 * Coordinates of a mesh are rationals. Over their common denominator D, relative to a local origin
 * (the first vertex, subtracted exactly), they are whole numbers, so that all that follows takes
 * ring operations only, and does not see where the solid lies:
 *     length in the file = (origin + whole) / D.
 * For doubles near = whole * 2^-exponent, at most 1 in size; off by 2^-53 of it at most where it is
 * not exact. A face of more than three corners is split from its first corner.
 *
 * Where a plane has cut the solid (solid/cut.h), points of the section have a denominator of their
 * own: each point is whole / weight, with the origin on the plane. */

#ifndef TP_SOLID_SURFACE_H
#define TP_SOLID_SURFACE_H

#include "format/mesh.h"
#include "geom/solid.h"
#include "number/near.h"

typedef struct tp_surface {
  const tp_mesh *mesh; /* borrowed */
  long vertex_count;   /* those that triangles have, in the order in which these do */
  int *sources;        /* which of the mesh each is; -1: a point of a section */
  fmpz *whole;         /* x, y, z of each */
  fmpz *weights;       /* by which these are to be divided, above 0; NULL: all 1 */
  double *near;
  bool is_exact;  /* are all of `near`? */
  long exponent;  /* of `near` */
  fmpz_t divisor; /* D */
  fmpz_t origin[3];
  double *given; /* coordinates as the file has them, where all are doubles and `near` is not exact:
                    else NULL */
  long triangle_count;
  int *triangles; /* vertices, three each */
  int *faces;     /* of the mesh, that they are of */
  long split;     /* faces of more than three corners */
} tp_surface;

/* Of one object, or of all where it is below zero; refuses coordinates of sizes too unlike. The
 * mesh must outlive it. On failure it is empty. */
TP_MUST_USE tp_status tp_surface_init(tp_surface *surface, const tp_mesh *mesh, long object,
                                      tp_message *message);
void tp_surface_clear(tp_surface *surface);

/* Of a mesh of several (tp_mesh_join): the triangles of one of its objects as a surface of its own,
 * on the same lattice, borrowed and not to be cleared. Vertices of the first are the first. */
tp_surface tp_surface_of_object(const tp_surface *surface, int object);

/* For CGAL. */
tp_geom_points tp_surface_points(const tp_surface *surface);

/* A coordinate of a vertex with its bound. */
static inline tp_near tp_surface_near(const tp_surface *surface, long vertex, int axis) {
  const double value = surface->near[3 * vertex + axis];
  return (tp_near){value, surface->is_exact ? 0 : fabs(value) * DBL_EPSILON};
}

/* The way between two vertices times both of their weights: a vector of its direction; `way` is
 * initialised. And a product of weights. */
void tp_surface_way(fmpz *way, const tp_surface *surface, long from, long to);
void tp_surface_weight(fmpz_t weight, const tp_surface *surface, long one, long other);

/* The double nearest to a number. */
double tp_surface_nearest(const fmpq_t number);

/* A coordinate of a vertex as the file has it, rounded to a double. */
double tp_surface_given(const tp_surface *surface, long vertex, int axis);

enum { TP_SURFACE_NAME = 48 };

/* "triangle 12" by its number in the file, or "face 12" of one that was split; or which gap it
 * closes (solid/mend.h). */
const char *tp_surface_name(char name[TP_SURFACE_NAME], const tp_surface *surface, long triangle);
tp_place tp_surface_place(const tp_surface *surface, long triangle);
/* The object of the mesh that a triangle is of. */
int tp_surface_object(const tp_surface *surface, long triangle);

#endif
