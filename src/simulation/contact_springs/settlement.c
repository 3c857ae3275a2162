/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Loads grow by a smooth cubic in time under strong damping until the watch reports rest; a block
 * that moves too far or gains kinetic energy is released as it is. */

#include "contact_springs/settlement.h"

#include "contact_springs/watch.h"

#include <math.h>

/* Over so many periods of the shear springs the loads grow; for so many times sqrt(extent / g) it
 * may take to come to rest then. */
enum { PERIODS_OF_GROWTH = 20, LONGEST = 30, PERIODS_OF_DASHPOTS = 5 };

/* Local damping alone sustains vibrations of contacts that slip in turns: the block would creep on
 * rather than rest. Dashpots of this share of the critical damping take them. */
static const double settling_damping = 0.8;

static const double critical_share = 0.5;

/* Of the extent: a block that has moved by the first and has more energy in its motion than in its
 * springs falls; no equilibrium lies as far as the second. */
static const double least_fall_share = 1e-3, farthest_share = 1e-2;

/* Of the block on its shear springs, all contacts of the start closed; 0: there are none. */
static double shear_period(const tp_stepper *s) {
  double area = 0;
  for (long k = 0; k < s->body->closed_count; k++) {
    area += s->body->closed[k].share_m * s->body->thickness_m;
  }
  if (s->body->closed_count > 0) area = fmax(area, s->contacts.least_area_m2);
  const double stiffness = area * fmin(s->contacts.shear_pa_m, s->contacts.normal_pa_m);
  return area > 0 ? 2 * acos(-1) * sqrt(s->body->mass_kg / stiffness) : 0;
}

/* 0 to 1, with no slope at both ends. */
static double smooth(double x) {
  return x >= 1 ? 1 : x * x * (3 - 2 * x);
}

static bool step(tp_stepper *s, double share, bool *failed) {
  *failed = !tp_stepper_evaluate(s);
  if (*failed) return false;
  if (s->contacts.changed) s->step_s = share * tp_stepper_stable_step(s);
  tp_stepper_advance(s);
  return true;
}

static bool falls(const tp_stepper *s, const tp_body_state *start) {
  const tp_xy moved = tp_xy_minus(s->state.moved, start->moved);
  const double turned = fabs(s->state.turned - start->turned) * s->body->extent_m;
  const double way = (fabs(moved.x) + fabs(moved.y) + turned) / s->body->extent_m;
  return way > farthest_share || (way > least_fall_share && s->energies.kinetic > s->energies.held);
}

/* Grow the loads, then wait until the block is quiet. One that neither is by the end of that time
 * nor has collapsed goes on from where it is: the run tells. */
static bool finds_equilibrium(tp_stepper *s, const tp_body_state *start, double growth_s,
                              double share, bool *failed) {
  while (s->time_s < growth_s) {
    s->load_share = smooth(s->time_s / growth_s);
    if (!step(s, share, failed) || falls(s, start)) return false;
  }
  s->load_share = 1;
  tp_spring_watch watch;
  tp_spring_watch_init(&watch, s);
  const double longest = s->time_s + LONGEST * sqrt(s->body->extent_m / TP_GRAVITY_M_S2);
  tp_spring_watch_news news = TP_WATCH_NOTHING;
  while (news == TP_WATCH_NOTHING && s->time_s < longest) {
    if (!step(s, share, failed) || falls(s, start)) return false;
    news = tp_spring_watch_step(&watch, s);
  }
  return news != TP_WATCH_COLLAPSES;
}

/* 2 z / omega over the length of a step, omega by its bound: step = share 2 / omega. */
static void set_dashpots(tp_spring_contacts *c, double share) {
  c->normal_dashpot = critical_share / share;
  c->shear_dashpot = c->normal_dashpot * sqrt(c->normal_pa_m / c->shear_pa_m);
}

static void let_settle(tp_stepper *s, bool *settled, bool *failed, const tp_body_state *start,
                       double share) {
  const tp_drive *drive = s->drive;
  const tp_drive held = {.angle = tp_drive_angle(drive, 0)};
  const double period = shear_period(s), damping = s->damping;
  *settled = false;
  if (period == 0) return;
  s->drive = &held;
  s->step_s = share * tp_stepper_stable_step(s);
  s->damping = settling_damping;
  set_dashpots(&s->contacts, share);
  *settled = finds_equilibrium(s, start, PERIODS_OF_GROWTH * period, share, failed);
  s->drive = drive;
  s->damping = damping;
  s->contacts.normal_dashpot = s->contacts.shear_dashpot = 0;
}

bool tp_stepper_is_past_letting_go(const tp_stepper *s) {
  return s->time_s > PERIODS_OF_DASHPOTS * shear_period(s);
}

tp_settlement tp_stepper_settle(tp_stepper *s, const tp_body_state *start, double share) {
  const bool at_rest = start->speed.x == 0 && start->speed.y == 0 && start->turning == 0;
  bool settled = false, failed = false;
  tp_stepper_place(s, start);
  s->time_s = 0;
  if (at_rest) let_settle(s, &settled, &failed, start, share);
  if (failed) return TP_SETTLEMENT_NO_MEMORY;
  s->time_s = 0;
  s->load_share = 1;
  s->steady = false;
  if (!settled) {
    tp_stepper_place(s, start);
    set_dashpots(&s->contacts, share);
    return TP_SETTLEMENT_NONE;
  }
  s->state.speed = (tp_xy){0, 0};
  s->state.turning = 0;
  s->displaced = (tp_xy){0, 0};
  s->turned = 0;
  for (long k = 0; k < s->contacts.count; k++) s->contacts.items[k].slipped = 0;
  /* the account begins with what the springs hold */
  s->energies = (tp_energies){.work = s->energies.held, .held = s->energies.held};
  return TP_SETTLEMENT_REACHED;
}
