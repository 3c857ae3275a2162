/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The surface, the gate, moments in doubles and the hull, in the order in which faults are told. */

#include "solid_tilt/solid_body.h"

#include "solid/gate.h"

#include <stdlib.h>

static tp_status pass(tp_solid_body *body, tp_message *message) {
  const tp_surface *surface = &body->surface;
  tp_status status = tp_gate_areas(surface, message);
  if (status == TP_OK) status = tp_gate_edges(surface, message);
  if (status != TP_OK) return status;
  tp_solid_moments_init(&body->moments, surface);
  status = tp_solid_moments_check(&body->moments, message);
  if (status == TP_OK) status = tp_gate_clashes(surface, message);
  if (status == TP_OK) status = tp_hull_facets_init(&body->facets, surface, message);
  if (status == TP_OK) return TP_OK;
  tp_hull_facets_clear(&body->facets);
  tp_solid_moments_clear(&body->moments);
  return status;
}

tp_status tp_solid_body_init(tp_solid_body *body, const tp_mesh *mesh, long object,
                             tp_message *message) {
  *body = (tp_solid_body){.mesh = mesh, .object = object};
  tp_status status = tp_surface_init(&body->surface, mesh, object, message);
  if (status != TP_OK) return status;
  status = pass(body, message);
  if (status != TP_OK) tp_surface_clear(&body->surface);
  return status;
}

void tp_solid_body_clear(tp_solid_body *body) {
  tp_hull_facets_clear(&body->facets);
  tp_solid_moments_clear(&body->moments);
  tp_surface_clear(&body->surface);
}

/* ---- of a scene --------------------------------------------------------------------------------
 */

static void give_back(void *made) {
  tp_solid_body_clear(made);
  free(made);
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
  const tp_status status = tp_solid_body_init(own, scene->solid.mesh, scene->solid.object, message);
  if (status == TP_OK) {
    *body = tp_scene_file_keep(file, own, give_back);
  } else {
    free(own);
  }
  return status;
}
