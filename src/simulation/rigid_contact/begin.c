/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Time at which a block at rest begins to move: next tilt from closed-form windows, looks at fixed
 * steps otherwise, and bisection of the interval found. */

#include "rigid_contact/begin.h"

#include "rigid_contact/rest.h"

#include <math.h>

/* A window of tilts narrower than this under loads, or shaking that is over in a shorter time, can
 * be missed. */
static const double look_tilt = 0.05 / 57.29577951308232, look_time = 0.02;

/* Of the bracket of a begin, as a share of the time. */
static const double begin_width = 1e-12;

static const double right_angle = 1.5707963267948966;

static double look_step(const tp_dynamics *d) {
  return look_tilt / fabs(d->run->drive->speed) / d->system.time_unit_s;
}

/* The acceleration without contacts at a tilt. */
static void set_free(double free[3], const tp_dynamics *d, double angle) {
  const tp_drive held = {.angle = angle};
  tp_contact_system system = d->system;
  system.drive = &held;
  tp_contact_system_free(free, &system, 0);
}

/* Up to one look before the next tilt at which a motion can begin. */
void tp_begin_wait(tp_dynamics *d) {
  const tp_drive *drive = d->run->drive;
  tp_touching *t = &d->touching;
  d->rests_until = d->time;
  if (drive->speed <= 0 || drive->shaking != NULL || d->run->body->loads.given) return;
  const double from = tp_drive_angle(drive, d->time * d->system.time_unit_s);
  if (fabs(from) >= right_angle) return;
  double level[3], upright[3];
  set_free(level, d, 0);
  set_free(upright, d, right_angle);
  const tp_law law = tp_touching_accelerations(t, &d->system, d->time);
  if (t->can_stay_count < 0) t->can_stay_count = tp_rest_list(t->can_stay, &law);
  const double next = tp_rest_next_tilt(&law, t->can_stay, t->can_stay_count, level, upright, from);
  const double until =
      (fmin(next, right_angle) - drive->angle) / drive->speed / d->system.time_unit_s;
  d->rests_until = fmax(d->time, until - look_step(d));
}

double tp_begin_next_look(const tp_dynamics *d) {
  const tp_drive *drive = d->run->drive;
  double next = INFINITY;
  if (d->time < d->rests_until) return d->rests_until;
  if (drive->speed != 0) next = d->time + look_step(d);
  return drive->shaking != NULL ? fmin(next, d->time + look_time) : next;
}

tp_resolved tp_begin_find(tp_dynamics *d, double moves_at) {
  double rests_at = d->time;
  while (moves_at - rests_at > begin_width * (1 + moves_at)) {
    d->time = (rests_at + moves_at) / 2;
    const tp_resolved now = tp_resolve_rest(d);
    if (now == TP_RESOLVED_NO_MEMORY) return now;
    *(now == TP_RESOLVED_MOVES ? &moves_at : &rests_at) = d->time;
  }
  d->time = moves_at;
  return TP_RESOLVED_MOVES;
}

tp_resolved tp_begin_choose(double *later, tp_dynamics *d) {
  const double begin = d->time, told = 1e-6, first = 1e-7, last = 1e-2;
  tp_resolved now = tp_resolve_rest(d);
  *later = begin;
  for (double after = first; now == TP_RESOLVED_MOVES && after <= last; after *= 10) {
    const double *x = d->solution.x;
    if (fabs(x[0]) + fabs(x[1]) + fabs(x[2]) >= told) break;
    d->time = begin + after;
    now = tp_resolve_rest(d);
    if (now == TP_RESOLVED_MOVES) *later = d->time;
  }
  if (now == TP_RESOLVED_RESTS) {
    d->time = *later;
    now = tp_resolve_rest(d);
  }
  d->time = begin;
  return now;
}
