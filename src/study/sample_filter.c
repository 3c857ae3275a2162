/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "study/sample_filter.h"

#include "number/near_angle.h"

#include <math.h>
#include <stdlib.h>

/* What a number that varies is. */
typedef enum tp_sample_part { TP_SAMPLE_FRICTION, TP_SAMPLE_TILT, TP_SAMPLE_WEIGHT } tp_sample_part;

struct tp_sample_filter {
  tp_case_filter *of;
  tp_sample_part *parts; /* by variable */
  bool has_tilt;
  tp_near friction_deg, tilt_deg; /* of the scene, where they do not vary */
};

/* ---- which samples -----------------------------------------------------------------------------
 */

static bool is_key(const tp_scene_key *key, const tp_study *study, const char *text) {
  tp_scene_key other;
  tp_message unused;
  return tp_scene_key_find(&other, study->scene, text, &unused) == TP_OK &&
         tp_scene_key_same(key, &other);
}

static bool find_part(tp_sample_part *part, const tp_scene_key *key, const tp_study *study) {
  if (is_key(key, study, "friction_angle_deg")) {
    *part = TP_SAMPLE_FRICTION;
  } else if (is_key(key, study, "tilt.angle_deg")) {
    *part = TP_SAMPLE_TILT;
  } else if (is_key(key, study, "block.unit_weight_kn_m3") ||
             is_key(key, study, "block.thickness")) {
    *part = TP_SAMPLE_WEIGHT;
  } else {
    return false;
  }
  return true;
}

/* A double is the decimal that names it to half a unit of its last place. */
static tp_near near_of(double number) {
  return (tp_near){number, number == rint(number) && fabs(number) < 0x1p52
                               ? 0
                               : fabs(number) * DBL_EPSILON + DBL_MIN};
}

static tp_near near_of_rational(const fmpq_t value) {
  return near_of(fmpq_get_d(value)); /* truncated: within one unit */
}

tp_status tp_sample_filter_new(tp_sample_filter **filter, const tp_study *study,
                               tp_message *message) {
  const tp_scene *scene = study->scene;
  *filter = NULL;
  tp_sample_part *parts = calloc(study->variable_count + 1, sizeof *parts);
  tp_sample_filter *own = calloc(1, sizeof *own);
  if (parts == NULL || own == NULL) {
    free(parts);
    free(own);
    return tp_fail_memory(message, "the study");
  }
  own->parts = parts;
  bool all = true;
  for (size_t k = 0; k < study->variable_count && all; k++) {
    all = find_part(parts + k, &study->variables[k].key, study);
  }
  const tp_status status = all ? tp_case_filter_new(&own->of, scene, message) : TP_OK;
  if (own->of == NULL) {
    tp_sample_filter_free(own);
    return status;
  }
  own->has_tilt = scene->tilt_angle_deg.given;
  own->friction_deg = near_of_rational(scene->friction_angle_deg.value);
  own->tilt_deg = near_of_rational(scene->tilt_angle_deg.value);
  *filter = own;
  return TP_OK;
}

void tp_sample_filter_free(tp_sample_filter *filter) {
  if (filter == NULL) return;
  free(filter->of);
  free(filter->parts);
  free(filter);
}

/* ---- a row -------------------------------------------------------------------------------------
 */

/* The numbers of a sample; false where one is none that every scene takes. */
static bool take_values(tp_near *friction_deg, tp_near *tilt_deg, const tp_sample_filter *f,
                        const tp_study_row *row, size_t count) {
  static const double least = 1e-6, most = 1e6;
  *friction_deg = f->friction_deg;
  *tilt_deg = f->tilt_deg;
  for (size_t k = 0; k < count; k++) {
    const double value = row->values[k];
    if (!(value >= least && value <= most)) return false;
    if (f->parts[k] == TP_SAMPLE_FRICTION) *friction_deg = near_of(value);
    if (f->parts[k] == TP_SAMPLE_TILT) *tilt_deg = near_of(value);
  }
  return friction_deg->value < 89 && tilt_deg->value < 89;
}

static tp_study_outcome outcome_of(tp_mechanism mechanism) {
  switch (mechanism) {
  case TP_STANDS:
    return TP_STUDY_STANDS;
  case TP_SLIDES:
    return TP_STUDY_SLIDES;
  case TP_TOPPLES:
    return TP_STUDY_TOPPLES;
  case TP_SLIDES_AND_TOPPLES:
    return TP_STUDY_SLIDES_AND_TOPPLES;
  case TP_LEAVES_BASE:
    return TP_STUDY_LEAVES_BASE;
  default:
    return TP_STUDY_MAY_MOVE;
  }
}
