/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The surface of a solid, and of the ground that it rests on, read again for drawing: mended,
 * thinned and cut as it was when it was solved. */

#include "figure/solid_surface.h"

#include "common/message.h"
#include "number/ratio.h"
#include "scene/scene.h"
#include "solid/azimuth.h"
#include "solid/cut.h"
#include "solid/gate.h"
#include "solid/mend.h"
#include "solid/thin.h"

#include <math.h>
#include <string.h>

static const double radian = 3.14159265358979323846 / 180;

static void take_values(double axis[3], const tp_near vector[3]) {
  for (int k = 0; k < 3; k++) axis[k] = vector[k].value;
}

static void set_normal(double normal[3], const double east[3], const double north[3]) {
  for (int k = 0; k < 3; k++) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    normal[k] = east[i] * north[j] - east[j] * north[i];
  }
}

void tp_solid_base_axes(double axes[3][3], const tp_solid *solid) {
  const double dip = radian * solid->tilt_angle_deg, way = radian * solid->tilt_azimuth_deg;
  const tp_near dipping[3] = {{sin(dip) * sin(way), 0}, {sin(dip) * cos(way), 0}, {cos(dip), 0}};
  tp_near up[3];
  tp_map_frame frame;
  for (int k = 0; k < 3; k++) up[k] = (tp_near){solid->up[k], 0};
  if (solid->is_on_slope) {
    tp_map_frame_down(&frame, up, dipping);
  } else {
    tp_map_frame_init(&frame, up);
  }
  take_values(axes[0], frame.east);
  take_values(axes[1], frame.north);
  set_normal(axes[2], axes[0], axes[1]);
}

static tp_status refuse_other(const char *file, tp_message *message) {
  return tp_refuse(message, TP_FAULT_KEY, (tp_place){file, 0, 0},
                   "the mesh has changed since it was solved: solve it again");
}

/* By its name; below zero: NULL means all of the mesh. False: the mesh has none of the name. */
static bool find_object(long *object, const tp_mesh *mesh, const char *name) {
  *object = -1;
  for (long k = 0; name != NULL && k < mesh->object_count; k++) {
    if (strcmp(mesh->objects[k].name, name) == 0) *object = k;
  }
  return name == NULL || *object >= 0;
}

/* Has it still as many triangles and points as when it was solved? */
static tp_status check_counts(tp_surface *surface, const char *file, size_t triangles,
                              size_t vertices, tp_message *message) {
  if (surface->triangle_count == (long)triangles && surface->vertex_count == (long)vertices) {
    return TP_OK;
  }
  tp_surface_clear(surface);
  return refuse_other(file, message);
}

/* ---- the solid ---------------------------------------------------------------------------------
 */

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

static tp_status read_whole(tp_surface *surface, tp_mesh *mesh, const tp_solid *solid,
                            tp_message *message) {
  long object = -1;
  if (!find_object(&object, mesh, solid->object)) return refuse_other(solid->file, message);
  tp_status status = mend(mesh, &object, solid, message);
  if (status == TP_OK) status = tp_surface_init(surface, mesh, object, message);
  if (status == TP_OK && solid->has_thinning) status = thin(surface, solid, message);
  return status == TP_OK
             ? check_counts(surface, solid->file, solid->triangles, solid->vertices, message)
             : status;
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
  double axes[3][3];
  fmpz up[3];
  fmpq_t height;
  fmpq_init(height);
  tp_solid_base_axes(axes, solid);
  for (int k = 0; k < 3; k++) {
    fmpz_init(up + k);
    fmpz_set_d_2exp(up + k, axes[2][k], BITS);
  }
  (void)tp_ratio_read_double(height, below_in_file(solid));
  tp_cut_plane_init(&plane, &whole, up, height);
  const tp_status status = tp_cut_above(surface, &whole, &plane, message);
  if (status != TP_OK) tp_surface_clear(surface);
  tp_cut_plane_clear(&plane);
  tp_surface_clear(&whole);
  fmpq_clear(height);
  for (int k = 0; k < 3; k++) fmpz_clear(up + k);
  return status;
}

tp_status tp_solid_surface_read(tp_surface *surface, tp_mesh *mesh, const tp_solid *solid,
                                tp_message *message) {
  tp_status status = tp_mesh_read(mesh, solid->file, message);
  if (status != TP_OK) return status;
  status = read_whole(surface, mesh, solid, message);
  if (status == TP_OK && solid->has_below) status = cut_surface(surface, solid, message);
  if (status != TP_OK) tp_mesh_clear(mesh);
  return status;
}

/* ---- its ground --------------------------------------------------------------------------------
 */

tp_status tp_solid_ground_read(tp_surface *surface, tp_mesh *mesh, const tp_solid *solid,
                               tp_message *message) {
  const tp_solid_ground *ground = &solid->ground;
  long object = -1;
  tp_status status = tp_mesh_read(mesh, ground->file, message);
  if (status != TP_OK) return status;
  if (find_object(&object, mesh, ground->object)) {
    status = tp_surface_init(surface, mesh, object, message);
    if (status == TP_OK) {
      status = check_counts(surface, ground->file, ground->triangles, ground->vertices, message);
    }
  } else {
    status = refuse_other(ground->file, message);
  }
  if (status != TP_OK) tp_mesh_clear(mesh);
  return status;
}
