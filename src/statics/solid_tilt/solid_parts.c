/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A part weighs by how much its unit weight is over the rock's; a hole takes away all of it. */

#include "solid_tilt/solid_parts.h"

#include <stdlib.h>
#include <string.h>

tp_status tp_solid_parts_weigh(tp_solid_part_moments **parts, const tp_solid_body *body,
                               const tp_solid_given *given, tp_message *message) {
  *parts = NULL;
  if (body->part_count == 0) return TP_OK;
  *parts = calloc((size_t)body->part_count, sizeof **parts);
  if (*parts == NULL) return tp_fail_memory(message, "the parts of a solid");
  for (long k = 0; k < body->part_count; k++) {
    const tp_solid_part_description *of = given->scene->solid.parts + k;
    tp_solid_part_moments *own = *parts + k;
    own->own = body->part_moments + k;
    fmpq_init(own->excess);
    if (!of->is_hole) {
      fmpq_div(own->excess, of->unit_weight_kn_m3.value, given->unit_weight);
    }
    fmpq_sub_si(own->excess, own->excess, 1);
  }
  return TP_OK;
}

void tp_solid_parts_clear(tp_solid_part_moments *parts, long part_count) {
  for (long k = 0; parts != NULL && k < part_count; k++) fmpq_clear(parts[k].excess);
  free(parts);
}

tp_status tp_solid_parts_tell(tp_solid *solid, const tp_solid_body *body,
                              const tp_solid_given *given, tp_message *message) {
  if (body->part_count == 0) return TP_OK;
  solid->parts = calloc((size_t)body->part_count, sizeof *solid->parts);
  if (solid->parts == NULL) return tp_fail_memory(message, "the parts of a solid");
  for (long k = 0; k < body->part_count; k++) {
    const tp_solid_part_description *of = given->scene->solid.parts + k;
    const char *object = of->object >= 0 ? of->mesh->objects[of->object].name : NULL;
    tp_solid_part *own = solid->parts + solid->part_count++;
    own->file = strdup(of->mesh->file);
    if (object != NULL) own->object = strdup(object);
    if (own->file == NULL || (own->object == NULL) != (object == NULL)) {
      return tp_fail_memory(message, "the parts of a solid");
    }
    own->is_hole = of->is_hole;
    if (!of->is_hole) own->unit_weight_kn_m3 = tp_surface_nearest(of->unit_weight_kn_m3.value);
    own->volume_m3 = tp_solid_moments_volume(body->part_moments + k, given->metres_per_unit);
  }
  return TP_OK;
}
