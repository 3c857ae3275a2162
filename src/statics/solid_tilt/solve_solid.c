/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* From a mesh to poses and tilts: read, gate, moments, hull, poses, bands. Moments are summed in
 * doubles with bounds first; where a decision or a number of what follows is not certain by them,
 * once more in whole numbers, by which every decision is made. */

#include "common/host.h"
#include "common/notes.h"
#include "common/options.h"
#include "common/outside.h"
#include "solid/gate.h"
#include "solid/poses.h"
#include "solid_tilt/rose.h"
#include "solid_tilt/solid_given.h"
#include "solid_tilt/solid_moments.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void tp_solid_free(tp_solid *solid) {
  if (solid == NULL) return;
  free(solid->file);
  tp_notes_clear(&solid->notes);
  free(solid->poses);
  for (size_t k = 0; k < solid->band_count; k++) tp_solid_band_clear(solid->bands + k);
  free(solid->bands);
  free(solid);
}

/* A solve under way. */
typedef struct work {
  tp_solid *solid;
  const tp_solid_options *options;
  tp_solid_given given;
  tp_mesh mesh;
  tp_surface surface;
  tp_hull_facets facets;
  tp_heights_above above;
  bool has_heights;
  tp_message *message;
} work;

/* ---- what is read ------------------------------------------------------------------------------
 */

static tp_status fail_object(const work *w) {
  char names[300] = "";
  size_t length = 0;
  for (long k = 0; k < w->mesh.object_count && length < sizeof names - 80; k++) {
    if (w->mesh.objects[k].face_count == 0) continue;
    const tp_quote quote = tp_quote_all(w->mesh.objects[k].name);
    length += (size_t)snprintf(names + length, sizeof names - length, "%s'%.60s'",
                               length > 0 ? ", " : "", quote.text);
  }
  return tp_refuse(w->message, TP_FAULT_KEY, (tp_place){w->mesh.file, 0, 0},
                   "the mesh has no object '%s' with faces; it has %s",
                   tp_quote_all(w->options->object).text, names);
}

static tp_status find_object(const work *w, long *object) {
  *object = -1;
  if (w->options->object == NULL) return TP_OK;
  for (long k = 0; k < w->mesh.object_count; k++) {
    if (strcmp(w->mesh.objects[k].name, w->options->object) != 0) continue;
    *object = k;
  }
  return *object >= 0 && w->mesh.objects[*object].face_count > 0 ? TP_OK : fail_object(w);
}

static tp_status add_notes(work *w) {
  tp_notes *notes = &w->solid->notes;
  const tp_place place = {w->mesh.file, 0, 0};
  tp_status status = TP_OK;
  if (!w->given.has_unit) {
    status = tp_notes_add(notes, w->message, TP_CAUTION, place,
                          "a mesh does not say what the unit of its lengths is: taken for m; give "
                          "the unit");
  }
  if (status == TP_OK && w->mesh.left_out > 0) {
    status =
        tp_notes_add(notes, w->message, TP_NOTE, (tp_place){w->mesh.file, w->mesh.left_out_line, 0},
                     "faces without three different corners are left out, %ld in all, the "
                     "first of them face %d",
                     w->mesh.left_out, w->mesh.left_out_number);
  }
  if (status == TP_OK && w->surface.split > 0) {
    status = tp_notes_add(notes, w->message, TP_NOTE, place,
                          "%ld faces of more than three corners are split into triangles from "
                          "their first corner",
                          w->surface.split);
  }
  return status;
}

static tp_status read_surface(work *w, const char *path) {
  long object = -1;
  tp_status status = tp_mesh_read(&w->mesh, path, w->message);
  if (status == TP_OK) status = find_object(w, &object);
  if (status == TP_OK) status = tp_surface_init(&w->surface, &w->mesh, object, w->message);
  if (status == TP_OK) status = tp_gate_areas(&w->surface, w->message);
  if (status == TP_OK) status = tp_gate_edges(&w->surface, w->message);
  return status == TP_OK ? add_notes(w) : status;
}

/* ---- what is found -----------------------------------------------------------------------------
 */

/* Metres for one of the surface's `near`, and for one of its whole numbers. */
static double metres_per_near(const work *w) {
  fmpq_t step;
  fmpq_init(step);
  fmpq_div_fmpz(step, w->given.metres_per_unit, w->surface.divisor);
  fmpq_mul_2exp(step, step, (ulong)w->surface.exponent);
  const double metres = tp_surface_nearest(step);
  fmpq_clear(step);
  return metres;
}

static tp_status find_bands(work *w, const tp_centre *centre, bool *told) {
  tp_solid *solid = w->solid;
  const tp_rose_question question = {.centre = centre,
                                     .above = &w->above,
                                     .metres_per_step = metres_per_near(w),
                                     .has_friction = solid->has_friction,
                                     .friction_angle_deg = solid->friction_angle_deg,
                                     .azimuths = w->options->azimuths};
  solid->bands = calloc(w->given.band_count + 1, sizeof *solid->bands);
  if (solid->bands == NULL) return tp_fail_memory(w->message, "the bands of a solid");
  tp_status status = TP_OK;
  for (size_t k = 0; k < w->given.band_count && status == TP_OK; k++) {
    tp_solid_band *own = solid->bands + solid->band_count++;
    own->band = tp_surface_nearest(w->given.bands + k);
    status = tp_rose_of_band(own, &question, w->given.bands + k, told, w->message);
  }
  return status;
}

static void drop_results(tp_solid *solid) {
  free(solid->poses);
  for (size_t k = 0; k < solid->band_count; k++) tp_solid_band_clear(solid->bands + k);
  free(solid->bands);
  solid->poses = NULL;
  solid->bands = NULL;
  solid->pose_count = solid->band_count = 0;
}

static tp_status find_results(work *w, const tp_centre *centre, bool *told) {
  tp_solid *solid = w->solid;
  drop_results(solid);
  const tp_status status = tp_solid_poses_find(&solid->poses, &solid->pose_count, centre,
                                               &w->facets, metres_per_near(w), told, w->message);
  return status == TP_OK && *told ? find_bands(w, centre, told) : status;
}

static tp_status prepare(work *w) {
  tp_status status = tp_gate_clashes(&w->surface, w->message);
  if (status == TP_OK) status = tp_hull_facets_init(&w->facets, &w->surface, w->message);
  if (status != TP_OK) return status;
  w->has_heights = tp_heights_above_init(&w->above, &w->surface, w->given.up);
  if (!w->has_heights) return tp_fail_memory(w->message, "the heights of a solid");
  if (w->given.bands != NULL) return TP_OK;
  return tp_solid_given_bands(&w->given, tp_heights_above_most(&w->above), w->message);
}

/* In doubles, then in whole numbers. */
static tp_status climb(work *w) {
  tp_solid_moments moments;
  bool told = true;
  tp_solid_moments_init(&moments, &w->surface);
  tp_status status = tp_solid_moments_check(&moments, w->message);
  if (status == TP_OK) status = prepare(w);
  while (status == TP_OK) {
    told = tp_solid_moments_told(&moments);
    if (told || moments.level == TP_LEVEL_EXACT) {
      status = find_results(w, &moments.centre, &told);
    }
    if (status != TP_OK || told || moments.level == TP_LEVEL_EXACT) break;
    tp_solid_moments_climb(&moments);
  }
  if (status == TP_OK && !told) {
    status = tp_fail(w->message, TP_UNDECIDED, (tp_place){w->mesh.file, 0, 0},
                     "coordinates of sizes too unlike for the range of doubles");
  }
  if (status == TP_OK) {
    tp_solid_moments_tell(w->solid, &moments, w->given.metres_per_unit, w->given.unit_weight);
  }
  tp_solid_moments_clear(&moments);
  return status;
}

static tp_status solve(work *w, const char *path) {
  tp_solid *solid = w->solid;
  const tp_solid_options *o = w->options;
  solid->size = sizeof *solid;
  solid->file = strdup(path);
  if (solid->file == NULL) return tp_fail_memory(w->message, "a solid");
  tp_status status = tp_solid_given_init(&w->given, o, w->message);
  if (status != TP_OK) return status;
  solid->length_unit = w->given.length_unit;
  solid->metres_per_unit = tp_surface_nearest(w->given.metres_per_unit);
  solid->has_weight = fmpq_sgn(w->given.unit_weight) > 0;
  solid->has_friction = o->friction_angle_deg >= 0;
  if (solid->has_friction) solid->friction_angle_deg = o->friction_angle_deg;
  memcpy(solid->up, o->up, sizeof solid->up);
  status = read_surface(w, path);
  if (status == TP_OK) status = climb(w);
  if (status == TP_OK) {
    solid->vertices = (size_t)w->surface.vertex_count;
    solid->triangles = (size_t)w->surface.triangle_count;
    solid->facets = (size_t)w->facets.count;
  }
  return status;
}

tp_status tp_solid_of_file(tp_solid **solid, const char *path, const tp_solid_options *options,
                           tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, solid);
  TP_REFUSE_NULL(message, path);
  TP_REFUSE_NULL(message, options);
  tp_solid_options taken = tp_solid_options_default();
  TP_TAKE_OPTIONS(message, taken, options);
  work w = {.options = options, .message = message};
  w.solid = calloc(1, sizeof *w.solid);
  if (w.solid == NULL) return tp_fail_memory(message, "a solid");
  const tp_status status = solve(&w, path);
  if (w.has_heights) tp_heights_above_clear(&w.above);
  tp_hull_facets_clear(&w.facets);
  tp_surface_clear(&w.surface);
  tp_mesh_clear(&w.mesh);
  if (w.given.length_unit != NULL) tp_solid_given_clear(&w.given);
  if (status == TP_OK) {
    *solid = w.solid;
  } else {
    tp_solid_free(w.solid);
  }
  return status;
}
