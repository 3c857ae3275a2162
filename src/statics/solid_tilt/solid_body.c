/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The surface, the gate, moments in doubles and the hull, in the order in which faults are told. Of
 * a mesh that is thinned the moments stay those of all of it, for they cost little. */

#include "solid_tilt/solid_body.h"

#include "solid/gate.h"

#include <stdlib.h>

/* ---- parts ------------------------------------------------------------------------------------
 */

/* The meshes of the rock and of all parts as one. */
static tp_status join(tp_solid_body *body, const tp_solid_part_description *parts,
                      tp_message *message) {
  body->joined.file = body->mesh->file;
  tp_status status = tp_mesh_join(&body->joined, body->mesh, body->object, message);
  for (long k = 0; k < body->part_count && status == TP_OK; k++) {
    status = tp_mesh_join(&body->joined, parts[k].mesh, parts[k].object, message);
  }
  return status;
}

static bool make_pieces(tp_solid_body *body, const tp_solid_part_description *parts) {
  const size_t count = (size_t)body->part_count;
  body->pieces = calloc(count + 1, sizeof *body->pieces);
  body->part_moments = calloc(count, sizeof *body->part_moments);
  if (body->pieces == NULL || body->part_moments == NULL) return false;
  for (int k = 0; k <= body->part_count; k++) {
    body->pieces[k] =
        (tp_solid_piece){tp_surface_of_object(&body->whole, k), k > 0 && parts[k - 1].is_hole};
  }
  body->surface = body->pieces[0].surface;
  return true;
}

static tp_status take_surfaces(tp_solid_body *body, const tp_solid_part_description *parts,
                               tp_message *message) {
  if (body->part_count == 0) {
    const tp_status status = tp_surface_init(&body->whole, body->mesh, body->object, message);
    body->surface = body->whole;
    return status;
  }
  tp_status status = join(body, parts, message);
  if (status == TP_OK) status = tp_surface_init(&body->whole, &body->joined, -1, message);
  if (status == TP_OK && !make_pieces(body, parts)) {
    status = tp_fail_memory(message, "the parts of a solid");
  }
  return status;
}

/* ---- the gate ---------------------------------------------------------------------------------
 */

/* A surface by itself. */
static tp_status pass(tp_solid_moments *moments, const tp_surface *surface, tp_message *message) {
  tp_status status = tp_gate_areas(surface, message);
  if (status == TP_OK) status = tp_gate_edges(surface, message);
  if (status != TP_OK) return status;
  tp_solid_moments_init(moments, surface);
  return tp_solid_moments_check(moments, message);
}

/* One that is thinned: edges and moments are of all of it, areas and where it meets itself of what
 * is left, which has the same hull. */
static tp_status pass_thinned(tp_solid_body *body, double length, tp_message *message) {
  body->is_thinned = true;
  body->surface = (tp_surface){.mesh = NULL};
  tp_status status = tp_gate_edges(&body->whole, message);
  if (status != TP_OK) return status;
  tp_solid_moments_init(&body->moments, &body->whole);
  status = tp_solid_moments_check(&body->moments, message);
  if (status == TP_OK) {
    status = tp_surface_thin(&body->surface, &body->thinning, &body->whole, length, message);
  }
  if (status != TP_OK) return status;
  tp_solid_moments_lie_on(&body->moments, &body->surface);
  tp_solid_moments_init(&body->of_thinned, &body->surface);
  return tp_solid_moments_check(&body->of_thinned, message);
}

static tp_status pass_all(tp_solid_body *body, const tp_solid_wish *wish, tp_message *message) {
  const bool thins = wish != NULL && wish->thin > 0;
  tp_status status = thins ? pass_thinned(body, wish->thin, message)
                           : pass(&body->moments, &body->surface, message);
  for (long k = 0; k < body->part_count && status == TP_OK; k++) {
    status = pass(body->part_moments + k, &body->pieces[k + 1].surface, message);
  }
  if (status == TP_OK && !thins) status = tp_gate_clashes(&body->whole, message);
  if (status == TP_OK && body->part_count > 0) {
    status = tp_gate_pieces(body->pieces, body->part_count + 1, message);
  }
  return status == TP_OK ? tp_hull_facets_init(&body->facets, &body->surface, message) : status;
}

static tp_status mend(tp_solid_body *body, const tp_solid_wish *wish, tp_message *message) {
  if (wish == NULL || !wish->repair) return TP_OK;
  body->is_mended = true;
  const tp_status status =
      tp_mesh_mend(&body->mended, &body->repair, body->mesh, body->object, &wish->mend, message);
  body->mesh = &body->mended;
  if (body->object > 0) body->object = 0;
  return status;
}

tp_status tp_solid_body_init(tp_solid_body *body, const tp_mesh *mesh, long object,
                             const tp_solid_wish *wish, const tp_solid_part_description *parts,
                             long part_count, tp_message *message) {
  *body = (tp_solid_body){.mesh = mesh, .object = object, .part_count = part_count};
  if (wish != NULL) body->wish = *wish;
  tp_status status = mend(body, wish, message);
  if (status == TP_OK) status = take_surfaces(body, parts, message);
  if (status == TP_OK) status = pass_all(body, wish, message);
  if (status != TP_OK) tp_solid_body_clear(body);
  return status;
}

void tp_solid_body_clear(tp_solid_body *body) {
  tp_hull_facets_clear(&body->facets);
  tp_solid_moments_clear(&body->moments);
  for (long k = 0; k < body->part_count && body->part_moments != NULL; k++) {
    tp_solid_moments_clear(body->part_moments + k);
  }
  free(body->part_moments);
  free(body->pieces);
  tp_ground_body_free(body->ground);
  if (body->is_thinned) {
    tp_solid_moments_clear(&body->of_thinned);
    tp_surface_clear(&body->surface);
  }
  tp_surface_clear(&body->whole);
  tp_mesh_clear(&body->joined);
  tp_mesh_clear(&body->mended);
  tp_solid_repair_clear(&body->repair);
}

/* ---- of a scene --------------------------------------------------------------------------------
 */

static void give_back(void *made) {
  tp_solid_body_clear(made);
  free(made);
}

static tp_solid_wish wish_of(const tp_solid_description *solid) {
  return (tp_solid_wish){
      solid->repair, {solid->repair_merge_within, solid->repair_drop_below}, solid->thin};
}

bool tp_solid_body_is_of(const tp_solid_body *body, const tp_scene *scene) {
  const tp_solid_wish one = body->wish, other = wish_of(&scene->solid);
  return one.repair == other.repair && one.mend.merge_within == other.mend.merge_within &&
         one.mend.drop_below == other.mend.drop_below && one.thin == other.thin;
}

tp_status tp_solid_body_make(tp_solid_body *body, const tp_scene *scene, tp_message *message) {
  const tp_solid_description *solid = &scene->solid;
  const tp_solid_wish wish = wish_of(solid);
  tp_status status = tp_solid_body_init(body, solid->mesh, solid->object, &wish, solid->parts,
                                        solid->part_count, message);
  if (status == TP_OK && solid->ground.place.file != NULL) {
    status = tp_ground_body_make(&body->ground, body->mesh, body->object, solid, message);
    if (status != TP_OK) tp_solid_body_clear(body);
  }
  return status;
}

tp_status tp_solid_body_of_scene(const tp_solid_body **body, const tp_scene *scene,
                                 tp_message *message) {
  tp_scene_file *file = scene->file;
  *body = NULL;
  if (scene->solid.wedge.place.file != NULL) return TP_OK;
  *body = atomic_load(&file->kept);
  if (*body != NULL) return TP_OK;
  tp_solid_body *own = malloc(sizeof *own);
  if (own == NULL) return tp_fail_memory(message, "a solid");
  const tp_status status = tp_solid_body_make(own, scene, message);
  if (status == TP_OK) {
    *body = tp_scene_file_keep(file, own, give_back);
  } else {
    free(own);
  }
  return status;
}
