/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

#include "tilt/engines.h"

static tp_run_end run_springs(tp_body_state *last, const tp_run *run, const void *settings,
                              tp_message *message) {
  return tp_springs_run(last, run, settings, message);
}

static tp_run_end run_rigid(tp_body_state *last, const tp_run *run, const void *settings,
                            tp_message *message) {
  return tp_rigid_contact_run(last, run, settings, message);
}

tp_tilt_dynamics tp_tilt_dynamics_of(tp_tilt_engine_settings *own, const tp_tilt_settings *s) {
  if (s->engine == TP_TILT_SPRINGS) {
    own->springs = (tp_spring_settings){.normal_pa_m = s->normal_stiffness_pa_m,
                                        .shear_pa_m = s->shear_stiffness_pa_m,
                                        .damping = s->damping,
                                        .rounding_m = s->rounding_m,
                                        .time_step_s = s->time_step_s};
    return (tp_tilt_dynamics){run_springs, &own->springs};
  }
  own->rigid = tp_rigid_contact_settings_default();
  own->rigid.law.restitution = s->restitution;
  return (tp_tilt_dynamics){run_rigid, &own->rigid};
}
