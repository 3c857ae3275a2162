/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A solid by the options of a call: its mesh read, its object found, its body solved. */

#include "solid_tilt/solve_solid.h"

#include "common/host.h"
#include "common/notes.h"
#include "common/options.h"
#include "common/outside.h"
#include "scene_varying/settings.h"
#include "solid_tilt/on_contacts.h"
#include "solid_tilt/on_ground.h"
#include "solid_tilt/repaired.h"
#include "solid_tilt/rose.h"
#include "solid_tilt/wedge_slide.h"

#include <stdlib.h>
#include <string.h>

void tp_solid_free(tp_solid *solid) {
  if (solid == NULL) return;
  free(solid->file);
  free(solid->object);
  free(solid->title);
  free(solid->scene);
  tp_notes_clear(&solid->notes);
  tp_settings_clear(&solid->settings);
  free(solid->poses);
  for (size_t k = 0; k < solid->band_count; k++) tp_solid_band_clear(solid->bands + k);
  free(solid->bands);
  for (size_t k = 0; k < solid->part_count; k++) {
    free(solid->parts[k].file);
    free(solid->parts[k].object);
  }
  free(solid->parts);
  tp_solid_contacts_clear(&solid->contacts);
  tp_solid_wedge_clear(&solid->wedge);
  tp_solid_repair_clear(&solid->repair);
  tp_solid_ground_clear(&solid->ground);
  free(solid);
}

/* ---- a file ------------------------------------------------------------------------------------
 */

static tp_status fail_object(const tp_mesh *mesh, const char *object, tp_message *message) {
  char names[TP_MESH_NAMES];
  tp_mesh_object_names(names, mesh);
  return tp_refuse(message, TP_FAULT_KEY, (tp_place){mesh->file, 0, 0},
                   "the mesh has no object '%s' with faces; it has %s", tp_quote_all(object).text,
                   names);
}

static tp_status find_object(long *found, const tp_mesh *mesh, const char *object,
                             tp_message *message) {
  *found = -1;
  if (object == NULL) return TP_OK;
  for (long k = 0; k < mesh->object_count; k++) {
    if (strcmp(mesh->objects[k].name, object) == 0) *found = k;
  }
  return *found >= 0 && mesh->objects[*found].face_count > 0 ? TP_OK
                                                             : fail_object(mesh, object, message);
}

static tp_status solve_mesh(tp_solid *solid, const tp_mesh *mesh, const tp_solid_options *options,
                            tp_solid_given *given, tp_message *message) {
  tp_solid_body body;
  long object = -1;
  tp_status status = find_object(&object, mesh, options->object, message);
  const tp_solid_wish wish = {
      options->repair, {options->repair_merge_within, options->repair_drop_below}, options->thin};
  if (status == TP_OK) {
    status = tp_solid_body_init(&body, mesh, object, &wish, NULL, 0, message);
  }
  if (status != TP_OK) return status;
  status = tp_solid_find(solid, &body, given, message);
  tp_solid_body_clear(&body);
  return status;
}

static tp_status solve_file(tp_solid *solid, const char *path, const tp_solid_options *options,
                            tp_message *message) {
  tp_solid_given given;
  tp_mesh mesh;
  memcpy(solid->up, options->up, sizeof solid->up);
  tp_status status = tp_solid_given_init(&given, options, message);
  if (status == TP_OK) {
    status = tp_mesh_read(&mesh, path, message);
    if (status == TP_OK) {
      status = solve_mesh(solid, &mesh, options, &given, message);
      tp_mesh_clear(&mesh);
    }
  }
  tp_solid_given_clear(&given);
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
  tp_solid *own = calloc(1, sizeof *own);
  if (own == NULL) return tp_fail_memory(message, "a solid");
  const tp_status status = solve_file(own, path, options, message);
  if (status == TP_OK) {
    *solid = own;
  } else {
    tp_solid_free(own);
  }
  return status;
}
