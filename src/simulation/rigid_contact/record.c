/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Writes a run of rigid contacts into its history: phases of contacts compared with those before as
 * events, moments, and reactions by facet, in the units of the scene. */

#include "rigid_contact/dynamics.h"

#include "common/grow.h"
#include "rigid_contact/rest.h"

#include <math.h>
#include <stdlib.h>

static const double degrees = 57.29577951308232;

/* Accelerations that are no more than this share of the block's are none. */
static const double no_share = 1e-8;

/* Contacts nearer to each other than this are one, seen from both bodies (over the extent). */
static const double same_place = 1e-8;

static tp_xy on_scene(const tp_dynamics *d, double x, double y) {
  const tp_rigid_body *body = d->run->body;
  return (tp_xy){body->origin.x + x * body->extent_m, body->origin.y + y * body->extent_m};
}

static double speed_unit(const tp_dynamics *d) {
  return d->run->body->extent_m / d->system.time_unit_s;
}

/* The same of the same contact, seen from both bodies, is told once. */
static bool is_told(const tp_dynamics *d, const tp_tilt_event *event) {
  const tp_history *h = d->run->history;
  const double near = same_place * d->run->body->extent_m;
  for (size_t k = h->event_count; k > 0 && h->events[k - 1].time_s == event->time_s; k--) {
    const tp_tilt_event *own = h->events + k - 1;
    if (own->what == event->what && own->facet == event->facet &&
        hypot(own->x_m - event->x_m, own->y_m - event->y_m) <= near) {
      return true;
    }
  }
  return false;
}

bool tp_record_event(tp_dynamics *d, tp_tilt_event_kind kind, const tp_touching_contact *contact,
                     double speed) {
  if (d->run->history == NULL) return true;
  const double time_s = d->time * d->system.time_unit_s;
  const tp_xy at = contact == NULL ? on_scene(d, d->state.place[0], d->state.place[1])
                                   : on_scene(d, contact->gap.at.x, contact->gap.at.y);
  const tp_tilt_event event = {.what = kind,
                               .time_s = time_s,
                               .angle_deg = tp_drive_angle(d->run->drive, time_s) * degrees,
                               .x_m = at.x,
                               .y_m = at.y,
                               .facet = contact == NULL ? 0 : contact->facet,
                               .speed_m_s = speed * speed_unit(d)};
  return is_told(d, &event) || tp_history_event(d->run->history, event);
}

/* What one of the law's contacts does in the mode that was set last. */
static tp_contact_phase phase_of(const tp_dynamics *d, long of_law) {
  const double *x = d->solution.x;
  const tp_law_contact *own = d->law.contacts + of_law;
  const tp_gap_pair *pair = &d->touching.items[d->touching.of_law[of_law]].pair;
  for (int k = 0; k < d->smooth.count; k++) {
    const tp_pressing *pressing = d->smooth.pressing + k;
    if (!tp_pair_is(&pressing->pair, pair)) continue;
    return pressing->sticks || pressing->pinned ? TP_PHASE_STICKS : TP_PHASE_SLIPS;
  }
  const double size = no_share * (fabs(x[0]) + fabs(x[1]) + fabs(x[2]));
  if (tp_double_dot(own->across, x) - own->least > size) return TP_PHASE_OPEN;
  if (own->slip != 0) return TP_PHASE_SLIPS;
  return fabs(tp_double_dot(own->along, x) - own->rest) > size ? TP_PHASE_SLIPS : TP_PHASE_STICKS;
}

static const tp_known_contact *find_known(const tp_known_contact *known, long count,
                                          const tp_known_contact *own) {
  for (long k = 0; k < count; k++) {
    if (tp_pair_is(&known[k].pair, &own->pair)) return known + k;
  }
  for (long k = 0; k < count; k++) {
    if (known[k].facet == own->facet &&
        hypot(known[k].at.x - own->at.x, known[k].at.y - own->at.y) <= same_place) {
      return known + k;
    }
  }
  return NULL;
}

static bool tell_change(tp_dynamics *d, tp_contact_phase before, const tp_known_contact *now) {
  if (before == now->phase) return true;
  const tp_touching_contact contact = {.gap = {.at = now->at}, .facet = now->facet};
  if (now->phase == TP_PHASE_OPEN) return tp_record_event(d, TP_EVENT_OPENS, &contact, 0);
  if (now->phase == TP_PHASE_SLIPS) {
    return tp_record_event(d, TP_EVENT_SLIPS, &contact, fabs(now->slip));
  }
  return before == TP_PHASE_OPEN || tp_record_event(d, TP_EVENT_STICKS, &contact, 0);
}

/* Those that were closed and are no more. */
static bool tell_gone(tp_dynamics *d, const tp_known_contact *old, long old_count) {
  for (long k = 0; k < old_count; k++) {
    if (old[k].phase == TP_PHASE_OPEN) continue;
    if (find_known(d->known, d->known_count, old + k) != NULL) continue;
    tp_known_contact now = old[k];
    const tp_gap gap = tp_gap_at(&d->system.shapes, &now.pair, &d->state);
    now.at = gap.at;
    now.phase = TP_PHASE_OPEN;
    if (!tell_change(d, TP_PHASE_SLIPS, &now)) return false;
  }
  return true;
}

bool tp_record_phases(tp_dynamics *d, bool moves) {
  if (d->run->history == NULL) return true;
  tp_known_contact *old = d->known;
  const long old_count = d->known_count;
  const bool first = old == NULL;
  const tp_touching *t = &d->touching;
  d->known = malloc(sizeof *d->known * (size_t)(t->count + 1));
  d->known_count = 0;
  bool done = d->known != NULL;
  for (long k = 0, of_law = 0; k < t->count && done; k++) {
    const tp_touching_contact *contact = t->items + k;
    tp_known_contact now = {.pair = contact->pair,
                            .at = contact->gap.at,
                            .facet = contact->facet,
                            .slip = contact->slip,
                            .phase = moves ? TP_PHASE_OPEN : TP_PHASE_STICKS};
    if (moves && of_law < t->law_count && t->of_law[of_law] == k) {
      now.phase = phase_of(d, of_law++);
    }
    d->known[d->known_count++] = now;
    const tp_known_contact *before = find_known(old, old_count, &now);
    if (!first) done = tell_change(d, before == NULL ? TP_PHASE_OPEN : before->phase, &now);
  }
  if (done) done = tell_gone(d, old, old_count);
  free(old);
  return done;
}

double tp_energy_balance(tp_dynamics *d) {
  const double kinetic = tp_motion_energy(&d->system, d->state.speed);
  const double balance = d->work - d->lost - (kinetic - d->first_energy);
  d->account.worst_balance = fmax(d->account.worst_balance, fabs(balance));
  return balance;
}

/* Forces of contacts, each added to its facet: those of the last moment are at the end of the list.
 */
static bool add_force(tp_dynamics *d, size_t first, long facet, double normal, double shear) {
  const double weight = d->run->body->mass_kg * TP_GRAVITY_M_S2;
  tp_history *h = d->run->history;
  for (size_t k = first; k < h->reaction_count; k++) {
    if (h->reactions[k].facet != facet) continue;
    h->reactions[k].normal_n += normal * weight;
    h->reactions[k].shear_n += shear * weight;
    return true;
  }
  return tp_history_reaction(h, facet, normal * weight, shear * weight);
}

static bool add_resting(tp_dynamics *d, size_t first) {
  const tp_law law = tp_touching_accelerations(&d->touching, &d->system, d->time);
  double *factors = malloc(sizeof *factors * (size_t)(2 * law.count + 1));
  if (factors == NULL) return false;
  bool done = true;
  if (tp_rest_forces(factors, &law)) {
    for (long k = 0; k < law.count && done; k++) {
      const double against = factors[2 * k], along = factors[2 * k + 1];
      const tp_touching_contact *own = d->touching.items + d->touching.of_law[k];
      if (against + along == 0) continue;
      done = add_force(d, first, own->facet, against + along, own->friction * (along - against));
    }
  }
  free(factors);
  return done;
}

static bool add_moving(tp_dynamics *d, size_t first) {
  tp_smooth_moment moment;
  if (!tp_smooth_at(&moment, &d->smooth, d->time, &d->state)) return true;
  for (int k = 0; k < moment.solution.count; k++) {
    const tp_pressing *own = d->smooth.pressing + moment.solution.edges[k].contact;
    const double factor = moment.solution.factors[k];
    const double shear = factor * own->friction * moment.solution.edges[k].side;
    if (!add_force(d, first, own->facet, factor, shear)) return false;
  }
  return true;
}

bool tp_record_moment(tp_dynamics *d) {
  const double balance = tp_energy_balance(d);
  tp_history *h = d->run->history;
  if (h == NULL) return true;
  const double time_s = d->time * d->system.time_unit_s;
  const double energy = d->run->body->mass_kg * TP_GRAVITY_M_S2 * d->run->body->extent_m;
  const tp_body_state told = tp_motion_told(&d->system, &d->state);
  const tp_tilt_moment moment = {.time_s = time_s,
                                 .angle_deg = tp_drive_angle(d->run->drive, time_s) * degrees,
                                 .moved_x_m = told.moved.x,
                                 .moved_y_m = told.moved.y,
                                 .turned_deg = told.turned * degrees,
                                 .speed_x_m_s = told.speed.x,
                                 .speed_y_m_s = told.speed.y,
                                 .turning_rad_s = told.turning,
                                 .kinetic_energy_j =
                                     tp_motion_energy(&d->system, d->state.speed) * energy,
                                 .energy_balance_j = balance * energy};
  if (!tp_history_moment(h, moment)) return false;
  return d->resting ? add_resting(d, h->reaction_count) : add_moving(d, h->reaction_count);
}
