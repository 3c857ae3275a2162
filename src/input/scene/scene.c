/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Length units as fractions of a metre, conversions of a tooth description (section 5.1 of the
 * paper), and initial values of the items of lists. */

#include "scene/scene.h"

#include <stdlib.h>
#include <string.h>

static const struct {
  const char *name;
  long numerator, denominator; /* metres per unit */
} units[] = {{"mm", 1, 1000}, {"cm", 1, 100},    {"m", 1, 1},
             {"km", 1000, 1}, {"in", 127, 5000}, {"ft", 381, 1250}};

bool tp_unit_find(fmpq_t metres, const char **unit) {
  for (size_t k = 0; k < sizeof units / sizeof units[0]; k++) {
    if (strcmp(*unit, units[k].name) != 0) continue;
    *unit = units[k].name;
    fmpq_set_si(metres, units[k].numerator, (unsigned long)units[k].denominator);
    return true;
  }
  return false;
}

tp_status tp_scene_use_unit(tp_scene *scene, const char *length_unit, tp_place place,
                            tp_message *message) {
  if (tp_unit_find(scene->metres_per_unit, &length_unit)) {
    scene->length_unit = length_unit;
    return TP_OK;
  }
  return tp_refuse(message, TP_FAULT_UNIT, place,
                   "length_unit must be one of mm, cm, m, km, in, ft");
}

bool tp_scene_is_shifted(const tp_scene *scene) {
  return scene->base.shift.given || scene->base.matching.given;
}

bool tp_scene_lies_in_place(const tp_scene *scene) {
  return scene->frame == TP_FRAME_SLOPE || scene->frame == TP_FRAME_WORLD;
}

tp_place tp_scene_shift_place(const tp_scene *scene) {
  return scene->base.shift.given ? scene->base.shift.place : scene->base.matching.place;
}

void tp_teeth_over(fmpq_t width, fmpq_t height, const fmpq_t amplitude, long count) {
  fmpq_t factor;
  fmpq_init(factor);
  fmpq_set_si(factor, count, 1);
  fmpq_div(width, width, factor);
  fmpq_div_2exp(factor, amplitude, 1);
  fmpq_sub(height, height, factor);
  fmpq_clear(factor);
}

bool tp_water_is_sited(const tp_water_description *water) {
  return water->given && (water->level.given || water->surface.count > 0 || water->cracked);
}

void tp_line_load_init(tp_line_load *load) {
  fmpq_init(load->x0.value);
  fmpq_init(load->y0.value);
  fmpq_init(load->x1.value);
  fmpq_init(load->y1.value);
  fmpq_init(load->first_kpa.value);
  fmpq_init(load->last_kpa.value);
  load->block = -1;
}

void tp_line_load_clear(tp_line_load *load) {
  fmpq_clear(load->x0.value);
  fmpq_clear(load->y0.value);
  fmpq_clear(load->x1.value);
  fmpq_clear(load->y1.value);
  fmpq_clear(load->first_kpa.value);
  fmpq_clear(load->last_kpa.value);
}

void tp_anchor_init(tp_anchor_description *anchor) {
  fmpq_init(anchor->x.value);
  fmpq_init(anchor->y.value);
  tp_quantity *const own[] = {&anchor->direction_deg, &anchor->dip_deg, &anchor->force_kn,
                              &anchor->capacity_kn,   &anchor->length,  &anchor->spacing,
                              &anchor->rows,          &anchor->step_x,  &anchor->step_y,
                              &anchor->to_x,          &anchor->to_y,    &anchor->azimuth_deg};
  for (size_t k = 0; k < sizeof own / sizeof own[0]; k++) fmpq_init(own[k]->value);
  anchor->block = anchor->into = -1;
}

void tp_joint_init(tp_joint_description *joint) {
  fmpq_init(joint->friction_angle_deg.value);
  fmpq_init(joint->cohesion_kpa.value);
  fmpq_init(joint->tension_kpa.value);
}

void tp_arc_init(tp_arc_description *arc) {
  fmpq_init(arc->x.value);
  fmpq_init(arc->y.value);
  fmpq_init(arc->through_x.value);
  fmpq_init(arc->through_y.value);
  fmpq_init(arc->bulge.value);
}

void tp_corner_init(tp_corner_description *corner) {
  fmpq_init(corner->x.value);
  fmpq_init(corner->y.value);
  fmpq_init(corner->radius.value);
}

void tp_facet_friction_description_init(tp_facet_friction_description *facets) {
  fmpq_init(facets->x0.value);
  fmpq_init(facets->x1.value);
  fmpq_init(facets->angle_deg.value);
}

void tp_traction_description_init(tp_traction_description *traction) {
  fmpq_init(traction->first_kpa.value);
  fmpq_init(traction->last_kpa.value);
  fmpq_init(traction->shear_kpa.value);
}

size_t tp_scene_source_count(const tp_scene *scene) {
  return 1 + (scene->file != NULL ? (size_t)scene->file->name_count : 0);
}

const char *tp_scene_source(const tp_scene *scene, size_t index) {
  return index == 0 ? scene->path : scene->file->names[index - 1];
}

tp_status tp_scene_copy_sources(char ***names, size_t *count, const tp_scene *scene,
                                tp_message *message) {
  const size_t all = tp_scene_source_count(scene);
  char **own = calloc(all, sizeof *own);
  *names = own;
  *count = 0;
  for (size_t k = 0; own != NULL && k < all; k++) {
    own[k] = strdup(tp_scene_source(scene, k));
    if (own[k] == NULL) break;
    *count = k + 1;
  }
  return *count == all ? TP_OK : tp_fail_memory(message, "the names of files");
}
