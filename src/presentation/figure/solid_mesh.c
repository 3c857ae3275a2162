/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The mesh of a solid for drawing: read again, put on its lattice, which knows no far origin, and
 * turned upright about the foot of its centroid, in doubles. */

#include "figure/solid.h"

#include "common/message.h"
#include "format/mesh.h"
#include "number/ratio.h"
#include "scene/scene.h"
#include "solid/azimuth.h"
#include "solid/cut.h"
#include "solid/gate.h"
#include "solid/mend.h"
#include "solid/sides.h"
#include "solid/solid_sums.h"
#include "solid/thin.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double radian = 3.14159265358979323846 / 180;

/* ---- the frame of the base ---------------------------------------------------------------------
 */

/* Across the base: up, or the normal of a base that dips. */
static void set_normal(tp_near up[3], const tp_solid *solid) {
  const double dip = radian * solid->tilt_angle_deg, way = radian * solid->tilt_azimuth_deg;
  const double dipping[3] = {sin(dip) * sin(way), sin(dip) * cos(way), cos(dip)};
  for (int k = 0; k < 3; k++) {
    up[k] = (tp_near){solid->is_on_slope ? dipping[k] : solid->up[k], 0};
  }
}

static void set_axes(tp_solid_mesh *mesh, const tp_solid *solid) {
  tp_near up[3];
  tp_map_frame frame;
  set_normal(up, solid);
  tp_map_frame_init(&frame, up);
  const double length =
      sqrt(up[0].value * up[0].value + up[1].value * up[1].value + up[2].value * up[2].value);
  for (int k = 0; k < 3; k++) {
    mesh->axes[0][k] = frame.east[k].value;
    mesh->axes[1][k] = frame.north[k].value;
    mesh->axes[2][k] = up[k].value / length;
  }
}

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

static bool fill(tp_solid_mesh *mesh, const tp_surface *surface, const tp_solid *solid) {
  double centre[3];
  const size_t corners = 3 * (size_t)surface->triangle_count;
  *mesh = (tp_solid_mesh){.vertex_count = surface->vertex_count,
                          .triangle_count = surface->triangle_count};
  mesh->points = malloc(3 * (size_t)surface->vertex_count * sizeof *mesh->points);
  mesh->triangles = malloc(corners * sizeof *mesh->triangles);
  if (mesh->points == NULL || mesh->triangles == NULL) return false;
  memcpy(mesh->triangles, surface->triangles, corners * sizeof *mesh->triangles);
  const double metres =
      solid->metres_per_unit * ldexp(1, (int)surface->exponent) / fmpz_get_d(surface->divisor);
  set_axes(mesh, solid);
  set_centre(centre, surface, solid, metres);
  set_points(mesh, surface, centre, metres);
  return set_edges(mesh);
}

/* ---- the mesh ----------------------------------------------------------------------------------
 */

static tp_status refuse_other(const tp_solid *solid, tp_message *message) {
  return tp_refuse(message, TP_FAULT_KEY, (tp_place){solid->file, 0, 0},
                   "the mesh has changed since it was solved: solve it again");
}

/* As it was mended, in place of what is in the file. */
static tp_status mend(tp_mesh *mesh, long *object, const tp_solid *solid, tp_message *message) {
  const tp_mend_wish wish = {solid->repair.merge_within, solid->repair.drop_below};
  tp_solid_repair record;
  tp_mesh mended;
  if (!solid->has_repair) return TP_OK;
  const tp_status status = tp_mesh_mend(&mended, &record, mesh, *object, &wish, message);
  tp_solid_repair_clear(&record);
  tp_mesh_clear(mesh);
  *mesh = mended;
  if (*object > 0) *object = 0;
  return status;
}

/* As it was thinned, in place of all of it. */
static tp_status thin(tp_surface *surface, const tp_solid *solid, tp_message *message) {
  tp_surface whole = *surface;
  tp_solid_thinning record;
  tp_status status = tp_gate_edges(&whole, message); /* what the file has now */
  if (status == TP_OK) {
    status = tp_surface_thin(surface, &record, &whole, solid->thinning.length, message);
  }
  tp_surface_clear(&whole);
  return status;
}

static tp_status read_surface(tp_surface *surface, tp_mesh *mesh, const tp_solid *solid,
                              tp_message *message) {
  long object = -1;
  for (long k = 0; solid->object != NULL && k < mesh->object_count; k++) {
    if (strcmp(mesh->objects[k].name, solid->object) == 0) object = k;
  }
  if (solid->object != NULL && object < 0) return refuse_other(solid, message);
  tp_status status = mend(mesh, &object, solid, message);
  if (status == TP_OK) status = tp_surface_init(surface, mesh, object, message);
  if (status == TP_OK && solid->has_thinning) status = thin(surface, solid, message);
  if (status != TP_OK) return status;
  if (surface->triangle_count == (long)solid->triangles &&
      surface->vertex_count == (long)solid->vertices) {
    return TP_OK;
  }
  tp_surface_clear(surface);
  return refuse_other(solid, message);
}

/* The height of the plane that cuts it, which is told in lengths of the scene or of the file. */
static double below_in_file(const tp_solid *solid) {
  const char *unit = solid->length_unit;
  fmpq_t metres;
  fmpq_init(metres);
  const double own = tp_unit_find(metres, &unit) ? tp_surface_nearest(metres) : 1;
  fmpq_clear(metres);
  return solid->below * own / solid->metres_per_unit;
}

/* What lies above the plane that cuts it, with numbers rounded to doubles. */
static tp_status cut_surface(tp_surface *surface, const tp_solid *solid, tp_message *message) {
  enum { BITS = 60 };
  tp_surface whole = *surface;
  tp_cut_plane plane;
  tp_near normal[3];
  fmpz up[3];
  fmpq_t height;
  fmpq_init(height);
  set_normal(normal, solid);
  const double length = hypot(hypot(normal[0].value, normal[1].value), normal[2].value);
  for (int k = 0; k < 3; k++) {
    fmpz_init(up + k);
    fmpz_set_d_2exp(up + k, normal[k].value / length, BITS);
  }
  (void)tp_ratio_read_double(height, below_in_file(solid));
  tp_cut_plane_init(&plane, &whole, up, height);
  const tp_status status = tp_cut_above(surface, &whole, &plane, message);
  tp_cut_plane_clear(&plane);
  tp_surface_clear(&whole);
  fmpq_clear(height);
  for (int k = 0; k < 3; k++) fmpz_clear(up + k);
  return status;
}

tp_status tp_solid_mesh_init(tp_solid_mesh *mesh, const tp_solid *solid, tp_message *message) {
  tp_mesh read;
  tp_surface surface;
  tp_status status = tp_mesh_read(&read, solid->file, message);
  if (status != TP_OK) return status;
  status = read_surface(&surface, &read, solid, message);
  if (status == TP_OK && solid->has_below) status = cut_surface(&surface, solid, message);
  if (status == TP_OK) {
    if (!fill(mesh, &surface, solid)) {
      tp_solid_mesh_clear(mesh);
      status = tp_fail_memory(message, "the figure");
    }
    tp_surface_clear(&surface);
  }
  tp_mesh_clear(&read);
  return status;
}

void tp_solid_mesh_clear(tp_solid_mesh *mesh) {
  free(mesh->points);
  free(mesh->triangles);
  free(mesh->edges);
}
