/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A scene with partial factors applied, exactly: weights, pressures, surcharges and forces of
 * anchors times their factor, cohesion and bond over theirs, and tan(phi) over its divisor, which
 * goes along to where that tangent is taken (evaluation/friction.c). The force of an earthquake is
 * k times the weight as it is, so that k is divided by what the weight is multiplied by. */

#include "scene/partial_factors.h"

#include "number/ratio.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Groups of actions, by their bits in a combination. */
typedef enum group { WEIGHT, WATER, PRESSURES, SURCHARGES, GROUPS } group;

static const tp_partial_factor unfavourable[GROUPS] = {
    TP_PARTIAL_PERMANENT_UNFAVOURABLE, TP_PARTIAL_WATER_UNFAVOURABLE,
    TP_PARTIAL_PERMANENT_UNFAVOURABLE, TP_PARTIAL_VARIABLE_UNFAVOURABLE};
static const tp_partial_factor favourable[GROUPS] = {
    TP_PARTIAL_PERMANENT_FAVOURABLE, TP_PARTIAL_WATER_FAVOURABLE, TP_PARTIAL_PERMANENT_FAVOURABLE,
    TP_PARTIAL_VARIABLE_FAVOURABLE};

/* What an action is multiplied by: of moments alone, over the factor of what drives. */
static void take(fmpq_t factor, const tp_partial_factors *own, tp_partial_factor which) {
  fmpq_set(factor, own->values + which);
  if (!own->toppling_alone) return;
  fmpq_div(factor, factor, own->values + TP_PARTIAL_PERMANENT_UNFAVOURABLE);
  if (which == TP_PARTIAL_EARTHQUAKE && fmpq_cmp_si(factor, 1) < 0) fmpq_one(factor);
}

static void take_group(fmpq_t factor, const tp_scene *scene, group of, unsigned combination) {
  const tp_partial_factors *own = scene->partial_factors;
  if (of == WEIGHT && own->toppling_alone) {
    fmpq_one(factor); /* its moments are compared with each other by the resistance */
  } else {
    take(factor, own, combination >> of & 1 ? favourable[of] : unfavourable[of]);
  }
}

/* Is there an action of a group? */
static bool acts(const tp_scene *scene, group of) {
  const tp_loads_description *loads = &scene->loads;
  switch (of) {
  case WEIGHT:
    return scene->block.unit_weight_kn_m3.given;
  case WATER:
    return loads->water.given;
  case PRESSURES:
    return loads->pressure_count > 0;
  case SURCHARGES:
    return loads->surcharge_count > 0;
  case GROUPS:
    break;
  }
  return false;
}

/* Does it act, and with another factor where it is favourable? */
static bool has_two(const tp_scene *scene, group of) {
  const tp_partial_factors *own = scene->partial_factors;
  if (of == WEIGHT && own->toppling_alone) return false;
  return acts(scene, of) &&
         fmpq_equal(own->values + unfavourable[of], own->values + favourable[of]) == 0;
}

bool tp_combination_differs(const tp_scene *scene, unsigned combination) {
  for (int k = 0; k < GROUPS; k++) {
    if ((combination >> k & 1) && !has_two(scene, (group)k)) return false;
  }
  return true;
}

/* A number of the copy becomes its own, times a factor. */
static void scale(fmpq_t value, const fmpq_t factor) {
  const fmpq held = *value;
  fmpq_init(value);
  fmpq_mul(value, &held, factor);
}

static void scale_over(fmpq_t value, const fmpq_t divisor) {
  const fmpq held = *value;
  fmpq_init(value);
  fmpq_div(value, &held, divisor);
}

/* A copy of an array, with room for one at least; NULL where memory is exhausted. */
static void *copied(const void *items, long count, size_t size) {
  void *copy = malloc((size_t)count * size + 1);
  if (copy != NULL && count > 0) memcpy(copy, items, (size_t)count * size);
  return copy;
}

static void scale_lines(tp_line_load *loads, long count, const fmpq_t factor) {
  for (long k = 0; k < count; k++) {
    scale(loads[k].first_kpa.value, factor);
    scale(loads[k].last_kpa.value, factor);
  }
}

static void clear_lines(tp_line_load *loads, long count) {
  for (long k = 0; k < count && loads != NULL; k++) {
    fmpq_clear(loads[k].first_kpa.value);
    fmpq_clear(loads[k].last_kpa.value);
  }
  free(loads);
}

static void scale_weight(tp_scene *copy, const tp_partial_factors *own, const fmpq_t weight) {
  tp_loads_description *loads = &copy->loads;
  fmpq_t shaken;
  fmpq_init(shaken);
  take(shaken, own, TP_PARTIAL_EARTHQUAKE);
  fmpq_div(shaken, shaken, weight);
  scale(copy->block.unit_weight_kn_m3.value, weight);
  for (long k = 0; k < copy->block.part_count; k++) {
    scale(copy->block.parts[k].unit_weight_kn_m3.value, weight);
  }
  scale(loads->horizontal.value, shaken);
  scale(loads->vertical.value, shaken);
  fmpq_clear(shaken);
}

static void scale_anchors(tp_scene *copy, const tp_partial_factors *own) {
  fmpq_t active;
  fmpq_init(active);
  take(active, own, TP_PARTIAL_PERMANENT_FAVOURABLE);
  for (long k = 0; k < copy->loads.anchor_count; k++) {
    tp_anchor_description *anchor = copy->loads.anchors + k;
    if (anchor->passive) {
      scale_over(anchor->force_kn.value, own->values + TP_PARTIAL_ANCHOR);
    } else {
      scale(anchor->force_kn.value, active);
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

tp_status tp_factored_init(tp_scene *copy, const tp_scene *scene, unsigned combination,
                           tp_message *message) {
  const tp_partial_factors *own = scene->partial_factors;
  tp_loads_description *loads = &copy->loads;
  *copy = *scene;
  copy->factored = true;
  copy->friction_divisor = own->values + TP_PARTIAL_FRICTION;
  copy->block.parts =
      copied(scene->block.parts, scene->block.part_count, sizeof *scene->block.parts);
  loads->pressures =
      copied(scene->loads.pressures, loads->pressure_count, sizeof *scene->loads.pressures);
  loads->surcharges =
      copied(scene->loads.surcharges, loads->surcharge_count, sizeof *scene->loads.surcharges);
  loads->anchors = copied(scene->loads.anchors, loads->anchor_count, sizeof *scene->loads.anchors);
  if (copy->block.parts == NULL || loads->pressures == NULL || loads->surcharges == NULL ||
      loads->anchors == NULL) {
    free(copy->block.parts);
    free(loads->pressures);
    free(loads->surcharges);
    free(loads->anchors);
    return tp_fail_memory(message, "the partial factors");
  }
  fmpq_t factor;
  fmpq_init(factor);
  take_group(factor, scene, WEIGHT, combination);
  scale_weight(copy, own, factor);
  take_group(factor, scene, WATER, combination);
  scale(loads->water.unit_weight_kn_m3.value, factor);
  take_group(factor, scene, PRESSURES, combination);
  scale_lines(loads->pressures, loads->pressure_count, factor);
  take_group(factor, scene, SURCHARGES, combination);
  scale_lines(loads->surcharges, loads->surcharge_count, factor);
  scale_anchors(copy, own);
  scale_over(loads->cohesion_kpa.value, own->values + TP_PARTIAL_COHESION);
  scale_over(loads->bond_kpa.value, own->values + TP_PARTIAL_COHESION);
  set_required(copy, own);
  fmpq_clear(factor);
  return TP_OK;
}

void tp_factored_clear(tp_scene *copy) {
  tp_loads_description *loads = &copy->loads;
  for (long k = 0; k < copy->block.part_count; k++) {
    fmpq_clear(copy->block.parts[k].unit_weight_kn_m3.value);
  }
  free(copy->block.parts);
  clear_lines(loads->pressures, loads->pressure_count);
  clear_lines(loads->surcharges, loads->surcharge_count);
  for (long k = 0; k < loads->anchor_count; k++) fmpq_clear(loads->anchors[k].force_kn.value);
  free(loads->anchors);
  fmpq_clear(copy->block.unit_weight_kn_m3.value);
  fmpq_clear(loads->horizontal.value);
  fmpq_clear(loads->vertical.value);
  fmpq_clear(loads->water.unit_weight_kn_m3.value);
  fmpq_clear(loads->cohesion_kpa.value);
  fmpq_clear(loads->bond_kpa.value);
  fmpq_clear(copy->required_fos.value);
}

/* ---- in words ----------------------------------------------------------------------------------
 */

static const char *const names[GROUPS] = {"weight", "water", "pressures", "surcharges"};

static void add(char *text, size_t size, const char *what, const char *how, const fmpq_t value) {
  char number[64];
  const size_t used = strlen(text);
  tp_ratio_text(number, sizeof number, value);
  snprintf(text + used, size - used, "%s%s %s %s", used > 0 ? ", " : "", what, how, number);
}

char *tp_factored_text(const tp_scene *scene, unsigned combination) {
  enum { SIZE = 600 };
  const tp_partial_factors *own = scene->partial_factors;
  const tp_loads_description *loads = &scene->loads;
  char *text = calloc(1, SIZE);
  fmpq_t factor;
  if (text == NULL) return NULL;
  fmpq_init(factor);
  for (int k = 0; k < GROUPS; k++) {
    if (!acts(scene, (group)k)) continue;
    take_group(factor, scene, (group)k, combination);
    add(text, SIZE, names[k], "×", factor);
  }
  if (loads->seismic_place.file != NULL) {
    take(factor, own, TP_PARTIAL_EARTHQUAKE);
    add(text, SIZE, "earthquake", "×", factor);
  }
  bool active = false, passive = false;
  for (long k = 0; k < loads->anchor_count; k++) {
    active = active || !loads->anchors[k].passive;
    passive = passive || loads->anchors[k].passive;
  }
  take(factor, own, TP_PARTIAL_PERMANENT_FAVOURABLE);
  if (active) add(text, SIZE, "active anchors", "×", factor);
  if (passive) add(text, SIZE, "passive anchors", "/", own->values + TP_PARTIAL_ANCHOR);
  if (scene->friction_angle_deg.given) {
    add(text, SIZE, "tan φ", "/", own->values + TP_PARTIAL_FRICTION);
  }
  if (loads->cohesion_kpa.given || loads->bond_kpa.given) {
    add(text, SIZE, "cohesion and bond", "/", own->values + TP_PARTIAL_COHESION);
  }
  fmpq_clear(factor);
  return text;
}

void tp_combination_text(char *text, size_t size, const tp_scene *scene, unsigned combination) {
  size_t used = 0;
  *text = '\0';
  for (int k = 0; k < GROUPS && used < size; k++) {
    if (!has_two(scene, (group)k)) continue;
    snprintf(text + used, size - used, "%s%s %s", used > 0 ? ", " : "", names[k],
             combination >> k & 1 ? "favourable" : "unfavourable");
    used = strlen(text);
  }
}
