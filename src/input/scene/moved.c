/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Copies of outline, holes, parts, arcs, profile and points of loads with a map applied to each
 * point, directions of anchors turned by an angle. */

#include "scene/moved.h"

#include "scene/anchor.h"

#include <stdlib.h>
#include <string.h>

static bool move_line(tp_polyline *moved, const tp_polyline *line, const tp_point_map *map) {
  if (!tp_polyline_copy(moved, line)) return false;
  for (long k = 0; k < moved->count && map->move != NULL; k++) {
    map->move(moved->x + k, moved->y + k, map->context);
  }
  return true;
}

/* Quantities of a copy: their values become its own. NULL: they stay as they are. */
static void move_quantities(tp_quantity *x, tp_quantity *y, const tp_point_map *map) {
  const fmpq held_x = *x->value, held_y = *y->value; /* the scene's */
  fmpq_init(x->value);
  fmpq_init(y->value);
  fmpq_set(x->value, &held_x);
  fmpq_set(y->value, &held_y);
  if (map != NULL && map->move != NULL && x->given) map->move(x->value, y->value, map->context);
}

static void clear_quantities(tp_quantity *x, tp_quantity *y) {
  fmpq_clear(x->value);
  fmpq_clear(y->value);
}

/* A copy of an array; NULL where memory is exhausted. */
static void *copied(const void *items, long count, size_t size) {
  void *copy = malloc((size_t)count * size + 1);
  if (copy != NULL && count > 0) memcpy(copy, items, (size_t)count * size);
  return copy;
}

void tp_moved_begin(tp_scene *copy, const tp_scene *scene) {
  *copy = *scene;
  tp_block_description *block = &copy->block;
  block->outline = copy->base.between = copy->base.profile = (tp_polyline){0};
  block->holes = NULL;
  block->parts = NULL;
  block->arcs = NULL;
  block->rounded.corners = NULL;
  copy->loads.pressures = copy->loads.surcharges = copy->loads.supports = NULL;
  copy->loads.anchors = NULL;
  copy->base.below.given = copy->base.left_of.given = copy->base.right_of.given = false;
}

bool tp_moved_rings(tp_scene *copy, const tp_scene *scene, const tp_polyline *outline,
                    const tp_polyline *holes, const tp_point_map *map) {
  tp_block_description *block = &copy->block;
  const tp_block_description *own = &scene->block;
  bool done = move_line(&block->outline, outline, map);
  block->holes = calloc((size_t)own->hole_count + 1, sizeof *block->holes);
  block->parts = copied(own->parts, own->part_count, sizeof *block->parts);
  for (long k = 0; k < own->part_count && block->parts != NULL; k++) {
    block->parts[k].outline = (tp_polyline){0};
  }
  if (block->holes == NULL || block->parts == NULL) return false;
  for (long k = 0; k < own->hole_count && done; k++)
    done = move_line(block->holes + k, holes + k, map);
  for (long k = 0; k < own->part_count && done; k++) {
    done = move_line(&block->parts[k].outline, &own->parts[k].outline, map);
  }
  return done;
}

static bool move_curves(tp_scene *copy, const tp_block_description *own, const tp_point_map *map) {
  tp_block_description *block = &copy->block;
  block->arcs = copied(own->arcs, own->arc_count, sizeof *block->arcs);
  if (block->arcs == NULL) return false;
  for (long k = 0; k < own->arc_count; k++) {
    move_quantities(&block->arcs[k].x, &block->arcs[k].y, map);
    move_quantities(&block->arcs[k].through_x, &block->arcs[k].through_y, map);
  }
  block->rounded.corners =
      copied(own->rounded.corners, own->rounded.count, sizeof *block->rounded.corners);
  if (block->rounded.corners == NULL) return false;
  for (long k = 0; k < own->rounded.count; k++) {
    move_quantities(&block->rounded.corners[k].x, &block->rounded.corners[k].y, map);
  }
  return true;
}

static tp_line_load *move_lines(const tp_line_load *own, long count, const tp_point_map *map) {
  tp_line_load *loads = copied(own, count, sizeof *loads);
  for (long k = 0; k < count && loads != NULL; k++) {
    move_quantities(&loads[k].x0, &loads[k].y0, map);
    move_quantities(&loads[k].x1, &loads[k].y1, map);
    move_quantities(&loads[k].first_kpa, &loads[k].last_kpa, NULL);
  }
  return loads;
}

/* Its direction, which a dip and the scene's own frame give, becomes one of the frame that it is
 * turned to; the step between rows is the difference of two moved points. */
static void move_anchor(tp_anchor_description *moved, const tp_anchor_description *own,
                        const tp_scene *copy, const fmpq_t turn_deg, const tp_point_map *map) {
  const bool rows = own->step_x.given;
  move_quantities(&moved->x, &moved->y, map);
  fmpq_init(moved->direction_deg.value);
  if (!tp_anchor_waits(copy, own)) {
    tp_anchor_direction(moved->direction_deg.value, copy, own);
    fmpq_add(moved->direction_deg.value, moved->direction_deg.value, turn_deg);
    if (own->dip_deg.given) moved->direction_deg.place = own->dip_deg.place;
    moved->dip_deg.given = false;
  }
  fmpq_init(moved->step_x.value);
  fmpq_init(moved->step_y.value);
  if (!rows) return;
  fmpq_add(moved->step_x.value, own->x.value, own->step_x.value);
  fmpq_add(moved->step_y.value, own->y.value, own->step_y.value);
  if (map->move != NULL) map->move(moved->step_x.value, moved->step_y.value, map->context);
  fmpq_sub(moved->step_x.value, moved->step_x.value, moved->x.value);
  fmpq_sub(moved->step_y.value, moved->step_y.value, moved->y.value);
}

bool tp_moved_loads(tp_scene *copy, const tp_scene *scene, const fmpq_t turn_deg,
                    const tp_point_map *map) {
  tp_loads_description *loads = &copy->loads;
  const tp_loads_description *own = &scene->loads;
  loads->pressures = move_lines(own->pressures, own->pressure_count, map);
  loads->surcharges = move_lines(own->surcharges, own->surcharge_count, map);
  loads->supports = move_lines(own->supports, own->support_count, map);
  loads->anchors = copied(own->anchors, own->anchor_count, sizeof *loads->anchors);
  if (loads->pressures == NULL || loads->surcharges == NULL || loads->supports == NULL ||
      loads->anchors == NULL) {
    return false;
  }
  for (long k = 0; k < own->anchor_count; k++) {
    move_anchor(loads->anchors + k, own->anchors + k, copy, turn_deg, map);
  }
  return true;
}

bool tp_moved_block(tp_scene *copy, const tp_scene *scene, const fmpq_t turn_deg,
                    const tp_point_map *map) {
  return move_curves(copy, &scene->block, map) && tp_moved_loads(copy, scene, turn_deg, map);
}

bool tp_moved_profile(tp_scene *copy, const tp_scene *scene, const tp_point_map *map) {
  return move_line(&copy->base.profile, &scene->base.profile, map);
}

void tp_moved_clear_lines(tp_line_load *loads, long count) {
  for (long k = 0; k < count && loads != NULL; k++) {
    clear_quantities(&loads[k].x0, &loads[k].y0);
    clear_quantities(&loads[k].x1, &loads[k].y1);
    clear_quantities(&loads[k].first_kpa, &loads[k].last_kpa);
  }
  free(loads);
}

void tp_moved_clear_loads(tp_scene *copy) {
  tp_loads_description *loads = &copy->loads;
  tp_moved_clear_lines(loads->pressures, loads->pressure_count);
  tp_moved_clear_lines(loads->surcharges, loads->surcharge_count);
  tp_moved_clear_lines(loads->supports, loads->support_count);
  for (long k = 0; k < loads->anchor_count && loads->anchors != NULL; k++) {
    clear_quantities(&loads->anchors[k].x, &loads->anchors[k].y);
    clear_quantities(&loads->anchors[k].step_x, &loads->anchors[k].step_y);
    fmpq_clear(loads->anchors[k].direction_deg.value);
  }
  free(loads->anchors);
}

void tp_moved_clear(tp_scene *copy) {
  tp_block_description *block = &copy->block;
  tp_polyline_clear(&block->outline);
  tp_polyline_clear(&copy->base.between);
  tp_polyline_clear(&copy->base.profile);
  for (long k = 0; k < block->hole_count && block->holes != NULL; k++) {
    tp_polyline_clear(block->holes + k);
  }
  for (long k = 0; k < block->part_count && block->parts != NULL; k++) {
    tp_polyline_clear(&block->parts[k].outline);
  }
  for (long k = 0; k < block->arc_count && block->arcs != NULL; k++) {
    clear_quantities(&block->arcs[k].x, &block->arcs[k].y);
    clear_quantities(&block->arcs[k].through_x, &block->arcs[k].through_y);
  }
  for (long k = 0; k < block->rounded.count && block->rounded.corners != NULL; k++) {
    clear_quantities(&block->rounded.corners[k].x, &block->rounded.corners[k].y);
  }
  tp_moved_clear_loads(copy);
  free(block->holes);
  free(block->parts);
  free(block->arcs);
  free(block->rounded.corners);
}
