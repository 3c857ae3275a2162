/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* A run at work: its state, its contacts, its records. */

#ifndef TP_RIGID_CONTACT_DYNAMICS_H
#define TP_RIGID_CONTACT_DYNAMICS_H

#include "rigid_contact/rigid_contact.h"
#include "rigid_contact/touching.h"

/* What a contact did when it was recorded last. */
typedef struct tp_known_contact {
  tp_gap_pair pair;
  tp_contact_phase phase;
  tp_xy at;
  long facet;
  double slip; /* speed */
} tp_known_contact;

typedef struct tp_dynamics {
  tp_contact_system system;
  const tp_run *run;
  const tp_rigid_contact_settings *settings;
  tp_message *message;
  tp_rigid_contact_account account;
  double time; /* over sqrt(extent / gravity), as all that follows is without dimension */
  tp_motion_state state;
  double work;               /* of loads, shaking and friction up to now */
  double lost, first_energy; /* in impacts; kinetic at the start */
  bool resting, moved, overturned;
  double rests_until; /* at rest: the time up to which it is sure to stay so */
  bool held;          /* where a motion from rest was set: forces could hold it */
  tp_touching touching;
  tp_law law; /* of the mode that was set last: */
  tp_law_solution solution;
  tp_smooth smooth;
  long known_count, known_room;
  tp_known_contact *known;
} tp_dynamics;

/* What to do next. */
typedef enum tp_resolved {
  TP_RESOLVED_MOVES,
  TP_RESOLVED_RESTS,
  TP_RESOLVED_NOT, /* no mode fits; the message says so */
  TP_RESOLVED_NO_MEMORY
} tp_resolved;

/* After an event, or at the start: impacts, contacts that are to stay closed, and the mode in which
 * it goes on, or that it rests. */
tp_resolved tp_resolve(tp_dynamics *dynamics);

/* A block at rest: does it begin to move now? The mode is set where it does. */
tp_resolved tp_resolve_rest(tp_dynamics *dynamics);

/* ---- records (record.c); false when memory is exhausted ---- */

/* An event of a contact, or of the whole block where `contact` is NULL. */
TP_MUST_USE bool tp_record_event(tp_dynamics *dynamics, tp_tilt_event_kind kind,
                                 const tp_touching_contact *contact, double speed);

/* What the contacts do from now on, told against what they did: in the mode that was set last, or
 * at rest. */
TP_MUST_USE bool tp_record_phases(tp_dynamics *dynamics, bool moves);

/* A moment with its reactions. */
TP_MUST_USE bool tp_record_moment(tp_dynamics *dynamics);

/* The energy's balance, over weight and extent; the account keeps the worst. */
double tp_energy_balance(tp_dynamics *dynamics);

#endif
