/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A table of mechanisms and outcomes, and which quantities there are of one block and of many. */

#include "study/outcome.h"

#include "block_system/governing_case.h"

tp_study_outcome tp_study_outcome_of(tp_mechanism mechanism) {
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
  case TP_INTERLOCKED:
    return TP_STUDY_INTERLOCKED;
  case TP_MAY_MOVE:
    return TP_STUDY_MAY_MOVE;
  default:
    return TP_STUDY_UNDECIDED;
  }
}

tp_study_outcome tp_study_outcome_of_system(const tp_system_case *own) {
  const tp_mechanism mechanism = tp_system_case_mechanism(own);
  switch (tp_system_case_worst_verdict(own)) {
  case TP_SYSTEM_STANDS:
    return TP_STUDY_STANDS;
  case TP_SYSTEM_CAN_HOLD:
  case TP_SYSTEM_MAY_MOVE:
    return TP_STUDY_MAY_MOVE;
  case TP_SYSTEM_COLLAPSES:
    return mechanism == TP_STANDS ? TP_STUDY_SLIDES_AND_TOPPLES : tp_study_outcome_of(mechanism);
  default:
    return TP_STUDY_UNDECIDED;
  }
}

bool tp_study_is_of_many(const tp_study *study) {
  return tp_scene_block_count(study->scene) > 0;
}

bool tp_study_is_of_solid(const tp_study *study) {
  return tp_scene_is_solid(study->scene);
}

size_t tp_study_quantity_count(const tp_study *study) {
  return tp_study_is_of_many(study) || tp_study_is_of_solid(study) ? TP_STUDY_QUANTITIES
                                                                   : TP_STUDY_FOS + 1;
}

bool tp_study_has_quantity(const tp_study *study, tp_study_quantity quantity) {
  if (tp_study_is_of_solid(study)) {
    return quantity == TP_STUDY_LIMIT_DEG || quantity == TP_STUDY_FOS ||
           quantity == TP_STUDY_ACCELERATION_G;
  }
  if (!tp_study_is_of_many(study)) return quantity <= TP_STUDY_FOS;
  if (quantity == TP_STUDY_SUPPORT_N_M) return study->scene->many.support.place.file != NULL;
  return quantity != TP_STUDY_MOMENTS_DEG && quantity != TP_STUDY_ONSET_DEG;
}

bool tp_study_has_stance(const tp_study *study) {
  const tp_scene *scene = study->scene;
  return scene->tilt_angle_deg.given || scene->solid.dip_deg.given ||
         scene->solid.wedge.place.file != NULL ||
         (tp_study_is_of_solid(study) && scene->loads.horizontal.given) ||
         (!tp_study_is_of_solid(study) && tp_scene_lies_in_place(scene));
}

bool tp_study_quantity_is_factor(tp_study_quantity quantity) {
  return quantity == TP_STUDY_FOS || quantity == TP_STUDY_FOS_GOODMAN_BRAY;
}
