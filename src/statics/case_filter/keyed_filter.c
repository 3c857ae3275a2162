/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Tells which numbers are friction, tilt or numbers of loads, and converts their values to doubles
 * with bounds. */

#include "case_filter/keyed_filter.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* What a number that varies is. */
typedef enum tp_keyed_part {
  TP_KEYED_FRICTION,
  TP_KEYED_TILT,
  TP_KEYED_THICKNESS, /* on which nothing in a row depends, but for bolts */
  TP_KEYED_BLOCK,
  TP_KEYED_LOAD /* and on, by tp_load_number */
} tp_keyed_part;

/* ---- which numbers -----------------------------------------------------------------------------
 */

static bool is_key(const tp_scene_key *key, const tp_scene *scene, const char *text) {
  tp_scene_key other;
  tp_message unused;
  return tp_scene_key_find(&other, scene, text, &unused) == TP_OK && tp_scene_key_same(key, &other);
}

/* On a slope the dip is the tilt. */
static const char *tilt_key_of(const tp_scene *scene) {
  return scene->frame == TP_FRAME_SLOPE ? "slope.dip_deg" : "tilt.angle_deg";
}

static int part_of(const tp_scene_key *key, const tp_scene *scene) {
  if (is_key(key, scene, "friction_angle_deg")) return TP_KEYED_FRICTION;
  if (is_key(key, scene, tilt_key_of(scene)) || is_key(key, scene, "tilt.angle_deg")) {
    return TP_KEYED_TILT;
  }
  if (is_key(key, scene, "block.thickness")) return TP_KEYED_THICKNESS;
  for (int k = 0; k < TP_LOAD_NUMBERS; k++) {
    if (is_key(key, scene, tp_load_number_key((tp_load_number)k))) return TP_KEYED_LOAD + k;
  }
  return TP_KEYED_BLOCK;
}

/* A double is the decimal that names it to half a unit of its last place. */
tp_near tp_keyed_number(double number) {
  return (tp_near){number, number == rint(number) && fabs(number) < 0x1p52
                               ? 0
                               : fabs(number) * DBL_EPSILON + DBL_MIN};
}

/* Cut off: within one unit of its last place. */
static tp_near near_of_rational(const fmpq_t value) {
  const double number = fmpq_get_d(value);
  if (fmpz_is_one(fmpq_denref(value))) return tp_keyed_number(number);
  return (tp_near){number, fabs(number) * DBL_EPSILON + DBL_MIN};
}

/* Do the loads that stay with the block stay the same, too? */
static bool keeps_loads(const tp_keyed_filter *own, size_t count, bool further_tilts) {
  const tp_staying_plan *staying = &own->of->loads.staying;
  bool keeps = !(staying->knows_tilt && further_tilts);
  for (size_t k = 0; k < count; k++) {
    keeps = keeps && !(staying->knows_tilt && own->parts[k] == TP_KEYED_TILT) &&
            !(staying->knows_thickness && own->parts[k] == TP_KEYED_THICKNESS);
  }
  return keeps;
}

/* Is the tilt one of the dip and of what is given beside it, of which one alone varies? */
static bool adds_to_dip(const tp_scene *scene) {
  return scene->frame == TP_FRAME_WORLD ||
         (scene->frame == TP_FRAME_SLOPE && scene->tilt_angle_deg.given);
}

static tp_status find(tp_keyed_filter *own, const tp_scene *scene, const tp_scene_key *keys,
                      bool further_tilts, tp_message *message) {
  tp_scene_key of_block[TP_AFFINE_VARIABLES];
  size_t blocks = 0;
  for (size_t k = 0; k < own->count; k++) {
    own->parts[k] = part_of(keys + k, scene);
    const bool weighs = own->parts[k] == TP_KEYED_LOAD + TP_NUMBER_UNIT_WEIGHT;
    if (weighs && scene->block.part_count > 0) return TP_OK; /* it moves the centroid */
    if (own->parts[k] == TP_KEYED_TILT && adds_to_dip(scene)) return TP_OK;
    if (own->parts[k] != TP_KEYED_BLOCK) continue;
    if (blocks == TP_AFFINE_VARIABLES) return TP_OK;
    of_block[blocks++] = keys[k];
  }
  own->lies_in_place = tp_scene_lies_in_place(scene);
  own->has_tilt = scene->tilt_angle_deg.given || own->lies_in_place;
  own->friction_deg = near_of_rational(scene->friction_angle_deg.value);
  const tp_status status = tp_case_filter_new(&own->of, scene, of_block, blocks, message);
  if (own->of != NULL) own->tilt_deg = own->of->tilt_deg;
  if (own->of == NULL || keeps_loads(own, own->count, further_tilts)) return status;
  free(own->of);
  own->of = NULL;
  return status;
}

/* With room for all that varies. */
static tp_keyed_filter *allocate(size_t count) {
  tp_keyed_filter *own = calloc(1, sizeof *own);
  int *parts = calloc(count + 1, sizeof *parts);
  if (own != NULL && parts != NULL) {
    own->count = count;
    own->parts = parts;
    return own;
  }
  free(own);
  free(parts);
  return NULL;
}

tp_status tp_keyed_filter_new(tp_keyed_filter **filter, const tp_scene *scene,
                              const tp_scene_key *keys, size_t count, bool further_tilts,
                              tp_message *message) {
  *filter = NULL;
  tp_keyed_filter *own = allocate(count);
  if (own == NULL) return tp_fail_memory(message, "the filter");
  const tp_status status = find(own, scene, keys, further_tilts, message);
  if (own->of != NULL) {
    *filter = own;
  } else {
    tp_keyed_filter_free(own);
  }
  return status;
}

void tp_keyed_filter_free(tp_keyed_filter *filter) {
  if (filter == NULL) return;
  free(filter->of);
  free(filter->parts);
  free(filter);
}

/* ---- a sample ----------------------------------------------------------------------------------
 */

/* The numbers of a sample. */
typedef struct numbers {
  tp_case_sample sample;
  tp_near tilt_deg;
  tp_near variables[TP_AFFINE_VARIABLES];
} numbers;

/* Is it a number of its kind that every scene takes? */
static bool is_taken(double value, int part) {
  static const double least = 1e-6, most = 1e6;
  const double size = fabs(value);
  const bool is_share =
      part == TP_KEYED_LOAD + TP_NUMBER_HORIZONTAL || part == TP_KEYED_LOAD + TP_NUMBER_VERTICAL;
  const bool is_water = part == TP_KEYED_LOAD + TP_NUMBER_WATER_HEIGHT ||
                        part == TP_KEYED_LOAD + TP_NUMBER_WATER_WEIGHT;
  if (value == 0) return is_share || is_water;
  return size >= least && size <= most && (value > 0 || is_share || part == TP_KEYED_BLOCK);
}

static bool take_values(numbers *n, const tp_keyed_filter *f, const double *values) {
  size_t next = 0;
  n->sample.friction_deg = f->friction_deg;
  n->sample.variables = n->variables;
  n->sample.at_rest = false;
  memcpy(n->sample.numbers, f->of->loads.numbers, sizeof n->sample.numbers);
  n->tilt_deg = f->tilt_deg;
  for (size_t k = 0; k < f->count; k++) {
    const int part = f->parts[k];
    if (!is_taken(values[k], part)) return false;
    const tp_near own = tp_keyed_number(values[k]);
    if (part == TP_KEYED_FRICTION) n->sample.friction_deg = own;
    if (part == TP_KEYED_TILT) n->tilt_deg = own;
    if (part == TP_KEYED_BLOCK) n->variables[next++] = own;
    if (part >= TP_KEYED_LOAD) n->sample.numbers[part - TP_KEYED_LOAD] = own;
  }
  return n->sample.friction_deg.value < 89 && n->tilt_deg.value < 89;
}

bool tp_keyed_filter_tell(tp_case_told *told, tp_near *tilt_deg, const tp_keyed_filter *f,
                          const double *values) {
  numbers n;
  if (!take_values(&n, f, values)) return false;
  *tilt_deg = n.tilt_deg;
  return tp_case_filter_tell(told, f->of, &n.sample);
}
