/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Shares of the weight and strengths that are accepted, yet look as if they stood in another unit.
 *
 * Earthquakes of more than 1 g are hardly designed for, while
 * m/s2 and % are beyond. Cohesion of joints and bond of contacts stay below 1 MPa. */

#include "scene/unit_cautions.h"

static const double pascals = 1000; /* of a kPa */
static const long most_share = 1, most_kpa = 1000;

static tp_status check_seismic(tp_notes *notes, const tp_loads_description *loads,
                               tp_message *message) {
  const tp_quantity *shares[] = {&loads->horizontal, &loads->vertical};
  static const char *const names[] = {"horizontal", "vertical"};
  tp_status status = TP_OK;
  for (int k = 0; k < 2 && status == TP_OK; k++) {
    if (!shares[k]->given || (fmpq_cmp_si(shares[k]->value, most_share) <= 0 &&
                              fmpq_cmp_si(shares[k]->value, -most_share) >= 0)) {
      continue;
    }
    status = tp_notes_add(notes, message, TP_CAUTION, shares[k]->place,
                          "%s: %.6g is an earthquake of more than gravity; it is a share of the "
                          "weight, 0.15 for 15 %% of g",
                          names[k], fmpq_get_d(shares[k]->value));
  }
  if (status != TP_OK || !loads->horizontal.given || fmpq_sgn(loads->horizontal.value) >= 0) {
    return status;
  }
  return tp_notes_add(notes, message, TP_CAUTION, loads->horizontal.place,
                      "a negative 'horizontal' pushes the block up-dip, which helps it; an "
                      "earthquake shakes both ways: give the share above 0");
}

static tp_status check_strength(tp_notes *notes, const tp_quantity *strength, const char *what,
                                tp_message *message) {
  if (!strength->given || fmpq_cmp_si(strength->value, most_kpa) <= 0) return TP_OK;
  const double given = fmpq_get_d(strength->value);
  return tp_notes_add(notes, message, TP_CAUTION, strength->place,
                      "%s of %.6g kPa, above 1 MPa, is that of sound rock, not of a joint; if it "
                      "is in Pa, write %.6g",
                      what, given, given / pascals);
}

typedef struct strength {
  const tp_quantity *friction_angle_deg, *cohesion_kpa, *tension_kpa;
} strength;

static tp_status check_joint(tp_notes *notes, strength own, tp_message *message) {
  tp_status status = tp_scene_friction_caution(notes, own.friction_angle_deg, message);
  if (status == TP_OK) status = check_strength(notes, own.cohesion_kpa, "cohesion", message);
  if (status == TP_OK) {
    status = check_strength(notes, own.tension_kpa, "tensile strength", message);
  }
  return status;
}

static tp_status check_set(tp_notes *notes, const tp_joint_set *set, tp_message *message) {
  const strength own = {&set->friction_angle_deg, &set->cohesion_kpa, &set->tension_kpa};
  return check_joint(notes, own, message);
}

/* What was made for many pairs of blocks stands in one place. */
static tp_status check_joints(tp_notes *notes, const tp_block_list *many, tp_message *message) {
  tp_status status = TP_OK;
  for (long k = 0; k < many->joint_count && status == TP_OK; k++) {
    const tp_joint_description *j = many->joints + k;
    const bool again = k > 0 && j->place.line == j[-1].place.line &&
                       j->place.column == j[-1].place.column && j->place.file != NULL;
    const strength own = {&j->friction_angle_deg, &j->cohesion_kpa, &j->tension_kpa};
    if (!again) status = check_joint(notes, own, message);
  }
  if (many->slope.place.file == NULL) return status;
  for (long k = 0; k < many->slope.set_count && status == TP_OK; k++) {
    status = check_set(notes, many->slope.sets + k, message);
  }
  return status == TP_OK ? check_set(notes, &many->slope.base, message) : status;
}

tp_status tp_scene_unit_cautions(tp_notes *notes, const tp_scene *scene, tp_message *message) {
  const tp_loads_description *loads = &scene->loads;
  tp_status status = tp_scene_angle_cautions(notes, scene, message);
  if (status == TP_OK) status = check_seismic(notes, loads, message);
  if (status == TP_OK) status = check_strength(notes, &loads->cohesion_kpa, "cohesion", message);
  if (status == TP_OK) status = check_strength(notes, &loads->bond_kpa, "a bond", message);
  for (int k = 0; k < 2 && status == TP_OK; k++) {
    status = check_strength(notes, &scene->solid.wedge.cohesion_kpa[k], "cohesion", message);
  }
  if (status == TP_OK) status = check_joints(notes, &scene->many, message);
  return status;
}
