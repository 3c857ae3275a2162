/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Rigid-body kinematics: position and velocity of a point of the block in a state, and kinetic
 * energy. */

#include "rigid_body/body.h"

#include <math.h>

static tp_xy turn(const tp_body_state *state, tp_xy point) {
  const double cosine = cos(state->turned), sine = sin(state->turned);
  return (tp_xy){cosine * point.x - sine * point.y, sine * point.x + cosine * point.y};
}

tp_xy tp_rigid_body_place(const tp_body_state *state, tp_xy point) {
  return tp_xy_plus(state->moved, 1, turn(state, point));
}

tp_xy tp_rigid_body_velocity(const tp_body_state *state, tp_xy point) {
  return tp_xy_plus(state->speed, state->turning, tp_xy_left(turn(state, point)));
}

double tp_rigid_body_kinetic_energy(const tp_rigid_body *body, const tp_body_state *state) {
  const double square = tp_xy_dot(state->speed, state->speed);
  return (body->mass_kg * square + body->inertia_kg_m2 * state->turning * state->turning) / 2;
}
