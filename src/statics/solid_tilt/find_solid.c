/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* From a body to poses and tilts. Moments are summed in doubles with bounds first; where a decision
 * or a number of what follows is not certain by them, once more in whole numbers, by which every
 * decision is made. */

#include "solid_tilt/find_solid.h"

#include "common/notes.h"
#include "solid/poses.h"
#include "solid_tilt/on_contacts.h"
#include "solid_tilt/on_ground.h"
#include "solid_tilt/repaired.h"
#include "solid_tilt/results_check.h"
#include "solid_tilt/rose.h"
#include "solid_tilt/solid_parts.h"
#include "solid_tilt/stance.h"
#include "solid_tilt/thinned.h"

#include <stdlib.h>
#include <string.h>

/* A solve under way. */
typedef struct work {
  tp_solid *solid;
  const tp_solid_body *body;
  tp_solid_given *given;
  tp_heights_above above;
  tp_stance_loads loads; /* of a scene */
  tp_message *message;
} work;

/* ---- what is found -----------------------------------------------------------------------------
 */

/* Metres for one of the surface's `near`. */
static double metres_per_near(const work *w) {
  fmpq_t step;
  fmpq_init(step);
  fmpq_div_fmpz(step, w->given->metres_per_unit, w->body->surface.divisor);
  fmpq_mul_2exp(step, step, (ulong)w->body->surface.exponent);
  const double metres = tp_surface_nearest(step);
  fmpq_clear(step);
  return metres;
}

/* A band as it is told, and in metres. */
static double told_band(double *metres, const work *w, size_t k) {
  fmpq_t band;
  fmpq_init(band);
  fmpq_mul(band, w->given->bands + k, w->given->metres_per_unit);
  *metres = tp_surface_nearest(band);
  fmpq_div(band, w->given->bands + k, w->given->band_lengths);
  const double told = tp_surface_nearest(band);
  fmpq_clear(band);
  return told;
}

static size_t count_lasting(const tp_solid *solid, double band_m) {
  size_t count = 0;
  for (size_t k = 0; k < solid->pose_count; k++) {
    const tp_solid_pose *own = solid->poses + k;
    count +=
        !own->has_persistence || own->persistence_m.value - own->persistence_m.error > 2 * band_m;
  }
  return count;
}

static tp_status find_bands(work *w, const tp_centre *centre, bool *told) {
  tp_solid *solid = w->solid;
  const tp_rose_question question = {.centre = centre,
                                     .above = &w->above,
                                     .metres_per_step = metres_per_near(w),
                                     .has_friction = solid->has_friction,
                                     .friction_angle_deg = solid->friction_angle_deg,
                                     .azimuths = w->given->azimuths,
                                     .loads = w->given->scene != NULL ? &w->loads : NULL};
  solid->bands = calloc(w->given->band_count + 1, sizeof *solid->bands);
  if (solid->bands == NULL) return tp_fail_memory(w->message, "the bands of a solid");
  tp_status status = TP_OK;
  for (size_t k = 0; k < w->given->band_count && status == TP_OK; k++) {
    tp_solid_band *own = solid->bands + solid->band_count++;
    double metres = 0;
    own->band = told_band(&metres, w, k);
    own->lasting_poses = count_lasting(solid, metres);
    status = tp_rose_of_band(own, &question, w->given->bands + k, told, w->message);
    if (own->band < solid->bands[solid->governing].band) solid->governing = k;
  }
  return status;
}

static void drop_results(tp_solid *solid) {
  free(solid->poses);
  for (size_t k = 0; k < solid->band_count; k++) tp_solid_band_clear(solid->bands + k);
  free(solid->bands);
  solid->poses = NULL;
  solid->bands = NULL;
  solid->pose_count = solid->band_count = solid->governing = 0;
}

/* A table of many has no roses, and needs no poses. */
static tp_status find_results(work *w, const tp_centre *centre, bool *told) {
  tp_solid *solid = w->solid;
  drop_results(solid);
  const tp_status status =
      w->given->azimuths > 0
          ? tp_solid_poses_find(&solid->poses, &solid->pose_count, centre, &w->body->facets,
                                metres_per_near(w), told, w->message)
          : TP_OK;
  return status == TP_OK && *told ? find_bands(w, centre, told) : status;
}

/* In doubles, then in whole numbers. */
static tp_status climb(work *w) {
  tp_solid_moments moments;
  bool told = true;
  tp_solid_part_moments *parts = NULL;
  tp_status status = tp_solid_parts_weigh(&parts, w->body, w->given, w->message);
  if (status != TP_OK) return status;
  tp_solid_moments_weigh(&moments, &w->body->moments, parts, w->body->part_count);
  if (w->given->contact_count > 0 || w->given->ground_band_count > 0) {
    tp_solid_moments_climb(&moments);
  }
  while (status == TP_OK) {
    told = tp_solid_moments_told(&moments);
    if (told || moments.level == TP_LEVEL_EXACT) {
      status = find_results(w, &moments.centre, &told);
    }
    if (status != TP_OK || told || moments.level == TP_LEVEL_EXACT) break;
    tp_solid_moments_climb(&moments);
  }
  if (status == TP_OK && !told) {
    status = tp_fail(w->message, TP_UNDECIDED, (tp_place){w->body->mesh->file, 0, 0},
                     "coordinates of sizes too unlike for the range of doubles");
  }
  if (status == TP_OK) status = tp_solid_results_check(w->solid, w->message);
  if (status == TP_OK) {
    tp_solid_moments_tell(w->solid, &moments, w->given->metres_per_unit, w->given->unit_weight);
    status = w->given->ground_band_count > 0
                 ? tp_on_ground_find(w->solid, w->body, &moments, w->given, w->message)
                 : tp_on_contacts_find(w->solid, &moments, w->given, w->message);
  }
  if (status == TP_OK) {
    status = tp_solid_parts_tell(w->solid, w->body, w->given, w->message);
  }
  tp_solid_moments_clear(&moments);
  tp_solid_parts_clear(parts, w->body->part_count);
  return status;
}

/* ---- what is given -----------------------------------------------------------------------------
 */

static tp_status add_notes(work *w) {
  tp_notes *notes = &w->solid->notes;
  const tp_mesh *mesh = w->body->mesh;
  const tp_place place = {mesh->file, 0, 0};
  tp_status status = TP_OK;
  if (!w->given->has_unit) {
    status = tp_notes_add(notes, w->message, TP_CAUTION, place,
                          "a mesh does not say what the unit of its lengths is: taken for m; give "
                          "the unit");
  }
  if (status == TP_OK && mesh->left_out > 0) {
    status =
        tp_notes_add(notes, w->message, TP_NOTE, (tp_place){mesh->file, mesh->left_out_line, 0},
                     "faces without three different corners are left out, %ld in all, the "
                     "first of them face %d",
                     mesh->left_out, mesh->left_out_number);
  }
  if (status == TP_OK) status = tp_repair_notes(w->solid, w->message);
  if (status == TP_OK && w->body->surface.split > 0) {
    status = tp_notes_add(notes, w->message, TP_NOTE, place,
                          "%ld faces of more than three corners are split into triangles from "
                          "their first corner",
                          w->body->surface.split);
  }
  return status;
}

static void describe(work *w) {
  tp_solid *solid = w->solid;
  solid->length_unit = w->given->length_unit;
  solid->metres_per_unit = tp_surface_nearest(w->given->metres_per_unit);
  solid->has_weight = fmpq_sgn(w->given->unit_weight) > 0;
  solid->has_friction = w->given->has_friction;
  if (solid->has_friction) solid->friction_angle_deg = w->given->friction_angle_deg;
  solid->vertices = (size_t)w->body->surface.vertex_count;
  solid->triangles = (size_t)w->body->surface.triangle_count;
  solid->facets = (size_t)w->body->facets.count;
}

tp_status tp_solid_find_body(tp_solid *solid, const tp_solid_body *body, tp_solid_given *given,
                             tp_message *message) {
  work w = {.solid = solid, .body = body, .given = given, .message = message};
  solid->size = sizeof *solid;
  const char *object = body->object >= 0 ? body->mesh->objects[body->object].name : NULL;
  solid->file = strdup(body->mesh->file);
  if (object != NULL) solid->object = strdup(object);
  if (solid->file == NULL || (solid->object == NULL) != (object == NULL)) {
    return tp_fail_memory(message, "a solid");
  }
  describe(&w);
  tp_status status = tp_repair_tell(solid, body, message);
  if (status == TP_OK) status = add_notes(&w);
  if (status != TP_OK) return status;
  if (given->scene != NULL) tp_stance_loads_of(&w.loads, given->scene);
  if (!tp_heights_above_init(&w.above, &body->surface, given->up,
                             given->is_on_slope ? &given->frame : NULL)) {
    return tp_fail_memory(message, "the heights of a solid");
  }
  if (given->bands == NULL && given->scene == NULL) {
    status = tp_solid_given_bands(given, tp_heights_above_most(&w.above), message);
  }
  if (status == TP_OK) status = tp_thinning_tell(solid, body, given, message);
  if (status == TP_OK) status = climb(&w);
  tp_heights_above_clear(&w.above);
  return status;
}
