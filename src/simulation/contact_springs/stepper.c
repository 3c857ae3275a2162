/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Leapfrog integration with local damping, and the accounts of kinetic, spring, friction, damping
 * and driving energy. */

#include "contact_springs/stepper.h"

#include <math.h>
#include <string.h>

bool tp_stepper_init(tp_stepper *s, const tp_rigid_body *body, const tp_drive *drive,
                     tp_spring_stiffness stiffness) {
  *s = (tp_stepper){.body = body, .drive = drive, .load_share = 1};
  return tp_spring_contacts_init(&s->contacts, body, stiffness);
}

void tp_stepper_clear(tp_stepper *s) {
  tp_spring_contacts_clear(&s->contacts);
}

void tp_stepper_place(tp_stepper *s, const tp_body_state *state) {
  tp_spring_contacts_forget(&s->contacts);
  s->state = *state;
  s->displaced = (tp_xy){0, 0};
  s->turned = 0;
  s->steady = false;
  s->net = s->damped = (tp_body_force){0, 0, 0};
  memset(&s->energies, 0, sizeof s->energies);
}

/* Does the drive give the same force from now on? */
static bool is_steady(const tp_stepper *s) {
  const tp_base_motion *shaking = s->drive->shaking;
  double horizontal_m_s2 = 0, vertical_m_s2 = 0;
  if (!isinf(tp_drive_next_kink(s->drive, s->time_s))) return false;
  if (shaking != NULL) {
    shaking->acceleration(&horizontal_m_s2, &vertical_m_s2, shaking, s->time_s);
  }
  return horizontal_m_s2 == 0 && vertical_m_s2 == 0; /* past its end it is still for good */
}

static double power(tp_body_force f, tp_xy displaced, double turned) {
  return f.x_n * displaced.x + f.y_n * displaced.y + f.moment_nm * turned;
}

static double against(double force, double speed, double share) {
  return speed > 0 ? -share * fabs(force) : speed < 0 ? share * fabs(force) : 0;
}

bool tp_stepper_evaluate(tp_stepper *s) {
  const tp_body_force driven_before = s->drive_force, damped_before = s->damped;
  tp_spring_forces springs;
  if (!tp_spring_contacts_step(&springs, &s->contacts, &s->state, s->displaced, s->turned)) {
    return false;
  }
  if (!s->steady) {
    tp_body_force f = tp_drive_force(s->drive, s->body, s->time_s);
    s->drive_force =
        (tp_body_force){s->load_share * f.x_n, s->load_share * f.y_n, s->load_share * f.moment_nm};
    s->steady = s->load_share == 1 && is_steady(s);
  }
  s->net =
      (tp_body_force){s->drive_force.x_n + springs.sum.x_n, s->drive_force.y_n + springs.sum.y_n,
                      s->drive_force.moment_nm + springs.sum.moment_nm};
  s->damped = (tp_body_force){against(s->net.x_n, s->state.speed.x, s->damping),
                              against(s->net.y_n, s->state.speed.y, s->damping),
                              against(s->net.moment_nm, s->state.turning, s->damping)};
  tp_energies *e = &s->energies;
  e->work += (power(driven_before, s->displaced, s->turned) +
              power(s->drive_force, s->displaced, s->turned)) /
             2;
  e->taken_by_damping -=
      (power(damped_before, s->displaced, s->turned) + power(s->damped, s->displaced, s->turned)) /
      2;
  e->taken_by_damping += springs.taken_by_dashpots;
  e->taken_by_friction += springs.taken_by_friction;
  e->held = springs.held;
  return true;
}

void tp_stepper_advance(tp_stepper *s) {
  const double dt = s->step_s, m = s->body->mass_kg, inertia = s->body->inertia_kg_m2;
  tp_body_state *state = &s->state;
  const tp_xy speed = {state->speed.x + dt * (s->net.x_n + s->damped.x_n) / m,
                       state->speed.y + dt * (s->net.y_n + s->damped.y_n) / m};
  const double turning = state->turning + dt * (s->net.moment_nm + s->damped.moment_nm) / inertia;
  s->energies.kinetic =
      (m * tp_xy_dot(speed, state->speed) + inertia * turning * state->turning) / 2;
  state->speed = speed;
  state->turning = turning;
  s->displaced = (tp_xy){dt * speed.x, dt * speed.y};
  s->turned = dt * turning;
  state->moved = tp_xy_plus(state->moved, 1, s->displaced);
  state->turned += s->turned;
  s->time_s += dt;
}

void tp_stepper_put_back(tp_stepper *s) {
  const double half = s->step_s / 2;
  s->state.speed.x -= half * s->net.x_n / s->body->mass_kg;
  s->state.speed.y -= half * s->net.y_n / s->body->mass_kg;
  s->state.turning -= half * s->net.moment_nm / s->body->inertia_kg_m2;
}

double tp_stepper_stable_step(const tp_stepper *s) {
  const tp_rigid_body *b = s->body;
  double straight = 0, turning = 0;
  const double stiffness = s->contacts.normal_pa_m + s->contacts.shear_pa_m;
  for (long k = 0; k < b->closed_count; k++) {
    const double own = stiffness * b->closed[k].share_m * b->thickness_m;
    straight += own;
    turning += own * tp_xy_dot(b->closed[k].at, b->closed[k].at);
  }
  const double at_start = straight / b->mass_kg + turning / b->inertia_kg_m2;
  tp_spring_contacts_stiffness(&straight, &turning, &s->contacts);
  const double now = straight / b->mass_kg + turning / b->inertia_kg_m2;
  return 2 / sqrt(fmax(fmax(at_start, now), stiffness * s->contacts.least_area_m2 / b->mass_kg));
}

double tp_energies_balance(const tp_energies *e) {
  return e->work - e->held - e->taken_by_friction - e->taken_by_damping - e->kinetic;
}
