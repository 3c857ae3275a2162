/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Lower end of the first window of motion at a given precision, for the comparison of topple
 * accuracy; without load-dependent friction, cohesion or bonds. */

#include "onset/onset_price.h"

#include "evaluation/friction.h"
#include "onset/onset_question.h"
#include "onset/onset_result.h"

/* The lower end of the first window. */
static tp_motion_outcome find(arb_t degrees, bool *found, const tp_motion_question *question) {
  tp_motions motions;
  tp_motion_windows windows;
  tp_motion_outcome done = tp_motions_init(&motions, question);
  if (done != TP_MOTION_PROVEN) return done;
  done = tp_windows_init(&windows, &motions, &question->judge);
  if (done == TP_MOTION_PROVEN) {
    const long first = tp_onset_first_window(&windows, &question->judge);
    *found = first >= 0 && !windows.items[first].from.endless;
    if (*found) arb_set(degrees, windows.items[first].from.degrees);
    tp_windows_clear(&windows);
  }
  tp_motions_clear(&motions);
  return done;
}

tp_status tp_evaluate_onset_at_price(arb_t degrees, bool *found, const tp_evaluation *e,
                                     tp_direction towards) {
  *found = false;
  if (tp_friction_is_load_dependent(e) || tp_onset_has_strength(e)) return TP_OK;
  tp_onset_asked asked;
  if (!tp_onset_asked_init(&asked, e, towards, NULL)) return TP_OUT_OF_MEMORY;
  tp_work work = {.spent = 0};
  tp_work_begin(&work, tp_cones_column_count(&asked.cones));
  asked.question.work = &work;
  arb_t friction;
  arb_init(friction);
  tp_friction_at(friction, e, friction);
  tp_friction_tangent(asked.cones.friction, friction, e->rung.bits);
  arb_clear(friction);
  const tp_motion_outcome outcome = find(degrees, found, &asked.question);
  tp_onset_asked_clear(&asked);
  return outcome == TP_MOTION_OUT_OF_MEMORY ? TP_OUT_OF_MEMORY : TP_OK;
}
