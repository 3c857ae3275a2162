/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SPDX-FileCopyrightText: 2026 The Topple authors */

/* What a motion that is to be proven begins from: one mode a contact, friction, loads, and forces
 * near to its own. */

#ifndef TP_CONTACT_MODES_TRIAL_MODE_H
#define TP_CONTACT_MODES_TRIAL_MODE_H

#include "contact_modes/resting.h"
#include "contact_modes/rigid_groups.h"

/* Of one contact. Ties have two laws at once: an end stays closed and bears nothing; a contact
 * sticks, and all of its friction acts to one side. */
typedef struct tp_trial_mode {
  tp_mode_set mode; /* one: what closes, and what sticks */
  bool idle[2];     /* that end is closed, and bears nothing */
  int spent;        /* friction as if it slipped forward, 1, or back, -1; else 0 */
} tp_trial_mode;

typedef struct tp_beginning_question {
  tp_rigid_groups *groups;        /* of the blocks; kept from one question to the next */
  const tp_near *friction;        /* by contact */
  const tp_near *cohesion;        /* by contact: the force of all of it */
  const tp_near *loads;           /* w by row, about centroids */
  const double *normals, *shears; /* 2 a contact: forces to begin from */
} tp_beginning_question;

#endif
