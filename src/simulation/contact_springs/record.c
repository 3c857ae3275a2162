/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* Compares the contacts observed with those known before and writes events, moments and reactions
 * into a history. */

#include "contact_springs/record.h"

#include "common/grow.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A shear force of so much of Coulomb's limit is at it; a contact that has not slipped in so many
 * observations sticks. */
static const double at_limit = 0.999;
enum { STUCK_OBSERVATIONS = 4, MISSING_OBSERVATIONS = 8 };

/* Of the weight over the number of contacts: what bears less does not close. */
static const double least_share = 0.01;
enum { LEAST_CONTACTS = 2 };

void tp_spring_record_clear(tp_spring_record *r) {
  free(r->known);
  memset(r, 0, sizeof *r);
}

static double degrees(double radians) {
  return radians * 90 / acos(0);
}

/* ---- moments
 * --------------------------------------------------------------------------------------------- */

static bool add_reactions(tp_history *history, const tp_spring_contacts *c) {
  bool done = true;
  for (long k = 0; k < c->count && done; k++) {
    const long facet = c->items[k].facet;
    double normal = 0, shear = 0;
    bool first = true;
    for (long i = 0; i < c->count; i++) {
      const tp_spring_contact *own = c->items + i;
      if (own->facet != facet) continue;
      if (i < k) first = false;
      normal += own->normal_n;
      shear += own->tangent.x < 0 ? -own->shear_n : own->shear_n;
    }
    if (first) done = tp_history_reaction(history, facet, normal, shear);
  }
  return done;
}

static bool add_moment(const tp_spring_record *r, const tp_stepper *s) {
  const tp_body_state *at = &s->state, *start = &r->run->start;
  const tp_tilt_moment moment = {.time_s = s->time_s,
                                 .angle_deg = degrees(tp_drive_angle(s->drive, s->time_s)),
                                 .moved_x_m = at->moved.x - start->moved.x,
                                 .moved_y_m = at->moved.y - start->moved.y,
                                 .turned_deg = degrees(at->turned - start->turned),
                                 .speed_x_m_s = at->speed.x,
                                 .speed_y_m_s = at->speed.y,
                                 .turning_rad_s = at->turning,
                                 .kinetic_energy_j = s->energies.kinetic,
                                 .energy_balance_j = tp_energies_balance(&s->energies)};
  return tp_history_moment(r->run->history, moment) && add_reactions(r->run->history, &s->contacts);
}

/* ---- events
 * -----------------------------------------------------------------------------------------------
 */

static tp_tilt_event event_at(const tp_spring_record *r, const tp_stepper *s,
                              tp_tilt_event_kind kind, double time_s, tp_xy at) {
  const tp_xy origin = r->run->body->origin;
  return (tp_tilt_event){.what = kind,
                         .time_s = time_s,
                         .angle_deg = degrees(tp_drive_angle(s->drive, time_s)),
                         .x_m = origin.x + at.x,
                         .y_m = origin.y + at.y};
}

/* Events stand in the order of their times; some are known only after a while. */
static bool insert_event(const tp_spring_record *r, tp_tilt_event event) {
  tp_history *h = r->run->history;
  if (!tp_history_event(h, event)) return false;
  size_t place = h->event_count - 1;
  for (; place > 0 && h->events[place - 1].time_s > event.time_s; place--) {
    h->events[place] = h->events[place - 1];
  }
  h->events[place] = event;
  return true;
}

static bool add_event(const tp_spring_record *r, const tp_stepper *s, tp_tilt_event_kind kind,
                      double time_s, const tp_known_spring *contact, double speed) {
  tp_tilt_event event = event_at(r, s, kind, time_s, contact->at);
  event.facet = contact->facet;
  event.speed_m_s = speed;
  return insert_event(r, event);
}

bool tp_spring_record_block(tp_spring_record *r, const tp_stepper *s, tp_tilt_event_kind kind,
                            double since_s) {
  if (r->run->history == NULL) return true;
  return insert_event(r, event_at(r, s, kind, since_s, s->state.moved)) && add_moment(r, s);
}

/* ---- contacts
 * --------------------------------------------------------------------------------------------- */

static tp_known_spring *find_known(const tp_spring_record *r, tp_pair story) {
  for (long k = 0; k < r->count; k++) {
    tp_known_spring *own = r->known + k;
    if (own->story.of_block == story.of_block && own->story.of_base == story.of_base) return own;
  }
  return NULL;
}

static tp_known_spring *add_known(tp_spring_record *r, const tp_spring_contact *contact) {
  tp_known_spring *known = tp_grow(r->known, r->count, &r->room, sizeof *known);
  if (known == NULL) return NULL;
  r->known = known;
  known[r->count] = (tp_known_spring){.story = contact->story};
  return known + r->count++;
}

/* Did it begin or end to slip since it was last observed? */
static bool observe_slip(tp_spring_record *r, const tp_stepper *s, tp_known_spring *known,
                         const tp_spring_contact *contact, bool tell, bool *told) {
  const double most = contact->friction * contact->normal_n;
  const bool slips = contact->slipped > 0 && fabs(contact->shear_n) >= at_limit * most;
  known->stuck = contact->slipped > 0 ? 0 : known->stuck + 1;
  const bool was = known->slips;
  known->slips = was ? known->stuck < STUCK_OBSERVATIONS : slips;
  if (!tell || known->slips == was) return true;
  *told = true;
  const double elapsed = s->time_s - r->last_observed_s;
  const double speed = known->slips && elapsed > 0 ? contact->slipped / elapsed : 0;
  return add_event(r, s, known->slips ? TP_EVENT_SLIPS : TP_EVENT_STICKS, s->time_s, known, speed);
}

static double least_force(const tp_spring_record *r) {
  const tp_rigid_body *body = r->run->body;
  const long contacts = body->closed_count > LEAST_CONTACTS ? body->closed_count : LEAST_CONTACTS;
  return least_share * body->mass_kg * TP_GRAVITY_M_S2 / (double)contacts;
}

static bool observe_contact(tp_spring_record *r, const tp_stepper *s, tp_spring_contact *contact,
                            bool tell, bool *told) {
  tp_known_spring *known = find_known(r, contact->story);
  const bool closes = known == NULL;
  if (closes && contact->normal_n < least_force(r)) return true;
  if (closes) known = add_known(r, contact);
  if (known == NULL) return false;
  known->seen = true;
  known->at = contact->now.at;
  known->facet = contact->facet;
  bool done = true;
  if (closes && tell) {
    *told = true;
    done = add_event(r, s, TP_EVENT_CLOSES, s->time_s, known, contact->closing_m_s);
  }
  done = done && observe_slip(r, s, known, contact, tell, told);
  contact->slipped = 0;
  return done;
}

static bool drop_unseen(tp_spring_record *r, const tp_stepper *s, bool *told) {
  long kept = 0;
  bool done = true;
  for (long k = 0; k < r->count; k++) {
    tp_known_spring own = r->known[k];
    if (own.missing == 0 && !own.seen) own.opened_s = s->time_s;
    own.missing = own.seen ? 0 : own.missing + 1;
    own.seen = false;
    if (own.missing < MISSING_OBSERVATIONS) {
      r->known[kept++] = own;
    } else if (done) {
      *told = true;
      done = add_event(r, s, TP_EVENT_OPENS, own.opened_s, &own, 0);
    }
  }
  r->count = kept;
  return done;
}

static bool observe(tp_spring_record *r, tp_stepper *s, bool tell, bool *told) {
  bool done = true;
  for (long k = 0; k < s->contacts.count && done; k++) {
    done = observe_contact(r, s, s->contacts.items + k, tell, told);
  }
  done = done && drop_unseen(r, s, told);
  r->last_observed_s = s->time_s;
  return done;
}

bool tp_spring_record_init(tp_spring_record *r, const tp_run *run, tp_stepper *s) {
  bool told = false;
  *r = (tp_spring_record){.run = run};
  if (run->history == NULL) return true;
  r->next_moment_s = run->moments_every_s > 0 ? run->moments_every_s : INFINITY;
  return observe(r, s, false, &told) && add_moment(r, s);
}

bool tp_spring_record_observe(tp_spring_record *r, tp_stepper *s) {
  if (r->run->history == NULL) return true;
  bool told = false;
  if (!observe(r, s, true, &told)) return false;
  const bool due = s->time_s >= r->next_moment_s;
  if (due) {
    const double every = r->run->moments_every_s;
    r->next_moment_s = every * (floor(s->time_s / every) + 1);
  }
  return (!told && !due) || add_moment(r, s);
}
