/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Contacts in whole numbers of both meshes' lattice become points in the coordinates of the rock's
 * mesh, which are solved as contacts that a scene gives. */

#include "solid_tilt/on_ground.h"

#include "common/notes.h"
#include "ground/depth.h"
#include "ground/ground_contacts.h"
#include "solid_contacts/hold_load.h"
#include "solid_tilt/on_contacts.h"
#include "solid_tilt/solid_safety.h"

#include <stdlib.h>
#include <string.h>

typedef struct work {
  tp_solid *solid;
  const tp_ground_body *ground;
  const tp_solid_moments *moments;
  const tp_solid_given *given;
  double metres; /* of the lattice's doubles */
  tp_message *message;
} work;

static tp_status fail_memory(const work *w) {
  return tp_fail_memory(w->message, "the contacts of a solid on its ground");
}

static tp_place place_of(const work *w) {
  return w->given->scene->solid.ground.place;
}

/* A length of the mesh as the scene has it, and in metres. */
static double told(const work *w, const fmpq_t length) {
  fmpq_t own;
  fmpq_init(own);
  fmpq_div(own, length, w->given->band_lengths);
  const double number = tp_surface_nearest(own);
  fmpq_clear(own);
  return number;
}

static void set_metres(work *w) {
  const tp_surface *s = &w->ground->whole;
  fmpq_t step;
  fmpq_init(step);
  fmpq_div_fmpz(step, w->given->metres_per_unit, s->divisor);
  fmpq_mul_2exp(step, step, (ulong)s->exponent);
  w->metres = tp_surface_nearest(step);
  fmpq_clear(step);
}

/* ---- what is refused ---------------------------------------------------------------------------
 */

static double in_scene(const work *w, double metres) {
  return metres / tp_surface_nearest(w->given->scene->metres_per_unit);
}

static tp_status refuse_depth(const work *w, const tp_ground_depth *depth, const fmpq_t band) {
  const char *unit = w->solid->length_unit;
  char rock[TP_SURFACE_NAME], ground[TP_SURFACE_NAME];
  return tp_refuse(w->message, TP_FAULT_GEOMETRY, place_of(w),
                   "the rock enters the ground by %.6g %s, at %s of the rock and %s of the ground: "
                   "deeper than the band of %.6g %s; give bands of that or more where the survey "
                   "is off by as much, or lift the rock",
                   in_scene(w, depth->most * w->metres), unit,
                   tp_surface_name(rock, &w->ground->rock.surface, depth->rock),
                   tp_surface_name(ground, &w->ground->ground.surface, depth->ground),
                   told(w, band), unit);
}

/* A point of the lattice's doubles in the coordinates of the rock's mesh. */
static void tell_point(double given[3], const tp_surface *s, const double point[3]) {
  fmpq_t own;
  fmpq_init(own);
  for (int k = 0; k < 3; k++) {
    tp_hold_double(own, ldexp(point[k], (int)s->exponent));
    fmpq_add_fmpz(own, own, s->origin[k]);
    fmpq_div_fmpz(own, own, s->divisor);
    given[k] = tp_surface_nearest(own);
  }
  fmpq_clear(own);
}

static tp_status refuse_gap(const work *w, const fmpq_t band) {
  const char *unit = w->solid->length_unit;
  const tp_nearest_pair pair =
      tp_triangle_tree_nearest(&w->ground->rock.tree, &w->ground->ground.tree);
  double points[2][3];
  char rock[TP_SURFACE_NAME], ground[TP_SURFACE_NAME];
  for (int k = 0; k < 2; k++) tell_point(points[k], &w->ground->whole, pair.points[k]);
  tp_surface_name(rock, &w->ground->rock.surface, pair.triangles[0]);
  tp_surface_name(ground, &w->ground->ground.surface, pair.triangles[1]);
  if (pair.distance * w->metres <=
      told(w, band) * tp_surface_nearest(w->given->scene->metres_per_unit)) {
    return tp_refuse(w->message, TP_FAULT_GEOMETRY, place_of(w),
                     "the rock is within the band of %.6g %s of the ground, at %s of the rock and "
                     "%s of the ground about (%.9g, %.9g, %.9g), but no corner or edge of one "
                     "stands on the other there: is the ground's face turned to the rock, "
                     "counter-clockwise seen from it? Else give a wider band",
                     told(w, band), unit, rock, ground, points[0][0], points[0][1], points[0][2]);
  }
  return tp_refuse(
      w->message, TP_FAULT_GEOMETRY, place_of(w),
      "the rock touches the ground nowhere: they are %.6g %s apart at the least, %s of the rock at "
      "(%.9g, %.9g, %.9g) and %s of the ground at (%.9g, %.9g, %.9g), farther than the band of "
      "%.6g %s; move one by the way between these points, give a wider band where the survey is "
      "off by as much, or check the unit of the ground's mesh",
      in_scene(w, pair.distance * w->metres), unit, rock, points[0][0], points[0][1], points[0][2],
      ground, points[1][0], points[1][1], points[1][2], told(w, band), unit);
}

static tp_status refuse_many(const work *w, long count, const fmpq_t band) {
  return tp_refuse(w->message, TP_FAULT_RANGE, place_of(w),
                   "%ld contacts within the band of %.6g %s; there may be %d: give a narrower "
                   "band, or thin both meshes to triangles of about its size",
                   count, told(w, band), w->solid->length_unit, TP_SOLID_CONTACTS);
}

/* ---- contacts ----------------------------------------------------------------------------------
 */

/* As a scene gives them. */
typedef struct listed {
  long count;
  tp_contact_description *contacts;
  double *gaps; /* in metres */
} listed;

static void clear(listed *l) {
  for (long k = 0; l->contacts != NULL && k < l->count; k++) {
    for (int axis = 0; axis < 3; axis++) {
      fmpq_clear(l->contacts[k].at + axis);
      fmpq_clear(l->contacts[k].normal + axis);
    }
  }
  free(l->contacts);
  free(l->gaps);
}

static bool list(listed *l, const work *w, const tp_ground_contacts *found) {
  const tp_surface *s = &w->ground->whole;
  *l = (listed){.contacts = calloc((size_t)found->count, sizeof *l->contacts),
                .gaps = calloc((size_t)found->count, sizeof *l->gaps)};
  if (l->contacts == NULL || l->gaps == NULL) return false;
  for (; l->count < found->count; l->count++) {
    const tp_ground_contact *from = found->items + l->count;
    tp_contact_description *own = l->contacts + l->count;
    own->place = place_of(w);
    own->has_normal = true;
    for (int k = 0; k < 3; k++) {
      fmpq_init(own->at + k);
      fmpq_init(own->normal + k);
      fmpq_add_fmpz(own->at + k, from->at + k, s->origin[k]);
      fmpq_div_fmpz(own->at + k, own->at + k, s->divisor);
      fmpq_set_fmpz(own->normal + k, from->normal.at + k);
    }
    l->gaps[l->count] = from->gap * w->metres;
  }
  return true;
}

static double angle_between(const double a[3], const double b[3]) {
  const double x = a[1] * b[2] - a[2] * b[1], y = a[2] * b[0] - a[0] * b[2];
  const double z = a[0] * b[1] - a[1] * b[0];
  return atan2(sqrt(x * x + y * y + z * z), a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) * 180 / M_PI;
}

static void tell_band(tp_solid_ground_band *own, const tp_solid_contacts *c, const listed *l) {
  for (long k = 0; k < l->count; k++) own->widest_m = fmax(own->widest_m, l->gaps[k]);
  for (size_t i = 0; i < c->contact_count; i++) {
    for (size_t j = 0; j < i; j++) {
      own->normals_deg =
          fmax(own->normals_deg, angle_between(c->contacts[i].normal, c->contacts[j].normal));
    }
  }
  own->verdict = c->verdict;
  own->has_fos = c->has_fos;
  own->fos = c->fos;
  own->has_critical = c->has_critical;
  own->critical_deg = c->critical_deg;
  own->has_acceleration = c->has_acceleration;
  own->acceleration_g = c->acceleration_g;
}

/* ---- a band ------------------------------------------------------------------------------------
 */

static tp_status solve_on(work *w, tp_solid_contacts *own, const listed *l, size_t azimuths,
                          bool has_mean_normals) {
  tp_solid_given given = *w->given; /* borrowed */
  given.has_mean_normals = has_mean_normals;
  given.contacts = l->contacts;
  given.contact_count = l->count;
  given.contact_gaps = l->gaps;
  given.azimuths = azimuths;
  return tp_on_contacts_solve(own, &w->solid->notes, w->moments, &given, w->message);
}

/* To the mean of all normals; false where these cancel. */
static bool smooth(const listed *l, const tp_solid_contacts *c) {
  static const double least = 0.1;
  double mean[3] = {0};
  for (size_t k = 0; k < c->contact_count; k++) {
    for (int axis = 0; axis < 3; axis++) {
      mean[axis] += c->contacts[k].normal[axis] / (double)c->contact_count;
    }
  }
  if (!(mean[0] * mean[0] + mean[1] * mean[1] + mean[2] * mean[2] > least * least)) return false;
  for (long k = 0; k < l->count; k++) {
    for (int axis = 0; axis < 3; axis++) tp_hold_double(l->contacts[k].normal + axis, mean[axis]);
  }
  return true;
}

/* With one normal nothing is wedged between bumps that may be noise. What is decided in a section
 * is decided whatever is wedged. */
static tp_status solve_smooth(work *w, tp_solid_ground_band *band, const listed *l,
                              const tp_solid_contacts *plain, tp_solid_safety *safety) {
  *safety = plain->safety;
  band->has_smooth = smooth(l, plain);
  if (!band->has_smooth) return TP_OK;
  tp_solid_contacts own = {0};
  const tp_status status = solve_on(w, &own, l, 0, true);
  band->smooth_verdict = own.verdict;
  band->has_smooth_fos = own.has_fos;
  band->smooth_fos = own.fos;
  band->has_smooth_critical = own.has_critical;
  band->smooth_critical_deg = own.critical_deg;
  if (!plain->is_in_section) tp_solid_safety_add_mean(safety, &own.safety);
  tp_solid_contacts_clear(&own);
  return status;
}

/* Solved for all azimuths where it governs. */
static tp_status solve(work *w, const listed *l, size_t k) {
  tp_solid_ground *ground = &w->solid->ground;
  tp_solid_contacts other = {0};
  const bool governs = k == ground->governing;
  tp_solid_contacts *own = governs ? &w->solid->contacts : &other;
  tp_status status = solve_on(w, own, l, governs ? w->given->azimuths : 0, false);
  if (status == TP_OK) {
    tell_band(ground->bands + k, own, l);
    tp_solid_safety safety;
    status = solve_smooth(w, ground->bands + k, l, own, &safety);
    if (governs) ground->safety = safety;
  }
  tp_solid_contacts_clear(&other);
  return status;
}

static tp_status find_band(work *w, size_t k) {
  const fmpq *band = w->given->ground_bands + k;
  tp_solid_ground_band *own = w->solid->ground.bands + k;
  tp_ground_contacts found;
  listed l = {0};
  fmpq_t lattice;
  fmpq_init(lattice);
  fmpq_mul_fmpz(lattice, band, w->ground->whole.divisor);
  tp_status status = TP_OK;
  if (!tp_ground_contacts_find(&found, &w->ground->rock, &w->ground->ground, lattice)) {
    status = fail_memory(w);
  } else if (found.count == 0) {
    status = refuse_gap(w, band);
  } else if (found.count > TP_SOLID_CONTACTS) {
    status = refuse_many(w, found.count, band);
  } else if (!list(&l, w, &found)) {
    status = fail_memory(w);
  }
  own->band = told(w, band);
  own->found = (size_t)found.found;
  own->contacts = (size_t)found.count;
  tp_ground_contacts_clear(&found);
  fmpq_clear(lattice);
  if (status == TP_OK) status = solve(w, &l, k);
  clear(&l);
  return status;
}

/* ---- all ---------------------------------------------------------------------------------------
 */

static tp_status describe(work *w) {
  tp_solid_ground *own = &w->solid->ground;
  const tp_ground_description *from = &w->given->scene->solid.ground;
  const char *object = from->object >= 0 ? from->mesh->objects[from->object].name : NULL;
  own->file = strdup(from->mesh->file);
  if (object != NULL) own->object = strdup(object);
  own->bands = calloc(w->given->ground_band_count, sizeof *own->bands);
  if (own->file == NULL || own->bands == NULL || (own->object == NULL) != (object == NULL)) {
    return fail_memory(w);
  }
  const tp_relief *relief = &w->ground->ground;
  for (long v = 0; v < relief->surface.vertex_count; v++) {
    own->vertices += relief->starts[v] < relief->starts[v + 1];
  }
  own->triangles = (size_t)relief->surface.triangle_count;
  own->metres_per_unit = tp_surface_nearest(from->metres_per_unit);
  own->band_count = w->given->ground_band_count;
  for (size_t k = 1; k < own->band_count; k++) {
    const fmpq *least = w->given->ground_bands + own->governing;
    if (fmpq_cmp(w->given->ground_bands + k, least) < 0) own->governing = k;
  }
  return TP_OK;
}

static tp_status find_depth(work *w) {
  const fmpq *band = w->given->ground_bands + w->solid->ground.governing;
  tp_ground_depth depth;
  if (!tp_ground_depth_find(&depth, &w->ground->rock, &w->ground->ground)) return fail_memory(w);
  w->solid->ground.entered_m = depth.most * w->metres;
  fmpq_t metres;
  fmpq_init(metres);
  fmpq_mul(metres, band, w->given->metres_per_unit);
  const double most = tp_surface_nearest(metres);
  fmpq_clear(metres);
  return w->solid->ground.entered_m > most * (1 + 1e-9) ? refuse_depth(w, &depth, band) : TP_OK;
}

static tp_status add_notes(work *w) {
  const tp_mesh *mesh = w->given->scene->solid.ground.mesh;
  tp_notes *notes = &w->solid->notes;
  tp_status status = TP_OK;
  if (mesh->left_out > 0) {
    status =
        tp_notes_add(notes, w->message, TP_NOTE, (tp_place){mesh->file, mesh->left_out_line, 0},
                     "faces without three different corners are left out, %ld in all, the "
                     "first of them face %d",
                     mesh->left_out, mesh->left_out_number);
  }
  const tp_solid_ground_band *own = w->solid->ground.bands + w->solid->ground.governing;
  if (status != TP_OK || own->widest_m <= 0) return status;
  return tp_notes_add(notes, w->message, TP_CAUTION, place_of(w),
                      "what is no farther than the band from the ground counts as touching, with "
                      "gaps up to %.3g m: on fewer points the rock holds less",
                      own->widest_m);
}

tp_status tp_on_ground_find(tp_solid *solid, const tp_solid_body *body,
                            const tp_solid_moments *moments, const tp_solid_given *given,
                            tp_message *message) {
  work w = {.solid = solid,
            .ground = body->ground,
            .moments = moments,
            .given = given,
            .message = message};
  set_metres(&w);
  solid->has_ground = solid->has_contacts = true;
  tp_status status = describe(&w);
  if (status == TP_OK) status = find_depth(&w);
  for (size_t k = 0; k < given->ground_band_count && status == TP_OK; k++) {
    status = find_band(&w, k);
  }
  if (status == TP_OK) status = add_notes(&w);
  if (status == TP_OK) tp_on_contacts_row(solid->bands, &solid->contacts);
  return status;
}

void tp_solid_ground_clear(tp_solid_ground *ground) {
  free(ground->file);
  free(ground->object);
  free(ground->bands);
}
