/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Names of ends, engines, protocols and events, and notes on stiffness and on the baseline of a
 * record. */

#include "tilt/words.h"

#include "common/notes.h"

#include <math.h>

/* A record whose velocity does not come back to zero pushes the block beyond its motion. */
static tp_status note_baseline(tp_tilt_test *test, const tp_scene *scene, tp_message *message) {
  static const double share = 0.05;
  for (int axis = 0; axis < TP_SHAKING_AXES; axis++) {
    const tp_tilt_shaking *own = test->shaking + axis;
    if (scene->shaking[axis].form != TP_SHAKING_RECORD) continue;
    if (fabs(own->last_velocity_m_s) <= share * own->peak_velocity_m_s) continue;
    const tp_status status = tp_notes_add(
        &test->notes, message, TP_CAUTION, scene->shaking[axis].place,
        "the %s record leaves its base with a velocity of %.3g m/s, %.0f %% of its "
        "peak: its baseline is not corrected, here or in the file",
        axis == TP_SHAKING_HORIZONTAL ? "horizontal" : "vertical", own->last_velocity_m_s,
        100 * fabs(own->last_velocity_m_s) / own->peak_velocity_m_s);
    if (status != TP_OK) return status;
  }
  return TP_OK;
}

tp_status tp_tilt_notes(tp_tilt_test *test, const tp_scene *scene, tp_message *message) {
  const tp_tilt_settings *s = &test->settings;
  tp_status status = note_baseline(test, scene, message);
  if (status == TP_OK && s->engine == TP_TILT_PATH && !s->stiffness_given) {
    status = tp_notes_add(&test->notes, message, TP_NOTE, scene->tilt_test.place,
                          "no stiffness is given: the path takes 1000 and 10 GPa/m, as the paper; "
                          "in the limit of stiff contacts its angles depend on their ratio alone");
  }
  if (status == TP_OK && !scene->block.unit_weight_kn_m3.given) {
    status = tp_notes_add(&test->notes, message, TP_NOTE, scene->block.place,
                          "no unit weight is given: forces and energies are those of 1 kN/m3");
  }
  return status;
}
