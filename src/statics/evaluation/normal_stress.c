/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Cautions where the mean normal stress exceeds JCS, on level ground or at the tilt, where Barton's
 * law (Eq. 8) has no data, and where the stated contact width exceeds the width found. */

#include "evaluation/normal_stress.h"

#include "common/notes.h"
#include "evaluation/contact_length.h"
#include "evaluation/friction.h"
#include "number/ball.h"

/* Is the stress at a tilt above JCS? With its doubles, to be told. */
static bool exceeds(double *stress_mpa, const tp_evaluation *e, const arb_t tilt) {
  arb_t stress, strength;
  arb_init(stress);
  arb_init(strength);
  tp_friction_stress_at(stress, e, tilt);
  arb_set_fmpq(strength, e->problem->scene->friction.jcs_mpa.value, e->rung.bits);
  arb_mul_ui(strength, strength, TP_KILO * TP_KILO, e->rung.bits);
  const bool above = arb_gt(stress, strength) != 0;
  *stress_mpa = arf_get_d(arb_midref(stress), ARF_RND_NEAR) / (TP_KILO * TP_KILO);
  arb_clear(stress);
  arb_clear(strength);
  return above;
}

/* `*told` where it is. */
static tp_status note_stress(tp_notes *notes, const tp_evaluation *e, bool *told,
                             tp_message *message) {
  const tp_scene *scene = e->problem->scene;
  double stress_mpa = 0;
  arb_t tilt;
  arb_init(tilt);
  bool above = exceeds(&stress_mpa, e, tilt), level = true;
  if (!above && scene->tilt_angle_deg.given) {
    arb_set_fmpq(tilt, scene->tilt_angle_deg.value, e->rung.bits);
    above = exceeds(&stress_mpa, e, tilt);
    level = false;
  }
  arb_clear(tilt);
  *told = above;
  if (!above) return TP_OK;
  const bool world = tp_scene_lies_in_place(scene);
  return tp_notes_add(
      notes, message, TP_CAUTION, scene->friction.jcs_mpa.place,
      "%s the mean normal stress on the contact is %.4g MPa and exceeds JCS, %.4g MPa: asperities "
      "are crushed, and friction is the residual angle, %.4g°; if the contact is wider than it is "
      "drawn, say 'contact: {width: …}'",
      world   ? (level ? "where its mean plane is level" : "as it lies")
      : level ? "on level ground"
              : "at the scene's tilt",
      stress_mpa, fmpq_get_d(scene->friction.jcs_mpa.value),
      fmpq_get_d(scene->friction_angle_deg.value));
}

static tp_status note_width(tp_notes *notes, const tp_evaluation *e, tp_message *message) {
  const tp_scene *scene = e->problem->scene;
  const tp_quantity *stated = &scene->friction.contact_width;
  if (!stated->given) return TP_OK;
  arb_t width;
  arb_init(width);
  tp_contact_nominal_length(width, e);
  tp_evaluation_to_metres(width, e, 1);
  const double touches =
      arf_get_d(arb_midref(width), ARF_RND_NEAR) / fmpq_get_d(scene->metres_per_unit);
  arb_clear(width);
  if (touches == 0 || touches >= fmpq_get_d(stated->value)) return TP_OK;
  return tp_notes_add(notes, message, TP_CAUTION, stated->place,
                      "the contact is stated to be %.4g %s wide but touches over %.4g: a larger "
                      "width lowers the stress and raises the friction by the law barton",
                      fmpq_get_d(stated->value), scene->length_unit, touches);
}

/* Once, under what acts in the first direction that has it. */
static tp_status note_directions(tp_notes *notes, tp_evaluation *e, tp_message *message) {
  const tp_problem *problem = e->problem;
  const bool asked[2] = {problem->scene->towards_left, problem->scene->towards_right};
  if (!problem->loaded) return note_stress(notes, e, &(bool){false}, message);
  tp_status status = TP_OK;
  bool told = false;
  for (int d = 0; d < 2 && status == TP_OK && !told; d++) {
    tp_loaded loaded;
    if (!asked[d]) continue;
    if (!tp_loaded_init(&loaded, e, d == 0 ? TP_TOWARDS_LEFT : TP_TOWARDS_RIGHT)) {
      return tp_fail_memory(message, "the loads");
    }
    e->loaded = &loaded;
    status = note_stress(notes, e, &told, message);
    e->loaded = NULL;
    tp_loaded_clear(&loaded);
  }
  return status;
}

tp_status tp_normal_stress_cautions(tp_notes *notes, const tp_problem *problem,
                                    tp_message *message) {
  if (!problem->scene->friction.load_dependent) return TP_OK;
  const tp_solve_options options = {.size = sizeof options, .digits = 9};
  tp_evaluation e;
  tp_evaluation_init(&e, problem, (tp_rung){TP_LEVEL_DOUBLE, TP_BALL_BITS}, &options);
  tp_friction_stress_when_level(e.weight_per_area_pa, &e);
  tp_status status = note_width(notes, &e, message);
  if (status == TP_OK) status = note_directions(notes, &e, message);
  tp_evaluation_clear(&e);
  return status;
}
