/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The motions that can begin from rest at the start of a run, each once and in SI units, and
 * whether contact forces can hold the block there (docs/mechanics.md section 6a). */

#include "rigid_contact/rest.h"
#include "rigid_contact/rigid_contact.h"
#include "rigid_contact/touching.h"

#include <math.h>
#include <stdlib.h>

typedef struct told {
  tp_rigid_contact_rest *rest;
  double length_m, time_s;
} told;

/* Modes that share a motion tell it once. */
static bool tell(void *context, const tp_law_solution *solution) {
  told *own = context;
  tp_rigid_contact_rest *rest = own->rest;
  const double unit = own->length_m / own->time_s / own->time_s;
  const tp_rigid_contact_motion motion = {.x_m_s2 = solution->x[0] * unit,
                                          .y_m_s2 = solution->x[1] * unit,
                                          .turning_rad_s2 =
                                              solution->x[2] / own->time_s / own->time_s};
  for (int k = 0; k < rest->motion_count; k++) {
    const tp_rigid_contact_motion *other = rest->motions + k;
    const double off = hypot(other->x_m_s2 - motion.x_m_s2, other->y_m_s2 - motion.y_m_s2) +
                       fabs(other->turning_rad_s2 - motion.turning_rad_s2) * own->length_m;
    if (off <= 10 * tp_law_tolerance * unit) return true;
  }
  rest->motions[rest->motion_count++] = motion;
  return rest->motion_count < TP_RIGID_CONTACT_MOTIONS;
}

static bool find(tp_rigid_contact_rest *rest, tp_touching *touching, tp_contact_system *system,
                 const tp_body_state *start) {
  tp_motion_state at = tp_motion_of(system, start);
  for (int e = 0; e < 3; e++) at.speed[e] = 0;
  if (!tp_touching_collect(touching, system, &at)) return false;
  const tp_law law = tp_touching_accelerations(touching, system, 0);
  told own = {rest, system->body->extent_m, system->time_unit_s};
  double *factors = malloc(sizeof *factors * (size_t)(2 * law.count + 1));
  if (factors == NULL) return false;
  rest->held = tp_rest_forces(factors, &law);
  free(factors);
  const long count = tp_rest_list(touching->can_stay, &law);
  tp_rest_motions(&law, touching->can_stay, count, tell, &own);
  return true;
}

bool tp_rigid_contact_rest_find(tp_rigid_contact_rest *rest, const tp_run *run) {
  tp_contact_system system;
  tp_touching touching = {0};
  tp_rigid_contact_rest own = {0};
  if (!tp_contact_system_init(&system, run->body, run->drive, &run->start)) return false;
  const bool done = find(&own, &touching, &system, &run->start);
  tp_touching_clear(&touching);
  tp_contact_system_clear(&system);
  if (done) *rest = own;
  return done;
}
