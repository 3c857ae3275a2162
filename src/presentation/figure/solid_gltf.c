/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A solid as a model of glTF: the rock in its pose, what carries it, its load and how it moves.
 * Lengths are metres from the foot of the centroid. */

#include "figure/gltf.h"
#include "figure/solid.h"

#include "output/encode.h"
#include "report/solid_page.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double radian = 3.14159265358979323846 / 180;

/* ---- what there is -----------------------------------------------------------------------------
 */

/* Side by side: loops of lines are known to fewer viewers. */
static bool add_support(tp_gltf *m, const tp_solid_figure *f, const tp_solid_band *band) {
  const size_t count = 2 * band->corner_count;
  double *points = calloc(count, 3 * sizeof *points);
  char name[80];
  if (points == NULL) return false;
  for (size_t k = 0; k < count; k++) {
    const tp_solid_corner *own = band->support + (k + 1) / 2 % band->corner_count;
    points[3 * k] = own->east_m;
    points[3 * k + 1] = own->north_m;
  }
  snprintf(name, sizeof name, "support, %s %.6g %s", f->solid->has_below ? "section at" : "band",
           band->band, f->solid->length_unit);
  tp_gltf_add_lines(m, name, band == f->band ? TP_GLTF_RED : TP_GLTF_BLUE, points, count);
  free(points);
  return true;
}

static bool add_bands(tp_gltf *m, const tp_solid_figure *f) {
  const double way = radian * f->azimuth_deg, reach = f->mesh.height * tan(f->tilt);
  const double centre[3] = {0, 0, f->mesh.height};
  tp_solid_corner ends[2];
  for (size_t k = 0; k < f->solid->band_count; k++) {
    if (f->solid->bands[k].corner_count < 3) continue;
    if (!add_support(m, f, f->solid->bands + k)) return false;
  }
  if (tp_solid_edge_met(ends, f)) {
    tp_gltf_add_line(m, "edge that governs", TP_GLTF_RED,
                     (double[]){ends[0].east_m, ends[0].north_m, 0},
                     (double[]){ends[1].east_m, ends[1].north_m, 0});
  }
  tp_gltf_add_line(m, "weight", TP_GLTF_BLACK, centre,
                   (double[]){reach * sin(way), reach * cos(way), 0});
  return true;
}

static void add_contact(tp_gltf *m, const tp_solid_figure *f, const tp_solid_contact *c, size_t n) {
  double at[3], way[3], end[3];
  char name[40];
  tp_solid_mesh_place(at, &f->mesh, f->solid, c->at);
  tp_solid_mesh_turn(way, &f->mesh, c->normal);
  tp_solid_go(end, at, 0.12 * f->mesh.size, way);
  snprintf(name, sizeof name, "normal %zu", n);
  tp_gltf_add_line(m, name, TP_GLTF_BLUE, at, end);
  if (!tp_solid_is_held(&f->solid->contacts)) return;
  tp_solid_mesh_turn(way, &f->mesh, c->force);
  tp_solid_go(end, at, -tp_solid_force_scale(f), way);
  snprintf(name, sizeof name, "force %zu", n);
  tp_gltf_add_line(m, name, TP_GLTF_GREEN, end, at);
}

static void add_contacts(tp_gltf *m, const tp_solid_figure *f) {
  const tp_solid_contacts *c = &f->solid->contacts;
  const tp_solid_motion *motion = c->has_motion ? &c->motion : &c->critical;
  for (size_t k = 0; k < c->contact_count; k++) add_contact(m, f, c->contacts + k, k + 1);
  if (!c->has_motion && !c->has_critical) return;
  double at[3] = {0, 0, f->mesh.height}, axis[3], ends[2][3];
  tp_solid_mesh_turn(axis, &f->mesh, motion->axis);
  if (motion->turns) tp_solid_mesh_place(at, &f->mesh, f->solid, motion->at);
  tp_solid_go(ends[0], at, motion->turns ? -0.7 * f->mesh.size : 0, axis);
  tp_solid_go(ends[1], at, 0.7 * f->mesh.size, axis);
  tp_gltf_add_line(m, motion->turns ? "axis" : "way", TP_GLTF_PURPLE, ends[0], ends[1]);
}

static void add_mesh(tp_gltf *m, const char *name, tp_gltf_material material,
                     const tp_solid_mesh *mesh) {
  tp_gltf_add_triangles(m, name, material, mesh->points, (size_t)mesh->vertex_count,
                        mesh->triangles, 3 * (size_t)mesh->triangle_count);
}

/* All of it, by the name of its file, and of its object where one is meant. */
static bool add_ground(tp_gltf *m, const tp_solid_figure *f) {
  const tp_solid_ground *own = &f->solid->ground;
  tp_text name = {0};
  if (f->ground.triangle_count == 0) return true;
  const char *slash = strrchr(own->file, '/');
  tp_text_add(&name, "ground, ");
  tp_encode_plain(&name, slash != NULL ? slash + 1 : own->file);
  if (own->object != NULL) {
    tp_text_add(&name, ", ");
    tp_encode_plain(&name, own->object);
  }
  if (!name.failed) add_mesh(m, name.data, TP_GLTF_GROUND, &f->ground);
  const bool done = !name.failed;
  tp_text_drop(&name);
  return done;
}

static bool fill(tp_gltf *m, const tp_solid_figure *f) {
  add_mesh(m, "rock", TP_GLTF_ROCK, &f->mesh);
  if (!add_ground(m, f)) return false;
  if (f->band != NULL) return add_bands(m, f);
  add_contacts(m, f);
  return true;
}

tp_status tp_solid_gltf(char **bytes, size_t *length, const tp_solid_figure *f,
                        tp_message *message) {
  tp_gltf model = {.centroid_height = f->mesh.height};
  if (!fill(&model, f)) model.failed = true;
  const tp_status status = tp_gltf_write(bytes, length, &model, f->tilt, radian * f->azimuth_deg,
                                         f->solid->file, message);
  tp_gltf_clear(&model);
  return status;
}
