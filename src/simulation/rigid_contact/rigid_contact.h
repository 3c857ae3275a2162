/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* The motion of a rigid block on a rigid base, from event to event (docs/rigid_contact.md): smooth
 * motion in between, in which each contact is open, sticks or slips; impacts by a stated law; and
 * the modes of docs/mechanics.md section 6a, in doubles, wherever a contact changes.
 *
 * Accuracy: steps within the tolerance, events to the last digits of the time, contacts kept closed
 * within 1e-11 of the extent of the block; the account says what the energy's balance came to. */

#ifndef TP_RIGID_CONTACT_RIGID_CONTACT_H
#define TP_RIGID_CONTACT_RIGID_CONTACT_H

#include "rigid_body/history.h"

/* What a block at rest does where a motion can begin and forces that hold it exist too: the forces
 * that its history has left in its contacts decide, of which rigid contacts know nothing. */
typedef enum tp_window_rule {
  TP_WINDOW_MOVES, /* nothing has put them there */
  TP_WINDOW_STANDS /* they are there */
} tp_window_rule;

typedef struct tp_rigid_contact_settings {
  double restitution;  /* of the speed across a contact that closes: 0 to 1 */
  double tolerance;    /* of a step: of place and speed, over extent and sqrt(gravity extent) */
  double least_bounce; /* a bounce no higher than this share of the extent is passed: the contact
                          stays closed (the end of impacts that accumulate) */
  long most_events, most_steps;
  tp_window_rule window;
} tp_rigid_contact_settings;

tp_rigid_contact_settings tp_rigid_contact_settings_default(void);

/* What a run took, and what it came to. Energies over weight times extent. */
typedef struct tp_rigid_contact_account {
  long steps, events, impacts, evaluations;
  long accumulated;     /* contacts that were closed by the rule of the least bounce */
  double worst_balance; /* the largest deviation of the energy's balance from 0 */
  double largest_drift; /* the farthest that a step's contacts were moved back, over the extent */
  bool lowered_restitution; /* in some impact energy would have grown */
  bool in_window;           /* at the begin of a motion from rest, forces could have held it */
  bool paradox; /* Painleve's was met: a contact that slips would press itself harder, and
                   rigid bodies have no unique answer */
} tp_rigid_contact_account;

/* Runs until the end of the time, until it rests for good or has left the base; or, under a drive
 * without shaking and where the run asks for that, as soon as it begins to move. `last` gets the
 * last state, `account`, unless NULL, what it took. A run that is undecided says why in the
 * message. */
tp_run_end tp_rigid_contact_run(tp_body_state *last, tp_rigid_contact_account *account,
                                const tp_run *run, const tp_rigid_contact_settings *settings,
                                tp_message *message);

/* One way in which a block can begin to move. */
typedef struct tp_rigid_contact_motion {
  double x_m_s2, y_m_s2, turning_rad_s2; /* acceleration of its centroid, and of its turn */
} tp_rigid_contact_motion;

enum { TP_RIGID_CONTACT_MOTIONS = 32 };

/* A block at rest in a place. */
typedef struct tp_rigid_contact_rest {
  int motion_count; /* that can begin, so many at most; 0: it is certain to stand */
  tp_rigid_contact_motion motions[TP_RIGID_CONTACT_MOTIONS];
  bool held; /* forces of its contacts can hold it; not: it is certain to move */
} tp_rigid_contact_rest;

/* The start of the run, its speeds left out, at the start of its drive. False when memory is
 * exhausted. */
TP_MUST_USE bool tp_rigid_contact_rest_find(tp_rigid_contact_rest *rest, const tp_run *run);

#endif
