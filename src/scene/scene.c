/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A scene made, with what holds where nothing is given, and given back. */

#include "scene/scene.h"

#include <stdlib.h>
#include <string.h>

static const struct {
  const char *name;
  long numerator, denominator; /* metres per unit */
} units[] = {{"mm", 1, 1000}, {"cm", 1, 100},    {"m", 1, 1},
             {"km", 1000, 1}, {"in", 127, 5000}, {"ft", 381, 1250}};

tp_status tp_scene_use_unit(tp_scene *scene, const char *length_unit, tp_place place,
                            tp_message *message) {
  for (size_t k = 0; k < sizeof units / sizeof units[0]; k++) {
    if (strcmp(length_unit, units[k].name) != 0) continue;
    scene->length_unit = units[k].name;
    fmpq_set_si(scene->metres_per_unit, units[k].numerator, (unsigned long)units[k].denominator);
    return TP_OK;
  }
  return tp_fail(message, TP_BAD_INPUT, place, "length_unit must be one of mm, cm, m, km, in, ft");
}

void tp_line_load_init(tp_line_load *load) {
  fmpq_init(load->x0.value);
  fmpq_init(load->y0.value);
  fmpq_init(load->x1.value);
  fmpq_init(load->y1.value);
  fmpq_init(load->first_kpa.value);
  fmpq_init(load->last_kpa.value);
}

void tp_anchor_init(tp_anchor_description *anchor) {
  fmpq_init(anchor->x.value);
  fmpq_init(anchor->y.value);
  fmpq_init(anchor->direction_deg.value);
  fmpq_init(anchor->force_kn.value);
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

/* The single numbers of a scene. */
static void for_each(tp_scene *scene, void (*visit)(fmpq_t)) {
  tp_block_description *block = &scene->block;
  visit(scene->metres_per_unit);
  visit(block->teeth.width);
  visit(block->teeth.height);
  visit(block->teeth.depth);
  visit(block->ellipse.width.value);
  visit(block->ellipse.height.value);
  visit(block->ellipse.flat.value);
  visit(block->thickness.value);
  visit(block->unit_weight_kn_m3.value);
  visit(scene->base.beyond_left.value);
  visit(scene->base.beyond_right.value);
  visit(scene->base.below.value);
  visit(scene->base.left_of.value);
  visit(scene->base.right_of.value);
  visit(scene->loads.horizontal.value);
  visit(scene->loads.vertical.value);
  visit(scene->loads.water.height.value);
  visit(scene->loads.water.unit_weight_kn_m3.value);
  visit(scene->loads.bond_kpa.value);
  visit(scene->loads.cohesion_kpa.value);
  visit(scene->friction_angle_deg.value);
  visit(scene->friction.jrc.value);
  visit(scene->friction.jcs_mpa.value);
  visit(scene->friction.roughness_angle_deg.value);
  visit(scene->friction.test_angle_deg.value);
  visit(scene->friction.test_stress_kpa.value);
  visit(scene->tilt_angle_deg.value);
}

tp_scene *tp_scene_make(const char *path) {
  tp_scene *scene = calloc(1, sizeof *scene);
  if (scene == NULL) return NULL;
  scene->path = strdup(path);
  if (scene->path == NULL) {
    free(scene);
    return NULL;
  }
  for_each(scene, fmpq_init);
  scene->base.mated = true;
  scene->towards_left = scene->towards_right = true;
  return scene;
}

static void clear_lines(tp_line_load *loads, long count) {
  for (long k = 0; k < count; k++) {
    fmpq_clear(loads[k].x0.value);
    fmpq_clear(loads[k].y0.value);
    fmpq_clear(loads[k].x1.value);
    fmpq_clear(loads[k].y1.value);
    fmpq_clear(loads[k].first_kpa.value);
    fmpq_clear(loads[k].last_kpa.value);
  }
  free(loads);
}

static void clear_loads(tp_loads_description *loads) {
  clear_lines(loads->pressures, loads->pressure_count);
  clear_lines(loads->surcharges, loads->surcharge_count);
  for (long k = 0; k < loads->anchor_count; k++) {
    fmpq_clear(loads->anchors[k].x.value);
    fmpq_clear(loads->anchors[k].y.value);
    fmpq_clear(loads->anchors[k].direction_deg.value);
    fmpq_clear(loads->anchors[k].force_kn.value);
  }
  free(loads->anchors);
}

static void clear_arcs(tp_block_description *block) {
  for (long k = 0; k < block->arc_count; k++) {
    fmpq_clear(block->arcs[k].x.value);
    fmpq_clear(block->arcs[k].y.value);
    fmpq_clear(block->arcs[k].through_x.value);
    fmpq_clear(block->arcs[k].through_y.value);
    fmpq_clear(block->arcs[k].bulge.value);
  }
  free(block->arcs);
}

static void clear_block(tp_block_description *block) {
  tp_polyline_clear(&block->outline);
  for (long k = 0; k < block->hole_count; k++) tp_polyline_clear(block->holes + k);
  for (long k = 0; k < block->part_count; k++) {
    tp_polyline_clear(&block->parts[k].outline);
    fmpq_clear(block->parts[k].unit_weight_kn_m3.value);
  }
  for (long k = 0; k < block->rounded.count; k++) {
    fmpq_clear(block->rounded.corners[k].x.value);
    fmpq_clear(block->rounded.corners[k].y.value);
    fmpq_clear(block->rounded.corners[k].radius.value);
  }
  free(block->rounded.corners);
  clear_arcs(block);
  free(block->holes);
  free(block->parts);
}

void tp_scene_free(tp_scene *scene) {
  if (scene == NULL) return;
  clear_block(&scene->block);
  clear_loads(&scene->loads);
  tp_polyline_clear(&scene->base.between);
  tp_polyline_clear(&scene->base.profile);
  tp_polyline_clear(&scene->mean_plane);
  for_each(scene, fmpq_clear);
  for (long k = 0; k < scene->parameters.count; k++) {
    free(scene->parameters.names[k]);
    fmpq_clear(scene->parameters.values + k);
  }
  free(scene->parameters.names);
  free(scene->parameters.values);
  for (long k = 0; k < scene->file_count; k++) free(scene->files[k]);
  free(scene->files);
  tp_notes_clear(&scene->notes);
  if (!scene->borrows_source) tp_node_free(scene->source);
  free(scene->title);
  free(scene->path);
  free(scene);
}
