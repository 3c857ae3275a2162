/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Points exactly about the centroid, in lengths of a power of two of the surface's steps; normals
 * across the surface where none is given. */

#include "solid_tilt/contact_points.h"

#include "common/notes.h"
#include "number/near_angle.h"
#include "solid/nearest.h"
#include "solid_contacts/hold_proof.h"

#include <stdlib.h>

/* ---- numbers -----------------------------------------------------------------------------------
 */

static void set_centre(tp_contact_points *points, const tp_centre *centre) {
  for (int k = 0; k < 3; k++) {
    fmpz_set(fmpq_numref(points->centre + k), centre->moment + k);
    fmpz_set(fmpq_denref(points->centre + k), centre->weight4);
    fmpq_canonicalise(points->centre + k);
  }
}

/* In whole steps of the surface, from its origin. */
static void set_steps(fmpq at[3], const tp_surface *surface, const fmpq given[3]) {
  for (int k = 0; k < 3; k++) {
    fmpq_mul_fmpz(at + k, given + k, surface->divisor);
    fmpq_sub_fmpz(at + k, at + k, surface->origin[k]);
  }
}

/* About the size of the farthest one, from the centroid. */
static void set_length(tp_contact_points *points) {
  slong most = 0;
  for (long n = 0; n < points->cones.count; n++) {
    for (int k = 0; k < 3; k++) {
      const fmpq *own = points->cones.cones[n].at + k;
      if (fmpq_is_zero(own)) continue;
      const slong bits = (slong)fmpz_bits(fmpq_numref(own)) - (slong)fmpz_bits(fmpq_denref(own));
      if (bits > most) most = bits;
    }
  }
  fmpq_one(points->length);
  fmpq_mul_2exp(points->length, points->length, (ulong)most);
}

static void set_metres(tp_contact_points *points, const tp_surface *surface,
                       const tp_solid_given *given) {
  fmpq_t metres;
  fmpq_init(metres);
  fmpq_div_fmpz(metres, given->metres_per_unit, surface->divisor);
  fmpq_mul(metres, metres, points->length);
  points->metres = tp_surface_nearest(metres);
  fmpq_clear(metres);
}

/* Without error at 0 and 45 degrees, the only rational angles in degrees of a rational tangent. */
static tp_near friction_of(const fmpq_t degrees) {
  enum { UNITY = 45 };
  const double value = tp_surface_nearest(degrees);
  tp_near sine, cosine;
  if (fmpq_is_zero(degrees)) return (tp_near){0, 0};
  if (fmpq_cmp_si(degrees, UNITY) == 0) return (tp_near){1, 0};
  tp_near_sin_cos(&sine, &cosine, (tp_near){value, value * DBL_EPSILON});
  return tp_near_div(sine, cosine);
}

/* ---- one contact -------------------------------------------------------------------------------
 */

typedef struct asked {
  const tp_contact_description *given;
  const tp_surface *surface;
  tp_friction_cone *cone;
  tp_solid_contact *result;
  double near_metres; /* metres for one of the surface's `near` */
  tp_notes *notes;
  tp_message *message;
} asked;

static tp_nearest_triangle find_triangle(const asked *a) {
  double near[3];
  fmpq_t part;
  fmpq_init(part);
  for (int k = 0; k < 3; k++) {
    fmpq_set(part, a->cone->at + k);
    if (a->surface->exponent >= 0) {
      fmpq_div_2exp(part, part, (ulong)a->surface->exponent);
    } else {
      fmpq_mul_2exp(part, part, (ulong)-a->surface->exponent);
    }
    near[k] = tp_surface_nearest(part);
  }
  fmpq_clear(part);
  return tp_surface_nearest_triangle(a->surface, near);
}

static void set_inward(const asked *a, long triangle) {
  fmpz inward[3];
  for (int k = 0; k < 3; k++) fmpz_init(inward + k);
  tp_surface_inward(inward, a->surface, triangle);
  for (int k = 0; k < 3; k++) {
    fmpq_set_fmpz(a->cone->normal + k, inward + k);
    fmpz_clear(inward + k);
  }
}

/* The cosine between a given normal and the one into the rock. */
static double inward_cosine(const asked *a, long triangle) {
  fmpz inward[3];
  fmpq_t sum, own;
  double size = 0, given = 0;
  fmpq_init(sum);
  fmpq_init(own);
  for (int k = 0; k < 3; k++) fmpz_init(inward + k);
  tp_surface_inward(inward, a->surface, triangle);
  for (int k = 0; k < 3; k++) {
    size = hypot(size, fmpz_get_d(inward + k));
    given = hypot(given, tp_surface_nearest(a->given->normal + k));
    fmpq_mul_fmpz(own, a->given->normal + k, inward + k);
    fmpq_add(sum, sum, own);
    fmpz_clear(inward + k);
  }
  const double cosine = tp_surface_nearest(sum) / (size * given);
  fmpq_clear(sum);
  fmpq_clear(own);
  return cosine;
}

/* A normal that is the wrong way round would make the ground pull, and the rock look safe. */
static tp_status check_normal(const asked *a, long triangle) {
  static const double wrong = -0.5;
  static const char *const what =
      "the normal of this contact points out of the rock: it is to point from the ground into the "
      "rock, against the surface of the mesh";
  const double cosine = inward_cosine(a, triangle);
  if (cosine < wrong) return tp_refuse(a->message, TP_FAULT_RANGE, a->given->place, "%s", what);
  return cosine < 0 ? tp_notes_add(a->notes, a->message, TP_CAUTION, a->given->place, "%s", what)
                    : TP_OK;
}

static tp_status check_place(const asked *a, const tp_nearest_triangle *nearest) {
  static const double far = 0.01; /* of the size of the surface */
  if (nearest->distance > far) {
    const tp_status status =
        tp_notes_add(a->notes, a->message, TP_CAUTION, a->given->place,
                     "this contact lies %.3g m from the surface of the rock: are its coordinates "
                     "those of the mesh?",
                     a->result->distance_m);
    if (status != TP_OK) return status;
  }
  return a->given->has_normal && !nearest->is_edge ? check_normal(a, nearest->triangle) : TP_OK;
}

static tp_status take_contact(const asked *a) {
  set_steps(a->cone->at, a->surface, a->given->at);
  const tp_nearest_triangle nearest = find_triangle(a);
  a->result->distance_m = nearest.distance * a->near_metres;
  if (a->given->has_normal) {
    for (int k = 0; k < 3; k++) fmpq_set(a->cone->normal + k, a->given->normal + k);
  } else if (nearest.is_edge) {
    return tp_refuse(a->message, TP_FAULT_KEY, a->given->place,
                     "this contact lies on an edge or a corner of the mesh, across which there is "
                     "no one normal: give its 'normal'");
  } else {
    set_inward(a, nearest.triangle);
  }
  return check_place(a, &nearest);
}

/* With its normal and its distance from the surface. */
static tp_status take_found(const asked *a, double gap) {
  set_steps(a->cone->at, a->surface, a->given->at);
  a->result->distance_m = fabs(gap);
  for (int k = 0; k < 3; k++) fmpq_set(a->cone->normal + k, a->given->normal + k);
  return TP_OK;
}

/* ---- all ---------------------------------------------------------------------------------------
 */

static void settle(tp_contact_points *points, tp_solid_contact *results,
                   const tp_solid_given *given) {
  const tp_scene *scene = given->scene;
  set_length(points);
  for (long n = 0; n < points->cones.count; n++) {
    tp_friction_cone *own = points->cones.cones + n;
    const tp_contact_description *of = given->contacts + n;
    const fmpq *degrees = of->friction_angle_deg.given ? of->friction_angle_deg.value
                                                       : scene->friction_angle_deg.value;
    for (int k = 0; k < 3; k++) fmpq_div(own->at + k, own->at + k, points->length);
    tp_friction_cone_settle(own, friction_of(degrees));
    results[n].friction_angle_deg = tp_surface_nearest(degrees);
    for (int k = 0; k < 3; k++) {
      results[n].at[k] = tp_surface_nearest(of->at + k);
      results[n].normal[k] = own->unit[k];
    }
  }
}

tp_status tp_contact_points_init(tp_contact_points *points, tp_solid_contact *results,
                                 const tp_solid_moments *moments, const tp_solid_given *given,
                                 tp_notes *notes, tp_message *message) {
  const tp_surface *surface = moments->surface;
  *points = (tp_contact_points){.metres = 1};
  fmpq_init(points->length);
  for (int k = 0; k < 3; k++) fmpq_init(points->centre + k);
  for (int k = 0; k < 6; k++) fmpq_init(points->inertia + k);
  if (!tp_friction_cones_init(&points->cones, given->contact_count)) {
    return tp_fail_memory(message, "the contacts of a solid");
  }
  fmpq_set_fmpz(points->length, (fmpz[]){1});
  fmpq_mul_2exp(points->length, points->length, (ulong)surface->exponent);
  set_metres(points, surface, given);
  const double near_metres = points->metres;
  set_centre(points, &moments->centre);
  tp_status status = TP_OK;
  for (long n = 0; n < given->contact_count && status == TP_OK; n++) {
    tp_friction_cone *cone = points->cones.cones + n;
    const asked own = {given->contacts + n, surface, cone,   results + n,
                       near_metres,         notes,   message};
    status =
        given->contact_gaps == NULL ? take_contact(&own) : take_found(&own, given->contact_gaps[n]);
    for (int k = 0; k < 3; k++) fmpq_sub(cone->at + k, cone->at + k, points->centre + k);
  }
  if (status == TP_OK) {
    settle(points, results, given);
    tp_solid_moments_inertia(points->inertia, moments);
    for (int k = 0; k < 6; k++) {
      fmpq_div(points->inertia + k, points->inertia + k, points->length);
      fmpq_div(points->inertia + k, points->inertia + k, points->length);
    }
  }
  set_metres(points, surface, given);
  return status;
}

void tp_contact_points_clear(tp_contact_points *points) {
  tp_friction_cones_clear(&points->cones);
  fmpq_clear(points->length);
  for (int k = 0; k < 3; k++) fmpq_clear(points->centre + k);
  for (int k = 0; k < 6; k++) fmpq_clear(points->inertia + k);
}

void tp_contact_points_given(double given[3], const tp_contact_points *points,
                             const tp_surface *surface, const double point[3]) {
  fmpq_t own;
  fmpq_init(own);
  for (int k = 0; k < 3; k++) {
    tp_hold_double(own, point[k]);
    fmpq_mul(own, own, points->length);
    fmpq_add(own, own, points->centre + k);
    fmpq_add_fmpz(own, own, surface->origin[k]);
    fmpq_div_fmpz(own, own, surface->divisor);
    given[k] = tp_surface_nearest(own);
  }
  fmpq_clear(own);
}
