/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Steps of central differences of a block on contact springs.
 *
 * Velocities stand half a step behind positions: v' = v + (F + D) dt / m, x' = x + v' dt, the same
 * for the turn. D is local damping: against each velocity, a share of the size of the unbalanced
 * force there. Stable for dt <= 2 / omega, omega the highest frequency; omega^2 is bounded by the
 * trace of stiffness over mass, the sum over all contacts of (k_n + k_s) A (1 / m + r^2 / I).
 *
 * The account of energy is by the rule that central differences keep: kinetic energy at a position
 * is m v v' / 2, work is the mean of the forces at both ends of a step times the step, so that
 * linear springs and steady forces balance but for rounding. What is left measures the step. */

#ifndef TP_CONTACT_SPRINGS_STEPPER_H
#define TP_CONTACT_SPRINGS_STEPPER_H

#include "contact_springs/contacts.h"
#include "rigid_body/drive.h"

typedef struct tp_energies {
  double work, held, taken_by_friction, taken_by_damping, kinetic;
} tp_energies;

typedef struct tp_stepper {
  const tp_rigid_body *body;
  const tp_drive *drive;
  tp_spring_contacts contacts;
  tp_body_state state; /* its velocities half a step behind */
  double time_s, step_s;
  double damping;    /* share of the unbalanced force, 0 to 1 */
  double load_share; /* of the weight and all loads: 1 but while the block settles */
  tp_body_force drive_force, net, damped; /* at the state; net without damping */
  tp_xy displaced;                        /* in the step that led there */
  double turned;
  bool steady; /* the drive does not change with time: its force is known */
  tp_energies energies;
} tp_stepper;

TP_MUST_USE bool tp_stepper_init(tp_stepper *stepper, const tp_rigid_body *body,
                                 const tp_drive *drive, tp_spring_stiffness stiffness);
void tp_stepper_clear(tp_stepper *stepper);

/* Begin, or begin again, at a state, with the energies of nothing. */
void tp_stepper_place(tp_stepper *stepper, const tp_body_state *state);

/* Forces at the state. False when memory is exhausted. */
TP_MUST_USE bool tp_stepper_evaluate(tp_stepper *stepper);

/* One step on, by the forces at the state. */
void tp_stepper_advance(tp_stepper *stepper);

/* Velocities stand for the time of the state: put them half a step back. */
void tp_stepper_put_back(tp_stepper *stepper);

/* The longest step that is stable with the contacts that there are, or that there were at the
 * start of the body. */
double tp_stepper_stable_step(const tp_stepper *stepper);

/* What work and energies differ by. */
double tp_energies_balance(const tp_energies *energies);

#endif
