/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The filter of a study's variables, and rows filled from what it tells. */

#include "study/sample_filter.h"

#include "solid_tilt/solid_body.h"
#include "study/outcome.h"

#include <math.h>
#include <stdlib.h>

tp_status tp_sample_filter_new(tp_keyed_filter **filter, const tp_study *study,
                               tp_message *message) {
  *filter = NULL;
  if (tp_study_is_of_many(study)) return TP_OK;
  if (tp_study_is_of_solid(study)) { /* the surface once for all samples */
    const tp_solid_body *body = NULL;
    return tp_solid_body_of_scene(&body, study->scene, message);
  }
  tp_scene_key *keys = calloc(study->variable_count + 1, sizeof *keys);
  if (keys == NULL) return tp_fail_memory(message, "the study");
  for (size_t k = 0; k < study->variable_count; k++) keys[k] = study->variables[k].key;
  const tp_status status = tp_keyed_filter_new(filter, study->scene, keys, study->variable_count,
                                               study->tilt_count > 0, message);
  free(keys);
  return status;
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
  for (int k = TP_STUDY_FOS + 1; k < TP_STUDY_QUANTITIES; k++) q[k] = NAN;
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

static bool take_at(tp_study_at *at, tp_case_told_at *of, tp_case_told *told, tp_near tilt_deg) {
  if (!tp_case_filter_tell_at(of, told, tilt_deg)) return false;
  at->outcome = tp_study_outcome_of(of->mechanism);
  return take_factor(&at->fos, of->fos);
}

/* At the scene's own tilt; of a scene without one what happens first stands for it. */
static bool take_own(tp_study_row *row, tp_case_told *told, tp_near tilt_deg, bool has_tilt) {
  tp_case_told_at own;
  row->tilt_deg = NAN;
  row->fos_mechanism = "";
  row->fos_definition = row->design = -1;
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

/* At the scene's own tilt, and what does not depend on it, which follows the state that governs
 * there. */
static bool take_row(tp_study_row *row, tp_case_told *told, tp_near tilt_deg, bool has_tilt) {
  return take_own(row, told, tilt_deg, has_tilt) && take_case(row, told);
}

/* The same of a copy, as another tilt may have another state that governs. */
static bool take_copy(tp_study_row *row, tp_study_at *at, const tp_case_told *told,
                      tp_near tilt_deg, bool has_tilt) {
  tp_case_told copy = *told;
  tp_case_told_at of;
  return at == NULL ? take_row(row, &copy, tilt_deg, has_tilt) : take_at(at, &of, &copy, tilt_deg);
}

bool tp_sample_filter_tell(tp_study_row *row, const tp_study *study, size_t tilts) {
  const tp_keyed_filter *f = study->filter;
  tp_case_told told;
  tp_near tilt_deg;
  if (f == NULL || (f->lies_in_place && tilts > 0) ||
      !tp_keyed_filter_tell(&told, &tilt_deg, f, row->values)) {
    return false;
  }
  const bool shares = f->of->loads.shakes && tilts > 0;
  if (!(shares ? take_copy(row, NULL, &told, tilt_deg, f->has_tilt)
               : take_row(row, &told, tilt_deg, f->has_tilt))) {
    return false;
  }
  for (size_t k = 0; k < tilts; k++) {
    tp_case_told_at at;
    const tp_near tilt = tp_keyed_number(study->tilts[k]);
    tp_study_at *of = row->at + k + 1;
    if (!(shares ? take_copy(row, of, &told, tilt, true) : take_at(of, &at, &told, tilt))) {
      return false;
    }
  }
  row->open = false;
  row->why = NULL;
  return true;
}
