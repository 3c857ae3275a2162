/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The rock and its parts cut by one plane, with moments, and the hull of the rock. Poses are those
 * of what lies above: the piece that can fall. */

#include "solid_tilt/solid_cut.h"

#include "solid/cut.h"
#include "solid_tilt/find_solid.h"
#include "solid_tilt/solve_solid.h"
#include "solid_tilt/thinned.h"

#include <stdlib.h>

/* Of a rock that is thinned all of it, for what lies above is then as exact as without. */
static const tp_surface *surface_of(const tp_solid_body *body, long k) {
  return k == 0 && body->is_thinned ? &body->whole
         : k == 0                   ? &body->surface
                                    : &body->pieces[k].surface;
}

static tp_place place_of(const tp_solid_cut *cut, const tp_solid_given *given) {
  return given->scene != NULL ? given->scene->solid.below.place
                              : (tp_place){cut->body.mesh->file, 0, 0};
}

/* ---- what is refused ---------------------------------------------------------------------------
 */

static tp_status refuse_parts(const tp_solid_cut *cut, const tp_solid_given *given,
                              const tp_cut_solids *solids, tp_message *message) {
  char names[2][TP_SURFACE_NAME];
  for (int k = 0; k < 2; k++) {
    tp_surface_name(names[k], cut->surfaces + solids->surfaces[k], solids->triangles[k]);
  }
  return tp_refuse(message, TP_FAULT_GEOMETRY, place_of(cut, given),
                   "what lies above the plane that cuts the rock is %ld pieces that nothing holds "
                   "together: %s of the mesh is of one, %s of another; cut it elsewhere, or name "
                   "one object",
                   solids->count, names[0], names[1]);
}

static tp_status check(const tp_solid_cut *cut, const tp_solid_given *given, const fmpz *up,
                       tp_message *message) {
  tp_cut_solids solids;
  if (cut->surfaces->triangle_count == 0) {
    return tp_refuse(message, TP_FAULT_RANGE, place_of(cut, given),
                     "nothing of the rock lies above the plane that cuts it: 'below' must be less "
                     "than its height over its lowest point");
  }
  bool *are_holes = calloc((size_t)cut->count, sizeof *are_holes);
  if (are_holes == NULL) return tp_fail_memory(message, "the parts of a solid");
  long count = 1;
  while (count < cut->count && given->scene->solid.parts[count - 1].is_hole) {
    are_holes[count++] = true; /* holes come first; parts do not part the rock */
  }
  const bool done = tp_cut_count(&solids, cut->surfaces, are_holes, count, up);
  free(are_holes);
  if (!done) return tp_fail_memory(message, "a solid that a plane cuts");
  return solids.count > 1 ? refuse_parts(cut, given, &solids, message) : TP_OK;
}

/* ---- what lies above ---------------------------------------------------------------------------
 */

static tp_status cut_all(tp_solid_cut *cut, const tp_solid_body *body, tp_cut_plane *plane,
                         tp_message *message) {
  const long count = body->part_count + 1;
  cut->surfaces = calloc((size_t)count, sizeof *cut->surfaces);
  if (cut->surfaces == NULL) return tp_fail_memory(message, "a solid that a plane cuts");
  tp_status status = TP_OK;
  for (; cut->count < count && status == TP_OK; cut->count++) {
    status = tp_cut_above(cut->surfaces + cut->count, surface_of(body, cut->count), plane, message);
  }
  return status;
}

static tp_status weigh(tp_solid_cut *cut, tp_message *message) {
  tp_solid_body *own = &cut->body;
  own->surface = own->whole = cut->surfaces[0];
  tp_solid_moments_init(&own->moments, &own->surface);
  if (own->part_count > 0) {
    own->part_moments = calloc((size_t)own->part_count, sizeof *own->part_moments);
    if (own->part_moments == NULL) return tp_fail_memory(message, "the parts of a solid");
  }
  for (long k = 0; k < own->part_count; k++) {
    tp_solid_moments_init(own->part_moments + k, cut->surfaces + k + 1);
  }
  const tp_status status = tp_solid_moments_check(&own->moments, message);
  return status == TP_OK ? tp_hull_facets_init(&own->facets, &own->surface, message) : status;
}

tp_status tp_solid_cut_init(tp_solid_cut *cut, const tp_solid_body *body,
                            const tp_solid_given *given, tp_message *message) {
  *cut = (tp_solid_cut){.body = {.mesh = body->mesh,
                                 .object = body->object,
                                 .is_mended = body->is_mended,
                                 .repair = body->repair, /* borrowed */
                                 .part_count = body->part_count}};
  tp_cut_plane plane;
  tp_cut_plane_init(&plane, surface_of(body, 0), given->up, given->below);
  tp_status status = cut_all(cut, body, &plane, message);
  tp_cut_plane_clear(&plane);
  if (status == TP_OK) status = check(cut, given, given->up, message);
  if (status == TP_OK) status = weigh(cut, message);
  if (status != TP_OK) tp_solid_cut_clear(cut);
  return status;
}

void tp_solid_cut_clear(tp_solid_cut *cut) {
  tp_solid_body *own = &cut->body;
  tp_hull_facets_clear(&own->facets);
  tp_solid_moments_clear(&own->moments);
  for (long k = 0; own->part_moments != NULL && k < own->part_count; k++) {
    tp_solid_moments_clear(own->part_moments + k);
  }
  free(own->part_moments);
  for (long k = 0; k < cut->count; k++) tp_surface_clear(cut->surfaces + k);
  free(cut->surfaces);
}

/* ---- results -----------------------------------------------------------------------------------
 */

/* Of what lies above a plane that cuts it; counts are those of the mesh. */
static tp_status find_cut(tp_solid *solid, const tp_solid_body *body, tp_solid_given *given,
                          tp_message *message) {
  tp_solid_cut cut;
  fmpq_t below;
  fmpq_init(below);
  fmpq_div(below, given->below, given->band_lengths);
  solid->has_below = true;
  solid->below = tp_surface_nearest(below);
  fmpq_clear(below);
  tp_status status = tp_solid_cut_init(&cut, body, given, message);
  if (status != TP_OK) return status;
  status = tp_solid_find_body(solid, &cut.body, given, message);
  solid->vertices = (size_t)body->surface.vertex_count;
  solid->triangles = (size_t)body->surface.triangle_count;
  if (status == TP_OK) status = tp_thinning_tell(solid, body, given, message);
  if (status == TP_OK) solid->bands->band = solid->below;
  tp_solid_cut_clear(&cut);
  return status;
}

tp_status tp_solid_find(tp_solid *solid, const tp_solid_body *body, tp_solid_given *given,
                        tp_message *message) {
  return given->has_below ? find_cut(solid, body, given, message)
                          : tp_solid_find_body(solid, body, given, message);
}
