/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The solid of a scene, with what the scene says of its tilt and its earthquake. */

#include "solid_tilt/solve_solid.h"

#include "common/host.h"
#include "common/notes.h"
#include "scene_varying/settings.h"
#include "solid_tilt/solid_safety.h"
#include "solid_tilt/wedge_slide.h"

#include <stdlib.h>
#include <string.h>

bool tp_scene_is_solid(const tp_scene *scene) {
  return scene != NULL && scene->solid.place.file != NULL;
}

/* Into a number, where it is given. */
static bool take_number(double *number, const tp_quantity *quantity) {
  if (quantity->given) *number = tp_surface_nearest(quantity->value);
  return quantity->given;
}

static void take_loads(tp_solid *own, const tp_scene *scene) {
  const tp_solid_description *solid = &scene->solid;
  own->is_on_slope = solid->dip_deg.given;
  own->has_tilt_angle = take_number(&own->tilt_angle_deg,
                                    own->is_on_slope ? &solid->dip_deg : &scene->tilt_angle_deg);
  own->has_tilt_azimuth =
      take_number(&own->tilt_azimuth_deg,
                  own->is_on_slope ? &solid->dip_direction_deg : &scene->tilt_azimuth_deg);
  const bool horizontal = take_number(&own->seismic_horizontal, &scene->loads.horizontal);
  const bool vertical = take_number(&own->seismic_vertical, &scene->loads.vertical);
  own->has_seismic = horizontal || vertical;
  own->has_seismic_azimuth = take_number(&own->seismic_azimuth_deg, &scene->loads.azimuth_deg);
  own->has_required_fos = take_number(&own->required_fos, &scene->required_fos);
}

static tp_status take_scene(tp_solid *own, const tp_scene *scene, tp_message *message) {
  own->of_scene = true;
  own->title = scene->title != NULL ? strdup(scene->title) : NULL;
  own->scene = strdup(scene->path);
  if (own->scene == NULL || (own->title == NULL) != (scene->title == NULL)) {
    return tp_fail_memory(message, "a solid");
  }
  for (int k = 0; k < 3; k++) own->up[k] = tp_surface_nearest(scene->solid.up + k);
  take_loads(own, scene);
  tp_status status = tp_scene_notes(&own->notes, scene, message);
  if (status == TP_OK) status = tp_scene_settings(&own->settings, scene, message);
  return status;
}

/* Rows of tables have the stance of the band that governs: a wedge has its own in the place behind
 * those that are counted. */
static void set_wedge_row(tp_solid *own) {
  const tp_solid_wedge *wedge = &own->wedge;
  own->bands->has_stance = true;
  own->bands->stance =
      (tp_solid_stance){.verdict = wedge->verdict,
                        .safety = wedge->safety,
                        .has_fos = wedge->has_fos,
                        .fos = wedge->fos,
                        .fos_mechanism = TP_SLIDES,
                        .has_acceleration = wedge->has_acceleration,
                        .acceleration_g = wedge->acceleration_g,
                        .acceleration_azimuth_deg = {.value = wedge->acceleration_azimuth_deg},
                        .acceleration_mechanism = TP_SLIDES};
}

/* A wedge is its own mesh, of this scene's numbers. */
static tp_status find_wedge(tp_solid *own, const tp_scene *scene, tp_solid_given *given,
                            tp_message *message) {
  const tp_wedge_description *wedge = &scene->solid.wedge;
  tp_wedge_shape shape;
  tp_solid_body body;
  tp_mesh mesh = {.file = scene->path};
  const size_t azimuths = given->azimuths;
  given->azimuths = 0; /* of a rock on its base */
  tp_status status = tp_wedge_shape_init(&shape, wedge, message);
  if (status == TP_OK) status = tp_wedge_shape_mesh(&mesh, &shape, scene->path, message);
  if (status == TP_OK) status = tp_solid_body_init(&body, &mesh, -1, NULL, NULL, 0, message);
  if (status == TP_OK) {
    status = tp_solid_find(own, &body, given, message);
    tp_solid_body_clear(&body);
  }
  if (status == TP_OK) {
    own->has_wedge = true;
    status = tp_wedge_slide(&own->wedge, &shape, scene, azimuths, message);
    set_wedge_row(own);
  }
  tp_mesh_clear(&mesh);
  tp_wedge_shape_clear(&shape);
  return status;
}

/* A row of a table that varies how the mesh is mended or thinned has a surface of its own. */
static tp_status find_of_mesh(tp_solid *own, const tp_solid_body *body, const tp_scene *scene,
                              tp_solid_given *given, tp_message *message) {
  tp_solid_body alone;
  if (tp_solid_body_is_of(body, scene)) return tp_solid_find(own, body, given, message);
  tp_status status = tp_solid_body_make(&alone, scene, message);
  if (status == TP_OK) {
    status = tp_solid_find(own, &alone, given, message);
    tp_solid_body_clear(&alone);
  }
  return status;
}

static tp_status find_in_scene(tp_solid *own, const tp_scene *scene, bool whole,
                               tp_message *message) {
  const tp_solid_body *body = NULL;
  tp_solid_given given;
  tp_status status = take_scene(own, scene, message);
  if (status == TP_OK) status = tp_solid_body_of_scene(&body, scene, message);
  if (status != TP_OK) return status;
  status = tp_solid_given_of_scene(&given, scene, message);
  if (!whole) given.azimuths = 0;
  if (status == TP_OK) {
    status = body == NULL ? find_wedge(own, scene, &given, message)
                          : find_of_mesh(own, body, scene, &given, message);
  }
  tp_solid_given_clear(&given);
  return status;
}

tp_status tp_solid_solve_scene(tp_solid **solid, const tp_scene *scene, bool whole,
                               tp_message *message) {
  if (!tp_scene_is_solid(scene)) {
    return tp_refuse(message, TP_FAULT_KEY, scene->block.place,
                     "this scene has no 'solid': tp_solve or tp_solve_block_system takes it");
  }
  tp_solid *own = calloc(1, sizeof *own);
  if (own == NULL) return tp_fail_memory(message, "a solid");
  const tp_status status = find_in_scene(own, scene, whole, message);
  if (status == TP_OK) {
    *solid = own;
  } else {
    tp_solid_free(own);
  }
  return status;
}

tp_status tp_solve_solid(tp_solid **solid, const tp_scene *scene, tp_message *message) {
  TP_GUARD_HOST;
  TP_REFUSE_NULL(message, solid);
  TP_REFUSE_NULL(message, scene);
  return tp_solid_solve_scene(solid, scene, true, message);
}

/* ---- what is asked of it -----------------------------------------------------------------------
 */

static const tp_solid_band *governing_band(const tp_solid *solid) {
  return solid == NULL || solid->governing >= solid->band_count ? NULL
                                                                : solid->bands + solid->governing;
}

bool tp_solid_is_undecided(const tp_solid *solid) {
  if (solid != NULL && solid->has_contacts) {
    return solid->contacts.verdict == TP_MECHANISM_UNDECIDED;
  }
  if (solid != NULL && solid->has_wedge) return solid->wedge.verdict == TP_MECHANISM_UNDECIDED;
  const tp_solid_band *own = governing_band(solid);
  return own == NULL || (own->has_stance && own->stance.verdict == TP_MECHANISM_UNDECIDED);
}

const tp_solid_safety *tp_solid_safety_of(const tp_solid *solid) {
  if (solid == NULL || !solid->of_scene) return NULL;
  if (solid->has_ground) return &solid->ground.safety;
  if (solid->has_contacts) return &solid->contacts.safety;
  if (solid->has_wedge) return &solid->wedge.safety;
  const tp_solid_band *own = governing_band(solid);
  return own != NULL && own->has_stance ? &own->stance.safety : NULL;
}

tp_design tp_solid_meets(const tp_solid *solid, double required) {
  TP_GUARD_HOST;
  const tp_solid_safety *safety = tp_solid_safety_of(solid);
  if (safety != NULL) return tp_solid_safety_meets(safety, required);
  const bool falls = solid != NULL && solid->of_scene && governing_band(solid) != NULL;
  return falls ? TP_DESIGN_NOT_MET : TP_DESIGN_OPEN; /* a point or a line carries it */
}
