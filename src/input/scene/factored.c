/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A scene with partial factors applied, exactly: weights, pressures, surcharges and forces of
 * anchors times their factor, cohesion and bond over theirs, and tan(phi) over its divisor, which
 * goes along to where that tangent is taken (evaluation/friction.c). The force of an earthquake is
 * k times the weight as it is, so that k is divided by what the weight is multiplied by. */

#include "scene/factored.h"

#include <stdlib.h>
#include <string.h>

static const tp_partial_factor unfavourable[TP_ACTION_GROUPS] = {
    TP_PARTIAL_PERMANENT_UNFAVOURABLE, TP_PARTIAL_WATER_UNFAVOURABLE,
    TP_PARTIAL_PERMANENT_UNFAVOURABLE, TP_PARTIAL_VARIABLE_UNFAVOURABLE};
static const tp_partial_factor favourable[TP_ACTION_GROUPS] = {
    TP_PARTIAL_PERMANENT_FAVOURABLE, TP_PARTIAL_WATER_FAVOURABLE, TP_PARTIAL_PERMANENT_FAVOURABLE,
    TP_PARTIAL_VARIABLE_FAVOURABLE};

/* What an action is multiplied by: of moments alone, over the factor of what drives. */
void tp_action_factor_of(fmpq_t factor, const tp_partial_factors *own, tp_partial_factor which) {
  fmpq_set(factor, own->values + which);
  if (!own->toppling_alone) return;
  fmpq_div(factor, factor, own->values + TP_PARTIAL_PERMANENT_UNFAVOURABLE);
  if (which == TP_PARTIAL_EARTHQUAKE && fmpq_cmp_si(factor, 1) < 0) fmpq_one(factor);
}

void tp_action_factor(fmpq_t factor, const tp_scene *scene, tp_action_group of,
                      unsigned combination) {
  const tp_partial_factors *own = scene->partial_factors;
  if (of == TP_ACTION_WEIGHT && own->toppling_alone) {
    fmpq_one(factor); /* its moments are compared with each other by the resistance */
  } else {
    tp_action_factor_of(factor, own, combination >> of & 1 ? favourable[of] : unfavourable[of]);
  }
}

/* Of those that have weight all have, or the scene says it for all. */
static bool has_weighed_block(const tp_block_list *many) {
  bool has = false;
  for (long k = 0; k < many->count && !has; k++) {
    has = many->blocks[k].shape.unit_weight_kn_m3.given;
  }
  return has;
}

bool tp_action_acts(const tp_scene *scene, tp_action_group of) {
  const tp_loads_description *loads = &scene->loads;
  switch (of) {
  case TP_ACTION_WEIGHT:
    return scene->block.unit_weight_kn_m3.given || has_weighed_block(&scene->many);
  case TP_ACTION_WATER:
    return loads->water.given;
  case TP_ACTION_PRESSURES:
    return loads->pressure_count > 0 || loads->force_count > 0;
  case TP_ACTION_SURCHARGES:
    return loads->surcharge_count > 0;
  case TP_ACTION_GROUPS:
    break;
  }
  return false;
}

bool tp_action_has_two(const tp_scene *scene, tp_action_group of) {
  const tp_partial_factors *own = scene->partial_factors;
  if (of == TP_ACTION_WEIGHT && own->toppling_alone) return false;
  return tp_action_acts(scene, of) &&
         fmpq_equal(own->values + unfavourable[of], own->values + favourable[of]) == 0;
}

bool tp_combination_differs(const tp_scene *scene, unsigned combination) {
  for (int k = 0; k < TP_ACTION_GROUPS; k++) {
    if ((combination >> k & 1) && !tp_action_has_two(scene, (tp_action_group)k)) return false;
  }
  return true;
}

static void scale_lines(tp_line_load *loads, long count, const fmpq_t factor) {
  for (long k = 0; k < count; k++) {
    tp_factored_scale(loads[k].first_kpa.value, factor);
    tp_factored_scale(loads[k].last_kpa.value, factor);
  }
}

static void clear_lines(tp_line_load *loads, long count) {
  for (long k = 0; k < count; k++) {
    fmpq_clear(loads[k].first_kpa.value);
    fmpq_clear(loads[k].last_kpa.value);
  }
  free(loads);
}

static void scale_weight(tp_scene *copy, const tp_partial_factors *own, const fmpq_t weight) {
  tp_loads_description *loads = &copy->loads;
  fmpq_t shaken;
  fmpq_init(shaken);
  tp_action_factor_of(shaken, own, TP_PARTIAL_EARTHQUAKE);
  fmpq_div(shaken, shaken, weight);
  tp_factored_scale(copy->block.unit_weight_kn_m3.value, weight);
  for (long k = 0; k < copy->block.part_count; k++) {
    tp_factored_scale(copy->block.parts[k].unit_weight_kn_m3.value, weight);
  }
  tp_factored_scale(loads->horizontal.value, shaken);
  tp_factored_scale(loads->vertical.value, shaken);
  fmpq_clear(shaken);
}

static void scale_anchors(tp_scene *copy, const tp_partial_factors *own) {
  fmpq_t active;
  fmpq_init(active);
  tp_action_factor_of(active, own, TP_PARTIAL_PERMANENT_FAVOURABLE);
  for (long k = 0; k < copy->loads.anchor_count; k++) {
    tp_anchor_description *anchor = copy->loads.anchors + k;
    if (anchor->passive) {
      tp_factored_scale_over(anchor->force_kn.value, own->values + TP_PARTIAL_ANCHOR);
    } else {
      tp_factored_scale(anchor->force_kn.value, active);
    }
  }
  fmpq_clear(active);
}

/* Of moments the factor of what drives over that of what holds. */
static void set_required(tp_scene *copy, const tp_partial_factors *own) {
  fmpq *required = copy->required_fos.value;
  fmpq_init(required);
  fmpq_set(required, own->values + TP_PARTIAL_RESISTANCE);
  copy->required_fos.given = true;
  copy->required_fos.place = own->place;
  if (!own->toppling_alone) return;
  fmpq_mul(required, required, own->values + TP_PARTIAL_PERMANENT_UNFAVOURABLE);
  fmpq_div(required, required, own->values + TP_PARTIAL_PERMANENT_FAVOURABLE);
}

/* What is factored item by item is copied. */
static bool own_lists(tp_scene *copy, const tp_scene *scene) {
  tp_loads_description *loads = &copy->loads;
  copy->block.parts =
      tp_factored_copy(scene->block.parts, scene->block.part_count, sizeof *copy->block.parts);
  loads->pressures =
      tp_factored_copy(loads->pressures, loads->pressure_count, sizeof *loads->pressures);
  loads->surcharges =
      tp_factored_copy(loads->surcharges, loads->surcharge_count, sizeof *loads->surcharges);
  loads->anchors = tp_factored_copy(loads->anchors, loads->anchor_count, sizeof *loads->anchors);
  loads->forces = tp_factored_copy(loads->forces, loads->force_count, sizeof *loads->forces);
  if (copy->block.parts != NULL && loads->pressures != NULL && loads->surcharges != NULL &&
      loads->anchors != NULL && loads->forces != NULL) {
    return true;
  }
  free(copy->block.parts);
  free(loads->pressures);
  free(loads->surcharges);
  free(loads->anchors);
  free(loads->forces);
  return false;
}

tp_status tp_factored_init(tp_scene *copy, const tp_scene *scene, unsigned combination,
                           tp_message *message) {
  const tp_partial_factors *own = scene->partial_factors;
  tp_loads_description *loads = &copy->loads;
  *copy = *scene;
  copy->factored = true;
  copy->friction_divisor = own->values + TP_PARTIAL_FRICTION;
  if (!own_lists(copy, scene)) return tp_fail_memory(message, "the partial factors");
  fmpq_t factor;
  fmpq_init(factor);
  tp_action_factor(factor, scene, TP_ACTION_WEIGHT, combination);
  scale_weight(copy, own, factor);
  const bool done = tp_factored_blocks_init(copy, factor, own->values + TP_PARTIAL_COHESION);
  tp_action_factor(factor, scene, TP_ACTION_WATER, combination);
  tp_factored_scale(loads->water.unit_weight_kn_m3.value, factor);
  tp_action_factor(factor, scene, TP_ACTION_PRESSURES, combination);
  scale_lines(loads->pressures, loads->pressure_count, factor);
  for (long k = 0; k < loads->force_count; k++) {
    tp_factored_scale(loads->forces[k].force_kn.value, factor);
  }
  tp_action_factor(factor, scene, TP_ACTION_SURCHARGES, combination);
  scale_lines(loads->surcharges, loads->surcharge_count, factor);
  scale_anchors(copy, own);
  tp_factored_scale_over(loads->cohesion_kpa.value, own->values + TP_PARTIAL_COHESION);
  tp_factored_scale_over(loads->bond_kpa.value, own->values + TP_PARTIAL_COHESION);
  set_required(copy, own);
  fmpq_clear(factor);
  if (done) return TP_OK;
  tp_factored_clear(copy);
  return tp_fail_memory(message, "the partial factors");
}

static void clear_pulls(tp_anchor_description *pulls, long count) {
  for (long k = 0; k < count; k++) fmpq_clear(pulls[k].force_kn.value);
  free(pulls);
}

void tp_factored_clear(tp_scene *copy) {
  tp_loads_description *loads = &copy->loads;
  for (long k = 0; k < copy->block.part_count; k++) {
    fmpq_clear(copy->block.parts[k].unit_weight_kn_m3.value);
  }
  free(copy->block.parts);
  tp_factored_blocks_clear(copy);
  clear_lines(loads->pressures, loads->pressure_count);
  clear_lines(loads->surcharges, loads->surcharge_count);
  clear_pulls(loads->anchors, loads->anchor_count);
  clear_pulls(loads->forces, loads->force_count);
  fmpq_clear(copy->block.unit_weight_kn_m3.value);
  fmpq_clear(loads->horizontal.value);
  fmpq_clear(loads->vertical.value);
  fmpq_clear(loads->water.unit_weight_kn_m3.value);
  fmpq_clear(loads->cohesion_kpa.value);
  fmpq_clear(loads->bond_kpa.value);
  fmpq_clear(copy->required_fos.value);
}
