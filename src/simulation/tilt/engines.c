/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Calls of the spring and the rigid-contact engine with settings from the test, and notes on what
 * the latter met (paradox, windows). */

#include "tilt/engines.h"

#include "common/notes.h"

static tp_run_end run_springs(tp_body_state *last, const tp_run *run, void *engines,
                              tp_message *message) {
  const tp_tilt_engines *own = engines;
  return tp_springs_run(last, run, &own->springs, message);
}

static tp_run_end run_rigid(tp_body_state *last, const tp_run *run, void *engines,
                            tp_message *message) {
  tp_tilt_engines *own = engines;
  tp_rigid_contact_account account = {.steps = 0};
  const tp_run_end end = tp_rigid_contact_run(last, &account, run, &own->rigid, message);
  own->paradox = own->paradox || account.paradox;
  own->in_window = own->in_window || account.in_window;
  own->lowered_restitution = own->lowered_restitution || account.lowered_restitution;
  own->accumulated = own->accumulated || account.accumulated > 0;
  return end;
}

tp_status tp_tilt_dynamics_of(tp_tilt_dynamics *dynamics, tp_tilt_engines *own,
                              const tp_tilt_settings *s, const tp_rigid_body *body, tp_place place,
                              tp_message *message) {
  *own = (tp_tilt_engines){.paradox = false};
  if (s->engine == TP_TILT_SPRINGS) {
    own->springs = (tp_spring_settings){.normal_pa_m = s->normal_stiffness_pa_m,
                                        .shear_pa_m = s->shear_stiffness_pa_m,
                                        .damping = s->damping,
                                        .rounding_m = s->rounding_m,
                                        .time_step_s = s->time_step_s};
    *dynamics = (tp_tilt_dynamics){run_springs, own};
    return tp_springs_check(&own->springs, body, place, message);
  }
  own->rigid = tp_rigid_contact_settings_default();
  own->rigid.restitution = s->restitution;
  *dynamics = (tp_tilt_dynamics){run_rigid, own};
  return TP_OK;
}

bool tp_tilt_engines_begin(tp_body_state *moving, const tp_tilting *tilting, double angle_deg) {
  const double angle = tp_tilt_radians(angle_deg);
  const tp_drive drive = {.angle = angle, .final_angle = angle};
  const tp_run run = {.body = tilting->body, .drive = &drive, .longest_s = 1};
  tp_rigid_contact_rest rest = {.motion_count = 0};
  if (!tp_rigid_contact_rest_find(&rest, &run) || rest.motion_count == 0) return false;
  *moving = (tp_body_state){.speed = {rest.motions[0].x_m_s2, rest.motions[0].y_m_s2},
                            .turning = rest.motions[0].turning_rad_s2};
  return true;
}

tp_status tp_tilt_engines_notes(tp_notes *notes, const tp_tilt_engines *own, tp_place place,
                                tp_message *message) {
  const struct {
    bool met;
    tp_note_kind kind;
    const char *text;
  } all[] = {
      {own->paradox, TP_CAUTION,
       "friction would press a slipping contact harder (Painlevé): rigid bodies with Coulomb "
       "friction "
       "have no unique motion there; compare with 'method: springs'"},
      {own->in_window, TP_NOTE,
       "at the tilt where it began to move, forces left in its contacts by its loading history "
       "could have held it; rigid contacts have no such forces, and it was released"},
      {own->lowered_restitution, TP_NOTE,
       "the restitution was reduced in an impact, as it would have increased the energy"},
      {own->accumulated, TP_NOTE,
       "rebounds below a threshold, a stated share of the block, are ignored: the contact then "
       "closes"}};
  tp_status status = TP_OK;
  for (size_t k = 0; k < sizeof all / sizeof all[0] && status == TP_OK; k++) {
    if (all[k].met) status = tp_notes_add(notes, message, all[k].kind, place, "%s", all[k].text);
  }
  return status;
}
