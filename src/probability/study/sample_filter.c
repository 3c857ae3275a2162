/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Tells which variables are friction, tilt or numbers of loads, converts a sample's numbers to
 * doubles with bounds, and fills the row from a case filter. */

#include "study/sample_filter.h"

#include "number/near_angle.h"
#include "study/outcome.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* What a number that varies is. */
typedef enum tp_sample_part {
  TP_SAMPLE_FRICTION,
  TP_SAMPLE_TILT,
  TP_SAMPLE_THICKNESS, /* on which nothing in a row depends, but for bolts */
  TP_SAMPLE_BLOCK,
  TP_SAMPLE_LOAD /* and on, by tp_load_number */
} tp_sample_part;

struct tp_sample_filter {
  tp_case_filter *of;
  int *parts; /* by variable */
  bool has_tilt, on_slope;
  tp_near friction_deg, tilt_deg; /* of the scene, where they do not vary; on a slope its dip */
};

/* ---- which samples -----------------------------------------------------------------------------
 */

static bool is_key(const tp_scene_key *key, const tp_study *study, const char *text) {
  tp_scene_key other;
  tp_message unused;
  return tp_scene_key_find(&other, study->scene, text, &unused) == TP_OK &&
         tp_scene_key_same(key, &other);
}

/* On a slope the dip is the tilt. */
static const char *tilt_key_of(const tp_study *study) {
  return study->scene->frame == TP_FRAME_SLOPE ? "slope.dip_deg" : "tilt.angle_deg";
}

static int part_of(const tp_scene_key *key, const tp_study *study) {
  if (is_key(key, study, "friction_angle_deg")) return TP_SAMPLE_FRICTION;
  if (is_key(key, study, tilt_key_of(study))) return TP_SAMPLE_TILT;
  if (is_key(key, study, "block.thickness")) return TP_SAMPLE_THICKNESS;
  for (int k = 0; k < TP_LOAD_NUMBERS; k++) {
    if (is_key(key, study, tp_load_number_key((tp_load_number)k))) return TP_SAMPLE_LOAD + k;
  }
  return TP_SAMPLE_BLOCK;
}

/* A double is the decimal that names it to half a unit of its last place. */
static tp_near near_of(double number) {
  return (tp_near){number, number == rint(number) && fabs(number) < 0x1p52
                               ? 0
                               : fabs(number) * DBL_EPSILON + DBL_MIN};
}

/* Cut off: within one unit of its last place. */
static tp_near near_of_rational(const fmpq_t value) {
  const double number = fmpq_get_d(value);
  if (fmpz_is_one(fmpq_denref(value))) return near_of(number);
  return (tp_near){number, fabs(number) * DBL_EPSILON + DBL_MIN};
}

/* With room for all that varies. */
static tp_sample_filter *allocate(size_t variables) {
  tp_sample_filter *own = calloc(1, sizeof *own);
  int *parts = calloc(variables + 1, sizeof *parts);
  if (own != NULL && parts != NULL) {
    own->parts = parts;
    return own;
  }
  free(own);
  free(parts);
  return NULL;
}

/* Do the loads that stay with the block stay the same, too? */
static bool keeps_loads(const tp_sample_filter *own, const tp_study *study) {
  const tp_staying_plan *staying = &own->of->loads.staying;
  bool keeps = !(staying->knows_tilt && study->tilt_count > 0);
  for (size_t k = 0; k < study->variable_count; k++) {
    keeps = keeps && !(staying->knows_tilt && own->parts[k] == TP_SAMPLE_TILT) &&
            !(staying->knows_thickness && own->parts[k] == TP_SAMPLE_THICKNESS);
  }
  return keeps;
}

static tp_status find(tp_sample_filter *own, const tp_study *study, tp_message *message) {
  const tp_scene *scene = study->scene;
  tp_scene_key keys[TP_AFFINE_VARIABLES];
  size_t count = 0;
  for (size_t k = 0; k < study->variable_count; k++) {
    const tp_scene_key *key = &study->variables[k].key;
    own->parts[k] = part_of(key, study);
    const bool weighs = own->parts[k] == TP_SAMPLE_LOAD + TP_NUMBER_UNIT_WEIGHT;
    if (weighs && scene->block.part_count > 0) return TP_OK; /* it moves the centroid */
    if (own->parts[k] != TP_SAMPLE_BLOCK) continue;
    if (count == TP_AFFINE_VARIABLES) return TP_OK;
    keys[count++] = *key;
  }
  own->on_slope = scene->frame == TP_FRAME_SLOPE;
  if (own->on_slope && scene->tilt_angle_deg.given) return TP_OK; /* it is added to the dip */
  own->has_tilt = scene->tilt_angle_deg.given || own->on_slope;
  own->friction_deg = near_of_rational(scene->friction_angle_deg.value);
  own->tilt_deg =
      near_of_rational(own->on_slope ? scene->slope.dip_deg.value : scene->tilt_angle_deg.value);
  const tp_status status = tp_case_filter_new(&own->of, scene, keys, count, message);
  if (own->of == NULL || keeps_loads(own, study)) return status;
  free(own->of);
  own->of = NULL;
  return status;
}

tp_status tp_sample_filter_new(tp_sample_filter **filter, const tp_study *study,
                               tp_message *message) {
  *filter = NULL;
  tp_sample_filter *own = allocate(study->variable_count);
  if (own == NULL) return tp_fail_memory(message, "the study");
  const tp_status status = find(own, study, message);
  if (own->of != NULL) {
    *filter = own;
  } else {
    tp_sample_filter_free(own);
  }
  return status;
}

void tp_sample_filter_free(tp_sample_filter *filter) {
  if (filter == NULL) return;
  free(filter->of);
  free(filter->parts);
  free(filter);
}

/* ---- a row -------------------------------------------------------------------------------------
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
      part == TP_SAMPLE_LOAD + TP_NUMBER_HORIZONTAL || part == TP_SAMPLE_LOAD + TP_NUMBER_VERTICAL;
  const bool is_water = part == TP_SAMPLE_LOAD + TP_NUMBER_WATER_HEIGHT ||
                        part == TP_SAMPLE_LOAD + TP_NUMBER_WATER_WEIGHT;
  if (value == 0) return is_share || is_water;
  return size >= least && size <= most && (value > 0 || is_share || part == TP_SAMPLE_BLOCK);
}

static bool take_values(numbers *n, const tp_sample_filter *f, const tp_study_row *row,
                        size_t count) {
  size_t next = 0;
  n->sample.friction_deg = f->friction_deg;
  n->sample.variables = n->variables;
  memcpy(n->sample.numbers, f->of->loads.numbers, sizeof n->sample.numbers);
  n->tilt_deg = f->tilt_deg;
  for (size_t k = 0; k < count; k++) {
    const int part = f->parts[k];
    if (!is_taken(row->values[k], part)) return false;
    const tp_near own = near_of(row->values[k]);
    if (part == TP_SAMPLE_FRICTION) n->sample.friction_deg = own;
    if (part == TP_SAMPLE_TILT) n->tilt_deg = own;
    if (part == TP_SAMPLE_BLOCK) n->variables[next++] = own;
    if (part >= TP_SAMPLE_LOAD) n->sample.numbers[part - TP_SAMPLE_LOAD] = own;
  }
  return n->sample.friction_deg.value < 89 && n->tilt_deg.value < 89;
}

/* A number as a row shows it, where all of its digits are certain: that of solve, which is as close
 * to the truth as this, has the same. */
static bool take_number(double *number, tp_near told) {
  static const double apart = 2.5e-13; /* of itself: between what is told here and by a solve */
  const double error = told.error + apart * fabs(told.value);
  *number = told.value;
  return tp_study_rounded(told.value - error) == tp_study_rounded(told.value + error);
}

static bool take_case(tp_study_row *row, const tp_case_told *told) {
  double *q = row->quantities;
  row->first = row->limit_mechanism = tp_study_outcome_name(tp_study_outcome_of(told->limit));
  q[TP_STUDY_ONSET_DEG] = q[TP_STUDY_MOMENTS_DEG] = INFINITY;
  return take_number(&row->pivot_x_m, told->pivot_x_m) &&
         take_number(&row->pivot_y_m, told->pivot_y_m) &&
         (told->never_topples || take_number(q + TP_STUDY_MOMENTS_DEG, told->moments_deg)) &&
         take_number(q + TP_STUDY_LIMIT_DEG, told->limit_deg) &&
         (told->never || take_number(q + TP_STUDY_ONSET_DEG, told->onset_deg));
}

static bool take_factor(double *number, tp_fos_told told) {
  *number = INFINITY;
  return told.state != TP_FOS_NUMBER || take_number(number, told.value);
}

static bool take_at(tp_study_at *at, tp_case_told_at *of, const tp_case_told *told,
                    tp_near tilt_deg) {
  if (!tp_case_filter_tell_at(of, told, tilt_deg)) return false;
  at->outcome = tp_study_outcome_of(of->mechanism);
  return take_factor(&at->fos, of->fos);
}

/* At the scene's own tilt; of a scene without one what happens first stands for it. */
static bool take_own(tp_study_row *row, const tp_case_told *told, tp_near tilt_deg, bool has_tilt) {
  tp_case_told_at own;
  row->tilt_deg = NAN;
  row->fos_mechanism = "";
  row->fos_definition = -1;
  row->quantities[TP_STUDY_FOS] = row->fos_moments = row->fos_sliding = NAN;
  row->at[0] = (tp_study_at){tp_study_outcome_of(told->limit), NAN};
  if (!has_tilt) return true;
  if (!take_at(row->at, &own, told, tilt_deg)) return false;
  row->tilt_deg = tilt_deg.value;
  row->quantities[TP_STUDY_FOS] = row->at[0].fos;
  row->fos_mechanism = tp_study_outcome_name(tp_study_outcome_of(own.fos_mechanism));
  row->fos_definition = (int)own.fos_definition;
  return take_factor(&row->fos_moments, own.by_moments) &&
         take_factor(&row->fos_sliding, own.by_shear);
}

bool tp_sample_filter_tell(tp_study_row *row, const tp_study *study, size_t tilts) {
  const tp_sample_filter *f = study->filter;
  numbers n;
  tp_case_told told;
  if (f == NULL || (f->on_slope && tilts > 0) || !take_values(&n, f, row, study->variable_count) ||
      !tp_case_filter_tell(&told, f->of, &n.sample) || !take_case(row, &told) ||
      !take_own(row, &told, n.tilt_deg, f->has_tilt)) {
    return false;
  }
  for (size_t k = 0; k < tilts; k++) {
    tp_case_told_at at;
    if (!take_at(row->at + k + 1, &at, &told, near_of(study->tilts[k]))) return false;
  }
  row->open = false;
  row->why = NULL;
  return true;
}
