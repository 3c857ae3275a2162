/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The mesh of a solid for drawing: read again, put on its lattice, which knows no far origin, and
 * turned upright about the foot of its centroid, in doubles. */

#include "figure/solid.h"
#include "figure/solid_surface.h"

#include "common/message.h"
#include "number/ratio.h"
#include "solid/sides.h"
#include "solid/solid_sums.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- the frame of the base ---------------------------------------------------------------------
 */

void tp_solid_mesh_turn(double turned[3], const tp_solid_mesh *mesh, const double vector[3]) {
  for (int k = 0; k < 3; k++) {
    const double *axis = mesh->axes[k];
    turned[k] = axis[0] * vector[0] + axis[1] * vector[1] + axis[2] * vector[2];
  }
}

void tp_solid_mesh_place(double placed[3], const tp_solid_mesh *mesh, const tp_solid *solid,
                         const double point[3]) {
  double way[3];
  for (int k = 0; k < 3; k++) {
    way[k] = solid->metres_per_unit * point[k] - solid->centroid_m[k].value;
  }
  tp_solid_mesh_turn(placed, mesh, way);
  placed[2] += mesh->height;
}

static void set_points(tp_solid_mesh *mesh, const tp_surface *surface, const double centre[3],
                       double metres) {
  double lowest = INFINITY;
  for (long v = 0; v < mesh->vertex_count; v++) {
    double way[3];
    for (int k = 0; k < 3; k++) way[k] = (surface->near[3 * v + k] - centre[k]) * metres;
    tp_solid_mesh_turn(mesh->points + 3 * v, mesh, way);
    lowest = fmin(lowest, mesh->points[3 * v + 2]);
  }
  mesh->height = -lowest;
  for (long v = 0; v < mesh->vertex_count; v++) {
    double *own = mesh->points + 3 * v;
    own[2] -= lowest;
    mesh->size = fmax(mesh->size, sqrt(own[0] * own[0] + own[1] * own[1] + own[2] * own[2]));
  }
}

/* Two sides of an edge lie one behind the other; one of a section is by itself. */
static bool set_edges(tp_solid_mesh *mesh) {
  tp_sides sides;
  bool done = tp_sides_init(&sides, mesh->triangles, mesh->triangle_count, mesh->vertex_count);
  mesh->edges = malloc((3 * (size_t)mesh->triangle_count + 1) * sizeof *mesh->edges);
  done = done && mesh->edges != NULL;
  for (long v = 0; v < mesh->vertex_count && done; v++) {
    for (long k = sides.starts[v]; k < sides.starts[v + 1]; k++) {
      const tp_side *side = sides.items + k;
      int *own = mesh->edges[mesh->edge_count++];
      own[0] = (int)v;
      own[1] = side->other;
      own[2] = own[3] = side->triangle;
      if (k + 1 == sides.starts[v + 1] || side[1].other != side->other) continue;
      own[3] = side[1].triangle;
      k++;
    }
  }
  tp_sides_clear(&sides);
  return done;
}

/* In lengths of the file. */
static double origin(const tp_surface *surface, int axis) {
  fmpq_t at;
  fmpq_init(at);
  fmpq_set_fmpz_frac(at, surface->origin[axis], surface->divisor);
  const double given = tp_surface_nearest(at);
  fmpq_clear(at);
  return given;
}

/* As the surface's `near`. */
static void set_centre(double centre[3], const tp_surface *surface, const tp_solid *solid,
                       double metres) {
  tp_near sums[TP_SOLID_SUM_COUNT];
  const bool sums_it = solid->part_count == 0 && !solid->has_thinning;
  if (sums_it) tp_solid_sums_near(sums, surface);
  for (int k = 0; k < 3; k++) {
    centre[k] = sums_it
                    ? sums[TP_SOLID_X24 + k].value / (4 * sums[TP_SOLID_V6].value)
                    : (solid->centroid_m[k].value - solid->metres_per_unit * origin(surface, k)) /
                          metres; /* not of what is read here */
  }
}

/* Metres to a length of the surface's doubles. */
static double step_of(const tp_surface *surface, double metres_per_unit) {
  return metres_per_unit * ldexp(1, (int)surface->exponent) / fmpz_get_d(surface->divisor);
}

static bool make_room(tp_solid_mesh *mesh, const tp_surface *surface) {
  const size_t corners = 3 * (size_t)surface->triangle_count;
  *mesh = (tp_solid_mesh){.vertex_count = surface->vertex_count,
                          .triangle_count = surface->triangle_count};
  mesh->points = malloc(3 * (size_t)surface->vertex_count * sizeof *mesh->points);
  mesh->triangles = malloc(corners * sizeof *mesh->triangles);
  if (mesh->points == NULL || mesh->triangles == NULL) return false;
  memcpy(mesh->triangles, surface->triangles, corners * sizeof *mesh->triangles);
  return true;
}

static bool fill(tp_solid_mesh *mesh, const tp_surface *surface, const tp_solid *solid) {
  double centre[3];
  const double step = step_of(surface, solid->metres_per_unit);
  if (!make_room(mesh, surface)) return false;
  tp_solid_base_axes(mesh->axes, solid);
  set_centre(centre, surface, solid, step);
  set_points(mesh, surface, centre, step);
  return set_edges(mesh);
}

/* ---- the ground --------------------------------------------------------------------------------
 */

/* In metres, by which the origin of a surface lies from that of another: the difference of far
 * origins is taken exactly. */
static double way_between(const tp_surface *from, double from_metres, const tp_surface *to,
                          double to_metres, int axis) {
  fmpq_t unit, one, other;
  fmpq_init(unit);
  fmpq_init(one);
  fmpq_init(other);
  fmpq_set_fmpz_frac(one, from->origin[axis], from->divisor);
  fmpq_set_fmpz_frac(other, to->origin[axis], to->divisor);
  (void)tp_ratio_read_double(unit, from_metres);
  fmpq_mul(one, one, unit);
  (void)tp_ratio_read_double(unit, to_metres);
  fmpq_mul(other, other, unit);
  fmpq_sub(other, other, one);
  const double way = tp_surface_nearest(other);
  fmpq_clear(unit);
  fmpq_clear(one);
  fmpq_clear(other);
  return way;
}

/* In the frame of the rock's mesh, which is filled. */
static bool fill_ground(tp_solid_mesh *ground, const tp_surface *surface, const tp_solid_mesh *rock,
                        const tp_surface *rock_surface, const tp_solid *solid) {
  const double metres = solid->metres_per_unit, own_metres = solid->ground.metres_per_unit;
  const double rock_step = step_of(rock_surface, metres), step = step_of(surface, own_metres);
  double centre[3], shift[3];
  if (!make_room(ground, surface)) return false;
  set_centre(centre, rock_surface, solid, rock_step);
  for (int k = 0; k < 3; k++) {
    shift[k] = way_between(rock_surface, metres, surface, own_metres, k) - rock_step * centre[k];
  }
  for (long v = 0; v < ground->vertex_count; v++) {
    double way[3];
    for (int k = 0; k < 3; k++) way[k] = step * surface->near[3 * v + k] + shift[k];
    tp_solid_mesh_turn(ground->points + 3 * v, rock, way);
    ground->points[3 * v + 2] += rock->height;
  }
  return set_edges(ground);
}

static tp_status add_ground(tp_solid_mesh *ground, const tp_solid_mesh *rock,
                            const tp_surface *rock_surface, const tp_solid *solid,
                            tp_message *message) {
  tp_mesh read;
  tp_surface surface;
  tp_status status = tp_solid_ground_read(&surface, &read, solid, message);
  if (status != TP_OK) return status;
  if (!fill_ground(ground, &surface, rock, rock_surface, solid)) {
    status = tp_fail_memory(message, "the figure");
  }
  tp_surface_clear(&surface);
  tp_mesh_clear(&read);
  return status;
}

/* ---- both --------------------------------------------------------------------------------------
 */

tp_status tp_solid_mesh_init(tp_solid_mesh *mesh, tp_solid_mesh *ground, const tp_solid *solid,
                             tp_message *message) {
  tp_mesh read;
  tp_surface surface;
  *mesh = *ground = (tp_solid_mesh){0};
  tp_status status = tp_solid_surface_read(&surface, &read, solid, message);
  if (status != TP_OK) return status;
  if (!fill(mesh, &surface, solid)) status = tp_fail_memory(message, "the figure");
  if (status == TP_OK && solid->has_ground) {
    status = add_ground(ground, mesh, &surface, solid, message);
  }
  tp_surface_clear(&surface);
  tp_mesh_clear(&read);
  if (status != TP_OK) {
    tp_solid_mesh_clear(mesh);
    tp_solid_mesh_clear(ground);
  }
  return status;
}

void tp_solid_mesh_clear(tp_solid_mesh *mesh) {
  free(mesh->points);
  free(mesh->triangles);
  free(mesh->edges);
}
